#include "sampled_elements.h"

#include <algorithm>
#include <limits>

namespace braidx::test {
namespace {

/// Of a smooth curve at a node: half the way from the node before to the one after; at an end, the
/// way to or from the next one.
Vec3 slope(const Rods& rods, std::size_t tube, std::int32_t node) {
    const auto last = rods.tubes[tube].num_elements;
    const auto before = std::max(node - 1, 0), after = std::min(node + 1, last);
    return (rods.node(tube, after) - rods.node(tube, before)) / (after - before);
}

Vec3 point(const Rods& rods, std::size_t tube, std::int32_t e, double t) {
    if (rods.tubes[tube].degree == 2) {
        const Vec3 x0 = rods.node(tube, 2 * e), x1 = rods.node(tube, 2 * e + 1),
                   x2 = rods.node(tube, 2 * e + 2);
        const Vec3 low = x0 + 2 * t * (x1 - x0), high = x1 + (2 * t - 1) * (x2 - x1);
        return low + t * (high - low);
    }
    const Vec3 x0 = rods.node(tube, e), x1 = rods.node(tube, e + 1);
    if (!rods.tubes[tube].smooth)
        return x0 + t * (x1 - x0);
    const Vec3 m0 = slope(rods, tube, e), m1 = slope(rods, tube, e + 1);
    const double u = 1 - t;
    return u * u * (1 + 2 * t) * x0 + t * t * (3 - 2 * t) * x1 + t * u * u * m0 - t * t * u * m1;
}

} // namespace

std::vector<SampledElement> sampled_elements(const Rods& rods, int count) {
    std::vector<SampledElement> out;
    for (std::size_t tube = 0; tube < rods.tubes.size(); ++tube)
        for (std::int32_t e = 0; e < rods.tubes[tube].num_elements; ++e) {
            SampledElement sampled{static_cast<std::int32_t>(tube), e, {}, 0};
            for (int i = 0; i <= count; ++i)
                sampled.points.push_back(point(rods, tube, e, static_cast<double>(i) / count));
            for (std::size_t i = 1; i < sampled.points.size(); ++i)
                sampled.step =
                    std::max(sampled.step, (sampled.points[i] - sampled.points[i - 1]).norm());
            out.push_back(std::move(sampled));
        }
    return out;
}

double sampled_distance(const SampledElement& a, const SampledElement& b) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& x : a.points)
        for (const Vec3& y : b.points)
            nearest = std::min(nearest, (x - y).squaredNorm());
    return std::sqrt(nearest);
}

} // namespace braidx::test
