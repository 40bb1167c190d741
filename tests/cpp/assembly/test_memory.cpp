#include "assembly/memory.h"
#include "support/contact.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

constexpr double mu = 0.2, reversible = 0.01;

/// Two crossing cables of one element, pressed by a constant penetration along x.
Contact pressed_pair() {
    Contact out{{}, {}, {}, laws_with(mu)};
    out.laws.reversible_slip = reversible;
    out.rods.add_straight(cable, 1, 1.0, {0, 0, -2}, {0, 0, 2});
    out.rods.add_straight(cable, 1, 1.0, {1.98, -2, 0}, {1.98, 2, 0});
    ContactElement e{};
    e.surface_b = 1;
    e.body_b = 1;
    e.s_a = e.s_b = 0.5;
    e.normal = Vec3::UnitX();
    e.weight = 1;
    e.stiffness = 500;
    out.elements = {e};
    out.start = out.rods.q;
    return out;
}

double normal_force(const Contact& c) {
    return reaction(c.rods.tubes, c.elements[0], c.rods.q, c.start, c.laws).normal_force;
}

/// One increment: b moves by `step` against a. Returns the work put in by the trapezoidal rule, N
/// mm.
double slide(Contact& c, const Vec3& step) {
    const auto force = [&] {
        return reaction(c.rods.tubes, c.elements[0], c.rods.q, c.start, c.laws).friction_force;
    };
    c.start = c.rods.q;
    const Vec3 before = force();
    for (std::size_t i = 6; i < 12; i += 3)
        Eigen::Map<Vec3>(c.rods.q.data() + i) += step;
    const Vec3 after = force();
    commit(c.rods.tubes, c.elements, c.rods.q, c.start, c.laws);
    return 0.5 * (before + after).dot(step);
}

} // namespace

TEST_CASE("C2: a friction cycle dissipates 4 mu N (d - g_rev)", "[memory]") {
    for (const double amplitude : {0.012, 0.05, 0.3})
        for (const int steps : {1, 7, 400}) { // increments per amplitude: the result is the same
            Contact contact = pressed_pair();
            const double force = normal_force(contact);
            const Vec3 along = Vec3(0, 0.6, 0.8) * (amplitude / steps);
            double put_in = 0;
            for (int i = 0; i < steps; ++i)
                slide(contact, along);
            const double before = contact.elements[0].work;
            CHECK(std::abs(before - mu * force * (amplitude - reversible)) < 1e-10);
            for (int i = 0; i < 4 * steps; ++i)
                put_in += slide(contact, i < 2 * steps ? Vec3(-along) : along);
            const double expected = 4 * mu * force * (amplitude - reversible);
            INFO("amplitude " << amplitude << ", " << steps << " increments");
            CHECK(std::abs(contact.elements[0].work - before - expected) < 1e-10);
            if (steps == 400) // and it is the work that went in
                CHECK(std::abs(put_in - expected) < 0.01 * expected);
        }
}

TEST_CASE("cycles within the reversible slip dissipate nothing", "[memory]") {
    Contact contact = pressed_pair();
    double put_in = 0;
    for (int i = 0; i < 40; ++i)
        put_in += slide(contact, {0, 0, (i % 8 < 4 ? 0.9 : -0.9) * reversible / 4});
    CHECK(contact.elements[0].work == 0);
    CHECK(std::abs(put_in) < 1e-12);
}

TEST_CASE("commit reports the work of the increment and the deepest penetration", "[memory]") {
    Contact contact = pressed_pair();
    contact.elements.push_back(contact.elements[0]);
    contact.elements[1].allowance = -0.01;
    contact.start[6 + 2] -= 0.2;
    contact.start[9 + 2] -= 0.2;
    const auto done =
        commit(contact.rods.tubes, contact.elements, contact.rods.q, contact.start, contact.laws);
    CHECK(done.work > 0);
    CHECK(std::abs(done.work - contact.elements[0].work - contact.elements[1].work) < 1e-14);
    CHECK(std::abs(done.penetration - 0.03) < 1e-12);
}

TEST_CASE("memory holds the reversible part of the slip, in its direction", "[memory]") {
    Contact contact = pressed_pair();
    slide(contact, {0, 0.03, 0.04});
    CHECK((contact.elements[0].slip - reversible * Vec3(0, 0.6, 0.8)).norm() < 1e-15);
    slide(contact, {0, -0.001, 0});
    CHECK((contact.elements[0].slip - Vec3(0, 0.005, 0.008)).norm() < 1e-15);
}

TEST_CASE("what is out of touch forgets its slip and keeps its work", "[memory]") {
    Contact contact = pressed_pair();
    slide(contact, {0, 0.05, 0});
    const double work = contact.elements[0].work;
    CHECK(work > 0);
    slide(contact, {0.5, 0, 0});
    CHECK(contact.elements[0].slip.norm() == 0);
    CHECK(contact.elements[0].work == work);
}

