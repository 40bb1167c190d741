#include "support/patches.h"
#include "surfaces/facet_projection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <limits>
#include <numeric>
#include <set>

using namespace braidx;
using namespace braidx::test;

namespace {

Vec3 normal_at(const Skin& skin, const std::vector<Vec3>& nodal, const FacetPoint& at) {
    return smooth_normal(skin, nodal, at.facet, facet_weights(skin.kind, at.u, at.v));
}

Vec3 position_at(const Skin& skin, Unknowns q, const FacetPoint& at) {
    return combined(skin, q, at.facet, facet_weights(skin.kind, at.u, at.v).value);
}

double total_area(const Skin& skin) {
    return std::accumulate(skin.area.begin(), skin.area.end(), 0.0);
}

/// Least distance to a fine sample of a facet.
double sampled_distance(const Skin& skin, Unknowns q, std::int32_t facet, const Vec3& x) {
    constexpr int steps = 60;
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= (is_triangle(skin.kind) ? steps - i : steps); ++j)
            best = std::min(
                best,
                (position_at(skin, q, {facet, double(i) / steps, double(j) / steps}) - x).norm());
    return best;
}

} // namespace

TEST_CASE("contact areas are those of the surface at rest", "[skin]") {
    for (const auto kind : all_facets) {
        Rods box, tube;
        add_box(box, kind, 3, {0, 0, 0}, {2, 3, 1});
        CHECK(std::abs(total_area(box.skins[0]) - 22) < 1e-12);
        add_cylinder(tube, kind, {48, 4}, {0, 0, 0}, 2, 3);
        const double exact = 2 * 3.14159265358979 * 2 * 3;
        CHECK(std::abs(total_area(tube.skins[0]) / exact - 1) <
              (facet_degree(kind) == 1 ? 1e-3 : 1e-5));
        const auto stretched = tube.q;
        for (auto& value : tube.q)
            value *= 2;
        CHECK(tube.skins[0].area ==
              make_skin(kind, tube.skins[0].unknown, 0, 2, -1, stretched).area);
    }
}

TEST_CASE("derivatives of a facet's positions are those of finite differences", "[skin]") {
    Random random(3);
    for (const auto kind : all_facets) {
        Rods rods;
        add_cylinder(rods, kind, {6, 2}, {0, 0, 0}, 2, 3);
        rods.shake(random, 0.1);
        const Skin& skin = rods.skins[0];
        constexpr double h = 1e-6, u = 0.3, v = 0.4;
        const auto g = facet_geometry(skin, rods.q, 3, facet_weights(kind, u, v));
        const Vec3 along_u =
            position_at(skin, rods.q, {3, u + h, v}) - position_at(skin, rods.q, {3, u - h, v});
        const Vec3 along_v =
            position_at(skin, rods.q, {3, u, v + h}) - position_at(skin, rods.q, {3, u, v - h});
        CHECK((along_u / (2 * h) - g.du).norm() < 1e-8);
        CHECK((along_v / (2 * h) - g.dv).norm() < 1e-8);
        CHECK(g.area().dot(along_u.cross(along_v)) > 0);
    }
}

TEST_CASE("normals point out of the solid, and are continuous across smooth edges", "[skin]") {
    for (const auto kind : all_facets) {
        Rods rods;
        add_cylinder(rods, kind, {12, 3}, {0, 0, 0}, 2, 3); // facets meet at 30 degrees
        const Skin& skin = rods.skins[0];
        CHECK(skin.num_normals == static_cast<std::int32_t>(rods.q.size() / 3));
        const auto nodal = nodal_normals(skin, rods.q);
        for (std::int64_t k = 0; k < skin.num_points(); ++k) {
            const auto at = contact_point(skin, k);
            Vec3 radial = position_at(skin, rods.q, at);
            radial[2] = 0;
            CHECK(normal_at(skin, nodal, at).dot(radial.normalized()) > 0.99);
        }
        if (is_triangle(kind))
            continue;
        for (const double v : {0.1, 0.5, 0.8}) { // the next facet around begins where this ends
            const Vec3 here = normal_at(skin, nodal, {4, 1, v}),
                       there = normal_at(skin, nodal, {5, 0, v});
            CHECK((here - there).norm() < 1e-14);
        }
    }
}

TEST_CASE("flat facets stand for the smooth surface through their nodes", "[skin]") {
    const auto height = [](const Skin& skin, const FacetPoint& at) {
        return rise(skin, at.facet, facet_weights(skin.kind, at.u, at.v));
    };
    for (const auto kind : {FacetKind::triangle3, FacetKind::square4}) {
        Rods rods;
        add_cylinder(rods, kind, {12, 3}, {0, 0, 0}, 2, 3);
        const Skin& skin = rods.skins[0];
        const auto nodal = nodal_normals(skin, rods.q);
        for (std::int64_t k = 0; k < skin.num_points(); ++k) {
            const auto at = contact_point(skin, k);
            const Vec3 facet = position_at(skin, rods.q, at),
                       smooth = facet + height(skin, at) * normal_at(skin, nodal, at);
            const double sag = 2 - facet.head<2>().norm(), missed = smooth.head<2>().norm() - 2;
            CHECK(sag > 0.02);
            // Nodes of triangles at the rim have normals of unequal facets.
            CHECK(std::abs(missed) < (is_triangle(kind) ? 0.15 : 0.03) * sag);
        }
        for (int node = 0; node < skin.nodes_per_facet(); ++node) {
            const auto [u, v] = facet_node(kind, node);
            CHECK(std::abs(height(skin, {5, u, v})) < 1e-15);
        }
    }
}

