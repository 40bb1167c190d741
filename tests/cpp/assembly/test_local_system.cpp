#include "support/contact.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

/// The same rods with all sections of one beam spun by `angle` (rad).
Rods spun(const Rods& rods, std::size_t which, double angle) {
    Rods out = rods;
    const Tube& tube = rods.tubes[which];
    for (std::int32_t i = 0; i < tube.num_nodes(); ++i) {
        const auto first = tube.unknown_of(i);
        const Vec3 g1 = vector_at(rods.q, first + 3), g2 = vector_at(rods.q, first + 6);
        Eigen::Map<Vec3>(out.q.data() + first + 3) = std::cos(angle) * g1 + std::sin(angle) * g2;
        Eigen::Map<Vec3>(out.q.data() + first + 6) = std::cos(angle) * g2 - std::sin(angle) * g1;
    }
    return out;
}

} // namespace

TEST_CASE("gap, its gradient and its curvature against finite differences", "[local_system]") {
    const double h = 1e-4;
    for (const auto& kind : all_kinds) {
        const auto contact = random_contact(kind, beam, 0, 0, 3);
        const auto& [rods, elements, start, laws] = contact;
        Random random(4);
        std::vector<double> step(rods.q.size());
        for (auto& value : step)
            value = random.uniform(-1, 1);
        const auto moved = [&](double size) {
            auto q = rods.q;
            for (std::size_t i = 0; i < q.size(); ++i)
                q[i] += size * step[i];
            return q;
        };
        for (const auto& e : elements) {
            INFO(kind.name);
            const auto here = local_system(rods.tubes, e, rods.q);
            const double ahead = local_system(rods.tubes, e, moved(h)).gap;
            const double behind = local_system(rods.tubes, e, moved(-h)).gap;
            double slope = 0, bend = 0;
            const auto along = [&](int i) { return vector_at(step, here.unknown[i]); };
            for (int i = 0; i < here.count; ++i)
                slope += here.gap_weight[i].dot(along(i));
            for (int k = 0; k < here.num_sections; ++k)
                for (const int i : {0, 1})
                    for (const int j : {0, 1}) {
                        const auto& s = here.sections[k];
                        bend +=
                            s.share * along(s.director[i])
                                          .dot(s.half_width.hessian[i][j] * along(s.director[j]));
                    }
            CHECK(std::abs((ahead - behind) / (2 * h) - slope) < 1e-6);
            CHECK(std::abs((ahead - 2 * here.gap + behind) / (h * h) + bend) < 1e-5);
        }
    }
}

TEST_CASE("separation is that of the material particles", "[local_system]") {
    const auto contact = random_contact(smooth_beam, quadratic_beam, 0, 0, 5);
    const auto& [rods, elements, start, laws] = contact;
    for (const auto& e : elements) {
        const auto particle = [&](const Tube& tube, double s, const double(&xi)[2]) -> Vec3 {
            const auto section = element_support(tube, s);
            return position(tube, rods.q, s) + xi[0] * director(tube, rods.q, section, 1) +
                   xi[1] * director(tube, rods.q, section, 2);
        };
        const Vec3 expected =
            particle(rods.tubes[1], e.s_b, e.xi_b) - particle(rods.tubes[0], e.s_a, e.xi_a);
        CHECK((local_system(rods.tubes, e, rods.q).separation - expected).norm() < 1e-14);
    }
}

TEST_CASE("gap of round sections is the distance less the radii", "[local_system]") {
    for (const auto& kind : all_kinds) {
        Rods rods;
        rods.add_straight(kind, 4, 1.0, {0, 0, 0}, {0, 0, 8});
        rods.add_straight(kind, 5, 0.8, {1.5, -3, 4}, {1.5, 3, 4});
        ContactElement e{};
        e.surface_b = 1;
        e.s_a = 2;
        e.s_b = 2.5;
        e.normal = Vec3::UnitX();
        INFO(kind.name);
        CHECK(std::abs(local_system(rods.tubes, e, rods.q).gap - (1.5 - 1.8)) < 1e-14);
        e.allowance = 0.25;
        CHECK(std::abs(local_system(rods.tubes, e, rods.q).gap - (1.5 - 1.8 + 0.25)) < 1e-14);
    }
}

TEST_CASE("a spinning section leaves the gap alone", "[local_system]") {
    const auto contact = random_contact(beam, quadratic_beam, 0, 0, 6); // deformed sections, too
    for (const double angle : {0.3, 1.6, 4.0})
        for (const std::size_t which : {0, 1}) {
            const Rods turned = spun(contact.rods, which, angle);
            for (const auto& e : contact.elements)
                CHECK(std::abs(local_system(turned.tubes, e, turned.q).gap -
                               local_system(turned.tubes, e, contact.rods.q).gap) < 1e-13);
        }
}

TEST_CASE("round sections that are turned, each on its own, leave the gap alone",
          "[local_system]") {
    auto contact = random_contact(beam, quadratic_beam, 0, 0, 6);
    Random random(8);
    contact.rods.turn_sections(random);
    for (const auto& e : contact.elements) {
        const Tube &a = contact.rods.tubes[0], &b = contact.rods.tubes[1];
        const double apart =
            (position(b, contact.rods.q, e.s_b) - position(a, contact.rods.q, e.s_a)).dot(e.normal);
        const auto system = local_system(contact.rods.tubes, e, contact.rods.q);
        CHECK(std::abs(system.gap - (apart - a.radius - b.radius + e.allowance)) < 1e-9);
    }
}

TEST_CASE("sections that spin against each other keep their half width", "[local_system]") {
    Rods rods;
    rods.add_straight(beam, 4, 1.0, {0, 0, 0}, {0, 0, 8});
    rods.add_straight(beam, 5, 0.8, {1.5, -3, 4}, {1.5, 3, 4});
    for (std::int32_t i = 0; i < rods.tubes[0].num_nodes(); ++i) {
        const auto first = rods.tubes[0].unknown_of(i);
        Eigen::Map<Vec3>(rods.q.data() + first + 3) = Vec3(std::cos(i), std::sin(i), 0);
        Eigen::Map<Vec3>(rods.q.data() + first + 6) = Vec3(-std::sin(i), std::cos(i), 0);
    }
    ContactElement e{};
    e.surface_b = 1;
    e.s_a = 1.4;
    e.s_b = 2.5;
    e.normal = Vec3::UnitX();
    CHECK(std::abs(local_system(rods.tubes, e, rods.q).gap - (1.5 - 1.8)) < 1e-14);
}

TEST_CASE("a spinning section does no work without friction", "[local_system]") {
    const auto contact = random_contact(smooth_beam, quadratic_beam, 0, 0, 7);
    const Vector force = contact.residual();
    for (const std::size_t which : {0, 1}) {
        const Tube& tube = contact.rods.tubes[which];
        double work = 0, size = 0;
        for (std::int32_t i = 0; i < tube.num_nodes(); ++i) {
            const auto first = tube.unknown_of(i);
            const Vec3 f1 = force.segment<3>(first + 3), f2 = force.segment<3>(first + 6);
            work += f1.dot(vector_at(contact.rods.q, first + 6)) -
                    f2.dot(vector_at(contact.rods.q, first + 3));
            size += f1.norm() + f2.norm();
        }
        CHECK(size > 1);
        CHECK(std::abs(work) < 1e-13 * size);
    }
}
