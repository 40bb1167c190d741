#include "pairing/stations.h"
#include "support/rods.h"

#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

/// Rod a from z = 0 to `length_a`, rod b beside it from `start_b` to `end_b` (downwards if less).
Rods parallel_rods(const Kind& kind, double length_a, int elements_a, double start_b, double end_b,
                   int elements_b) {
    Rods rods;
    rods.add_straight(kind, elements_a, 1.0, {0, 0, 0}, {0, 0, length_a});
    rods.add_straight(kind, elements_b, 0.8, {1.75, 0, start_b}, {1.75, 0, end_b});
    return rods;
}

struct Line {
    TubePair pair;
    std::vector<Station> stations;
};

/// Line stations of all zones of the first two tubes.
Line line_of(const Rods& rods, double spacing, double margin = 0.5) {
    const auto pairs = close_pairs(rods.tubes, rods.q, {margin, 4});
    const auto zones = proximity_zones(rods.tubes, rods.q, pairs);
    Line out{{rods.tubes[0], rods.tubes[1], rods.q, zones.empty() ? 1 : zones[0].orientation}, {}};
    for (const auto& zone : zones)
        for (const auto& s : line_stations(out.pair, zone.pairs, spacing))
            out.stations.push_back(s);
    return out;
}

double total_weight(const Line& line) {
    double sum = 0;
    for (const auto& s : line.stations)
        sum += s.weight;
    return sum;
}

} // namespace

TEST_CASE("weights along parallel rods sum to the length of their overlap", "[line_stations]") {
    Random random;
    for (int i = 0; i < 300; ++i) {
        const Kind& kind = all_kinds[i % 6];
        const double length = random.uniform(8, 14), spacing = random.uniform(0.5, 2);
        const double offset = random.uniform(-7, 9), length_b = random.uniform(5, 15);
        const double start = i % 4 < 2 ? offset : offset + length_b;
        const double end = i % 4 < 2 ? offset + length_b : offset;
        const Rods rods =
            parallel_rods(kind, length, random.integer(4, 12), start, end, random.integer(4, 12));
        const double overlap = std::min(length, offset + length_b) - std::max(0.0, offset);
        if (overlap < 0.1)
            continue;
        const auto line = line_of(rods, spacing);
        INFO(kind.name << ", case " << i << ": a 0 to " << length << ", b " << start << " to "
                       << end << ", spacing " << spacing);
        CHECK(line.pair.orientation == (start < end ? 1 : -1));
        CHECK(std::abs(total_weight(line) - overlap) < 1e-3 * spacing);
        for (const auto& s : line.stations)
            CHECK(std::abs(line.pair.across(s)[2]) < 1e-3 * spacing); // they face each other
    }
}

TEST_CASE("line stations are one per cell and none is heavier than a cell", "[line_stations]") {
    const Rods rods = parallel_rods(cable, 12, 7, 1.3, 14, 9);
    const auto line = line_of(rods, 0.9);
    REQUIRE(line.stations.size() > 10);
    for (std::size_t i = 0; i < line.stations.size(); ++i) {
        CHECK(line.stations[i].weight < 0.9 * (1 + 1e-9));
        if (i > 0)
            CHECK(line.stations[i].index == line.stations[i - 1].index + 1);
    }
}

TEST_CASE("line stations are fixed in the material", "[line_stations]") {
    const Rods before = parallel_rods(smooth_cable, 12, 7, 1.3, 14, 9);
    Rods after = before;
    const double slide = 0.3; // b moves along a, and all that moves on
    for (std::size_t i = 0; i < after.q.size(); i += 3) {
        after.q[i + 2] += static_cast<std::int64_t>(i) >= after.tubes[1].first_unknown ? slide : 0;
        after.q[i] += 7;
        after.q[i + 1] -= 3;
    }
    const auto old = line_of(before, 0.9).stations, now = line_of(after, 0.9).stations;
    REQUIRE(old.size() > 10);
    const double half_a = slide / 2 / before.tubes[0].element_length;
    const double half_b = slide / 2 / before.tubes[1].element_length;
    std::size_t kept = 0;
    for (const auto& o : old)
        for (const auto& n : now)
            if (o.index == n.index && o.weight > 0.9 - 1e-9 && n.weight > 0.9 - 1e-9) {
                CHECK(std::abs(n.s_a - o.s_a - half_a) < 1e-6);
                CHECK(std::abs(n.s_b - o.s_b + half_b) < 1e-6);
                ++kept;
            }
    CHECK(kept >= old.size() - 3);
}

TEST_CASE("line stations are the same when a and b are swapped", "[line_stations]") {
    for (const bool opposite : {false, true})
        for (const auto& kind : all_kinds) {
            Random random(11);
            Rods rods = opposite ? parallel_rods(kind, 12, 7, 11.2, -1, 6)
                                 : parallel_rods(kind, 12, 7, -1, 11.2, 6);
            rods.shake(random, 0.05);
            const Rods swapped = rods.reversed();
            const auto ab = line_of(rods, 0.9).stations, ba = line_of(swapped, 0.9).stations;
            INFO(kind.name << (opposite ? ", opposite ways" : ", same way"));
            REQUIRE(ab.size() == ba.size());
            for (std::size_t i = 0; i < ab.size(); ++i) {
                const auto& other = ba[opposite ? ba.size() - 1 - i : i];
                CHECK(std::abs(ab[i].s_a - other.s_b) < 1e-6);
                CHECK(std::abs(ab[i].s_b - other.s_a) < 1e-6);
                CHECK(std::abs(ab[i].weight - other.weight) < 1e-6);
                CHECK(other.index == (opposite ? -ab[i].index - 1 : ab[i].index));
            }
        }
}

TEST_CASE("no stations where two rods lie one after the other", "[line_stations]") {
    Rods rods;
    rods.add_straight(cable, 5, 1.0, {0, 0, 0}, {0, 0, 10});
    rods.add_straight(cable, 5, 1.0, {0.5, 0, 10.4}, {0.5, 0, 20.4});
    REQUIRE_FALSE(close_pairs(rods.tubes, rods.q, {}).empty());
    CHECK(line_of(rods, 1.0).stations.empty());
}
