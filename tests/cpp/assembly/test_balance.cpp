// C9 of the verification list: action and reaction, and no difference between a and b.
#include "pairing/pairing.h"
#include "support/contact.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <numbers>

using namespace braidx;
using namespace braidx::test;

namespace {

/// Force, and moment about the origin: a director g that carries f contributes g x f.
struct Load {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
};

Load load_on(const Tube& tube, const std::vector<double>& q, const Vector& residual) {
    Load out;
    for (std::int32_t i = 0; i < tube.num_nodes(); ++i) {
        const auto first = tube.unknown_of(i);
        out.force -= residual.segment<3>(first);
        for (int k = 0; k < tube.block; k += 3)
            out.moment -= vector_at(q, first + k).cross(Vec3(residual.segment<3>(first + k)));
    }
    return out;
}

/// Two rods pressed into each other, crossing at `angle` or parallel, their contact elements
/// freshly made.
Contact pressed(const Kind& kind, double angle, double mu) {
    Contact out{{}, {}, {}, laws_with(mu)};
    const Vec3 b(0, std::sin(angle), std::cos(angle));
    out.rods.add_straight(kind, 6, 1.0, {0, 0, -6}, {0, 0, 6});
    out.rods.add_straight(kind, 5, 0.8, Vec3(1.75, 0, 0) - 6 * b, Vec3(1.75, 0, 0) + 6 * b);
    out.elements = make_contact_elements({out.rods.tubes, {}, {}}, out.rods.q, {}, {});
    out.start = out.rods.q;
    for (auto i = static_cast<std::size_t>(out.rods.tubes[1].first_unknown); i < out.start.size();
         i += static_cast<std::size_t>(kind.block))
        out.start[i + 2] += 0.03; // b has slid along a
    return out;
}

} // namespace

TEST_CASE("C9: forces of a and b sum to zero, whatever the state", "[balance]") {
    unsigned seed = 1;
    for (const auto& kind_a : all_kinds)
        for (const auto& kind_b : all_kinds) {
            INFO(kind_a.name << " and " << kind_b.name);
            const auto contact = random_contact(kind_a, kind_b, 0.3, 0.2, ++seed);
            const Vector residual = contact.residual();
            const auto& [rods, elements, start, laws] = contact;
            const Load a = load_on(rods.tubes[0], rods.q, residual);
            const Load b = load_on(rods.tubes[1], rods.q, residual);
            CHECK(a.force.norm() > 1);
            CHECK((a.force + b.force).norm() < 1e-13 * residual.norm());
        }
}

TEST_CASE("C9: moments of a and b sum to zero without friction", "[balance]") {
    for (const auto& kind : all_kinds)
        for (const double angle : {0.0, 0.7, 1.57, 2.6}) {
            INFO(kind.name << " at " << angle);
            auto contact = pressed(kind, angle, 0);
            // Sections of beams stand square to their axis: line stations between crossing axes
            // press on them off their plane, the point station does not.
            if (kind.block == 9 && angle > 0)
                std::erase_if(contact.elements,
                              [](const auto& e) { return e.station != point_station; });
            REQUIRE_FALSE(contact.elements.empty());
            const Vector residual = contact.residual();
            const auto& [rods, elements, start, laws] = contact;
            const Load a = load_on(rods.tubes[0], rods.q, residual);
            const Load b = load_on(rods.tubes[1], rods.q, residual);
            CHECK(a.force.norm() > 1);
            CHECK((a.moment + b.moment).norm() < 1e-12 * residual.norm() * 6);
        }
}

TEST_CASE("C9: friction of beams acts at one point, where they touch", "[balance]") {
    for (const double angle : {0.0, 0.7, 1.2}) {
        auto contact = pressed(beam, angle, 0.3);
        if (angle > 0)
            std::erase_if(contact.elements,
                          [](const auto& e) { return e.station != point_station; });
        REQUIRE(contact.elements.size() >= 1);
        const auto& [rods, elements, start, laws] = contact;
        const Vector residual = contact.residual();
        const Load a = load_on(rods.tubes[0], rods.q, residual);
        const Load b = load_on(rods.tubes[1], rods.q, residual);
        double friction = 0, arm = 0;
        for (const auto& e : elements) {
            const auto r = reaction(rods.tubes, e, rods.q, start, laws);
            friction += r.friction_force.norm();
            arm = 1 + 0.5 * r.system.gap; // midway between the surfaces, a's is 1 mm off its axis
        }
        CHECK(friction > 1);
        CHECK((a.moment + b.moment).norm() < 1e-12 * residual.norm() * 6);
        // Along z: friction bends the rods.
        CHECK(std::abs(std::abs(a.moment[1]) - arm * friction) < 1e-9);
    }
}

TEST_CASE("C9: the moment of a contact element is that of its centres' and particles' distance",
          "[balance]") {
    for (const auto& kind : all_kinds) {
        INFO(kind.name);
        auto contact = random_contact(kind, kind, 0.3, 0.2, 50);
        contact.elements.resize(1);
        Random random(9);
        contact.rods.turn_sections(random);
        const auto& [rods, elements, start, laws] = contact;
        const Vector residual = contact.residual();
        const Load a = load_on(rods.tubes[0], rods.q, residual);
        const Load b = load_on(rods.tubes[1], rods.q, residual);
        const auto r = reaction(rods.tubes, elements[0], rods.q, start, laws);
        const Vec3 apart = position(rods.tubes[1], rods.q, elements[0].s_b) -
                           position(rods.tubes[0], rods.q, elements[0].s_a);
        const Vec3 expected = apart.cross(r.normal_force * elements[0].normal) -
                              r.system.separation.cross(r.friction_force);
        CHECK((a.moment + b.moment - expected).norm() < 1e-12 * residual.norm() * 6);
    }
}

TEST_CASE("C9: nothing changes when a and b are swapped", "[balance]") {
    for (const auto& kind : all_kinds)
        for (const double angle : {0.0, 0.7, 1.57, 2.6, std::numbers::pi})
            for (const double mu : {0.0, 0.3}) {
                INFO(kind.name << " at " << angle << ", mu " << mu);
                const auto ab = pressed(kind, angle, mu);
                Contact ba = ab;
                ba.rods = ab.rods.reversed();
                ba.elements = make_contact_elements({ba.rods.tubes, {}, {}}, ba.rods.q, {}, {});
                REQUIRE(ab.elements.size() == ba.elements.size());
                const Vector residual = ab.residual();
                CHECK(residual.norm() > 1);
                CHECK((residual - ba.residual()).norm() < 1e-6 * residual.norm());
                const Matrix tangent = ab.tangent(FrictionTangent::consistent);
                CHECK((tangent - ba.tangent(FrictionTangent::consistent)).norm() <
                      1e-6 * tangent.norm());
            }
}
