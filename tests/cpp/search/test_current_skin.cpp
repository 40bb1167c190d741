#include "search/current_skin.h"
#include "support/patches.h"

#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

constexpr auto anything = [](const SkinPlace&) { return true; };

} // namespace

TEST_CASE("the tree finds the places that a test of every facet finds", "[current_skin]") {
    Random random(1);
    for (const auto kind : all_facets)
        for (const double reach : {0.05, 0.4, 1.5}) {
            Rods rods;
            add_cylinder(rods, kind, {9, 5}, {0, 0, 0}, 1.5, 4);
            rods.shake(random, 0.1);
            const CurrentSkin skin(rods.skins[0], rods.q, reach);
            const auto lower_half = [](const SkinPlace& p) { return p.position[2] < 2; };
            int found = 0;
            for (int i = 0; i < 300; ++i) {
                const Vec3 x = random.vector(2.5) + Vec3(0, 0, 2);
                const auto check = [&](const auto& accept) {
                    const auto fast = skin.closest(x, accept),
                               slow = skin.closest_brute_force(x, accept);
                    REQUIRE(fast.has_value() == slow.has_value());
                    if (!fast)
                        return;
                    ++found;
                    CHECK(fast->at.facet == slow->at.facet);
                    CHECK(fast->position == slow->position);
                    CHECK((fast->position + fast->offset - x).norm() < 1e-14);
                    CHECK(fast->offset.norm() <= reach + 1e-8);
                };
                check(anything);
                check(lower_half);
            }
            CHECK((found > 10 && found < 600));
        }
}

TEST_CASE("no facet holds a nearer place than the one found", "[current_skin]") {
    Random random(2);
    for (const auto kind : all_facets) {
        Rods rods;
        add_box(rods, kind, 2, {0, 0, 0}, {2, 3, 1});
        rods.shake(random, 0.05);
        const Skin& skin = rods.skins[0];
        const CurrentSkin current(skin, rods.q, 2);
        for (int i = 0; i < 100; ++i) {
            const Vec3 x = random.vector(2) + Vec3(1, 1.5, 0.5);
            const auto place = current.closest(x, anything);
            double nearest = 2;
            for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet) {
                const auto at = closest_on_facet(skin, rods.q, facet, x);
                const auto w = facet_weights(skin.kind, at.u, at.v);
                nearest = std::min(nearest, (combined(skin, rods.q, facet, w.value) - x).norm());
            }
            REQUIRE(place.has_value() == (nearest < 2));
            if (place)
                CHECK(std::abs(place->offset.norm() - nearest) < 1e-8);
        }
    }
}

TEST_CASE("boxes hold curved facets", "[current_skin]") {
    Random random(3);
    for (const auto kind : {FacetKind::triangle6, FacetKind::square9})
        for (int trial = 0; trial < 50; ++trial) {
            Rods rods;
            add_rectangle(rods, kind, {1, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
            rods.shake(random, 0.4);
            const CurrentSkin skin(rods.skins[0], rods.q, 0.1);
            for (int i = 0; i < 40; ++i) {
                const double u = random.uniform(0, 1),
                             v = random.uniform(0, is_triangle(kind) ? 1 - u : 1);
                const auto w = facet_weights(kind, u, v);
                CHECK(skin.box().distance_to(combined(rods.skins[0], rods.q, 0, w.value)) == 0);
            }
        }
}

TEST_CASE("at an edge the place belongs to the facet that the point is in front of",
          "[current_skin]") {
    Rods rods;
    add_box(rods, FacetKind::square4, 1, {0, 0, 0}, {1, 1, 1});
    const CurrentSkin skin(rods.skins[0], rods.q, 1);
    const auto above = skin.closest({1.1, 0.4, 1.3}, anything), // off the edge x = 1, z = 1
        beside = skin.closest({1.3, 0.4, 1.1}, anything);
    REQUIRE((above && beside));
    CHECK((above->position - Vec3(1, 0.4, 1)).norm() < 1e-12);
    CHECK((above->normal - Vec3::UnitZ()).norm() < 1e-12);
    CHECK((beside->normal - Vec3::UnitX()).norm() < 1e-12);
    const auto inside = skin.closest({0.5, 0.4, 0.9}, anything);
    REQUIRE(inside);
    CHECK(std::abs(inside->height() + 0.1) < 1e-12);
}
