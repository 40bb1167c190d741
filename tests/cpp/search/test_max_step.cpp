#include "search/max_step.h"
#include "support/rods.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace braidx;
using namespace braidx::test;

namespace {

const auto all_meet = [](std::int32_t, std::int32_t) { return true; };

/// A motion of all unknowns: `of(x)` at each node, mm.
template <class Of> std::vector<double> motion(const Rods& rods, const Of& of) {
    std::vector<double> out(rods.q.size(), 0.0);
    for (std::size_t t = 0; t < rods.tubes.size(); ++t)
        for (std::int32_t i = 0; i < rods.tubes[t].num_nodes(); ++i)
            Eigen::Map<Vec3>(out.data() + rods.tubes[t].unknown_of(i)) = of(t, rods.node(t, i));
    return out;
}

/// A rod along x, and one along y that is `apart` above it.
Rods cross(const Kind& kind, double apart) {
    Rods rods;
    rods.add_straight(kind, 6, 0.5, {-6.1, 0, 0}, {5.9, 0, 0});
    rods.add_straight(kind, 5, 0.5, {0.3, -4, apart}, {0.3, 5, apart});
    return rods;
}

double share(const Rods& rods, const std::vector<double>& dq, int num_threads = 1) {
    return max_step(rods.tubes, rods.q, dq, {}, all_meet, num_threads);
}

/// Volume spanned by two segments: it changes its sign where their lines pass each other.
double volume(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    return (a1 - a0).cross(b1 - b0).dot(b0 - a0);
}

/// Whether two rods of one straight element each pass through each other before a share of the
/// step, which a thousand looks tell: the plane of two ends of one and an end of the other is
/// crossed within both segments.
bool pass(const Rods& rods, const std::vector<double>& dq, double share) {
    const auto at = [&](double t, std::size_t tube, std::int32_t i) -> Vec3 {
        return rods.node(tube, i) + t * vector_at(dq, rods.tubes[tube].unknown_of(i));
    };
    double before = 0;
    for (int k = 0; k <= 1000; ++k) {
        const double t = share * k / 1000;
        const Vec3 a0 = at(t, 0, 0), a1 = at(t, 0, 1), b0 = at(t, 1, 0), b1 = at(t, 1, 1);
        const double now = volume(a0, a1, b0, b1);
        const Vec3 n = (a1 - a0).cross(b1 - b0);
        const double on_a = (b0 - a0).cross(b1 - b0).dot(n) / n.squaredNorm(),
                     on_b = (b0 - a0).cross(a1 - a0).dot(n) / n.squaredNorm();
        const bool within = on_a > 0.01 && on_a < 0.99 && on_b > 0.01 && on_b < 0.99;
        if (k > 0 && within && now * before < 0)
            return true;
        before = now;
    }
    return false;
}

} // namespace

TEST_CASE("a rod falls onto another until it nearly meets its centre line", "[max_step]") {
    for (const auto& kind : all_kinds)
        for (const double way : {0.5, 1.9, 3.0, 50.0}) {
            const Rods rods = cross(kind, 2);
            const auto dq = motion(
                rods, [&](std::size_t t, const Vec3&) -> Vec3 { return {0, 0, t ? -way : 0}; });
            INFO(kind.name << ", " << way);
            const double found = share(rods, dq);
            if (way < 0.9 * 2) {
                CHECK(found == 1);
            } else {
                CHECK(found <= 2 / way);
                CHECK(found >= (1 - 0.1001) * 2 / way);
            }
        }
}

TEST_CASE("what moves as a whole, or apart, or past each other is free", "[max_step]") {
    const Rods rods = cross(smooth_cable, 2);
    const auto whole = [](std::size_t, const Vec3&) -> Vec3 { return {7, -3, 900}; };
    const auto apart = [](std::size_t t, const Vec3&) -> Vec3 { return {0, 0, t ? 9.0 : -9.0}; };
    const auto past = [](std::size_t t, const Vec3&) -> Vec3 { return {0, t ? 50.0 : 0.0, 0}; };
    CHECK(share(rods, motion(rods, whole)) == 1);
    CHECK(share(rods, motion(rods, apart)) == 1);
    CHECK(share(rods, motion(rods, past)) == 1);
}

TEST_CASE("tubes that never meet may pass", "[max_step]") {
    const Rods rods = cross(cable, 2);
    const auto dq =
        motion(rods, [](std::size_t t, const Vec3&) -> Vec3 { return {0, 0, t ? -9.0 : 0.0}; });
    const auto never = [](std::int32_t a, std::int32_t b) { return a == b; };
    CHECK(max_step(rods.tubes, rods.q, dq, {}, never) == 1);
    CHECK(share(rods, dq) < 1);
}

TEST_CASE("a tube does not pass through itself", "[max_step]") {
    Rods rods;
    rods.add(smooth_cable, 40, 0.3, [](double u) -> Vec3 { // out along x, and back across it, above
        if (u < 0.5)
            return {20 * u, 0, 0};
        return {10 - 16 * (u - 0.5), 8 * (u - 0.75), std::min(2.0, 20 * (u - 0.5))};
    });
    const auto dq = motion(
        rods, [](std::size_t, const Vec3& x) -> Vec3 { return {0, 0, x.z() > 1.5 ? -4.0 : 0.0}; });
    CHECK(share(rods, dq) < 1);
    CHECK(share(rods, std::vector<double>(rods.q.size(), 0.0)) == 1);
}

TEST_CASE("segments that move at random do not pass within the share", "[max_step]") {
    Random random(4);
    int cut = 0, passing = 0;
    for (int i = 0; i < 2000; ++i) {
        Rods rods;
        for (int t = 0; t < 2; ++t)
            rods.add_straight(cable, 1, 0.05, random.vector(1), random.vector(1));
        const auto dq =
            motion(rods, [&](std::size_t, const Vec3&) -> Vec3 { return random.vector(1.5); });
        const double found = share(rods, dq);
        const bool would = pass(rods, dq, 1);
        cut += found < 1;
        passing += would;
        REQUIRE(found > 0);
        REQUIRE_FALSE(pass(rods, dq, found));
        CHECK((!would || found < 1));
    }
    CHECK(passing > 200);
    CHECK(cut < 3 * passing); // it stops near misses, too, not anything
}

TEST_CASE("the share is the same with any number of threads", "[max_step]") {
    Random random(7);
    Rods rods;
    for (int t = 0; t < 8; ++t)
        rods.add(smooth_cable, 20, 0.2, [&](double u) -> Vec3 {
            return {10 * u, std::sin(5 * u + t), std::cos(5 * u + 2 * t)};
        });
    const auto dq =
        motion(rods, [&](std::size_t, const Vec3&) -> Vec3 { return random.vector(2); });
    const double found = share(rods, dq);
    CHECK(found < 1);
    CHECK(share(rods, dq, 3) == found);
}
