#include "pairing/stations.h"
#include "support/rods.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <numbers>

using namespace braidx;
using namespace braidx::test;

namespace {

constexpr double tolerance = 0.005;

/// Two rods that cross at `angle` (rad) off their middles, one diameter apart along x.
Rods crossing_rods(const Kind& kind, double angle, double off_a, double off_b) {
    const Vec3 a(0, 0, 1), b(0, std::sin(angle), std::cos(angle)), up(1.98, 0, 0);
    Rods rods;
    rods.add_straight(kind, 12, 1.0, (-10 + off_a) * a, (10 + off_a) * a);
    rods.add_straight(kind, 15, 1.0, up + (-12 + off_b) * b, up + (12 + off_b) * b);
    return rods;
}

/// Bends all tubes away from the plane x = 0, to a curvature in 1/mm.
void bend(Rods& rods, double curvature) {
    for (std::size_t t = 0; t < rods.tubes.size(); ++t)
        for (std::int32_t i = 0; i < rods.tubes[t].num_nodes(); ++i) {
            const Vec3 x = rods.node(t, i);
            const double rise = 0.5 * curvature * (x[1] * x[1] + x[2] * x[2]);
            rods.q[static_cast<std::size_t>(rods.tubes[t].unknown_of(i))] += t == 0 ? -rise : rise;
        }
}

struct Stations {
    TubePair pair;
    std::vector<Station> line, point;
};

Stations stations_of(const Rods& rods, double spacing) {
    const auto zones =
        proximity_zones(rods.tubes, rods.q, close_pairs(rods.tubes, rods.q, {0.5, 4}));
    REQUIRE(zones.size() == 1);
    Stations out{{rods.tubes[0], rods.tubes[1], rods.q, zones[0].orientation}, {}, {}};
    out.line = line_stations(out.pair, zones[0].pairs, spacing);
    out.point = point_stations(out.pair, out.line, spacing, tolerance);
    return out;
}

} // namespace

TEST_CASE("rods that cross at more than 30 degrees have a contact at their crossing",
          "[point_stations]") {
    Random random;
    for (const auto& kind : all_kinds)
        for (int degrees = 35; degrees < 150; degrees += 5) {
            const double angle = degrees * std::numbers::pi / 180;
            const double off_a = random.uniform(-3, 3), off_b = random.uniform(-3, 3);
            const Rods rods = crossing_rods(kind, angle, off_a, off_b);
            const auto found = stations_of(rods, 1.0);
            INFO(kind.name << " at " << degrees << " degrees");
            double nearest = 1e9;
            for (const auto& stations : {found.line, found.point})
                for (const auto& s : stations)
                    nearest = std::min(nearest, found.pair.across(s).norm());
            CHECK(nearest < 1.98 + 1.01 * tolerance);
            REQUIRE(found.point.size() == 1);
            const auto& s = found.point[0];
            CHECK(s.index == point_station);
            CHECK(std::abs(s.s_a - (10 - off_a) / 20 * 12) < 1e-6);
            CHECK(std::abs(s.s_b - (12 - off_b) / 24 * 15) < 1e-6);
        }
}

TEST_CASE("parallel rods need no point stations", "[point_stations]") {
    Rods rods;
    rods.add_straight(cable, 12, 1.0, {0, 0, 0}, {0, 0, 20});
    rods.add_straight(cable, 9, 1.0, {1.9, 0, 3}, {1.9, 0, 18});
    CHECK(stations_of(rods, 1.0).point.empty());
}

TEST_CASE("a crossing past the end of a rod is none", "[point_stations]") {
    for (const double off_b :
         {11.0, 12.5, 13.5}) { // b's end before, just past, beyond the crossing
        const Rods rods = crossing_rods(cable, std::numbers::pi / 3, 0, off_b);
        const auto pairs = close_pairs(rods.tubes, rods.q, {0.5, 4});
        if (pairs.empty())
            continue;
        INFO("b starts " << off_b - 12 << " mm past the crossing");
        CHECK(stations_of(rods, 1.0).point.size() == (off_b < 12 ? 1 : 0));
    }
}

