#include "support/skin_contacts.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

constexpr double stick = 1e-3, slide = 0.2; // motions of the increment, mm; reversible slip is 0.02

/// Contacts of every kind in which skins take part, with friction.
std::vector<Contact> every_kind(double mu, double motion) {
    std::vector<Contact> out;
    const std::pair<FacetKind, FacetKind> sheets[] = {{FacetKind::square4, FacetKind::square4},
                                                      {FacetKind::square9, FacetKind::square9},
                                                      {FacetKind::triangle3, FacetKind::square9},
                                                      {FacetKind::triangle6, FacetKind::square4}};
    for (const auto& [below, above] : sheets)
        out.push_back(contact_on(two_sheets(below, above), mu, motion));
    for (const auto& kind : all_kinds)
        for (const auto facets : {FacetKind::square9, FacetKind::triangle3})
            out.push_back(contact_on(tube_on_sheet(kind, facets), mu, motion));
    for (const auto facets : all_facets)
        out.push_back(contact_on(sheet_for_plane(facets), mu, motion, {plane_above()}));
    return out;
}

void check_equal(const Matrix& found, const Matrix& expected) {
    CHECK(expected.norm() > 1);
    CHECK((found - expected).norm() < 1e-6 * expected.norm());
}

Vec3 force(const Vector& residual, std::int64_t first, std::int64_t end) {
    Vec3 out = Vec3::Zero();
    for (auto i = first; i < end; i += 3)
        out -= residual.segment<3>(i);
    return out;
}

/// Moment about the origin of forces on positions, three unknowns each.
Vec3 moment(const Vector& residual, Unknowns q, std::int64_t first, std::int64_t end) {
    Vec3 out = Vec3::Zero();
    for (auto i = first; i < end; i += 3)
        out -= vector_at(q, i).cross(Vec3(residual.segment<3>(i)));
    return out;
}

} // namespace

TEST_CASE("normal forces on skins are the gradient of their energy", "[skin_assembly]") {
    for (const auto& contact : every_kind(0, stick)) {
        const Vector residual = contact.residual();
        CHECK(residual.norm() > 0.1);
        CHECK((residual - contact.finite_difference_gradient()).norm() < 1e-6 * residual.norm());
        const Matrix tangent = contact.tangent(FrictionTangent::consistent);
        check_equal(tangent, contact.finite_difference_tangent());
        CHECK((tangent - tangent.transpose()).norm() < 1e-13 * tangent.norm());
    }
}

TEST_CASE("the consistent tangent of skins is exact, sticking and sliding", "[skin_assembly]") {
    for (const double motion : {stick, slide})
        for (const auto& contact : every_kind(0.3, motion)) {
            int sliding = 0;
            for (const auto& e : contact.elements) {
                const auto r = reaction(contact.rods.surfaces(), e, contact.rods.q, contact.start,
                                        contact.laws);
                sliding += r.acts() && r.friction.slides(r.slip);
            }
            CHECK((sliding > 0) == (motion == slide || contact.elements[0].surface_b < 0));
            check_equal(contact.tangent(FrictionTangent::consistent),
                        contact.finite_difference_tangent(1e-7));
        }
}

TEST_CASE("each element of skins adds to the blocks of its own unknowns", "[skin_assembly]") {
    for (const auto& contact : every_kind(0.3, stick)) {
        const auto pattern = make_pattern(contact.rods.surfaces(), contact.elements, 0.3);
        for (std::size_t e = 0; e < contact.elements.size(); ++e) {
            const auto system =
                local_system(contact.rods.surfaces(), contact.elements[e], contact.rods.q);
            CHECK(system.count == system.count_frozen);
            auto slot = static_cast<std::size_t>(pattern.first_slot.at(e));
            for (int i = 0; i < system.count; ++i)
                for (int j = 0; j < system.count; ++j, ++slot) {
                    const auto block = static_cast<std::size_t>(pattern.slot.at(slot));
                    REQUIRE(pattern.row.at(block) == system.unknown[i]);
                    REQUIRE(pattern.col.at(block) == system.unknown[j]);
                }
        }
    }
}

