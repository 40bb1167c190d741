#include "support/rods.h"

#include <catch2/catch_test_macros.hpp>
#include <map>

using namespace braidx;
using namespace braidx::test;

namespace {

constexpr Kind curve_kinds[] = {cable, smooth_cable, quadratic_cable};

Tube tube_of(const Kind& kind, int num_elements) {
    return {0, num_elements, kind.degree, kind.block, 1.0, 2.0, 0, kind.smooth};
}

std::map<int, double> by_node(const Support& support, const std::array<double, 4>& values) {
    std::map<int, double> out;
    for (int i = 0; i < support.count; ++i)
        out[support.node[i]] += values[i];
    return out;
}

/// Calls check(tube, s) at many places, element ends included.
template <class Check> void everywhere(const Check& check) {
    for (const auto& kind : curve_kinds)
        for (const int n : {1, 2, 3, 7})
            for (int i = 0; i <= 12 * n; ++i) {
                INFO(kind.name << ", " << n << " elements, s = " << i / 12.0);
                check(tube_of(kind, n), i / 12.0);
            }
}

Rods random_curve(const Kind& kind, unsigned seed) {
    Random random(seed);
    Rods rods;
    rods.add_straight(kind, 6, 1.0, {0, 0, 0}, {0, 0, 12});
    rods.shake(random, 0.7);
    return rods;
}

} // namespace

TEST_CASE("weights sum to one, slopes to zero, on nodes of the tube", "[tube]") {
    everywhere([](const Tube& tube, double s) {
        for (const auto& support : {contact_support(tube, s), element_support(tube, s)}) {
            double weight = 0, slope = 0;
            for (int i = 0; i < support.count; ++i) {
                weight += support.weight[i];
                slope += support.slope[i];
                CHECK((support.node[i] >= 0 && support.node[i] < tube.num_nodes()));
            }
            CHECK(std::abs(weight - 1) < 1e-14);
            CHECK(std::abs(slope) < 1e-13);
        }
    });
}

TEST_CASE("slopes are the derivatives of the weights", "[tube]") {
    const double h = 1e-6;
    everywhere([&](const Tube& tube, double s) {
        if (std::abs(s - std::round(s)) < 1e-9)
            return;
        const auto low = contact_support(tube, s - h), high = contact_support(tube, s + h);
        const auto middle = contact_support(tube, s);
        const auto before = by_node(low, low.weight);
        for (const auto& [node, after] : by_node(high, high.weight))
            CHECK(std::abs((after - before.at(node)) / (2 * h) -
                           by_node(middle, middle.slope).at(node)) < 1e-8);
    });
}

TEST_CASE("a curve passes through its nodes", "[tube]") {
    for (const auto& kind : curve_kinds) {
        INFO(kind.name);
        const Rods rods = random_curve(kind, 3);
        for (int i = 0; i < rods.tubes[0].num_nodes(); ++i) {
            const double s = static_cast<double>(i) / kind.degree;
            CHECK((position(rods.tubes[0], rods.q, s) - rods.node(0, i)).norm() < 1e-13);
        }
    }
}

TEST_CASE("a straight rod is reproduced, its tangent is the stretch", "[tube]") {
    for (const auto& kind : curve_kinds)
        for (const int n : {1, 2, 5}) {
            INFO(kind.name << ", " << n << " elements");
            Rods rods;
            rods.add_straight(kind, n, 1.0, {1, 2, 3}, {4, 6, 3});
            rods.tubes[0].element_length /= 1.25; // now 25 % longer than at rest
            for (int i = 0; i <= 10 * n; ++i) {
                const auto at = curve_point(rods.tubes[0], rods.q, i / 10.0);
                CHECK((at.position - Vec3(1 + 0.3 * i / n, 2 + 0.4 * i / n, 3)).norm() < 1e-13);
                CHECK((at.tangent - 1.25 * Vec3(0.6, 0.8, 0)).norm() < 1e-13);
            }
        }
}