TEST_CASE("point stations are the same when a and b are swapped", "[point_stations]") {
    for (const auto& kind : all_kinds)
        for (const double angle : {0.6, 1.5, 2.4}) {
            Rods rods = crossing_rods(kind, angle, 0.7, -1.1);
            bend(rods, 0.02);
            const Rods swapped = rods.reversed();
            const auto ab = stations_of(rods, 1.0).point, ba = stations_of(swapped, 1.0).point;
            INFO(kind.name << " at " << angle);
            REQUIRE(ab.size() == 1);
            REQUIRE(ba.size() == 1);
            CHECK(std::abs(ab[0].s_a - ba[0].s_b) < 1e-6);
            CHECK(std::abs(ab[0].s_b - ba[0].s_a) < 1e-6);
        }
}

TEST_CASE("sharpness is the growth of the distance away from the closest approach",
          "[point_stations]") {
    for (const double angle : {0.6, 1.0, 1.5})
        for (const double curvature : {0.0, 0.1, -0.2}) {
            Rods rods = crossing_rods(quadratic_cable, angle, 0, 0);
            bend(rods, curvature);
            const auto found = stations_of(rods, 1.0);
            const TubePair& pair = found.pair;
            const double h = 1e-3, da = 10 + 0.0, db = 12 + 0.0;
            const auto half_square = [&](double a, double b) {
                return 0.5 * pair.across(pair.station(da + a, db + b, 1, 0)).squaredNorm();
            };
            Eigen::Matrix2d second;
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) {
                    const auto at = [&](double x, double y) {
                        return half_square(x * h * (i == 0) + y * h * (j == 0),
                                           x * h * (i == 1) + y * h * (j == 1));
                    };
                    second(i, j) = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * h * h);
                }
            const double lowest = second.selfadjointView<Eigen::Lower>().eigenvalues()[0];
            INFO("angle " << angle << ", curvature " << curvature);
            CHECK(std::abs(pair.sharpness(da, db) - lowest) < 1e-3);
        }
}

TEST_CASE("point and line stations share the length of the mean curve", "[point_stations]") {
    for (const double off : {0.0, 0.13, 0.5, 0.77}) {
        const Rods rods = crossing_rods(cable, 0.8, off, -1.1);
        const auto found = stations_of(rods, 1.0);
        REQUIRE(found.point.size() == 1);
        double whole = 0, shared = 0;
        for (const auto& s : found.line)
            whole += s.weight;
        for (const auto& s : share_length(found.line, found.point, found.pair))
            shared += s.weight;
        CHECK(std::abs(whole - shared) < 1e-9);
    }
}

TEST_CASE("rods with kinks have at most one contact at their crossing, one where it is sharp",
          "[point_stations]") {
    for (const auto& kind : all_kinds)
        for (const double angle : {0.6, 1.5, 2.4})
            for (unsigned seed = 1; seed <= 10; ++seed) {
                Random random(seed);
                Rods rods = crossing_rods(kind, angle, 0.7, -1.1);
                rods.shake(random, 0.04);
                const auto found = stations_of(rods, 1.0);
                INFO(kind.name << " at " << angle << ", seed " << seed);
                if (found.point.empty() && angle == 0.6)
                    continue; // kinks that wind around each other make the crossing flat
                REQUIRE(found.point.size() == 1);
                for (const auto& s : found.line)
                    CHECK(found.pair.across(found.point[0]).norm() <=
                          found.pair.across(s).norm() + tolerance);
            }
}

TEST_CASE("curves that bend around each other more than they cross have no closest approach",
          "[point_stations]") {
    // Wound around each other at a slope that changes along them: the distance has no minimum.
    Rods rods;
    for (const double sign : {1.0, -1.0})
        rods.add(smooth_cable, 24, 1.0, [=](double t) {
            const double z = 20 * (t - 0.5), angle = 0.35 * z, r = 1.0 + 0.002 * z;
            return Vec3(sign * r * std::cos(angle), sign * r * std::sin(angle), z);
        });
    const TubePair pair{rods.tubes[0], rods.tubes[1], rods.q, 1};
    const double middle = rods.tubes[0].length() / 2;
    CHECK_FALSE(pair.closest(middle, middle).has_value());
}
