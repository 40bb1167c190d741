#include "laws/friction_law.h"
#include "support/random.h"

#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

constexpr double mu = 0.3, reversible = 0.01;
const FrictionLaw law{mu, reversible};

/// A random slip of given size in the plane normal to N.
Vec3 random_slip(Random& random, const Vec3& normal, double size) {
    const Vec3 v = random.unit();
    return size * (v - v.dot(normal) * normal).normalized();
}

} // namespace

TEST_CASE("friction grows with the reversible slip, then slides at mu", "[friction_law]") {
    Random random;
    for (int i = 0; i < 20; ++i) {
        const Vec3 slip = random_slip(random, Vec3::UnitZ(), random.uniform(0, 3 * reversible));
        const double share = std::min(1.0, slip.norm() / reversible);
        CHECK((law.direction(slip) - mu * share * slip.normalized()).norm() < 1e-14);
        CHECK((law.remembered(slip) - share * reversible * slip.normalized()).norm() < 1e-15);
    }
    CHECK(law.direction(Vec3::Zero()).norm() == 0);
    CHECK(law.remembered(Vec3::Zero()).norm() == 0);
}

TEST_CASE("friction is continuous where sliding starts", "[friction_law]") {
    const Vec3 along = Vec3(3, 4, 0) / 5;
    const Vec3 before = law.direction((1 - 1e-12) * reversible * along);
    const Vec3 after = law.direction((1 + 1e-12) * reversible * along);
    CHECK((before - after).norm() < 1e-11);
}

TEST_CASE("friction is the gradient of its potential, sticking and sliding", "[friction_law]") {
    Random random(3);
    const double h = 1e-6 * reversible;
    for (int i = 0; i < 40; ++i) {
        const double size =
            reversible * (i % 2 ? random.uniform(0.1, 0.9) : random.uniform(1.1, 5));
        const Vec3 slip = random_slip(random, Vec3::UnitZ(), size), along = random.unit();
        const double change = law.potential(slip + h * along) - law.potential(slip - h * along);
        CHECK(std::abs(change / (2 * h) - law.direction(slip).dot(along)) < 1e-6 * mu);
    }
}

TEST_CASE("gradient of friction in the tangent plane, sticking and sliding", "[friction_law]") {
    Random random(2);
    const double h = 1e-7;
    for (int i = 0; i < 40; ++i) {
        const Vec3 normal = random.unit();
        const Mat3 plane = Mat3::Identity() - normal * normal.transpose();
        const double size =
            reversible * (i % 2 ? random.uniform(0.1, 0.9) : random.uniform(1.1, 5));
        const Vec3 slip = random_slip(random, normal, size);
        const Mat3 gradient = law.direction_gradient(slip, plane);
        CHECK((gradient - gradient.transpose()).norm() < 1e-12);
        for (int j = 0; j < 3; ++j) {
            const Vec3 step = h * plane.col(j);
            const Vec3 change = (law.direction(slip + step) - law.direction(slip - step)) / (2 * h);
            CHECK((gradient * plane.col(j) - change).norm() < 1e-5 * mu / reversible);
        }
    }
}
