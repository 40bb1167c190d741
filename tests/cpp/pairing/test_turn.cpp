#include "pairing/turn.h"
#include "support/rigid_motion.h"

#include <array>
#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

double difference(const Mat3& one, const Mat3& other) {
    return (one - other).cwiseAbs().maxCoeff();
}

/// Two straight rods whose middles touch, with an element there.
struct Crossing2 {
    Rods rods;
    ContactElement element{};

    explicit Crossing2(double angle, const Kind& kind = cable) {
        const Vec3 along(0, std::sin(angle), std::cos(angle));
        rods.add_straight(kind, 4, 1.0, {0, 0, -6}, {0, 0, 6});
        rods.add_straight(kind, 4, 1.0, Vec3(2, 0, 0) - 6 * along, Vec3(2, 0, 0) + 6 * along);
        element.surface_b = 1;
        element.s_a = element.s_b = 2;
        element.normal = Vec3::UnitX();
    }

    Mat3 turn_to(const std::vector<double>& q) const {
        return turn_of(rods.surfaces(), element, rods.q, q);
    }

    /// With the second rod moved by a rigid motion of its own.
    std::vector<double> second_moved(const RigidMotion& motion) const {
        auto q = motion.applied(rods).q;
        std::copy_n(rods.q.begin(), rods.tubes[1].first_unknown, q.begin());
        return q;
    }
};

} // namespace

TEST_CASE("a rotation takes its axis along, and the others in the mean", "[turn]") {
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        const Mat3 r = random_rotation(random);
        const Vec3 axis = random.unit(), u = random.unit(), v = random.unit();
        const std::array others{Turned(u, r * u), Turned(0.1 * v, 0.1 * (r * v))};
        CHECK(difference(rotation_of({axis, 2 * (r * axis)}, others), r) < 1e-12);
        const Mat3 smallest = rotation_of({axis, r * axis}, {});
        CHECK((smallest * axis - r * axis).norm() < 1e-12);
        const Vec3 across = axis.cross(Vec3(r * axis));
        CHECK((smallest * across - across).norm() < 1e-12);
    }
    // About z, one by 0.2 and one, twice as long, by 0.5: the longer one counts more.
    const auto at = [](double angle) { return Vec3(std::cos(angle), std::sin(angle), 0); };
    const Mat3 mean =
        rotation_of({Vec3::UnitZ(), Vec3::UnitZ()},
                    std::array{Turned(at(0), at(0.2)), Turned(2 * at(1), 2 * at(1.5))});
    const double expected =
        std::atan2(std::sin(0.2) + 4 * std::sin(0.5), std::cos(0.2) + 4 * std::cos(0.5));
    CHECK(std::abs(std::atan2(mean(1, 0), mean(0, 0)) - expected) < 1e-14);
}

TEST_CASE("pairs follow every rigid motion exactly", "[turn]") {
    Random random(5);
    for (const auto& contact : every_contact(0, 0))
        for (int i = 0; i < 5; ++i) {
            const RigidMotion motion(random);
            const auto q = motion.applied(contact.rods).q;
            for (const auto& e : contact.elements)
                CHECK(difference(
                          turn_of(contact.rods.surfaces(), e, contact.rods.q, q, motion.rotation),
                          motion.rotation) < 1e-12);
        }
}

TEST_CASE("rods that slide across each other do not turn", "[turn]") {
    for (const double angle : {0.0, 0.1, 0.3, 1.0, 1.57, 2.5}) {
        const Crossing2 pair(angle);
        const Vec3 along_b(0, std::sin(angle), std::cos(angle));
        for (const Vec3& by : {Vec3(0.1 * Vec3::UnitZ()), Vec3(0.1 * along_b)}) {
            const Mat3 turn = pair.turn_to(pair.second_moved({Mat3::Identity(), by}));
            // What is left makes the slip of cables wrong by 4 % of it at most.
            const Vec3 missed = turn * Vec3(2, 0, 0) - Vec3(2, 0, 0);
            CHECK(missed.norm() < 0.04 * by.norm());
        }
    }
}

TEST_CASE("parallel rods turn with the line between their centres", "[turn]") {
    const Crossing2 pair(0);
    const double angle = 0.4;
    const Vec3 round(2 * std::cos(angle) - 2, 2 * std::sin(angle), 0);
    const Mat3 turn = pair.turn_to(pair.second_moved({Mat3::Identity(), round}));
    CHECK(difference(turn, Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix()) < 1e-14);
}

TEST_CASE("rods that open like scissors turn by half of it", "[turn]") {
    for (const double angle : {0.3, 1.57, 2.5}) {
        const Crossing2 pair(angle);
        const RigidMotion opened{Eigen::AngleAxisd(0.2, Vec3::UnitX()).toRotationMatrix(),
                                 Vec3::Zero()};
        const Mat3 half = Eigen::AngleAxisd(0.1, Vec3::UnitX()).toRotationMatrix();
        CHECK(difference(pair.turn_to(pair.second_moved(opened)), half) < 1e-14);
    }
}

TEST_CASE("pairs turn the same when a and b are swapped", "[turn]") {
    Random random(6);
    for (const auto& kind : all_kinds) {
        auto contact = random_contact(kind, smooth_beam, 0, 0.1, 8);
        const auto swapped = contact.rods.reversed();
        for (auto e : contact.elements) {
            const Mat3 turn = turn_of(contact.rods.surfaces(), e, contact.start, contact.rods.q);
            std::swap(e.s_a, e.s_b);
            CHECK(difference(turn, turn_of(swapped.surfaces(), e, contact.start, swapped.q)) <
                  1e-14);
        }
    }
}

TEST_CASE("centres that coincide leave the smallest rotation of the tangents", "[turn]") {
    Crossing2 pair(0);
    for (std::size_t i = 0; i < pair.rods.q.size(); i += 3)
        pair.rods.q[i] = 0;
    CHECK(difference(pair.turn_to(pair.rods.q), Mat3::Identity()) < 1e-14);
}
