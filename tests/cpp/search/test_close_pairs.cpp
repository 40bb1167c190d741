#include "search/close_pairs.h"
#include "support/sampled_elements.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <tuple>

using namespace braidx;
using namespace braidx::test;

namespace {

auto elements(const ElementPair& p) {
    return std::tuple(p.tube_a, p.tube_b, p.element_a, p.element_b);
}

auto fields(const ElementPair& p) {
    return std::tuple_cat(elements(p), std::tuple(p.s_a, p.s_b, p.distance));
}

/// Tubes that wander through a box, with sizes of their own.
Rods tangle(unsigned seed) {
    Random random(seed);
    Rods rods;
    for (int t = 0; t < 6; ++t) {
        const Kind& kind = all_kinds[random.integer(0, 5)];
        const Vec3 from = random.vector(8), to = random.vector(8), size = random.vector(6);
        const double turns = random.uniform(0, 12);
        rods.add(kind, random.integer(1, 25), random.uniform(0.1, 0.8), [&](double u) -> Vec3 {
            const Vec3 wave(std::sin(turns * u), std::cos(turns * u), std::sin(1.7 * turns * u));
            return from + u * (to - from) + size.cwiseProduct(wave);
        });
    }
    return rods;
}

/// Whether the elements are neighbours on one tube, nearer along it than the exclusion.
bool excluded(const Tube& tube, const SampledElement& a, const SampledElement& b,
              double self_exclusion) {
    const double between = (b.element - a.element - 1) * tube.element_length;
    return a.tube == b.tube && between < self_exclusion * tube.radius;
}

} // namespace

TEST_CASE("no two elements whose curves come within reach are missed", "[close_pairs]") {
    std::size_t needed = 0, self = 0, found = 0;
    for (unsigned seed = 1; seed <= 24; ++seed) {
        const Rods rods = tangle(seed);
        const SearchOptions options{0.25 * (seed % 5), 1.0 + seed % 4};
        const auto pairs = close_pairs(rods.tubes, rods.q, options);
        CHECK(std::ranges::is_sorted(pairs, {}, elements));
        found += pairs.size();
        const auto sampled = sampled_elements(rods, 16);
        for (std::size_t i = 0; i < sampled.size(); ++i)
            for (std::size_t j = i + 1; j < sampled.size(); ++j) {
                const auto &a = sampled[i], &b = sampled[j];
                const Tube &tube_a = rods.tubes[a.tube], &tube_b = rods.tubes[b.tube];
                const auto key = std::tuple(a.tube, b.tube, a.element, b.element);
                const bool is_found = std::ranges::binary_search(pairs, key, {}, elements);
                const double radii = tube_a.radius + tube_b.radius,
                             apart = sampled_distance(a, b) - radii - options.margin;
                INFO("seed " << seed << ", tubes " << a.tube << " and " << b.tube << ", elements "
                             << a.element << " and " << b.element << ", " << apart);
                if (excluded(tube_a, a, b, options.self_exclusion)) {
                    REQUIRE_FALSE(is_found);
                } else if (apart <= 0) {
                    REQUIRE(is_found);
                    ++needed;
                    self += a.tube == b.tube;
                } else if (apart > 0.25 * radii + 0.5 * (a.step + b.step)) {
                    REQUIRE_FALSE(is_found); // a search may not give just everything
                }
            }
    }
    CHECK(needed > 1000); // the tangles are tangles
    CHECK(self > 30);
    CHECK(found < 1.6 * needed);
}

TEST_CASE("places of pairs belong to them, and are as far apart as they say", "[close_pairs]") {
    const Rods rods = tangle(7);
    for (const auto& p : close_pairs(rods.tubes, rods.q, {0.5, 3})) {
        const Tube &a = rods.tubes[p.tube_a], &b = rods.tubes[p.tube_b];
        CHECK(std::pair(p.tube_a, p.element_a) < std::pair(p.tube_b, p.element_b));
        CHECK((p.s_a >= p.element_a && p.s_a <= p.element_a + 1));
        CHECK((p.s_b >= p.element_b && p.s_b <= p.element_b + 1));
        const double apart = (position(a, rods.q, p.s_a) - position(b, rods.q, p.s_b)).norm();
        CHECK(std::abs(apart - p.distance) < 0.11 * (a.radius + b.radius));
    }
}

TEST_CASE("two points of different tubes within reach are in some pair", "[close_pairs]") {
    Rods rods;
    rods.add_straight(cable, 9, 0.4, {-4, 0, 0}, {5, 0, 0});
    rods.add_straight(cable, 7, 0.3, {0, -3, 0.8}, {1, 4, 1.0});
    const SearchOptions options{0.5, 4};
    const auto pairs = close_pairs(rods.tubes, rods.q, options);
    for (double s_a = 0.01; s_a < 9; s_a += 0.05)
        for (double s_b = 0.01; s_b < 7; s_b += 0.05) {
            const Vec3 x_a = position(rods.tubes[0], rods.q, s_a);
            const Vec3 x_b = position(rods.tubes[1], rods.q, s_b);
            if ((x_a - x_b).norm() > 0.4 + 0.3 + 0.5)
                continue;
            bool found = false;
            for (const auto& p : pairs)
                found |=
                    p.element_a == static_cast<int>(s_a) && p.element_b == static_cast<int>(s_b);
            CHECK(found);
        }
}

