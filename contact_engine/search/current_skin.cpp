#include "current_skin.h"

#include "../surfaces/skin_edges.h"

#include <algorithm>

namespace braidx {
namespace {

/// How far facets of degree 2 may reach beyond the box of their nodes, as a share of its size: half
/// of what the sum of |weights| exceeds one by, at most.
constexpr double bulge = 0.34;

/// Sine of the angle between normals from which on an edge has two sides: smooth edges have one,
/// but for round-off.
constexpr double sine_sharp = 0.1;

} // namespace

CurrentSkin::CurrentSkin(const Skin& skin, Unknowns q, double reach)
    : skin_(&skin), q_(q), reach_(reach), nodal_(nodal_normals(skin, q)),
      box_{Vec3::Constant(std::numeric_limits<double>::infinity()),
           Vec3::Constant(-std::numeric_limits<double>::infinity())},
      tree_(make_boxes()) {}

std::vector<Box> CurrentSkin::make_boxes() {
    std::vector<Box> in_reach;
    for (std::int32_t facet = 0; facet < skin_->num_facets(); ++facet) {
        boxes_.push_back(box_of(facet));
        box_ = box_.joined(boxes_.back());
        in_reach.push_back(boxes_.back().inflated(reach_));
        size_ = std::max(size_, (in_reach.back().high - in_reach.back().low).maxCoeff());
    }
    return in_reach;
}

CurrentSkin::Point CurrentSkin::point(std::int64_t number) const {
    const auto at = contact_point(*skin_, number);
    const auto weights = facet_weights(skin_->kind, at.u, at.v);
    return {at, combined(*skin_, q_, at.facet, weights.value),
            smooth_normal(*skin_, nodal_, at.facet, weights), rise(*skin_, at.facet, weights)};
}

Box CurrentSkin::box_of(std::int32_t facet) const {
    const Vec3 first = vector_at(q_, skin_->unknown_of(facet, 0));
    Box box{first, first};
    for (int node = 1; node < skin_->nodes_per_facet(); ++node) {
        const Vec3 x = vector_at(q_, skin_->unknown_of(facet, node));
        box = box.joined({x, x});
    }
    if (facet_degree(skin_->kind) == 1)
        return box;
    const Vec3 more = bulge * (box.high - box.low);
    return {box.low - more, box.high + more};
}

SkinPlace CurrentSkin::place(std::int32_t facet, const Vec3& x) const {
    const auto at = closest_on_facet(*skin_, q_, facet, x);
    const auto weights = facet_weights(skin_->kind, at.u, at.v);
    const Vec3 position = combined(*skin_, q_, facet, weights.value);
    const Vec3 normal = smooth_normal(*skin_, nodal_, facet, weights);
    return {at, position, normal, x - position, rise(*skin_, facet, weights) * normal};
}

/// On a sharp edge the shift is that to the line where the shifted surfaces of both sides meet, or,
/// in a corner, to the point where those of three do.
void CurrentSkin::shift_edge(SkinPlace& place, const std::vector<std::int32_t>& facets,
                             const Vec3& x) const {
    if ((skin_->offset.empty() && skin_->bulge.empty()) || !is_on_edge(*skin_, place.at))
        return;
    std::vector<Vec3> basis = {place.normal}; // of the normals so far, orthonormal
    for (const auto facet : facets) {
        if (boxes_[static_cast<std::size_t>(facet)].distance_to(place.position) >
            nearly_same * size_)
            continue;
        const auto side = this->place(facet, x);
        if ((side.position - place.position).norm() > nearly_same * size_)
            continue;
        Vec3 across = side.normal;
        for (const Vec3& known : basis)
            across -= across.dot(known) * known;
        if (basis.size() == 3 || across.norm() < sine_sharp)
            continue;
        place.shift += (side.shift.dot(side.normal) - place.shift.dot(side.normal)) /
                       across.dot(side.normal) * across;
        basis.push_back(across.normalized());
    }
}

} // namespace braidx
