// V11 of the verification list, for contact: friction does not notice that all turn together.
#include "assembly/memory.h"
#include "support/rigid_motion.h"

#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

/// A contact that remembers slip, and the rigid surfaces in it.
struct Remembering {
    Contact contact;
    std::vector<Rigid> rigid;

    Remembering(Rods rods, double slide, std::vector<Rigid> walls = {})
        : contact(contact_on(std::move(rods), 0.3, slide, walls)), rigid(std::move(walls)) {
        commit(contact.rods.surfaces(), contact.elements, contact.rods.q, contact.start,
               contact.laws);
        contact.start = contact.rods.q;
    }

    /// An increment in which everything moves rigidly; the work that is dissipated.
    double move(const RigidMotion& motion) {
        contact.start = contact.rods.q;
        contact.rods = motion.applied(contact.rods);
        const Eigen::AngleAxisd turn(motion.rotation);
        for (auto& r : rigid) {
            auto& plane = std::get<Plane>(r.shape);
            plane = {motion(plane.point), motion.rotation * plane.normal};
            r = {plane, r.body, Vec3::Zero(), turn.angle() * turn.axis(), motion.translation};
        }
        contact.elements =
            make_contact_elements({contact.rods.tubes, {}, rigid, contact.rods.skins},
                                  contact.rods.q, contact.elements, {}, contact.start);
        auto& [rods, elements, start, laws] = contact;
        return commit(rods.surfaces(), elements, rods.q, start, laws).work;
    }

    /// Forces before an increment is accepted are those after it.
    Vector forces() {
        contact.start = contact.rods.q;
        return contact.residual();
    }
};

Rods two_rods(const Kind& kind, double angle) {
    const Vec3 b(0, std::sin(angle), std::cos(angle));
    Rods out;
    out.add_straight(kind, 6, 1.0, {0, 0, -6}, {0, 0, 6});
    out.add_straight(kind, 5, 0.8, Vec3(1.75, 0, 0) - 6 * b, Vec3(1.75, 0, 0) + 6 * b);
    return out;
}

std::vector<Remembering> every_pair(double slide) {
    std::vector<Remembering> out;
    for (const auto& kind : all_kinds) {
        for (const double angle : {0.0, 0.05, 0.7, 1.57, 2.6})
            out.emplace_back(two_rods(kind, angle), slide);
        out.emplace_back(tube_on_sheet(kind, FacetKind::square9), slide);
        Rods rod;
        rod.add_straight(kind, 5, 1.0, {0, 0, -1}, {8, 0, -1});
        out.emplace_back(std::move(rod), slide, std::vector{plane_above(0.02)});
    }
    for (const auto facets : all_facets) {
        out.emplace_back(two_sheets(facets, FacetKind::square9), slide);
        out.emplace_back(sheet_for_plane(facets), slide, std::vector{plane_above()});
    }
    return out;
}

constexpr double stick = 3e-3, slide = 0.2; // mm; reversible slip is 0.02

} // namespace

TEST_CASE("V11: friction turns with a rigid motion of any size, and does no work",
          "[objectivity]") {
    Random random(40);
    for (const double motion : {stick, slide})
        for (auto& pair : every_pair(motion)) {
            Vector expected = pair.forces();
            const Vector normal = [&] {
                Contact frictionless = pair.contact;
                frictionless.laws = laws_with(0);
                return frictionless.residual();
            }();
            const double friction = (expected - normal).norm();
            REQUIRE(friction > 1e-3 * normal.norm());
            for (const double size : {1.0, 0.1, 0.1, 1e-3}) { // one after the other
                RigidMotion step(random);
                const Eigen::AngleAxisd turn(step.rotation);
                step.rotation = Eigen::AngleAxisd(size * turn.angle(), turn.axis());
                const double before = [&] {
                    double work = 0;
                    for (const auto& e : pair.contact.elements)
                        work += e.work;
                    return work;
                }();
                CHECK(std::abs(pair.move(step)) < 1e-12 * (before + friction));
                expected = step.turned(expected);
                CHECK((pair.forces() - expected).norm() < 1e-10 * friction);
            }
        }
}