TEST_CASE("a skin's offset lifts its surface everywhere, plane or of degree 2", "[skin]") {
    for (const auto kind : all_facets) {
        Rods rods;
        add_rectangle(rods, kind, {2, 2}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
        Skin& skin = rods.skins[0];
        skin.offset.assign(static_cast<std::size_t>(skin.num_facets()), -0.07);
        for (std::int64_t k = 0; k < skin.num_points(); ++k) {
            const auto at = contact_point(skin, k);
            const auto weights = facet_weights(kind, at.u, at.v);
            CHECK(std::abs(rise(skin, at.facet, weights) + 0.07) < 1e-15);
        }
    }
}

TEST_CASE("sharp edges have a normal per side", "[skin]") {
    for (const auto kind : all_facets) {
        Rods rods;
        add_box(rods, kind, 2, {0, 0, 0}, {2, 3, 1});
        const Skin& skin = rods.skins[0];
        const auto nodal = nodal_normals(skin, rods.q);
        std::set<int> sides;
        for (std::int64_t k = 0; k < skin.num_points(); ++k) {
            const auto at = contact_point(skin, k);
            const Vec3 normal = normal_at(skin, nodal, at);
            Vec3::Index axis;
            CHECK(std::abs(normal.cwiseAbs().maxCoeff(&axis) - 1) < 1e-14);
            const Vec3 from_centre = position_at(skin, rods.q, at) - Vec3(1, 1.5, 0.5);
            CHECK(normal.dot(from_centre) > 0);
            sides.insert(2 * static_cast<int>(axis) + (normal[axis] > 0));
        }
        CHECK(sides.size() == 6);
    }
}

TEST_CASE("places near an edge may move onto the facets beyond it", "[skin]") {
    const auto within = [](const Skin& skin, const FacetPoint& at) {
        auto facets = facets_within(skin, at, 0.25);
        std::ranges::sort(facets);
        return facets;
    };
    using Facets = std::vector<std::int32_t>;
    for (const auto kind : {FacetKind::square4, FacetKind::square9}) {
        Rods rods; // facets 0 1 2, above them 3 4 5, above them 6 7 8
        add_rectangle(rods, kind, {3, 3}, {0, 0, 0}, {3, 0, 0}, {0, 3, 0});
        const Skin& skin = rods.skins[0];
        CHECK(within(skin, {4, 0.5, 0.5}) == Facets{4});
        CHECK(within(skin, {4, 0.1, 0.5}) == Facets{0, 1, 3, 4, 6, 7});
        CHECK(within(skin, {4, 0.5, 0.9}) == Facets{3, 4, 5, 6, 7, 8});
        CHECK(within(skin, {0, 0.9, 0.5}) == Facets{0, 1, 3, 4});
        CHECK(within(skin, {0, 0.1, 0.1}) == Facets{0, 1, 3}); // the ends of the rim
    }
    Rods rods; // two triangles, which share their longest edge
    add_rectangle(rods, FacetKind::triangle6, {1, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    CHECK(within(rods.skins[0], {0, 0.3, 0.3}) == Facets{0});
    CHECK(within(rods.skins[0], {0, 0.45, 0.45}) == Facets{0, 1});
}

TEST_CASE("the closest point of a facet is nearer than all samples of it", "[skin]") {
    Random random(4);
    for (const auto kind : all_facets) {
        int inside = 0;
        for (int trial = 0; trial < 120; ++trial) {
            Rods rods;
            add_rectangle(rods, kind, {1, 1}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
            rods.shake(random, 0.12);
            const Skin& skin = rods.skins[0];
            const Vec3 x(random.uniform(-0.7, 2.7), random.uniform(-0.7, 2.7),
                         random.uniform(-0.6, 0.6));
            const auto at = closest_on_facet(skin, rods.q, 0, x);
            CHECK((at.u >= 0 && at.v >= 0 && at.u <= 1 && at.v <= 1));
            if (is_triangle(kind))
                CHECK(at.u + at.v <= 1 + 1e-15);
            const double sampled = sampled_distance(skin, rods.q, 0, x),
                         found = (position_at(skin, rods.q, at) - x).norm();
            CHECK(found <= sampled + 1e-12);
            CHECK(found > sampled - 0.05); // no farther from the samples than these from each other
            const auto g = facet_geometry(skin, rods.q, 0, facet_weights(kind, at.u, at.v));
            const Vec3 d = x - g.position;
            if (std::abs(g.du.dot(d)) + std::abs(g.dv.dot(d)) < 1e-11)
                ++inside;
        }
        CHECK((inside > 8 && inside < 100));
    }
}