TEST_CASE("penalties grow by zone until penetrations are tolerable", "[memory]") {
    Contact contact = pressed_pair(); // 0.02 mm deep
    contact.elements.resize(4, contact.elements[0]);
    for (int i = 0; i < 4; ++i)
        contact.elements[static_cast<std::size_t>(i)].zone = i / 2;
    contact.elements[1].allowance = 0.015; // same zone as 0, not as deep
    contact.elements[2].allowance = 0.018; // zone 1: within tolerance
    contact.elements[3].allowance = 0.5;
    const auto adapt = [&](double tolerance, double growth) {
        return adapt_stiffness(contact.rods.tubes, contact.elements, contact.rods.q, tolerance,
                               growth);
    };
    CHECK(adapt(0.03, 3) == 0);
    CHECK(std::abs(deepest_penetration(contact.rods.tubes, contact.elements, contact.rods.q) -
                   0.02) < 1e-12);
    auto nearby = contact.elements; // another process has a zone that is too deep
    CHECK(adapt_stiffness(contact.rods.tubes, nearby, contact.rods.q, 0.03, 3, 0.04) == 1);
    CHECK(std::abs(nearby[0].stiffness - 500 * 1.6 * 0.02 / 0.03) < 1e-9);
    CHECK(contact.elements[0].stiffness == 500);
    CHECK(adapt(0.015, 10) == 1);
    CHECK(std::abs(contact.elements[0].stiffness - 500 * 1.6 * 0.02 / 0.015) < 1e-9);
    CHECK(contact.elements[1].stiffness == contact.elements[0].stiffness);
    CHECK(contact.elements[2].stiffness == 500);
    CHECK(contact.elements[3].stiffness == 500);
    const double before = contact.elements[0].stiffness;
    CHECK(adapt(0.001, 3) == 2); // far too deep: by `growth` at most
    CHECK(std::abs(contact.elements[0].stiffness - 3 * before) < 1e-9);
}

TEST_CASE("penalties do not grow where nothing that touches can move", "[memory]") {
    Contact contact = pressed_pair(); // 0.02 mm deep
    const auto adapt = [&](int first, int last) {
        std::array<bool, 12> held{};
        std::fill(held.begin() + first, held.begin() + last, true);
        auto elements = contact.elements;
        return adapt_stiffness(contact.rods.tubes, elements, contact.rods.q, 0.015, 3, 0, 1, held);
    };
    CHECK(adapt(0, 0) == 1);
    CHECK(adapt(0, 6) == 1); // b still can
    CHECK(adapt(0, 12) == 0);
    std::array<bool, 12> held{}; // the first nodes of both
    for (const std::size_t i : {0U, 1U, 2U, 6U, 7U, 8U})
        held[i] = true;
    for (const double s : {0.1, 0.9}) {
        contact.elements[0].s_a = contact.elements[0].s_b = s;
        CHECK(adapt_stiffness(contact.rods.tubes, contact.elements, contact.rods.q, 0.015, 3, 0, 1,
                              held) == (s > 0.5 ? 1 : 0));
    }
}

TEST_CASE("multipliers take over the forces, and the same ones then need no penetration",
          "[memory]") {
    Contact contact = pressed_pair();
    const double force = normal_force(contact);
    const auto pressed = contact.rods.q;
    update_multipliers(contact.rods.tubes, contact.elements, contact.rods.q, contact.start,
                       contact.laws);
    const auto& e = contact.elements[0];
    CHECK(e.multiplier * e.weight == force);
    for (std::size_t i = 6; i < 12; i += 3)
        contact.rods.q[i] += 0.02; // to gap 0
    CHECK(std::abs(normal_force(contact) - force) < 1e-12 * force);
    for (std::size_t i = 6; i < 12; i += 3)
        contact.rods.q[i] += 0.0201; // by more than the force needs
    CHECK(normal_force(contact) == 0);
    update_multipliers(contact.rods.tubes, contact.elements, contact.rods.q, contact.start,
                       contact.laws);
    contact.rods.q = pressed;
    CHECK(std::abs(normal_force(contact) - force) < 1e-12 * force);
    scale_stiffness(contact.elements, 2);
    CHECK(std::abs(normal_force(contact) - 2 * force) < 1e-12 * force);
}

TEST_CASE("any number of threads remembers the same", "[memory]") {
    const Contact contact = mixed_contacts();
    const auto& tubes = contact.rods.tubes;
    const Unknowns q = contact.rods.q, start = contact.start;
    auto expected = contact.elements;
    const auto done = commit(tubes, expected, q, start, contact.laws);
    const auto forces = sum_normal_forces(tubes, contact.elements, q, start, contact.laws);
    const double deepest = deepest_penetration(tubes, contact.elements, q);
    CHECK(deepest == done.penetration);
    const int raised = adapt_stiffness(tubes, expected, q, 0.5 * deepest, 3);
    for (const int num_threads : {2, 7}) {
        auto found = contact.elements;
        const auto again = commit(tubes, found, q, start, contact.laws, num_threads);
        CHECK(again.work == done.work);
        CHECK(again.penetration == done.penetration);
        CHECK(adapt_stiffness(tubes, found, q, 0.5 * deepest, 3, 0, num_threads) == raised);
        for (std::size_t e = 0; e < found.size(); ++e) {
            CHECK(found[e].slip == expected[e].slip);
            CHECK(found[e].work == expected[e].work);
            CHECK(found[e].stiffness == expected[e].stiffness);
        }
        const auto same =
            sum_normal_forces(tubes, contact.elements, q, start, contact.laws, num_threads);
        CHECK(same.all == forces.all);
        CHECK(same.rigid == forces.rigid);
    }
}

TEST_CASE("normal forces add up, those on rigid surfaces by themselves", "[memory]") {
    Contact contact = mixed_contacts();
    for (auto& e : contact.elements) // all of them penetrate
        e.allowance -= local_system(contact.rods.tubes, e, contact.rods.q).gap + 0.01;
    double rigid = 0, all = 0;
    for (const auto& e : contact.elements) {
        const auto r = reaction(contact.rods.tubes, e, contact.rods.q, contact.start, contact.laws);
        all += r.normal_force;
        rigid += e.surface_b < 0 ? r.normal_force : 0;
    }
    const auto sums = sum_normal_forces(contact.rods.tubes, contact.elements, contact.rods.q,
                                        contact.start, contact.laws);
    CHECK(sums.all == all);
    CHECK(sums.rigid == rigid);
    CHECK((rigid > 0 && rigid < all));
}
