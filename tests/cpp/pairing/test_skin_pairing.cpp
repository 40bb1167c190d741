#include "assembly/memory.h"
#include "support/skin_contacts.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace braidx;
using namespace braidx::test;

namespace {

double total_weight(const ContactElements& elements, std::int32_t a, std::int32_t b) {
    double sum = 0;
    for (const auto& e : elements)
        if (e.surface_a == a && e.surface_b == b)
            sum += e.weight;
    return sum;
}

void check_same(const ContactElements& found, const ContactElements& expected) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto &f = found[i], &e = expected[i];
        CHECK((f.surface_a == e.surface_a && f.surface_b == e.surface_b));
        CHECK((f.station == e.station && f.facet_b == e.facet_b && f.zone == e.zone));
        CHECK((f.normal == e.normal && f.weight == e.weight && f.stiffness == e.stiffness));
    }
}

/// Options for which only these pairs of bodies may touch.
PairingOptions only(int num_bodies, const std::vector<std::pair<int, int>>& pairs) {
    PairingOptions out;
    out.num_bodies = num_bodies;
    out.may_touch.assign(static_cast<std::size_t>(num_bodies * num_bodies), 0);
    for (const auto& [a, b] : pairs)
        out.may_touch[static_cast<std::size_t>(a * num_bodies + b)] =
            out.may_touch[static_cast<std::size_t>(b * num_bodies + a)] = 1;
    return out;
}

} // namespace

