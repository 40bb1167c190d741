#include "search/close_pairs.h"
#include "support/rods.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <numbers>
#include <tuple>

using namespace braidx;
using namespace braidx::test;

namespace {

auto fields(const ElementPair& p) {
    return std::tuple(p.tube_a, p.tube_b, p.element_a, p.element_b, p.s_a, p.s_b, p.distance);
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

} // namespace

TEST_CASE("the grid finds the pairs that brute force finds", "[close_pairs]") {
    std::size_t found = 0, self = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const Rods rods = tangle(seed);
        const SearchOptions options{0.25 * (seed % 5), 1.0 + seed % 4};
        const auto fast = close_pairs(rods.tubes, rods.q, options);
        const auto slow = close_pairs_brute_force(rods.tubes, rods.q, options);
        INFO("seed " << seed);
        REQUIRE(fast.size() == slow.size());
        for (std::size_t i = 0; i < fast.size(); ++i) {
            REQUIRE(fields(fast[i]) == fields(slow[i]));
            self += fast[i].tube_a == fast[i].tube_b;
        }
        found += fast.size();
    }
    CHECK(found > 1000); // the tangles are tangles
    CHECK(self > 50);
}

TEST_CASE("pairs are ordered and within reach, their places belong to them", "[close_pairs]") {
    const Rods rods = tangle(7);
    const SearchOptions options{0.5, 3};
    for (const auto& p : close_pairs(rods.tubes, rods.q, options)) {
        const Tube &a = rods.tubes[p.tube_a], &b = rods.tubes[p.tube_b];
        CHECK(std::pair(p.tube_a, p.element_a) < std::pair(p.tube_b, p.element_b));
        CHECK(p.distance <= a.radius + b.radius + options.margin);
        CHECK((p.s_a >= p.element_a && p.s_a <= p.element_a + 1));
        CHECK((p.s_b >= p.element_b && p.s_b <= p.element_b + 1));
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