TEST_CASE("smooth geometry has no kinks, and tangents of polygons do not jump", "[tube]") {
    const double h = 1e-7;
    for (const auto& kind : {cable, smooth_cable}) {
        const Rods rods = random_curve(kind, 4);
        const auto at = [&](double s) { return curve_point(rods.tubes[0], rods.q, s); };
        for (int node = 1; node < rods.tubes[0].num_elements; ++node) {
            INFO(kind.name << ", node " << node);
            CHECK((at(node - h).position - at(node + h).position).norm() < 1e-5);
            CHECK((at(node - h).tangent - at(node + h).tangent).norm() < 1e-5);
            if (!kind.smooth)
                continue;
            const double scale = h * rods.tubes[0].element_length;
            const Vec3 left = (at(node).position - at(node - h).position) / scale;
            const Vec3 right = (at(node + h).position - at(node).position) / scale;
            CHECK((left - right).norm() < 1e-5);
            CHECK((left - at(node).tangent).norm() < 1e-5);
        }
    }
}

TEST_CASE("a smooth curve of degree 1 is exact on a parabola, to its ends", "[tube]") {
    const auto parabola = [](double t) { return Vec3(t, t * t, 1 - 2 * t * t); };
    Rods rods;
    rods.add(smooth_cable, 8, 1.0, parabola);
    rods.tubes[0].round_ends = true;
    for (double s = 0; s <= 8; s += 0.125) {
        const auto at = curve_point(rods.tubes[0], rods.q, s);
        const double t = s / 8;
        CHECK((at.position - parabola(t)).norm() < 1e-14);
        CHECK((at.tangent * rods.tubes[0].length() - Vec3(1, 2 * t, -4 * t)).norm() < 1e-12);
    }
}

TEST_CASE("a curve of degree 2 is exact on a parabola, to its ends", "[tube]") {
    const auto parabola = [](double t) { return Vec3(t, t * t, 1 - 2 * t * t); };
    Rods rods;
    rods.add(quadratic_cable, 3, 1.0, parabola);
    const Tube& tube = rods.tubes[0];
    for (double s = 0; s <= 3; s += 0.125) {
        const auto at = curve_point(tube, rods.q, s);
        const double t = s / 3;
        CHECK((at.position - parabola(t)).norm() < 1e-14);
        CHECK((at.tangent * tube.length() - Vec3(1, 2 * t, -4 * t)).norm() < 1e-12);
    }
}

TEST_CASE("directors are interpolated by the finite element's own functions", "[tube]") {
    Random random;
    Rods rods;
    rods.add_straight(smooth_beam, 3, 1.0, {0, 0, 0}, {0, 0, 6});
    rods.shake(random, 0.3);
    const Tube& tube = rods.tubes[0];
    for (int which : {1, 2}) {
        const auto at_node = [&](int i) {
            return vector_at(rods.q, tube.unknown_of(i) + 3 * which);
        };
        const Vec3 g = director(tube, rods.q, element_support(tube, 1.25), which);
        CHECK((g - 0.75 * at_node(1) - 0.25 * at_node(2)).norm() < 1e-14);
    }
}

TEST_CASE("a closed tube goes on over its joint", "[tube]") {
    constexpr int num_elements = 6;
    for (const auto& kind : curve_kinds) {
        Rods rods = random_curve(kind, 5);
        Tube tube = rods.tubes[0];
        tube.is_closed = true;
        for (const double s : {-0.3, 0.0, 0.31, 2.7, 5.9}) {
            const auto here = curve_point(tube, rods.q, s),
                       around = curve_point(tube, rods.q, s + num_elements);
            CHECK((here.position - around.position).norm() < 1e-13);
            CHECK((here.tangent - around.tangent).norm() < 1e-13);
            CHECK(std::abs(tube.once_around(s + 3 * num_elements) - tube.once_around(s)) < 1e-13);
            CHECK((tube.once_around(s) >= tube.first() && tube.once_around(s) < tube.end()));
        }
        // The last node counts no more: the first one follows the one before.
        const auto joint = position(tube, rods.q, num_elements);
        CHECK((joint - vector_at(rods.q, tube.unknown_of(0))).norm() < 1e-13);
        CHECK(std::abs(tube.apart(0.5, 5.5) - 1.0) < 1e-13);
    }
}
