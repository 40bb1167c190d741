#include "assembly/half_width.h"

#include "support/random.h"

#include <Eigen/Geometry>

#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

using Directors = std::array<Vec3, 2>;

/// Some section, deformed and turned.
Directors section(Random& random) {
    return {random.unit() * random.uniform(0.8, 1.2), random.unit() * random.uniform(0.8, 1.2)};
}

} // namespace

TEST_CASE("half width of an ellipse in its plane is its stretch towards the normal",
          "[half_width]") {
    const Directors g{1.2 * Vec3::UnitX(), 0.9 * Vec3::UnitY()};
    CHECK(std::abs(half_width(g, Vec3::UnitX()).value - 1.2) < 1e-14);
    CHECK(std::abs(half_width(g, Vec3::UnitY()).value - 0.9) < 1e-14);
}

TEST_CASE("derivatives of the half width against finite differences", "[half_width]") {
    Random random(1);
    const double step = 1e-6;
    for (int trial = 0; trial < 50; ++trial) {
        const Directors g = section(random), move{random.vector(1), random.vector(1)};
        const Vec3 normal = random.unit();
        if (g[0].cross(g[1]).norm() < 0.3 || std::hypot(g[0].dot(normal), g[1].dot(normal)) < 0.3)
            continue; // hardly a section, or seen along the yarn
        const auto at = [&](double size) {
            return half_width({g[0] + size * move[0], g[1] + size * move[1]}, normal);
        };
        const auto here = at(0), ahead = at(step), behind = at(-step);
        const double slope = here.gradient[0].dot(move[0]) + here.gradient[1].dot(move[1]);
        CHECK(std::abs((ahead.value - behind.value) / (2 * step) - slope) < 1e-8);
        for (const int a : {0, 1}) {
            const Vec3 difference = (ahead.gradient[a] - behind.gradient[a]) / (2 * step);
            const Vec3 expected = here.hessian[a][0] * move[0] + here.hessian[a][1] * move[1];
            CHECK((difference - expected).norm() < 1e-6 * (1 + expected.norm()));
        }
        CHECK((here.hessian[0][1] - here.hessian[1][0].transpose()).norm() < 1e-12);
    }
}