TEST_CASE("one tube meets itself, but not where it merely goes on", "[close_pairs]") {
    Rods rods; // a ring that overlaps itself by an eighth of a turn, one diameter aside
    rods.add(cable, 36, 0.5, [](double u) {
        const double angle = u * 2.25 * std::numbers::pi;
        return Vec3(6 * std::cos(angle), 6 * std::sin(angle), u);
    });
    const auto pairs = close_pairs(rods.tubes, rods.q, {0.2, 4});
    REQUIRE_FALSE(pairs.empty());
    for (const auto& p : pairs)
        CHECK(p.element_b - p.element_a > 30);

    Rods straight;
    straight.add_straight(cable, 40, 1.0, {0, 0, 0}, {20, 0, 0});
    CHECK(close_pairs(straight.tubes, straight.q, {0.5, 4}).empty());
}

TEST_CASE("tubes that nothing is near make no pairs", "[close_pairs]") {
    Rods rods;
    CHECK(close_pairs(rods.tubes, rods.q, {}).empty());
    rods.add_straight(cable, 5, 0.5, {0, 0, 0}, {5, 0, 0});
    rods.add_straight(cable, 5, 0.5, {0, 0, 9}, {5, 0, 9});
    CHECK(close_pairs(rods.tubes, rods.q, {}).empty());
}

TEST_CASE("any number of threads finds the same pairs", "[close_pairs]") {
    const Rods rods = tangle(7);
    const auto list = [&](int num_threads) {
        std::vector<decltype(fields({}))> out;
        for (const auto& pair : close_pairs(rods.tubes, rods.q, {1.0, 2.0}, num_threads))
            out.push_back(fields(pair));
        return out;
    };
    CHECK(list(1).size() > 1);
    CHECK(list(2) == list(1));
    CHECK(list(9) == list(1));
}

TEST_CASE("a thick coarse core beside fine yarns costs little more than what touches",
          "[close_pairs]") {
    constexpr int num_yarns = 24, num_elements = 200;
    const Vec3 along = Vec3(1, 1, 1).normalized(), across = along.unitOrthogonal();
    const auto arc = [&](double u) -> Vec3 { // 160 mm askew to the axes, bent by 1.6 radians
        return 100 * (std::sin(1.6 * u) * along + (1 - std::cos(1.6 * u)) * across);
    };
    Rods rods;
    rods.add(quadratic_beam, 4, 5, arc);
    for (int yarn = 0; yarn < num_yarns; ++yarn)
        rods.add(yarn % 2 ? smooth_cable : quadratic_cable, num_elements, 0.2, [&](double u) {
            const Vec3 tangent = std::cos(1.6 * u) * along + std::sin(1.6 * u) * across;
            const Vec3 up = along.cross(across), side = up.cross(tangent);
            const double angle = 2 * std::numbers::pi * yarn / num_yarns + 9 * u;
            return Vec3(arc(u) + 5.2 * (std::cos(angle) * side + std::sin(angle) * up));
        });
    SearchCost cost;
    const auto pairs = close_pairs(rods.tubes, rods.q, {0.1, 1e9}, 1, &cost);
    std::vector<int> with_core(num_yarns + 1);
    for (const auto& p : pairs)
        if (p.tube_a == 0)
            ++with_core[static_cast<std::size_t>(p.tube_b)];
    CHECK(*std::min_element(with_core.begin() + 1, with_core.end()) >= num_elements);
    // All against all would be 11.5 million pairs.
    const double n = num_yarns * num_elements;
    INFO(pairs.size() << " pairs, " << cost.chords << " chords, " << cost.boxes << " boxes");
    CHECK(static_cast<double>(cost.chords) < 3 * static_cast<double>(pairs.size()));
    CHECK(static_cast<double>(cost.boxes) < 10 * n * std::log2(n));
}

TEST_CASE("unknowns that are no numbers are refused, and so are those far out", "[close_pairs]") {
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e200}) {
        Rods rods = tangle(3);
        rods.q[10] = bad;
        CHECK_THROWS_AS(close_pairs(rods.tubes, rods.q, {}), std::invalid_argument);
    }
    Rods rods = tangle(3);
    for (const double large : {1e9, 1e20, 9e29}) { // far from all others, but a place
        rods.q[10] = large;
        CHECK_NOTHROW(close_pairs(rods.tubes, rods.q, {}));
    }
}
