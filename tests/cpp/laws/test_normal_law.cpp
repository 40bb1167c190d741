#include "laws/normal_law.h"

#include <catch2/catch_test_macros.hpp>

using braidx::NormalLaw;
using braidx::reduced_gap;

namespace {

constexpr double k = 1200, p = 0.004;
constexpr NormalLaw law{k, p};

bool near(double value, double expected, double tolerance) {
    return std::abs(value - expected) <= tolerance * std::max(1.0, std::abs(expected));
}

} // namespace

TEST_CASE("C1: value, slope and energy at the threshold, from both sides", "[normal_law]") {
    for (const double side : {-1e-13, 0.0, 1e-13}) {
        CHECK(near(law.force(-p + side), k * p / 2, 1e-9));
        CHECK(near(law.tangent(-p + side), k, 1e-9));
        CHECK(near(law.energy(-p + side), k * p * p / 6, 1e-9));
    }
}

TEST_CASE("the law is that of paper 1, eq. (4)", "[normal_law]") {
    CHECK(law.force(0.1) == 0);
    CHECK(law.force(0) == 0);
    CHECK(law.tangent(0) == 0);
    CHECK(near(law.force(-p / 2), k / (2 * p) * p * p / 4, 1e-12));
    CHECK(near(law.force(-5 * p), k * (5 * p - p / 2), 1e-12));
}

TEST_CASE("force is the derivative of energy, tangent that of force", "[normal_law]") {
    const double h = 1e-7;
    for (double gap = -3.013 * p; gap < p; gap += 0.071 * p) {
        INFO("gap " << gap);
        CHECK(near(-(law.energy(gap + h) - law.energy(gap - h)) / (2 * h), law.force(gap), 1e-6));
        CHECK(near(-(law.force(gap + h) - law.force(gap - h)) / (2 * h), law.tangent(gap), 1e-6));
    }
}

TEST_CASE("a force has its penetration", "[normal_law]") {
    CHECK(law.penetration(0) == 0);
    for (double gap = -3.013 * p; gap < 0; gap += 0.071 * p)
        CHECK(near(law.penetration(law.force(gap)), -gap, 1e-12));
}

TEST_CASE("gap reduction lets an element open by one step, and no more", "[normal_law]") {
    CHECK(reduced_gap(-0.5, -0.5, 0.1) == -0.5 + 0.4);   // acts with one step of penetration
    CHECK(near(reduced_gap(-0.4, -0.5, 0.1), 0, 1e-15)); // opened by one step: free
    CHECK(reduced_gap(-0.05, -0.05, 0.1) == -0.05);      // less than a step deep: unchanged
    CHECK(reduced_gap(-0.5, 0.2, 0.1) == -0.5);          // did not touch: unchanged
    CHECK(reduced_gap(-0.5, -0.5, -1) == -0.5);          // switched off
}

TEST_CASE("gap reduction is continuous in both gaps", "[normal_law]") {
    const double step = 0.1, h = 1e-9;
    for (double start = -0.3; start < 0.1; start += 0.01)
        for (double gap = -0.3; gap < 0.1; gap += 0.01) {
            const double here = reduced_gap(gap, start, step);
            CHECK(std::abs(reduced_gap(gap, start + h, step) - here) < 1.1 * h);
            CHECK(std::abs(reduced_gap(gap + h, start, step) - here - h) < 0.1 * h);
            CHECK(here >= gap);
        }
}
