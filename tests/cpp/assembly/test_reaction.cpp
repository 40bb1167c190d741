#include "support/contact.h"
#include "surfaces/rigid.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

/// Two straight cables `gap` apart along x, with one contact element.
Contact one_contact(double gap, double mu) {
    Contact out{{}, {}, {}, laws_with(mu)};
    out.rods.add_straight(cable, 1, 1.0, {0, 0, 0}, {0, 0, 4});
    out.rods.add_straight(cable, 1, 0.5, {1.5 + gap, 0, 0}, {1.5 + gap, 0, 4});
    ContactElement e{};
    e.surface_b = 1;
    e.body_b = 1;
    e.s_a = e.s_b = 0.5;
    e.normal = Vec3::UnitX();
    e.weight = 2;
    e.stiffness = 600;
    out.elements = {e};
    out.start = out.rods.q;
    return out;
}

Reaction reaction_of(const Contact& c) {
    return reaction(c.rods.tubes, c.elements[0], c.rods.q, c.start, c.laws);
}

} // namespace

TEST_CASE("normal force is the law's for the stiffness of the whole station", "[reaction]") {
    for (const double gap : {-0.03, -0.002, 0.001}) {
        const auto r = reaction_of(one_contact(gap, 0));
        const NormalLaw law{1200, 0.004};
        CHECK(std::abs(r.system.gap - gap) < 1e-14);
        CHECK(std::abs(r.normal_force - law.force(gap)) < 1e-9);
        CHECK(std::abs(r.stiffness - law.tangent(gap)) < 1e-9);
        CHECK(std::abs(r.energy - law.energy(gap)) < 1e-12);
        CHECK(r.acts() == (gap < 0));
    }
}

TEST_CASE("slip is what b moved against a in the tangent plane, plus memory", "[reaction]") {
    auto contact = one_contact(-0.02, 0.2);
    contact.elements[0].slip = {0, 0.002, -0.001};
    for (std::size_t i = 6; i < 12; i += 3) { // nodes of b: where they came from
        contact.start[i] -= 0.01;
        contact.start[i + 1] -= 0.003;
        contact.start[i + 2] += 0.001;
    }
    const auto r = reaction_of(contact);
    CHECK((r.slip - Vec3(0, 0.005, -0.002)).norm() < 1e-14);
    const double share = r.slip.norm() / contact.laws.reversible_slip;
    CHECK(std::abs(r.friction_force.norm() - 0.2 * r.normal_force * share) < 1e-9);
    CHECK(r.friction_force.dot(r.slip) > 0); // on a, towards where b goes
}

TEST_CASE("friction belongs to the pair of bodies", "[reaction]") {
    auto contact = one_contact(-0.02, 0);
    contact.laws.num_bodies = 3;
    contact.laws.friction = {0.1, 0.2, 0.3, 0.2, 0.4, 0.5, 0.3, 0.5, 0.6};
    contact.elements[0].slip = {0, 1, 0};
    contact.rods.tubes[0].body = 2;
    CHECK(std::abs(reaction_of(contact).friction.coefficient - 0.5) < 1e-15);
    contact.elements[0].body_b = 0;
    CHECK(std::abs(reaction_of(contact).friction.coefficient - 0.3) < 1e-15);
    contact.laws.friction.clear(); // none given: none acts
    CHECK(reaction_of(contact).friction_force.norm() == 0);
}

TEST_CASE("gap reduction limits the force to that of one step", "[reaction]") {
    auto contact = one_contact(-0.8, 0);
    contact.laws.gap_step = 0.05;
    const NormalLaw law{1200, contact.laws.regularisation};
    CHECK(std::abs(reaction_of(contact).normal_force - law.force(-0.05)) < 1e-9);
    CHECK(std::abs(reaction_of(contact).system.gap + 0.8) < 1e-14); // reported as it is
    contact.laws.gap_step = 2;
    CHECK(std::abs(reaction_of(contact).normal_force - law.force(-0.8)) < 1e-9);
}

TEST_CASE("a frame drags as a motion that is prescribed does", "[reaction]") {
    const Vec3 centre(-1.98, 0.3, 0);
    const double angle = 0.004;
    const Rigid bar{Cylinder{centre, Vec3::UnitZ(), 1, false}, 0}, moved = [&] {
        Rigid out = bar;
        out.pivot = centre;
        out.rotation = angle * Vec3::UnitZ();
        return out;
    }();
    auto contact = one_contact(0, 0.2);
    auto& e = contact.elements[0];
    e.surface_b = -1;
    e.normal = -Vec3::UnitX();
    e.wall = Vec3(-0.98, 0.3, 2);
    e.wall_start = moved.at_start(e.wall, {}, {});
    const auto prescribed = reaction_of(contact);
    Rigid framed = bar;
    framed.frame = static_cast<std::int64_t>(contact.rods.q.size());
    const auto turned = [](double by) {
        return Mat3(Eigen::AngleAxisd(by, Vec3::UnitZ()).toRotationMatrix());
    };
    for (auto [q, by] : {std::pair(&contact.start, 0.1), std::pair(&contact.rods.q, 0.1 + angle)}) {
        q->insert(q->end(), centre.begin(), centre.end());
        for (int i = 0; i < 3; ++i) {
            const Vec3 director = turned(by).col(i);
            q->insert(q->end(), director.begin(), director.end());
        }
    }
    CHECK((framed.at_start(e.wall, contact.start, contact.rods.q) - e.wall_start).norm() < 1e-14);
    CHECK((framed.turn(contact.start, contact.rods.q) - moved.turn({}, {})).norm() < 1e-14);
    e.frame = framed.frame;
    e.in_frame = framed.in_frame(e.wall, contact.rods.q);
    const auto found = reaction_of(contact);
    CHECK(prescribed.slip.norm() > 1e-3);
    CHECK((found.slip - prescribed.slip).norm() < 1e-12);
    CHECK(std::abs(found.system.gap - prescribed.system.gap) < 1e-12);
}

TEST_CASE("a moving wall drags", "[reaction]") {
    auto contact = one_contact(0, 0.2);
    auto& e = contact.elements[0];
    e.surface_b = -1;
    e.normal = -Vec3::UnitX();
    e.wall = Vec3(-0.98, 0, 2);
    e.wall_start = e.wall - Vec3(0, 0.004, 0);
    const auto r = reaction_of(contact);
    CHECK(std::abs(r.system.gap + 0.02) < 1e-14);
    CHECK((r.slip - Vec3(0, 0.004, 0)).norm() < 1e-14);
    CHECK(r.friction_force[1] > 0); // on the tube, along with the wall
}
