#include "current_skin.h"

#include <algorithm>
#include <cmath>

namespace braidx {
namespace {

/// How far facets of degree 2 may reach beyond the box of their nodes, as a share of its size: half
/// of what the sum of |weights| exceeds one by, at most.
constexpr double bulge = 0.34;

} // namespace

CurrentSkin::CurrentSkin(const Skin& skin, Unknowns q, double reach)
    : skin_(&skin), q_(q), reach_(reach), nodal_(nodal_normals(skin, q)),
      box_{Vec3::Constant(std::numeric_limits<double>::infinity()),
           Vec3::Constant(-std::numeric_limits<double>::infinity())} {
    double size = 0;
    for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet) {
        boxes_.push_back(box_of(facet));
        box_.low = box_.low.cwiseMin(boxes_.back().low);
        box_.high = box_.high.cwiseMax(boxes_.back().high);
        size = std::max(size, (boxes_.back().high - boxes_.back().low).maxCoeff());
    }
    size_ = std::max(size + 2 * reach, std::numeric_limits<double>::min());
    fill_cells();
}

CurrentSkin::Point CurrentSkin::point(std::int64_t number) const {
    const auto at = contact_point(*skin_, number);
    const auto weights = facet_weights(skin_->kind, at.u, at.v);
    return {at, combined(*skin_, q_, at.facet, weights.value),
            smooth_normal(*skin_, nodal_, at.facet, weights), rise(*skin_, at.facet, weights)};
}

CurrentSkin::Cell CurrentSkin::cell_of(const Vec3& x) const {
    const auto index = [this](double v) {
        return static_cast<std::int64_t>(std::floor(v / size_));
    };
    return {index(x[0]), index(x[1]), index(x[2])};
}

Box CurrentSkin::box_of(std::int32_t facet) const {
    Vec3 low = vector_at(q_, skin_->unknown_of(facet, 0)), high = low;
    for (int node = 1; node < skin_->nodes_per_facet(); ++node) {
        const Vec3 x = vector_at(q_, skin_->unknown_of(facet, node));
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    if (facet_degree(skin_->kind) == 1)
        return {low, high};
    const Vec3 more = bulge * (high - low);
    return {low - more, high + more};
}

void CurrentSkin::fill_cells() {
    const Vec3 inflation = Vec3::Constant(reach_);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const Cell low = cell_of(boxes_[i].low - inflation),
                   high = cell_of(boxes_[i].high + inflation);
        for (auto x = low.x; x <= high.x; ++x)
            for (auto y = low.y; y <= high.y; ++y)
                for (auto z = low.z; z <= high.z; ++z)
                    cells_[{x, y, z}].push_back(static_cast<std::int32_t>(i));
    }
}

SkinPlace CurrentSkin::place(std::int32_t facet, const Vec3& x) const {
    const auto at = closest_on_facet(*skin_, q_, facet, x);
    const auto weights = facet_weights(skin_->kind, at.u, at.v);
    const Vec3 position = combined(*skin_, q_, facet, weights.value);
    return {at, position, smooth_normal(*skin_, nodal_, facet, weights), x - position,
            rise(*skin_, facet, weights)};
}

} // namespace braidx
