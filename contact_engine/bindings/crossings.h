#pragma once

#include "checks.h"

#include <cmath>

/// Prescribed crossings from Python.
namespace braidx::bindings {

inline std::vector<Crossing> make_crossings(const In<std::int32_t>& tubes,
                                            const In<double>& windows,
                                            const In<std::int32_t>& order, const In<double>& axis) {
    require_shape(tubes, "tubes", {-1, 2});
    const auto count = static_cast<std::int64_t>(tubes.shape(0));
    require_shape(windows, "windows", {count, 4});
    require_shape(order, "order", {count});
    require_shape(axis, "axis", {2, 3});
    const Vec3 point = Eigen::Map<const Vec3>(axis.data()),
               way = Eigen::Map<const Vec3>(axis.data() + 3);
    require(way.norm() > 0, "axis[1]", way.transpose(), "a vector with a direction");
    std::vector<Crossing> out;
    for (std::int64_t i = 0; i < count; ++i) {
        const auto* t = tubes.data() + 2 * i;
        const auto* w = windows.data() + 4 * i;
        out.push_back(
            {t[0], t[1], w[0], w[1], w[2], w[3], order.data()[i], point, way.normalized()});
    }
    return out;
}

inline void require_crossings(const std::vector<Tube>& tubes,
                              const std::vector<Crossing>& crossings) {
    const auto count = static_cast<std::int32_t>(tubes.size());
    for (const auto& c : crossings)
        for (const auto tube : {c.tube_a, c.tube_b})
            require(tube >= 0 && tube < count, "a tube of crossings", tube,
                    "a number from 0, below ", count);
}

inline auto heights(const std::vector<Tube>& tubes, const std::vector<Crossing>& crossings,
                    const In<double>& q) {
    require_crossings(tubes, crossings);
    require_unknowns(OwnedSurfaces(tubes), q, "q");
    return make_array<double>({crossings.size()}, [&](double* out) {
        for (const auto& c : crossings)
            *out++ = crossing_height(tubes, view(q), c).value_or(NAN);
    });
}

} // namespace braidx::bindings
