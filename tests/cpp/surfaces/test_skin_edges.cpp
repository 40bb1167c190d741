#include "support/patches.h"
#include "surfaces/skin_edges.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace braidx;
using namespace braidx::test;

namespace {

Vec3 position_at(const Rods& rods, const FacetPoint& at) {
    const Skin& skin = rods.skins[0];
    return combined(skin, rods.q, at.facet, facet_weights(skin.kind, at.u, at.v).value);
}

/// Distance from the nearest edge of the face of a cube of edge 2 that a place is on.
double distance_to_edges(const Vec3& x) {
    Vec3 inside = Vec3::Ones() - (x - Vec3::Ones()).cwiseAbs();
    std::ranges::sort(inside);
    return inside[1]; // the smallest one is 0, of the face itself
}

} // namespace

TEST_CASE("shares of points fall to nothing at sharp edges, and are one elsewhere",
          "[skin_edges]") {
    for (const auto kind : all_facets) {
        Rods rods;
        add_box(rods, kind, 2, {0, 0, 0}, {2, 2, 2}); // facets of 1 mm
        const Skin& skin = rods.skins[0];
        for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet)
            for (int i = 0; i <= 40; ++i)
                for (int j = 0; j <= (is_triangle(kind) ? 40 - i : 40); ++j) {
                    const FacetPoint at{facet, i / 40.0, j / 40.0};
                    const double distance = distance_to_edges(position_at(rods, at)),
                                 share = share_inside_edges(skin, at);
                    // Exact on squares; triangles measure vertices along their other edges.
                    const double expected = std::min(1.0, distance / 0.05);
                    CHECK(share >= expected - 1e-9);
                    if (!is_triangle(kind) || distance < 1e-9 || distance > 0.05)
                        CHECK(std::abs(share - expected) < 1e-9);
                }
    }
}

TEST_CASE("shares are the same from both facets at an edge between them", "[skin_edges]") {
    for (const auto kind : all_facets) {
        Rods rods;
        add_box(rods, kind, 3, {0, 0, 0}, {1, 1, 1});
        const Skin& skin = rods.skins[0];
        std::vector<std::pair<Vec3, double>> places;
        const auto outline = facet_outline(kind);
        for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet)
            for (std::size_t edge = 0; edge < outline.size(); ++edge)
                for (const double t : {0.02, 0.04, 0.3, 0.7, 0.96, 0.98}) {
                    const auto from = facet_node(kind, outline[edge]),
                               to = facet_node(kind, outline[(edge + 1) % outline.size()]);
                    const FacetPoint at{facet, from[0] + t * (to[0] - from[0]),
                                        from[1] + t * (to[1] - from[1])};
                    places.emplace_back(position_at(rods, at), share_inside_edges(skin, at));
                }
        int met = 0;
        for (const auto& [x, share] : places)
            for (const auto& [y, other] : places)
                if (&share != &other && (x - y).norm() < 1e-9) {
                    CHECK(std::abs(share - other) < 1e-9);
                    ++met;
                }
        CHECK(met > 100);
    }
}

TEST_CASE("edges that bend inward, smooth ones and rims take no share", "[skin_edges]") {
    Rods rods;
    add_rectangle(rods, FacetKind::square4, {2, 2}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    add_patch(rods, FacetKind::square4, {1, 2}, [](double u, double v) { // an inner corner
        return v < 0.5 ? Vec3(2 * v, 1 - u, 0) : Vec3(1, 1 - u, 2 * v - 1);
    });
    for (const auto& skin : rods.skins)
        for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet)
            for (const double v : {0.0, 0.01, 0.5, 1.0})
                CHECK(share_inside_edges(skin, {facet, 0.5, v}) == 1);
}
