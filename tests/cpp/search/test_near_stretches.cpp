#include "search/near_stretches.h"
#include "support/rods.h"

#include <catch2/catch_test_macros.hpp>
#include <limits>

using namespace braidx;
using namespace braidx::test;

namespace {

/// Least distance to a fine sample of the centre line, and where; the oracle.
std::pair<double, double> sampled(const Tube& tube, Unknowns q, const Vec3& x) {
    constexpr int steps = 4000;
    double least = std::numeric_limits<double>::infinity(), s = 0;
    for (int i = 0; i <= steps; ++i) {
        const double at = tube.num_elements * double(i) / steps;
        const double distance = (x - position(tube, q, at)).norm();
        if (distance < least) {
            least = distance;
            s = at;
        }
    }
    return {least, s};
}

} // namespace

TEST_CASE("the nearest section is that of a fine sample", "[near_stretches]") {
    Random random(5);
    int found = 0, past = 0;
    for (const auto& kind : {smooth_cable, quadratic_cable, smooth_beam})
        for (int trial = 0; trial < 60; ++trial) {
            Rods rods;
            rods.add_straight(kind, 6, 1.0, {0, 0, 0}, {0, 0, 12});
            rods.shake(random, 0.15);
            const Tube& tube = rods.tubes[0];
            const Box box{{-1, -1, -1}, {1, 1, 13}};
            const NearStretches near(tube, rods.q, box, 1.0);
            const Vec3 x(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8),
                         random.uniform(-1, 13));
            const auto s = near.nearest_section(x);
            const auto [least, at] = sampled(tube, rods.q, x);
            if (!s) {
                CHECK((at < 1e-9 || at > tube.num_elements - 1e-9));
                ++past;
                continue;
            }
            ++found;
            const double distance = (x - position(tube, rods.q, *s)).norm();
            CHECK(distance <= least + 1e-9);
            CHECK(distance > least - 1e-3);
        }
    CHECK((found > 120 && past > 5));
}

TEST_CASE("a tube far from a box has no stretches near it", "[near_stretches]") {
    Rods rods;
    rods.add_straight(smooth_cable, 6, 1.0, {0, 0, 0}, {0, 0, 12});
    const NearStretches beside(rods.tubes[0], rods.q, {{5, 0, 0}, {6, 1, 12}}, 1.0),
        below(rods.tubes[0], rods.q, {{0, 0, -9}, {1, 1, -5}}, 1.0);
    CHECK((beside.empty() && below.empty()));
}