TEST_CASE("points of two skins share the area, the denser ones with more of it", "[skin_pairing]") {
    for (const int finer : {1, 2, 3}) {
        Rods rods;
        add_rectangle(rods, FacetKind::square9, {2, 2}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
        add_rectangle(rods, FacetKind::square9, {2 * finer, 2 * finer}, {0, 0, -0.01}, {0, 2, 0},
                      {2, 0, 0});
        const auto elements = pair_up(rods);
        const double ratio = std::pow(finer, 4); // squares of the areas per point
        CHECK(std::abs(total_weight(elements, 0, 1) - 4 / (1 + ratio)) < 1e-12);
        CHECK(std::abs(total_weight(elements, 1, 0) - 4 * ratio / (1 + ratio)) < 1e-12);
    }
}

TEST_CASE("all points of two sheets that face each other meet", "[skin_pairing]") {
    for (const auto below : all_facets)
        for (const auto above : all_facets) {
            const Rods rods = two_sheets(below, above);
            const auto elements = pair_up(rods);
            // All of the upper sheet; the lower one reaches further, and its points beside the
            // upper one are left out.
            CHECK(std::ranges::count(elements, 1, &ContactElement::surface_a) ==
                  rods.skins[1].num_points());
            CHECK(std::ranges::count(elements, 0, &ContactElement::surface_a) <
                  rods.skins[0].num_points());
            CHECK(std::abs(total_weight(elements, 0, 1) + total_weight(elements, 1, 0) - 3) < 0.6);
            for (const auto& e : elements) {
                CHECK((e.zone == 0 && e.stiffness == PairingOptions{}.area_stiffness));
                CHECK((e.normal - (e.surface_a == 0 ? 1 : -1) * Vec3::UnitZ()).norm() < 1e-12);
                CHECK(std::abs(gap(rods, e) + 0.02) < 1e-12);
                CHECK(e.body_b == e.surface_b);
            }
        }
}

TEST_CASE("points see no surface from behind, beside or beyond the margin", "[skin_pairing]") {
    const auto kind = FacetKind::square4;
    Rods far, behind, beside, box;
    add_rectangle(far, kind, {2, 2}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    behind = beside = far;
    add_rectangle(far, kind, {2, 2}, {0, 0, 0.6}, {0, 2, 0}, {2, 0, 0});
    CHECK(pair_up(far).empty()); // the margin is 0.5
    add_rectangle(behind, kind, {2, 2}, {0, 0, -0.1}, {2, 0, 0}, {0, 2, 0});
    CHECK(pair_up(behind).empty());
    add_rectangle(beside, kind, {2, 2}, {2.1, 0, 0.01}, {0, 2, 0}, {2, 0, 0});
    CHECK(pair_up(beside).empty());
    // A thin plate deep in a thick one: only the sides that face each other meet.
    add_box(box, kind, 2, {0, 0, 0}, {2, 2, 1});
    add_box(box, kind, 2, {0.1, 0.1, 0.95}, {1.9, 1.9, 1.15}, 0.1);
    const auto elements = pair_up(box);
    CHECK_FALSE(elements.empty());
    for (const auto& e : elements) {
        CHECK(std::abs(std::abs(e.normal[2]) - 1) < 1e-12);
        CHECK(std::abs(gap(box, e) + 0.05) < 1e-12);
    }
}

TEST_CASE("a tube on a sheet touches below its centre line", "[skin_pairing]") {
    for (const auto& kind : all_kinds)
        for (const auto facets : all_facets) {
            const Rods rods = tube_on_sheet(kind, facets);
            const auto elements = pair_up(rods);
            CHECK(std::abs(total_weight(elements, 0, 1) - rods.tubes[0].length()) < 1e-12);
            CHECK(std::ssize(elements) == 3); // 2.4 mm, one per mm at least; none from the sheet
            for (const auto& e : elements) {
                CHECK((e.facet_a == -1 && e.facet_b >= 0 && e.follows == 0));
                CHECK((e.normal + Vec3::UnitZ()).norm() < 1e-12);
                CHECK(std::abs(gap(rods, e) + 0.02) < 1e-9);
                CHECK(e.stiffness == PairingOptions{}.stiffness);
                // Particles of beams are on the sheet, 0.02 mm inside the tube of radius 0.5 mm.
                const double facing = std::hypot(e.xi_a[0], e.xi_a[1]);
                CHECK(std::abs(facing - (kind.block == 9 ? 0.48 : 0)) < 1e-12);
            }
        }
}

TEST_CASE("a tube rolls over the edge of a box without a jump of its normal", "[skin_pairing]") {
    Rods rods;
    add_box(rods, FacetKind::square4, 2, {0, -2, -1}, {1, 2, 0});
    const std::vector<double> box = rods.q;
    Vec3 last = -Vec3::UnitZ();
    for (int step = 0; step <= 90; ++step) {
        const double angle = step * std::numbers::pi / 180;
        const Vec3 centre(1 + 0.49 * std::sin(angle), 0, 0.49 * std::cos(angle));
        Rods now;
        now.skins = rods.skins;
        now.q = box;
        now.add_straight(cable, 1, 0.5, centre - 0.4 * Vec3::UnitY(), centre + 0.4 * Vec3::UnitY());
        const auto elements = pair_up(now);
        REQUIRE(elements.size() == 1);
        CHECK(std::abs(gap(now, elements[0]) + 0.01) < 1e-9);
        CHECK((elements[0].normal - last).norm() < 0.02);
        last = elements[0].normal;
    }
    CHECK((last + Vec3::UnitX()).norm() < 0.01);
}

TEST_CASE("the surface goes round an edge without a jump where it is off the nodes of one side",
          "[skin_pairing]") {
    Rods box;
    add_box(box, FacetKind::square4, 2, {0, -2, -1}, {1, 2, 0});
    auto& skin = box.skins[0];
    const double below = 0.01;
    for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet) {
        const auto weights = facet_weights(skin.kind, 0.5, 0.5);
        const bool is_top = combined(skin, box.q, facet, weights.value)[2] > -1e-9;
        skin.offset.push_back(is_top ? -below : 0);
    }
    const Vec3 edge(1, 0, -below); // where the surface of the top, lower than its nodes, ends
    for (int step = 0; step <= 90; ++step) {
        const double angle = step * std::numbers::pi / 180;
        const Vec3 centre = edge + 0.49 * Vec3(std::sin(angle), 0, std::cos(angle));
        Rods now{{}, box.q, box.skins};
        now.add_straight(cable, 1, 0.5, centre - 0.4 * Vec3::UnitY(), centre + 0.4 * Vec3::UnitY());
        const auto elements = pair_up(now);
        REQUIRE(elements.size() == 1);
        // 0.01 deep but for the square of the angle between the ways to both edges, 0.01 / 0.49.
        CHECK(std::abs(gap(now, elements[0]) + 0.01) < 1.1e-4);
    }
}

TEST_CASE("points slide off a face without a jump, none counts beside it", "[skin_pairing]") {
    for (const auto kind : all_facets) {
        Rods rods;
        add_box(rods, kind, 2, {0, 0, -1}, {2, 2, 0});
        const auto first = rods.q.size();
        add_box(rods, kind, 2, {0, 0, -0.01}, {2, 2, 1});
        const auto pressed_area = [&](double along) {
            Rods now = rods;
            for (auto i = first; i < now.q.size(); i += 3)
                now.q[i] += along;
            double area = 0;
            for (const auto& e : pair_up(now))
                if (std::abs(e.normal[2]) > 0.5) {
                    CHECK(std::abs(gap(now, e) + 0.01) < 1e-12);
                    area += e.weight;
                }
            return area;
        };
        CHECK(std::abs(pressed_area(0) - 4) < 1e-12);
        // Changes halve with the step: no jump is left. Half a facet will do.
        double largest[2] = {0, 0};
        for (const int finer : {1, 2}) {
            const double step = 0.008 / finer;
            for (double x = 0, before = pressed_area(0); x < 0.55; x += step) {
                const double area = pressed_area(x + step);
                largest[finer - 1] = std::max(largest[finer - 1], std::abs(area - before));
                before = area;
            }
        }
        CHECK(largest[1] < 0.55 * largest[0]);
        CHECK(std::abs(pressed_area(0.6) - 2.8) < 0.4);
        CHECK(pressed_area(2) == 0);
    }
}

TEST_CASE("a tube whose centre is in the solid is pushed out", "[skin_pairing]") {
    Rods rods = tube_on_sheet(cable, FacetKind::square9, 0.6); // radius 0.5
    const auto elements = pair_up(rods);
    CHECK(elements.size() == 3);
    for (const auto& e : elements) {
        CHECK((e.normal + Vec3::UnitZ()).norm() < 1e-12);
        CHECK(std::abs(gap(rods, e) + 0.6) < 1e-9);
    }
}

TEST_CASE("points of a skin meet a rigid surface that they face", "[skin_pairing]") {
    Rods rods;
    add_box(rods, FacetKind::square9, 2, {0, 0, 0}, {2, 3, 1});
    const Rigid floor{Plane{{0, 0, 0.01}, Vec3::UnitZ()}, 1};
    const auto elements = pair_up(rods, {}, {}, {floor});
    CHECK(std::abs(total_weight(elements, 0, -1) - 6) < 1e-12); // and none of the other sides
    for (const auto& e : elements) {
        CHECK((e.normal + Vec3::UnitZ()).norm() < 1e-12);
        CHECK(std::abs(gap(rods, e) + 0.01) < 1e-12);
        CHECK(e.body_b == 1);
    }
}

TEST_CASE("groups and bodies that may not touch stay apart", "[skin_pairing]") {
    Rods rods = tube_on_sheet(smooth_beam, FacetKind::square4);
    rods.add_straight(cable, 4, 0.5, {1.5, -1, 1.4}, {1.5, 3, 1.4});
    rods.tubes.back().body = 1;
    rods.tubes.back().first_unknown = static_cast<std::int64_t>(rods.q.size()) - 15;
    rods.skins[0].body = 2;
    const Rigid floor{Plane{{0, 0, 0.1}, -Vec3::UnitZ()}, 3};
    const auto met = [&](const PairingOptions& options) {
        std::vector<bool> out(3);
        for (const auto& e : pair_up(rods, {}, options, {floor}))
            out[e.surface_b < 0 ? 2 : e.surface_b == 1 ? 1 : 0] = true;
        return out; // tube on sheet, tube on tube, on the plane
    };
    CHECK(met({}) == std::vector{true, true, true});
    CHECK(met(only(4, {{0, 1}})) == std::vector{false, true, false});
    CHECK(met(only(4, {{0, 2}, {2, 3}})) == std::vector{true, false, true});
    rods.tubes[0].group = rods.tubes[1].group = 3;
    CHECK(met({}) == std::vector{true, false, true});
    rods.tubes[1].group = 4;
    rods.skins[0].group = 3;
    CHECK(met({}) == std::vector{false, true, true});
}

TEST_CASE("memory of skins goes on through an update, also onto another facet", "[skin_pairing]") {
    Contact contact = contact_on(two_sheets(FacetKind::square4, FacetKind::square9), 0.3, 0, {}, 0);
    for (auto& e : contact.elements)
        e.slip.setZero();
    const auto first_of_b = static_cast<std::size_t>(contact.rods.skins[1].unknown[0]);
    for (auto i = first_of_b; i < contact.rods.q.size(); i += 3)
        contact.rods.q[i] += 0.3;
    const auto surfaces = contact.rods.surfaces();
    const auto done =
        commit(surfaces, contact.elements, contact.rods.q, contact.start, contact.laws);
    CHECK(done.work > 0);
    scale_stiffness(contact.elements, 3);
    const auto fresh = pair_up(contact.rods, contact.elements);
    int others = 0, known = 0;
    for (const auto& e : fresh) {
        CHECK(std::abs(e.stiffness - 3000) < 1e-9); // shared by the zone, also by new points
        for (const auto& old : contact.elements)
            if (old.surface_a == e.surface_a && old.station == e.station) {
                ++known;
                others += old.facet_b != e.facet_b;
                CHECK(e.work == old.work);
                CHECK((e.slip - old.slip).norm() < 1e-15);
            }
    }
    CHECK((known > 20 && others > 5));
    const auto logs = sum_log_stiffness(fresh, true);
    CHECK(std::abs(std::exp(logs.sum / static_cast<double>(logs.count)) - 3000) < 1e-6);
    CHECK(sum_log_stiffness(fresh, false).count == 0);
}

TEST_CASE("contact elements of skins are the same for any number of threads and parts",
          "[skin_pairing]") {
    Random random(5);
    Rods rods = tube_on_sheet(smooth_beam, FacetKind::square9);
    add_rectangle(rods, FacetKind::triangle3, {2, 2}, {0.4, 0.3, -0.02}, {0, 1.5, 0}, {2, 0, 0});
    add_box(rods, FacetKind::square4, 2, {0, 0, 0.9}, {2, 2, 2});
    rods.shake(random, 0.01);
    const std::vector<Rigid> walls = {{Plane{{0, 0, 1.9}, -Vec3::UnitZ()}, 4}};
    const auto expected = pair_up(rods, {}, {}, walls);
    CHECK(expected.back().zone ==
          4); // sheets, tube on sheet, tube below the box, tube, box at wall
    for (const int threads : {2, 7}) {
        PairingOptions options;
        options.num_threads = threads;
        check_same(pair_up(rods, {}, options, walls), expected);
    }
    std::size_t count = 0;
    for (int part = 0; part < 3; ++part) {
        PairingOptions options;
        options.part = part;
        options.num_parts = 3;
        count += pair_up(rods, {}, options, walls).size();
    }
    CHECK(count == expected.size());
}
