#include "support/contact.h"
#include "surfaces/rigid.h"

#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

constexpr double stick = 1e-3, slip = 0.2; // motions of the increment, mm; reversible slip is 0.02

constexpr std::pair<Kind, Kind> mixtures[] = {
    {cable, cable},         {smooth_cable, quadratic_cable},
    {beam, beam},           {smooth_beam, smooth_beam},
    {quadratic_beam, beam}, {smooth_cable, quadratic_beam},
};

void check_equal(const Matrix& found, const Matrix& expected) {
    CHECK(expected.norm() > 1);
    CHECK((found - expected).norm() < 1e-7 * expected.norm());
}

/// How many contact elements slide; all of them must act.
std::size_t num_sliding(const Contact& contact) {
    std::size_t count = 0;
    for (const auto& e : contact.elements) {
        const auto r = reaction(contact.rods.tubes, e, contact.rods.q, contact.start, contact.laws);
        REQUIRE(r.acts());
        count += r.friction.slides(r.slip);
    }
    return count;
}

} // namespace

TEST_CASE("normal forces are the gradient of their energy", "[assemble]") {
    unsigned seed = 1;
    for (const auto& [kind_a, kind_b] : mixtures) {
        INFO(kind_a.name << " and " << kind_b.name);
        auto contact = random_contact(kind_a, kind_b, 0, stick, ++seed);
        const Vector residual = contact.residual();
        CHECK((residual - contact.finite_difference_gradient()).norm() < 1e-6 * residual.norm());
        contact.laws.gap_step = 0.01; // reduced gaps have an energy, too
        const Vector reduced = contact.residual();
        CHECK((reduced - residual).norm() > 0.01 * residual.norm());
        CHECK((reduced - contact.finite_difference_gradient()).norm() < 1e-6 * residual.norm());
    }
}

TEST_CASE("with the normal forces there, friction is the gradient of its potential", "[assemble]") {
    unsigned seed = 30;
    for (const auto& [kind_a, kind_b] : mixtures)
        for (const double slide : {stick, slip}) {
            INFO(kind_a.name << " and " << kind_b.name << ", motion " << slide);
            const auto contact = random_contact(kind_a, kind_b, 0.3, slide, ++seed);
            CHECK(num_sliding(contact) == (slide == slip ? contact.elements.size() : 0));
            const Vector residual = contact.residual();
            CHECK((residual - contact.finite_difference_gradient()).norm() <
                  1e-6 * residual.norm());
        }
}

TEST_CASE("with multipliers residual and tangent are those of the energy, too", "[assemble]") {
    unsigned seed = 70;
    for (const auto& [kind_a, kind_b] : mixtures) {
        INFO(kind_a.name << " and " << kind_b.name);
        auto contact = random_contact(kind_a, kind_b, 0.3, stick, ++seed);
        for (auto& e : contact.elements)
            e.multiplier = 0.03 * static_cast<double>(&e - contact.elements.data()) * e.stiffness;
        const Vector residual = contact.residual();
        CHECK((residual - contact.finite_difference_gradient()).norm() < 1e-6 * residual.norm());
        check_equal(contact.tangent(FrictionTangent::consistent),
                    contact.finite_difference_tangent());
    }
}

TEST_CASE("the energy of contact is the same with any number of threads", "[assemble]") {
    const auto contact = mixed_contacts();
    const auto forces = normal_forces(contact.rods.surfaces(), contact.elements, contact.rods.q,
                                      contact.start, contact.laws);
    const auto energy = [&](int num_threads) {
        return contact_energy(contact.rods.surfaces(), contact.elements, contact.rods.q,
                              contact.start, contact.laws, forces, num_threads);
    };
    CHECK(energy(1) > 0);
    CHECK(energy(3) == energy(1));
}

TEST_CASE("without friction both tangents are exact and symmetric", "[assemble]") {
    unsigned seed = 20;
    for (const auto& [kind_a, kind_b] : mixtures) {
        INFO(kind_a.name << " and " << kind_b.name);
        const auto contact = random_contact(kind_a, kind_b, 0, stick, ++seed);
        const Matrix tangent = contact.tangent(FrictionTangent::consistent);
        check_equal(tangent, contact.finite_difference_tangent());
        CHECK((tangent - tangent.transpose()).norm() < 1e-13 * tangent.norm());
        CHECK((tangent - contact.tangent(FrictionTangent::symmetric)).norm() == 0);
    }
}

TEST_CASE("the consistent tangent is exact, sticking and sliding", "[assemble]") {
    unsigned seed = 40;
    for (const auto& [kind_a, kind_b] : mixtures)
        for (const double slide : {stick, slip}) {
            INFO(kind_a.name << " and " << kind_b.name << ", motion " << slide);
            const auto contact = random_contact(kind_a, kind_b, 0.3, slide, ++seed);
            CHECK(num_sliding(contact) == (slide == slip ? contact.elements.size() : 0));
            check_equal(contact.tangent(FrictionTangent::consistent),
                        contact.finite_difference_tangent());
        }
}

