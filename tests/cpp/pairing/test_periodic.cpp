#include "pairing/pairing.h"
#include "support/rods.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace braidx;
using namespace braidx::test;

namespace {

constexpr int num_elements = 20, beyond = 3;
constexpr double period = 20.0, radius = 1.0;

/// A tube along z that repeats itself after a period; its nodes past both ends are there.
void add_periodic(Rods& rods, const Kind& kind, const std::function<Vec3(double)>& at_z) {
    const double margin = period * beyond / num_elements;
    rods.add(kind, num_elements + 2 * beyond, radius,
             [&](double t) { return at_z(-margin + t * (period + 2 * margin)); });
    Tube& tube = rods.tubes.back();
    tube.first_unknown += std::int64_t{beyond} * tube.degree * tube.block;
    tube.num_elements = num_elements;
    tube.beyond = beyond;
}

/// Two yarns wound around each other once per period, from some phase on.
Rods twisted(const Kind& kind, double phase) {
    Rods rods;
    for (const double opposite : {0.0, std::numbers::pi})
        add_periodic(rods, kind, [=](double z) {
            const double angle = 2 * std::numbers::pi * z / period + phase + opposite;
            return Vec3(0.99 * std::cos(angle), 0.99 * std::sin(angle), z);
        });
    return rods;
}

/// A wavy yarn over a straight one, which it comes near at a height z.
Rods meeting_at(const Kind& kind, double height) {
    Rods rods;
    add_periodic(rods, kind, [](double z) { return Vec3(0, 0, z); });
    add_periodic(rods, kind, [=](double z) {
        const double angle = 2 * std::numbers::pi * (z - height) / period;
        return Vec3(1.98 + 3 * (1 - std::cos(angle)), 3 * std::sin(angle), z);
    });
    return rods;
}

double total_weight(const ContactElements& elements) {
    double sum = 0;
    for (const auto& e : elements)
        sum += e.weight;
    return sum;
}

} // namespace

TEST_CASE("yarns in contact all along a period have contact elements for just one", "[periodic]") {
    for (const auto& kind : all_kinds)
        for (const double spacing : {0.4, 0.7, 1.0, 2.2}) {
            INFO(kind.name << ", stations every " << spacing);
            PairingOptions options;
            options.spacing = spacing;
            double expected = 0;
            for (int k = 0; k < 7; ++k) {
                const Rods rods = twisted(kind, 0.9 * k);
                const auto elements =
                    make_contact_elements({rods.tubes, {}, {}}, rods.q, {}, options);
                const double weight = total_weight(elements);
                CHECK(weight == Catch::Approx(rods.tubes[0].length()).epsilon(1e-9));
                double first = 1e9, last = -1e9;
                for (const auto& e : elements) {
                    first = std::min(first, 0.5 * (e.s_a + e.s_b));
                    last = std::max(last, 0.5 * (e.s_a + e.s_b));
                }
                CHECK(last - first < num_elements);
                if (kind.degree == 1 && !kind.smooth)
                    continue; // where polygons have their points depends on the phase
                expected = k == 0 ? static_cast<double>(elements.size()) : expected;
                CHECK(static_cast<double>(elements.size()) == expected);
            }
        }
}

TEST_CASE("a contact at the end of a period is as good as one in its middle", "[periodic]") {
    for (const auto& kind : {smooth_cable, quadratic_cable, smooth_beam}) {
        INFO(kind.name);
        const auto weight_at = [&](double height) {
            const Rods rods = meeting_at(kind, height);
            return total_weight(make_contact_elements({rods.tubes, {}, {}}, rods.q, {}, {}));
        };
        // Beside a node: on the kink that degree 2 has there, round-off chooses the side.
        const double weight = weight_at(0.13);
        CHECK(weight == Catch::Approx(weight_at(0.13 + period / 2)).epsilon(1e-6));
        CHECK(weight == Catch::Approx(weight_at(0.13 + period)).epsilon(1e-6));
    }
}

TEST_CASE("a point station that passes the end of a period keeps its memory", "[periodic]") {
    const auto point_at = [](double height, const ContactElements& before, bool kept) {
        const Rods rods = meeting_at(smooth_cable, height);
        PairingOptions options;
        options.within_increment = kept;
        auto elements = make_contact_elements({rods.tubes, {}, {}}, rods.q, before, options);
        std::erase_if(elements, [](const auto& e) { return e.station != point_station; });
        return elements;
    };
    for (const bool kept : {false, true})
        for (const double sign : {1.0, -1.0}) {
            auto before = point_at(-0.31 + 0.1 * sign, {}, false);
            REQUIRE(before.size() == 1);
            before[0].work = 3.5;
            const auto after = point_at(-0.31 - 0.1 * sign, before, kept);
            REQUIRE(after.size() == 1);
            CHECK(after[0].work == 3.5);
            CHECK(std::abs(after[0].s_a - before[0].s_a) > num_elements / 2);
        }
}
