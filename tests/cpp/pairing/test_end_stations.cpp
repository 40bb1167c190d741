#include "pairing/end_stations.h"
#include "support/skin_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

using namespace braidx;
using namespace braidx::test;

namespace {

constexpr double radius = 0.5;

/// Tubes whose ends touch.
Rods with_ends(Rods rods) {
    for (auto& tube : rods.tubes)
        tube.round_ends = true;
    return rods;
}

/// Two straight tubes of radius 0.5.
Rods two_tubes(const Kind& kind, const Vec3& from_a, const Vec3& to_a, const Vec3& from_b,
               const Vec3& to_b) {
    Rods rods;
    rods.add_straight(kind, 6, radius, from_a, to_a);
    rods.add_straight(kind, 5, radius, from_b, to_b);
    return with_ends(std::move(rods));
}

/// Force of b on a when contact elements are made anew, N.
Vec3 force_on_a(const Rods& rods, const std::vector<Rigid>& rigid = {}) {
    Vec3 out = Vec3::Zero();
    for (const auto& e : pair_up(rods, {}, {}, rigid))
        out -= reaction(rods.surfaces(), e, rods.q, rods.q, {}).normal_force * e.normal;
    return out;
}

/// Smallest distance of two centre lines by sampling them: knows nothing of stations.
double sampled_distance(const Rods& rods) {
    double out = std::numeric_limits<double>::infinity();
    const auto places = [&](std::size_t t) {
        std::vector<Vec3> x;
        const Tube& tube = rods.tubes[t];
        for (int i = 0; i <= 300; ++i)
            x.push_back(position(tube, rods.q, tube.num_elements * i / 300.0));
        return x;
    };
    for (const Vec3& x : places(0))
        for (const Vec3& y : places(1))
            out = std::min(out, (x - y).norm());
    return out;
}

/// The largest change of the force on a over steps of a motion that is told how far it has gone.
template <class Make> double largest_change(const Make& make, double way, int steps) {
    double out = 0;
    Vec3 last = force_on_a(make(0.0));
    for (int i = 1; i <= steps; ++i) {
        const Vec3 next = force_on_a(make(way * i / steps));
        out = std::max(out, (next - last).norm());
        last = next;
    }
    return out;
}

} // namespace

TEST_CASE("no overlap of two tubes is missed, at their ends neither", "[end_stations]") {
    Random random(5);
    int at_ends = 0;
    for (int i = 0; i < 600; ++i) {
        const auto& kind = all_kinds[static_cast<std::size_t>(i) % std::size(all_kinds)];
        const auto tube = [&](const Vec3& middle) {
            const Vec3 along = random.vector(1).normalized(), across = random.vector(0.2);
            return [=](double t) -> Vec3 {
                return middle + 5 * (t - 0.5) * along + t * (1 - t) * across;
            };
        };
        Rods rods;
        rods.add(kind, 6, radius, tube(Vec3::Zero()));
        rods.add(kind, 5, radius, tube(random.vector(3)));
        rods = with_ends(std::move(rods));
        const double overlap = 2 * radius - sampled_distance(rods);
        if (overlap < 0.02 || overlap > 0.5)
            continue;
        double deepest = 0;
        for (const auto& e : pair_up(rods)) {
            const double depth = -gap(rods, e);
            if (depth > deepest)
                deepest = depth;
            at_ends += e.s_a == 0 || e.s_a == 6 || e.s_b == 0 || e.s_b == 5;
        }
        INFO(i << " " << kind.name << " overlap " << overlap);
        // A little less is seen where stations miss less than the tolerance, 0.005 mm of radii.
        CHECK(std::abs(deepest - overlap) < 0.01);
    }
    CHECK(at_ends > 20);
}

TEST_CASE("what slides over an end loses its force continuously", "[end_stations]") {
    // Crossing at right angles and askew: half the step, half the largest change.
    for (const auto& kind : all_kinds)
        for (const double askew : {0.0, 0.7, 2.0}) {
            const auto make = [&](double way) {
                const Vec3 along = Vec3(askew, 1, 0).normalized();
                const Vec3 middle(way - 0.8, 0, 0.98);
                return two_tubes(kind, {-5, 0, 0}, {0, 0, 0}, middle - 2.5 * along,
                                 middle + 2.5 * along);
            };
            INFO(kind.name << " askew " << askew);
            CHECK(force_on_a(make(0)).norm() > 1);
            const double coarse = largest_change(make, 2.5, 200),
                         fine = largest_change(make, 2.5, 400);
            CHECK(fine < 0.6 * coarse);
        }
}