TEST_CASE("a pattern with reach has a place for tubes that slid onto the next facets",
          "[skin_assembly]") {
    for (const auto facets : all_facets) {
        auto contact = contact_on(tube_on_sheet(cable, facets), 0, stick, {}, 0);
        auto far = make_pattern(contact.rods.surfaces(), contact.elements, 0.25),
             near = make_pattern(contact.rods.surfaces(), contact.elements);
        const auto before = contact.elements;
        const auto end_of_tube = static_cast<std::size_t>(3 * contact.rods.tubes[0].num_nodes());
        for (std::size_t i = 1; i < end_of_tube; i += 3)
            contact.rods.q[i] -= 0.12; // from beyond the edges y = 1; facets are 1 mm long
        contact.elements = pair_up(contact.rods, before);
        REQUIRE(contact.elements.size() == before.size());
        CHECK(place(far, contact.rods.surfaces(), contact.elements));
        CHECK_FALSE(place(near, contact.rods.surfaces(), contact.elements));
    }
}

TEST_CASE("C9: forces between skins sum to zero, and so do moments on flat ones",
          "[skin_assembly]") {
    for (const auto below : all_facets)
        for (const auto above : all_facets) {
            auto rods = two_sheets(below, above);
            const auto end_a = static_cast<std::int64_t>(3) *
                               (rods.skins[1].unknown[0] / 3); // unknowns of a come first
            auto contact = contact_on(std::move(rods), 0, stick, {}, 0);
            // Points less than the penetration beside the rim meet a particle that is not right
            // above them.
            const auto rim = std::erase_if(contact.elements, [&](const auto& e) {
                const auto s = local_system(contact.rods.surfaces(), e, contact.rods.q);
                return s.separation.cross(e.normal).norm() > 1e-12;
            });
            CHECK(rim * 20 < contact.elements.size());
            const auto end = static_cast<std::int64_t>(contact.rods.q.size());
            const Vector residual = contact.residual();
            const Vec3 on_a = force(residual, 0, end_a);
            CHECK(on_a[2] < -1);
            CHECK((on_a + force(residual, end_a, end)).norm() < 1e-12 * residual.norm());
            CHECK(moment(residual, contact.rods.q, 0, end).norm() < 1e-11 * residual.norm());
        }
}

TEST_CASE("C9: friction between skins is action and reaction", "[skin_assembly]") {
    for (const auto& contact : every_kind(0.3, slide)) {
        if (contact.elements[0].surface_b < 0 ||
            (!contact.rods.tubes.empty() && contact.rods.tubes[0].block == 9))
            continue; // rigid, or with directors, whose rows are no forces
        const Vector residual = contact.residual();
        const auto end = static_cast<std::int64_t>(contact.rods.q.size());
        CHECK(force(residual, 0, end).norm() < 1e-12 * residual.norm());
    }
}

TEST_CASE("C9: nothing changes when two skins are swapped", "[skin_assembly]") {
    for (const double mu : {0.0, 0.3})
        for (const auto below : all_facets)
            for (const auto above : all_facets) {
                const auto ab = contact_on(two_sheets(below, above), mu, slide);
                Contact ba = ab;
                ba.rods = ab.rods.reversed();
                ba.elements = pair_up(ba.rods);
                Contact fresh = ab;
                fresh.elements = pair_up(ab.rods);
                REQUIRE(ba.elements.size() == fresh.elements.size());
                const Vector residual = fresh.residual();
                CHECK(residual.norm() > 0.1);
                CHECK((residual - ba.residual()).norm() < 1e-12 * residual.norm());
                const Matrix tangent = fresh.tangent(FrictionTangent::consistent);
                CHECK((tangent - ba.tangent(FrictionTangent::consistent)).norm() <
                      1e-12 * tangent.norm());
            }
}

TEST_CASE("any number of threads adds up the same forces on skins", "[skin_assembly]") {
    const auto contact =
        contact_on(two_sheets(FacetKind::square9, FacetKind::triangle6), 0.3, slide);
    const Vector residual = contact.residual();
    const Matrix tangent = contact.tangent(FrictionTangent::consistent);
    for (const int threads : {2, 5}) {
        CHECK((contact.residual(contact.rods.q, threads) - residual).norm() <
              1e-13 * residual.norm());
        CHECK((contact.tangent(FrictionTangent::consistent, threads) - tangent).norm() <
              1e-13 * tangent.norm());
    }
}
