#pragma once

#include "../surfaces/facet_projection.h"
#include "box_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace braidx {

/// A place on a skin that is near a point x.
struct SkinPlace {
    FacetPoint at;
    Vec3 position;
    Vec3 normal; ///< smooth, out of the solid
    Vec3 offset; ///< x - position
    Vec3 shift;  ///< from the facet to the surface, mm: `rise` along the normal; on a sharp edge to
                 ///< where the surfaces of its sides meet
    double height() const { return offset.dot(normal); } ///< above the facet; negative: inside
};

/// A skin as it is now: normals, boxes of its facets, contact points. Finds its places within
/// `reach` (mm) of points.
class CurrentSkin {
public:
    CurrentSkin(const Skin& skin, Unknowns q, double reach);

    /// A contact point of the skin, its smooth normal, and how far the surface is above it.
    struct Point {
        FacetPoint at;
        Vec3 position, normal;
        double rise;
    };
    Point point(std::int64_t number) const;

    const Skin& skin() const { return *skin_; }
    const Box& box() const { return box_; } ///< of all facets

    /// The place nearest to x on those facets where accept(place) holds; among equally near ones,
    /// at an edge, that on the facet which x is most in front of.
    template <class Accept>
    std::optional<SkinPlace> closest(const Vec3& x, const Accept& accept) const {
        std::vector<std::int32_t> near;
        tree_.for_each_meeting({x, x}, [&](std::int32_t facet) { near.push_back(facet); });
        std::ranges::sort(near); // among equally near places the first one counts
        return closest_among(near, x, accept);
    }

    /// The same by testing every facet: the oracle of the tests.
    template <class Accept>
    std::optional<SkinPlace> closest_brute_force(const Vec3& x, const Accept& accept) const {
        std::vector<std::int32_t> all(static_cast<std::size_t>(skin_->num_facets()));
        std::iota(all.begin(), all.end(), 0);
        return closest_among(all, x, accept);
    }

private:
    Box box_of(std::int32_t facet) const;
    /// Fills box, boxes and size; returns the boxes within reach.
    std::vector<Box> make_boxes();
    SkinPlace place(std::int32_t facet, const Vec3& x) const;
    void shift_edge(SkinPlace& place, const std::vector<std::int32_t>& facets, const Vec3& x) const;

    template <class Accept>
    std::optional<SkinPlace> closest_among(const std::vector<std::int32_t>& facets, const Vec3& x,
                                           const Accept& accept) const {
        std::optional<SkinPlace> best;
        double nearest = reach_;
        const double same = nearly_same * size_;
        for (const auto facet : facets) {
            if (boxes_[static_cast<std::size_t>(facet)].distance_to(x) > nearest + same)
                continue;
            const auto found = place(facet, x);
            const double distance = found.offset.norm();
            if (distance > nearest + same || !accept(found))
                continue;
            if (best && distance > nearest - same &&
                std::abs(found.height()) <= std::abs(best->height()))
                continue;
            best = found;
            nearest = std::min(nearest, distance);
        }
        if (best)
            shift_edge(*best, facets, x);
        return best;
    }

    static constexpr double nearly_same = 1e-9; ///< distances that differ by round-off, over size_

    const Skin* skin_;
    Unknowns q_;
    double reach_;
    double size_ = 0; ///< of the largest box in reach, mm
    std::vector<Vec3> nodal_;
    std::vector<Box> boxes_;
    Box box_;
    BoxTree tree_; ///< of the boxes, inflated by the reach
};

} // namespace braidx
