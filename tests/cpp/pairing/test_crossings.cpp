#include "pairing/crossings.h"
#include "support/rods.h"

#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

constexpr double radius = 0.8;

/// Two straight tubes that cross at x = 10 (rope's axis: z), `height` = by how much b is outside a.
Rods crossing_tubes(const Kind& kind, double height) {
    Rods rods;
    rods.add_straight(kind, 12, radius, {10 - height / 2, -4, -9}, {10 - height / 2, 4, 9});
    rods.add_straight(kind, 12, radius, {10 + height / 2, 4, -9}, {10 + height / 2, -4, 9});
    return rods;
}

/// Prescribed order of the two, with windows `half` mm to both sides of the crossing.
Crossing crossing_of(const Rods& rods, int order, double half = 4) {
    const double middle = 0.5 * rods.tubes[0].length();
    return {0,     1,         middle - half, middle + half, middle - half, middle + half,
            order, {0, 0, 0}, {0, 0, 1}};
}

} // namespace

TEST_CASE("the normal of a crossing is radial, its sign the stacking order's", "[crossings]") {
    const Rods rods = crossing_tubes(cable, 0);
    const Vec3 x(3, 4, 17);
    CHECK((crossing_of(rods, 1).normal(x) + Vec3(0.6, 0.8, 0)).norm() <
          1e-15); // a outside: b inwards
    CHECK((crossing_of(rods, -1).normal(x) - Vec3(0.6, 0.8, 0)).norm() < 1e-15); // b outside
    CHECK(std::abs(crossing_of(rods, 1).normal({0, 0, 5}).norm() - 1) < 1e-15);
}

TEST_CASE("a crossing on the wrong side acts against it, on the right side not", "[crossings]") {
    for (const auto& kind : all_kinds)
        for (const int order : {1, -1})
            for (const double height : {-1.5, -0.4, 0.0, 0.4, 1.5}) {
                INFO(kind.name << ", order " << order << ", b outside by " << height);
                const Rods rods = crossing_tubes(kind, height);
                const auto crossing = crossing_of(rods, order);
                const auto stations = crossing_stations(rods.tubes, rods.q, crossing, 0.7, {});
                const double along = -order * height; // distance in the direction asked for
                REQUIRE(stations.empty() == (along > 0.7 * 2 * radius));
                for (const auto& s : stations) {
                    CHECK(std::abs(s.normal.norm() - 1) < 1e-14);
                    CHECK(s.normal.dot(Vec3(-order, 0, 0)) > 0.8);
                    CHECK(s.allowance >= 0);
                    CHECK(s.allowance < 2 * radius);
                    CHECK(s.station.weight > 0);
                }
            }
}

TEST_CASE("stations of a crossing stay in its windows", "[crossings]") {
    const Rods rods = crossing_tubes(smooth_cable, 0.1);
    const auto narrow = crossing_of(rods, 1, 1.0);
    const double length = rods.tubes[0].element_length;
    const auto stations = crossing_stations(rods.tubes, rods.q, narrow, 0.5, {});
    REQUIRE_FALSE(stations.empty());
    for (const auto& s : stations)
        CHECK(narrow.contains(s.station.s_a * length, s.station.s_b * length));
    auto elsewhere = narrow; // windows of a place where these tubes do not meet
    elsewhere.low_a -= 7;
    elsewhere.high_a -= 7;
    CHECK(crossing_stations(rods.tubes, rods.q, elsewhere, 0.5, {}).empty());
    CHECK_FALSE(crossing_height(rods.tubes, rods.q, elsewhere).has_value());
}

TEST_CASE("sections that do not face each other are allowed to come nearer", "[crossings]") {
    const Rods rods = crossing_tubes(cable, 0.2);
    for (const auto& s : crossing_stations(rods.tubes, rods.q, crossing_of(rods, -1), 0.7, {})) {
        const Vec3 across = position(rods.tubes[1], rods.q, s.station.s_b) -
                            position(rods.tubes[0], rods.q, s.station.s_a);
        const double lateral = (across - across.dot(s.normal) * s.normal).norm();
        const double touch = 2 * radius, height = touch - s.allowance;
        CHECK(std::abs(lateral * lateral + height * height - touch * touch) < 1e-9);
    }
}

TEST_CASE("height of a crossing is signed: positive on the side asked for", "[crossings]") {
    for (const int order : {1, -1})
        for (const double height : {-1.3, 0.0, 0.9}) {
            const Rods rods = crossing_tubes(cable, height);
            const auto found = crossing_height(rods.tubes, rods.q, crossing_of(rods, order));
            REQUIRE(found.has_value());
            CHECK(std::abs(*found + order * height) < 1e-9);
        }
}

TEST_CASE("judged by the crossing point alone, tubes that nowhere cross are separated",
          "[crossings]") {
    CrossingOptions by_point;
    by_point.by_point = true;
    const Rods crossing = crossing_tubes(cable, 0.3);
    CHECK_FALSE(
        crossing_stations(crossing.tubes, crossing.q, crossing_of(crossing, 1), 0.7, by_point)
            .empty());
    Rods beside; // parallel, overlapping sideways, at the same height
    beside.add_straight(cable, 12, radius, {10, -0.4, -9}, {10, -0.4, 9});
    beside.add_straight(cable, 12, radius, {10, 0.4, -9}, {10, 0.4, 9});
    const auto rule = crossing_of(beside, 1);
    CHECK(crossing_stations(beside.tubes, beside.q, rule, 0.7, by_point).empty());
    CHECK_FALSE(crossing_stations(beside.tubes, beside.q, rule, 0.7, {}).empty());
}
