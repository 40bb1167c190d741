#pragma once

#include "../surfaces/deformable.h"
#include "arrays.h"

#include <algorithm>
#include <cmath>

/// Tubes and skins as Python holds them.
namespace braidx::bindings {

/// Owner of all surfaces that have unknowns; tubes alone become one where it is asked for.
struct OwnedSurfaces {
    std::vector<Tube> tubes;
    std::vector<Skin> skins;
    std::int64_t num_unknowns = 0; ///< one past the last that they need
    int num_bodies = 0;            ///< one past the last of theirs

    OwnedSurfaces(std::vector<Tube> all_tubes, std::vector<Skin> all_skins = {})
        : tubes(std::move(all_tubes)), skins(std::move(all_skins)) {
        for (const auto& tube : tubes) {
            const auto last = tube.unknown_of(tube.is_closed ? tube.num_elements * tube.degree - 1
                                                             : tube.end_element() * tube.degree);
            num_unknowns = std::max(num_unknowns, last + tube.block);
            num_bodies = std::max(num_bodies, tube.body + 1);
        }
        for (const auto& skin : skins) {
            for (const auto unknown : skin.unknown)
                num_unknowns = std::max(num_unknowns, unknown + 3);
            num_bodies = std::max(num_bodies, skin.body + 1);
        }
    }

    operator DeformableSurfaces() const { return {tubes, skins}; }
};

inline void require_tube(const Tube& tube, std::size_t number) {
    const auto check = [&](bool holds, const char* name, auto value, const char* wanted) {
        require(holds, name + ("[" + std::to_string(number) + "]"), value, wanted);
    };
    check(tube.num_elements >= 1, "num_elements", tube.num_elements, "at least 1");
    check(tube.degree == 1 || tube.degree == 2, "degree", tube.degree, "1 or 2");
    check(tube.block == 3 || tube.block == 9, "block", tube.block, "3 (cable) or 9 (beam)");
    check(tube.radius > 0 && std::isfinite(tube.radius), "radius", tube.radius, "a length above 0");
    check(tube.element_length > 0 && std::isfinite(tube.element_length), "element_length",
          tube.element_length, "a length above 0");
    check(tube.body >= 0, "body", tube.body, "a number from 0");
    check(tube.beyond >= 0, "beyond", tube.beyond, "a number from 0");
    check(tube.unknown_of(tube.first_element() * tube.degree) >= 0, "first_unknown",
          tube.first_unknown, "one that leaves room for the nodes beyond");
}

inline std::vector<Tube> make_tubes(const In<std::int64_t>& first_unknown,
                                    const In<std::int32_t>& num_elements,
                                    const In<std::int32_t>& degree, const In<std::int32_t>& block,
                                    const In<double>& radius, const In<double>& element_length,
                                    const In<std::int32_t>& body, const In<bool>& is_image,
                                    bool smooth, int beyond, const std::vector<int>& group,
                                    const std::vector<int>& closed, bool round_ends) {
    require_shape(radius, "radius", {-1});
    const auto count = static_cast<std::int64_t>(radius.size());
    require_shape(first_unknown, "first_unknown", {count});
    require_shape(num_elements, "num_elements", {count});
    require_shape(degree, "degree", {count});
    require_shape(block, "block", {count});
    require_shape(element_length, "element_length", {count});
    require_shape(body, "body", {count});
    require_shape(is_image, "is_image", {count});
    require(group.empty() || group.size() == radius.size(), "group",
            "a list of " + std::to_string(group.size()), "one of ", count, ", or none");
    require(closed.empty() || closed.size() == radius.size(), "closed",
            "a list of " + std::to_string(closed.size()), "one of ", count, ", or none");
    std::vector<Tube> tubes;
    for (std::size_t i = 0; i < radius.size(); ++i) {
        tubes.push_back(
            {first_unknown.data()[i], num_elements.data()[i], degree.data()[i], block.data()[i],
             radius.data()[i], element_length.data()[i], body.data()[i], smooth, is_image.data()[i],
             beyond, group.empty() ? -1 : group[i], !closed.empty() && closed[i] != 0, round_ends});
        require_tube(tubes.back(), i);
    }
    return tubes;
}

/// A skin from facets, shape (num_facets, nodes per facet), rest positions in all unknowns, and how
/// far the surface is outside the nodes of each facet, shape (num_facets,) or (0,).
inline Skin skin_from_arrays(const In<std::int64_t>& facets, int body, double radius, int group,
                             const In<double>& rest, bool dense, bool smooth,
                             const In<double>& offset) {
    const auto nodes = facets.ndim() == 2 ? facets.shape(1) : 0;
    require(nodes == 3 || nodes == 4 || nodes == 6 || nodes == 9, "facets",
            "an array of shape " + written_shape(shape_of(facets)),
            "(n, 3), (n, 4), (n, 6) or (n, 9)");
    require_shape(rest, "rest", {-1});
    const auto size = static_cast<std::int64_t>(rest.size());
    for (const auto unknown : view(facets))
        require(unknown >= 0 && unknown + 3 <= size, "an unknown in facets", unknown,
                "one of three in a row of ", size);
    require(radius > 0 && body >= 0, "radius and body",
            std::to_string(radius) + " and " + std::to_string(body),
            "a length above 0 and a number from 0");
    if (offset.size() != 0)
        require_shape(offset, "offset", {static_cast<std::int64_t>(facets.shape(0))});
    return make_skin(static_cast<FacetKind>(nodes), {facets.data(), facets.data() + facets.size()},
                     body, radius, group, view(rest), dense, smooth,
                     {offset.data(), offset.data() + offset.size()});
}

} // namespace braidx::bindings
