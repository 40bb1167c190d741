#include "proximity_zones.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace braidx {
namespace {

using Pairs = std::span<const ElementPair>;

/// Root of i in a forest of parents, halving paths on the way.
std::size_t root(std::vector<std::size_t>& parent, std::size_t i) {
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

/// Joins each pair with those one element further on either curve; pairs are sorted by elements.
std::vector<std::size_t> components(Pairs pairs) {
    std::vector<std::size_t> parent(pairs.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto join = [&](std::size_t i, std::int32_t element_a, std::int32_t element_b) {
        const auto key = std::pair(element_a, element_b);
        const auto at = std::ranges::lower_bound(pairs, key, {}, [](const ElementPair& p) {
            return std::pair(p.element_a, p.element_b);
        });
        if (at != pairs.end() && std::pair(at->element_a, at->element_b) == key)
            parent[root(parent, i)] = root(parent, static_cast<std::size_t>(at - pairs.begin()));
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto a = pairs[i].element_a, b = pairs[i].element_b;
        join(i, a, b + 1);
        join(i, a + 1, b - 1);
        join(i, a + 1, b);
        join(i, a + 1, b + 1);
    }
    for (std::size_t i = 0; i < pairs.size(); ++i)
        parent[i] = root(parent, i);
    return parent;
}

/// Whether the curves run the same way where they are nearest to each other. Those that cross at
/// right angles do, whatever round-off says: stations are other ones if they do not, and what these
/// remember would be lost from one update to the next.
int orientation(const std::vector<Tube>& tubes, Unknowns q, const ProximityZone& zone) {
    constexpr double right_angle = 1e-6; // cosine: far beyond round-off of tangents
    double sum = 0, scale = 0;
    for (const auto& p : zone.pairs) {
        const Vec3 a = curve_point(tubes[zone.tube_a], q, p.s_a).tangent,
                   b = curve_point(tubes[zone.tube_b], q, p.s_b).tangent;
        sum += a.dot(b);
        scale += a.norm() * b.norm();
    }
    return sum >= -right_angle * scale ? 1 : -1;
}

} // namespace

std::vector<ProximityZone> proximity_zones(const std::vector<Tube>& tubes, Unknowns q,
                                           const std::vector<ElementPair>& pairs) {
    std::vector<ProximityZone> zones;
    for (auto first = pairs.begin(); first != pairs.end();) {
        const auto last = std::find_if(first, pairs.end(), [&](const ElementPair& p) {
            return p.tube_a != first->tube_a || p.tube_b != first->tube_b;
        });
        const Pairs group(first, last);
        const auto label = components(group);
        std::vector<std::ptrdiff_t> zone_of(group.size(), -1);
        for (std::size_t i = 0; i < group.size(); ++i) {
            auto& zone = zone_of[label[i]];
            if (zone < 0) {
                zone = static_cast<std::ptrdiff_t>(zones.size());
                zones.push_back({first->tube_a, first->tube_b, 1, {}});
            }
            zones[static_cast<std::size_t>(zone)].pairs.push_back(group[i]);
        }
        first = last;
    }
    for (auto& zone : zones)
        zone.orientation = orientation(tubes, q, zone);
    return zones;
}

} // namespace braidx
