#include "support/random.h"
#include "surfaces/rigid.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <numbers>

using namespace braidx;
using namespace braidx::test;

namespace {

const Vec3 axis = Vec3(1, 2, 2) / 3;
const Vec3 origin(0.5, -1, 2);

const Plane plane{origin, axis};
const Cylinder bar{origin, axis, 3, false};
const Cylinder bore{origin, axis, 3, true};
const Sheave sheave{origin, axis, 10, 2};

/// Distance from the surface, positive outside the solid.
double distance(const Rigid& rigid, const Vec3& x) {
    const auto at = rigid.nearest(x);
    return (x - at.position).dot(at.normal);
}

/// A place by cylindrical coordinates about the axis.
Vec3 place(double radius, double angle, double height) {
    const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
    return origin + radius * (std::cos(angle) * u + std::sin(angle) * v) + height * axis;
}

} // namespace

TEST_CASE("the nearest point lies on the surface, along the unit normal", "[rigid]") {
    Random random;
    for (const auto& rigid : {Rigid{plane, 0}, Rigid{bar, 0}, Rigid{bore, 0}, Rigid{sheave, 0}})
        for (int i = 0; i < 200; ++i) {
            INFO("shape " << rigid.shape.index());
            const Vec3 x = random.vector(15);
            const auto at = rigid.nearest(x);
            CHECK(std::abs(at.normal.norm() - 1) < 1e-14);
            CHECK((x - at.position).cross(at.normal).norm() < 1e-12 * (1 + x.norm()));
            CHECK((rigid.nearest(at.position).position - at.position).norm() < 1e-12);
        }
}

TEST_CASE("the normal is the gradient of the distance", "[rigid]") {
    Random random(2);
    const double h = 1e-5;
    for (const auto& rigid : {Rigid{plane, 0}, Rigid{bar, 0}, Rigid{bore, 0}, Rigid{sheave, 0}})
        for (int i = 0; i < 200; ++i) {
            const Vec3 x =
                place(random.uniform(1, 15), random.uniform(0, 6), random.uniform(0.1, 3));
            Vec3 gradient;
            for (int k = 0; k < 3; ++k)
                gradient[k] = (distance(rigid, x + h * Vec3::Unit(k)) -
                               distance(rigid, x - h * Vec3::Unit(k))) /
                              (2 * h);
            INFO("shape " << rigid.shape.index() << ", x = " << x.transpose());
            CHECK((gradient - rigid.nearest(x).normal).norm() < 1e-6);
        }
}

TEST_CASE("plane, bar and bore: distance in closed form", "[rigid]") {
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        const double r = random.uniform(0.1, 6), height = random.uniform(-5, 5);
        const Vec3 x = place(r, random.uniform(0, 6), height);
        CHECK(std::abs(distance({plane, 0}, x) - height) < 1e-12);
        CHECK(std::abs(distance({bar, 0}, x) - (r - 3)) < 1e-12);
        CHECK(std::abs(distance({bore, 0}, x) - (3 - r)) < 1e-12);
    }
}

TEST_CASE("a point on the axis of a bar still has a nearest point", "[rigid]") {
    const auto at = bar.nearest(origin + 2 * axis);
    CHECK(std::abs((at.position - origin - 2 * axis).norm() - 3) < 1e-12);
    CHECK(std::abs(at.normal.dot(axis)) < 1e-12);
}

TEST_CASE("groove of a sheave: nothing of it is nearer than the nearest point", "[rigid]") {
    Random random(4);
    for (int i = 0; i < 50; ++i) {
        const Vec3 x =
            place(random.uniform(5, 14), random.uniform(0, 6), random.uniform(-1.9, 1.9));
        const double nearest = (x - sheave.nearest(x).position).norm();
        double sampled = 1e9;
        for (int turn = 0; turn < 120; ++turn)
            for (int k = 0; k <= 40; ++k) { // round bottom, then both flanks
                const double angle = turn * std::numbers::pi / 60, way = k * std::numbers::pi / 40;
                const Vec3 bottom = place(10 - 2 * std::sin(way), angle, 2 * std::cos(way));
                sampled = std::min({sampled, (x - bottom).norm(),
                                    (x - place(10 + 0.2 * k, angle, 2)).norm(),
                                    (x - place(10 + 0.2 * k, angle, -2)).norm()});
            }
        CHECK(nearest < sampled + 1e-9);
        CHECK(nearest > sampled - 0.35);
    }
}

TEST_CASE("groove of a sheave: distance of a rope in it, and of one that leaves it", "[rigid]") {
    const Rigid rigid{sheave, 0};
    CHECK(std::abs(distance(rigid, place(10, 1, 0)) - 2) < 1e-12);     // centre of the groove
    CHECK(std::abs(distance(rigid, place(9, 1, 0)) - 1) < 1e-12);      // over its bottom
    CHECK(std::abs(distance(rigid, place(7, 1, 0)) + 1) < 1e-12);      // in the disc
    CHECK(std::abs(distance(rigid, place(10, 1, 1.5)) - 0.5) < 1e-12); // beside a flank
    const Vec3 away = (place(10, 1 + 1e-6, 0) - place(10, 1, 0)).normalized();
    for (double length = 0; length < 60; length += 2.5) // straight off along the tangent: free
        CHECK(std::abs(distance(rigid, place(10, 1, 0) + length * away) - 2) < 1e-4);
}

TEST_CASE("at_start undoes the motion of the increment", "[rigid]") {
    Random random(5);
    for (int i = 0; i < 20; ++i) {
        const Vec3 turn = i == 0 ? Vec3::Zero() : random.vector(2);
        const Rigid rigid{plane, 0, random.vector(5), turn, random.vector(3)};
        const Vec3 x = random.vector(10);
        const Mat3 rotation =
            i == 0 ? Mat3::Identity()
                   : Mat3(Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix());
        const Vec3 moved = rigid.pivot + rotation * (x - rigid.pivot) + rigid.translation;
        CHECK((rigid.at_start(moved, {}, {}) - x).norm() < 1e-12);
    }
}
