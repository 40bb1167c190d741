#include "support/rigid_motion.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <limits>
#include <numbers>

using namespace braidx;
using namespace braidx::test;

namespace {

/// A ring of few elements and, `apart` outside its centre line, a straight rod that runs past the
/// middle of one of them, parallel to the ring's axis. Radii are 1, but for that of the rod.
Rods ring_and_rod(const Kind& kind, int num_elements, double ring, double radius, double apart) {
    Rods rods;
    rods.add(kind, num_elements, 1, [&](double u) -> Vec3 {
        const double angle = 2 * std::numbers::pi * u;
        return ring * Vec3(std::cos(angle), std::sin(angle), 0);
    });
    // On the true curve, which is symmetric about the middle of an inner element.
    const Vec3 middle = position(rods.tubes[0], rods.q, num_elements / 2 + 0.5),
               place = middle + apart * middle.normalized();
    rods.add_straight(kind, 2, radius, place - Vec3(0, 0, 4.3), place + Vec3(0, 0, 5.1));
    return rods;
}

double smallest_gap(const Rods& rods, const ContactElements& elements) {
    double out = std::numeric_limits<double>::infinity();
    for (const auto& e : elements)
        out = std::min(out, gap(rods, e));
    return out;
}

} // namespace

TEST_CASE("a rod past the middle of a curved element touches it, however deep", "[pairing]") {
    struct Case {
        const Kind& kind;
        int num_elements;
        double ring;
    };
    // Sagittas of 1.5, 5.9 and 10 radii; curves of degree 1 leave their chords by less.
    const Case cases[] = {{quadratic_beam, 8, 20}, {quadratic_cable, 8, 20},
                          {quadratic_beam, 4, 20}, {quadratic_beam, 3, 20},
                          {smooth_beam, 16, 20},   {smooth_cable, 8, 20},
                          {beam, 16, 20}};
    Random random(5);
    for (const auto& [kind, num_elements, ring] : cases)
        for (const double radius : {0.2, 1.0})
            for (const double share : {-0.1, -0.5, -1.0, -1.2, 0.05}) {
                const double wanted = share * std::min(radius, 1.0), touch = 1 + radius;
                const Rods rods = RigidMotion(random).applied(
                    ring_and_rod(kind, num_elements, ring, radius, touch + wanted));
                PairingOptions options;
                options.search = {0.5 * radius, std::numeric_limits<double>::infinity()};
                options.spacing = 2 * radius;
                options.point_tolerance = 5e-3 * radius;
                const auto elements = pair_up(rods, {}, options);
                INFO(kind.name << ", " << num_elements << " elements, rod " << radius << ", gap "
                               << wanted);
                REQUIRE_FALSE(elements.empty());
                CHECK(std::abs(smallest_gap(rods, elements) - wanted) < 1e-6);
            }
}