TEST_CASE("the consistent tangent is exact with gap reduction", "[assemble]") {
    auto contact = random_contact(beam, smooth_beam, 0.3, 0.03, 60);
    contact.laws.gap_step = 0.01;
    const Matrix tangent = contact.tangent(FrictionTangent::consistent);
    check_equal(tangent, contact.finite_difference_tangent());
}

TEST_CASE("against a wall all of it holds, too", "[assemble]") {
    unsigned seed = 70;
    for (const auto& kind : all_kinds)
        for (const double slide : {stick, slip}) {
            INFO(kind.name << ", motion " << slide);
            auto contact = random_contact_with_wall(kind, 0.3, slide, ++seed);
            CHECK(num_sliding(contact) == (slide == slip ? contact.elements.size() : 0));
            check_equal(contact.tangent(FrictionTangent::consistent),
                        contact.finite_difference_tangent());
            contact.laws = laws_with(0);
            const Vector residual = contact.residual();
            CHECK((residual - contact.finite_difference_gradient()).norm() <
                  1e-6 * residual.norm());
        }
}

TEST_CASE("against a wall that a frame turns all of it holds, too", "[assemble]") {
    unsigned seed = 90;
    Random random(9);
    for (const auto& kind : all_kinds)
        for (const double slide : {stick, slip}) {
            INFO(kind.name << ", motion " << slide);
            auto contact = random_contact_with_wall(kind, 0.3, slide, ++seed);
            Rigid rigid{Cylinder{Vec3::Zero(), Vec3::UnitX(), 1, false}, 1};
            rigid.frame = static_cast<std::int64_t>(contact.rods.q.size());
            for (const Vec3& x :
                 {random.vector(3), Vec3(Vec3::UnitX()), Vec3(0, 0.8, 0.6), Vec3(0, -0.6, 0.8)}) {
                contact.rods.q.insert(contact.rods.q.end(), x.begin(), x.end());
                const Vec3 before = x + random.vector(0.1 * slide);
                contact.start.insert(contact.start.end(), before.begin(), before.end());
            }
            for (auto& e : contact.elements) {
                e.frame = rigid.frame;
                e.in_frame = rigid.in_frame(e.wall, contact.rods.q);
            }
            CHECK(num_sliding(contact) == (slide == slip ? contact.elements.size() : 0));
            const Matrix tangent = contact.tangent(FrictionTangent::consistent);
            check_equal(tangent, contact.finite_difference_tangent());
            CHECK(tangent.bottomRightCorner(12, 12).norm() > 1);
            const Vector residual = contact.residual();
            CHECK((residual - contact.finite_difference_gradient()).norm() <
                  1e-6 * residual.norm());
            // Friction on the frame is that on the tube, turned round.
            const auto forces = -residual.tail<12>();
            Vec3 friction = Vec3::Zero();
            for (const auto& e : contact.elements)
                friction +=
                    reaction(contact.rods.tubes, e, contact.rods.q, contact.start, contact.laws)
                        .friction_force;
            CHECK((forces.head<3>() + friction).norm() < 1e-12 * friction.norm());
        }
}

TEST_CASE("the symmetric tangent is symmetric, positive, and exact but for the coupling",
          "[assemble]") {
    for (const double slide : {stick, slip}) {
        const auto contact = random_contact(beam, beam, 0.3, slide, 90);
        const Matrix symmetric = contact.tangent(FrictionTangent::symmetric);
        CHECK((symmetric - symmetric.transpose()).norm() < 1e-13 * symmetric.norm());
        Random random(8);
        for (int i = 0; i < 100; ++i) {
            const Vector v =
                Vector::NullaryExpr(symmetric.rows(), [&](auto) { return random.uniform(-1, 1); });
            CHECK(v.dot(symmetric * v) >= 0);
        }
        // What it leaves out is how friction follows the normal force: not symmetric, and not
        // small.
        const Matrix coupling = contact.tangent(FrictionTangent::consistent) - symmetric;
        CHECK(coupling.norm() > 1e-3 * symmetric.norm());
        CHECK((coupling - coupling.transpose()).norm() > 0.1 * coupling.norm());
    }
}

TEST_CASE("forces are added, not set", "[assemble]") {
    const auto contact = random_contact(cable, beam, 0.3, slip, 95);
    const Vector once = contact.residual();
    Vector twice = once;
    add_residual(contact.rods.tubes, contact.elements, contact.rods.q, contact.start, contact.laws,
                 {twice.data(), static_cast<std::size_t>(twice.size())});
    CHECK((twice - 2 * once).norm() < 1e-13 * once.norm());
}

TEST_CASE("tubes out of touch exert nothing", "[assemble]") {
    auto contact = random_contact(beam, beam, 0.3, slip, 96);
    for (auto& e : contact.elements)
        e.allowance += 1;
    CHECK(contact.residual().norm() == 0);
    CHECK(contact.tangent(FrictionTangent::consistent).norm() == 0);
}
