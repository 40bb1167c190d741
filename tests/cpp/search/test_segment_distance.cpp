#include "search/segment_distance.h"
#include "support/random.h"

#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

struct Segments {
    Vec3 p0, p1, q0, q1;

    Vec3 between(double t_a, double t_b) const {
        return q0 + t_b * (q1 - q0) - p0 - t_a * (p1 - p0);
    }
};

/// Random segments, some of them parallel, nearly parallel, on one line, or crossing.
Segments random_segments(Random& random, int i) {
    Segments s{random.vector(1), random.vector(1), random.vector(1), random.vector(1)};
    const double factor = random.uniform(-2, 2);
    if (i % 5 == 1)
        s.q1 = s.q0 + factor * (s.p1 - s.p0);
    if (i % 5 == 2)
        s.q1 = s.q0 + factor * (s.p1 - s.p0) + random.vector(1e-5);
    if (i % 5 == 3) {
        s.q0 = s.p0 + random.uniform(-2, 2) * (s.p1 - s.p0);
        s.q1 = s.q0 + factor * (s.p1 - s.p0);
    }
    if (i % 5 == 4)
        s.q1 = s.q0 + 2 * (0.5 * (s.p0 + s.p1) - s.q0);
    return s;
}

} // namespace

TEST_CASE("no sampled points are closer than the closest points", "[segment_distance]") {
    Random random;
    for (int i = 0; i < 200; ++i) {
        const auto s = random_segments(random, i);
        const auto found = segment_distance(s.p0, s.p1, s.q0, s.q1);
        double sampled = 1e9;
        for (int a = 0; a <= 40; ++a)
            for (int b = 0; b <= 40; ++b)
                sampled = std::min(sampled, s.between(a / 40.0, b / 40.0).norm());
        CHECK(found.distance <= sampled + 1e-9);
        CHECK(found.distance >= sampled - ((s.p1 - s.p0).norm() + (s.q1 - s.q0).norm()) / 80);
    }
}

TEST_CASE("closest points satisfy the conditions of optimality", "[segment_distance]") {
    Random random(2);
    for (int i = 0; i < 5000; ++i) {
        const auto s = random_segments(random, i);
        const auto [t_a, t_b, distance] = segment_distance(s.p0, s.p1, s.q0, s.q1);
        REQUIRE((t_a >= 0 && t_a <= 1 && t_b >= 0 && t_b <= 1));
        const Vec3 d = s.between(t_a, t_b);
        CHECK(std::abs(d.norm() - distance) < 1e-14);
        // The problem is convex: a point where no direction leads down is the minimum.
        const double slope_a = -d.dot(s.p1 - s.p0), slope_b = d.dot(s.q1 - s.q0);
        const double tolerance = i % 5 == 2 ? 1e-5 : 1e-10;
        INFO("case " << i << ": t_a " << t_a << ", t_b " << t_b);
        CHECK((slope_a > -tolerance || t_a == 1));
        CHECK((slope_a < tolerance || t_a == 0));
        CHECK((slope_b > -tolerance || t_b == 1));
        CHECK((slope_b < tolerance || t_b == 0));
    }
}

TEST_CASE("distance is symmetric in the two segments", "[segment_distance]") {
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const auto s = random_segments(random, i);
        const double ab = segment_distance(s.p0, s.p1, s.q0, s.q1).distance;
        const double ba = segment_distance(s.q0, s.q1, s.p1, s.p0).distance;
        CHECK(std::abs(ab - ba) < (i % 5 == 2 ? 1e-6 : 1e-12)); // 1e-6 rad apart count as parallel
    }
}

TEST_CASE("segments without length are points", "[segment_distance]") {
    const Vec3 x(1, 2, 3), left(0, 0, 0), right(4, 0, 0);
    CHECK(segment_distance(x, x, left, right).distance == std::sqrt(13.0));
    CHECK(segment_distance(left, right, x, x).distance == std::sqrt(13.0));
    CHECK(segment_distance(left, right, x, x).t_a == 0.25);
    CHECK(segment_distance(x, x, left, left).distance == x.norm());
}
