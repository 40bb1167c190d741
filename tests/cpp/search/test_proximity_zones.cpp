#include "search/proximity_zones.h"
#include "support/rods.h"

#include <catch2/catch_test_macros.hpp>
#include <map>
#include <set>

using namespace braidx;
using namespace braidx::test;

namespace {

using Cell = std::pair<int, int>; // element of a, element of b
using Cells = std::set<Cell>;

/// Takes a cell and all that hang on to it out of `cells`.
void flood(Cells& cells, Cell from, Cells& zone) {
    if (cells.erase(from) == 0)
        return;
    zone.insert(from);
    for (int i : {-1, 0, 1})
        for (int j : {-1, 0, 1})
            flood(cells, {from.first + i, from.second + j}, zone);
}

std::set<Cells> flood_fill(Cells cells) {
    std::set<Cells> zones;
    while (!cells.empty()) {
        Cells zone;
        flood(cells, *cells.begin(), zone);
        zones.insert(zone);
    }
    return zones;
}

Rods parallel_tubes(int count, int num_elements) {
    Rods rods;
    for (int t = 0; t < count; ++t)
        rods.add_straight(cable, num_elements, 0.5, {1.0 * t, 0, 0},
                          {1.0 * t, 0, 1.0 * num_elements});
    return rods;
}

} // namespace

TEST_CASE("zones are those of a flood fill", "[proximity_zones]") {
    constexpr int n = 14;
    const Rods rods = parallel_tubes(3, n);
    for (unsigned seed = 1; seed <= 60; ++seed) {
        Random random(seed);
        const double density = random.uniform(0.05, 0.5);
        std::vector<ElementPair> pairs;
        std::map<Cell, Cells> cells; // by tubes
        for (const auto& [a, b] : {Cell{0, 1}, Cell{0, 2}, Cell{1, 2}})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                    if (random.chance(density)) {
                        pairs.push_back({a, b, i, j, i + 0.5, j + 0.5, 1.0});
                        cells[{a, b}].insert({i, j});
                    }
        std::map<Cell, std::set<Cells>> found;
        for (const auto& zone : proximity_zones(rods.tubes, rods.q, pairs)) {
            Cells members;
            for (const auto& p : zone.pairs)
                members.insert({p.element_a, p.element_b});
            CHECK(members.size() == zone.pairs.size());
            found[{zone.tube_a, zone.tube_b}].insert(members);
        }
        INFO("seed " << seed);
        for (const auto& [tubes, all] : cells)
            REQUIRE(found[tubes] == flood_fill(all));
    }
}

TEST_CASE("tubes that touch along all their length make one zone", "[proximity_zones]") {
    const Rods rods = parallel_tubes(2, 10);
    const auto zones =
        proximity_zones(rods.tubes, rods.q, close_pairs(rods.tubes, rods.q, {0.5, 4}));
    REQUIRE(zones.size() == 1);
    CHECK(zones[0].orientation == 1);
}

TEST_CASE("a tube that waves through another makes one zone per meeting", "[proximity_zones]") {
    Rods rods;
    rods.add_straight(cable, 30, 0.3, {0, 0, 0}, {30, 0, 0});
    rods.add(cable, 60, 0.3, [](double u) { return Vec3(30 * u, 4 * std::cos(12 * u), 0.5); });
    const auto zones =
        proximity_zones(rods.tubes, rods.q, close_pairs(rods.tubes, rods.q, {0.2, 4}));
    CHECK(zones.size() == 4);
}

TEST_CASE("orientation follows the curves", "[proximity_zones]") {
    for (const double way : {-1.0, 1.0}) {
        Rods rods;
        rods.add_straight(cable, 6, 0.5, {0, 0, 0}, {0, 0, 6});
        rods.add_straight(cable, 8, 0.5, {1, 0.2, 3 - 3.5 * way}, {1, -0.2, 3 + 3.5 * way});
        const auto zones =
            proximity_zones(rods.tubes, rods.q, close_pairs(rods.tubes, rods.q, {0.5, 4}));
        REQUIRE(zones.size() == 1);
        CHECK(zones[0].orientation == (way > 0 ? 1 : -1));
    }
}