TEST_CASE("a tube pushed end-on touches with its half sphere", "[end_stations]") {
    for (const auto& kind : all_kinds) {
        INFO(kind.name);
        for (const bool to_end : {false, true}) { // against the side of a tube, or against its end
            const double away = 2 * radius - 0.02;
            const Rods rods =
                to_end ? two_tubes(kind, {-5, 0, 0}, {0, 0, 0}, {away, 0, 0}, {6, 0, 0})
                       : two_tubes(kind, {-5, 0, 0}, {0, 0, 0}, {away, -3, 0}, {away, 2, 0});
            const auto elements = pair_up(rods);
            const auto deepest =
                std::ranges::min_element(elements, {}, [&](const auto& e) { return gap(rods, e); });
            REQUIRE(deepest != elements.end());
            CHECK(std::abs(gap(rods, *deepest) + 0.02) < 1e-9);
            CHECK((deepest->normal - Vec3::UnitX()).norm() < 1e-9);
            CHECK(std::abs(deepest->weight - 1) < 1e-9); // a whole spacing
            const Vec3 force = force_on_a(rods);
            CHECK(force[0] < -1);
            CHECK((force_on_a(rods.reversed()) + force).norm() < 1e-9 * force.norm());
        }
    }
}

TEST_CASE("a tube touches walls and sheets with its end", "[end_stations]") {
    const Rigid floor{Plane{{0, 0, 0}, Vec3::UnitZ()}, 1};
    for (const auto& kind : all_kinds)
        for (const double tilt : {0.0, 0.4, 1.2, 1.55}) {
            INFO(kind.name << " tilted by " << tilt);
            const Vec3 along(std::sin(tilt), 0, std::cos(tilt)), end(0.1, 0.2, radius - 0.02);
            Rods rods;
            rods.add_straight(kind, 4, radius, end, end + 5 * along);
            rods = with_ends(std::move(rods));
            const auto deepest_of = [&](const ContactElements& elements) {
                double out = std::numeric_limits<double>::infinity();
                for (const auto& e : elements)
                    out = std::min(out, gap(rods, e));
                return out;
            };
            CHECK(std::abs(deepest_of(pair_up(rods, {}, {}, {floor})) + 0.02) < 1e-9);
            add_rectangle(rods, FacetKind::square4, {4, 4}, {-3, -3, 0}, {9, 0, 0}, {0, 6, 0});
            CHECK(std::abs(deepest_of(pair_up(rods)) + 0.02) < 1e-9);
        }
}

TEST_CASE("ends that do not touch have no stations", "[end_stations]") {
    Rods rods = two_tubes(beam, {-5, 0, 0}, {0, 0, 0}, {0.9, 0, 0}, {6, 0, 0});
    CHECK(pair_up(rods).size() == 1);
    rods.tubes[0].round_ends = rods.tubes[1].round_ends = false;
    CHECK(pair_up(rods).empty());
}

TEST_CASE("the tangent of contact at ends is exact", "[end_stations]") {
    const Rigid wall{Plane{{0.45, 0, 0}, -Vec3::UnitX()}, 1};
    for (const auto& kind : all_kinds)
        for (const double mu : {0.0, 0.3}) {
            const Vec3 along = Vec3(0.3, 1, 0.2).normalized(), middle(0.9, 0.1, 0.2);
            Rods rods =
                two_tubes(kind, {-5, 0, 0}, {0, 0, 0}, middle - 2.5 * along, middle + 2.5 * along);
            add_rectangle(rods, FacetKind::square9, {2, 2}, {0.46, -2, -2}, {0, 0, 4}, {0, 4, 0});
            auto contact = contact_on(std::move(rods), mu, 0.01, {wall}, 0.002);
            std::erase_if(contact.elements, [&](const auto& e) {
                return e.surface_a != 0 || e.s_a != contact.rods.tubes[0].num_elements ||
                       gap(contact.rods, e) > 0;
            });
            INFO(kind.name << " mu " << mu);
            CHECK(contact.elements.size() == 3); // tube, sheet and wall
            const Matrix tangent = contact.tangent(FrictionTangent::consistent),
                         expected = contact.finite_difference_tangent();
            CHECK((tangent - expected).norm() < 1e-6 * expected.norm());
        }
}
