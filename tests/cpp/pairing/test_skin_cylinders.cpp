#include "support/skin_contacts.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace braidx;
using namespace braidx::test;

TEST_CASE("points at a wall do not see the far one through it", "[skin_pairing]") {
    const auto at = [](double degrees, double radius) -> Vec3 {
        const double angle = degrees * std::numbers::pi / 180;
        return {radius * std::cos(angle), radius * std::sin(angle), 1.5};
    };
    for (const double radius : {0.85, 0.93}) { // inside of the facet at 0.924, and outside
        Rods rods;
        add_cylinder(rods, FacetKind::square4, {8, 3}, {0, 0, 0}, 1, 3);
        // With it places on skins matter up to 1.5 away.
        rods.add_straight(cable, 1, 1.0, {9, 0, 0}, {9, 0, 3});
        // Its normal is nearly square to that of the wall, and opposite to that of one beyond.
        const Vec3 side = 0.02 * at(118.2 - 90, 1) - Vec3(0, 0, 0.03);
        add_rectangle(rods, FacetKind::square4, {1, 1}, at(22.5, radius), {0, 0, 0.02}, side);
        CHECK(Vec3::UnitZ().cross(side).dot(at(118.2, 1)) > 0);
        CHECK(pair_up(rods).empty());
    }
    // Beyond the oblique end of a cylinder at its near wall, which it faces, not yet at the far
    // one.
    Rods rods;
    const auto oblique = [&](double u, double v) -> Vec3 {
        Vec3 x = at(360 * u, 1);
        x[2] = v * (3 - 0.05 * x.dot(at(22.5, 1).cwiseProduct(Vec3(1, 1, 0))));
        return x;
    };
    add_patch(rods, FacetKind::square4, {8, 3}, oblique);
    rods.add_straight(cable, 1, 1.0, {9, 0, 0}, {9, 0, 3});
    Vec3 beyond = at(22.5, 0.8), side = 0.004 * at(22.5 + 90, 1);
    beyond[2] = 2.962, side[2] = 0;
    add_rectangle(rods, FacetKind::square4, {1, 1}, beyond, {0, 0, 0.004}, side);
    CHECK(Vec3::UnitZ().cross(side).dot(at(22.5, 1)) < 0);
    CHECK(pair_up(rods).empty());
}

TEST_CASE("concentric cylinders meet all around", "[skin_pairing]") {
    Rods rods;
    add_cylinder(rods, FacetKind::square9, {24, 3}, {0, 0, 0}, 2, 3);
    const auto hollow = [](double u, double v) -> Vec3 { // seen from inside
        const double angle = -2 * std::numbers::pi * u + 0.1;
        return {2.05 * std::cos(angle), 2.05 * std::sin(angle), 3 * v};
    };
    add_patch(rods, FacetKind::square9, {20, 4}, hollow);
    const auto elements = pair_up(rods);
    CHECK(std::ssize(elements) == rods.skins[0].num_points() + rods.skins[1].num_points());
    for (const auto& e : elements)
        CHECK(std::abs(gap(rods, e) - 0.05) < 2e-3);
}

TEST_CASE("coarse facets meet at the distance of the smooth surfaces", "[skin_pairing]") {
    Rods rods; // facets miss their circles by up to 0.1
    const Vec3 centre[] = {{0, 0, 0}, {4.05, 0.3, 0}};
    add_cylinder(rods, FacetKind::square4, {12, 3}, centre[0], 2, 3);
    add_cylinder(rods, FacetKind::square4, {10, 3}, centre[1], 2, 3);
    // What the parabola over the middle of a facet misses the circle of radius 2 by.
    const auto missed = [](int facets) {
        return std::pow(1 - std::cos(std::numbers::pi / facets), 2);
    };
    const double angle = 11 * std::numbers::pi / 12; // the middle of a facet
    const Vec3 beside(2.55 * std::cos(angle), 2.55 * std::sin(angle), 0);
    rods.add_straight(cable, 6, 0.5, beside, beside + 3 * Vec3::UnitZ());
    int points = 0, stations = 0;
    for (const auto& e : pair_up(rods)) {
        if (e.facet_a < 0) {
            CHECK(std::abs(gap(rods, e) - missed(12) - 0.05) < 1e-5);
            ++stations;
            continue;
        }
        const auto of_a = static_cast<std::size_t>(e.surface_a - 1);
        const Skin& skin = rods.skins[of_a];
        Vec3 out = combined(skin, rods.q, e.facet_a,
                            facet_weights(skin.kind, e.xi_a[0], e.xi_a[1]).value) -
                   centre[of_a];
        out[2] = 0;
        const Vec3 smooth = centre[of_a] + 2 * out.normalized() - centre[1 - of_a];
        const double exact = smooth.head<2>().norm() - 2;
        if (exact > 0.3) // seen at an angle from a facet that is about as long
            continue;
        CHECK(std::abs(gap(rods, e) - exact) < missed(12) + missed(10));
        ++points;
    }
    CHECK((points > 15 && stations > 2));
}
