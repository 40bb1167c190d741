#include "pairing/pairing.h"
#include "support/rods.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

using namespace braidx;
using namespace braidx::test;

namespace {

/// Three rods side by side and one across them, all just in touch.
Rods raft(const Kind& kind) {
    Rods rods;
    for (int i = 0; i < 3; ++i)
        rods.add_straight(kind, 8, 1.0, {1.98 * i, 0, 0}, {1.98 * i, 0, 16});
    rods.add_straight(kind, 9, 1.0, {-4, 1.98, 6}, {8, 1.98, 9});
    return rods;
}

auto identity(const ContactElement& e) {
    return std::tuple(e.surface_a, e.surface_b, e.station, e.s_a, e.s_b);
}

auto all_of(const ContactElement& e) {
    const auto of = [](const Vec3& v) { return std::tuple(v[0], v[1], v[2]); };
    return std::tuple(identity(e), e.body_b, of(e.normal), e.follows, e.weight, e.stiffness,
                      e.xi_a[0], e.xi_a[1], e.xi_b[0], e.xi_b[1], of(e.slip), e.work, of(e.wall),
                      of(e.wall_start), e.allowance, e.zone, e.crossing);
}

} // namespace

TEST_CASE("normals are unit, from a to b, through the centres", "[pairing]") {
    for (const auto& kind : all_kinds) {
        INFO(kind.name);
        const Rods rods = raft(kind);
        const auto elements = make_contact_elements({rods.tubes, {}, {}}, rods.q, {}, {});
        std::set<std::pair<int, int>> met;
        for (const auto& e : elements) {
            const Vec3 d = position(rods.tubes[e.surface_b], rods.q, e.s_b) -
                           position(rods.tubes[e.surface_a], rods.q, e.s_a);
            CHECK((e.normal - d.normalized()).norm() < 1e-12);
            CHECK(e.body_b == rods.tubes[e.surface_b].body);
            CHECK(e.weight > 0);
            CHECK(e.slip.norm() == 0);
            met.emplace(e.surface_a, e.surface_b);
        }
        CHECK(met == std::set<std::pair<int, int>>{{0, 1}, {1, 2}, {0, 3}, {1, 3}, {2, 3}});
    }
}

TEST_CASE("particles of beams face each other and meet midway between the surfaces", "[pairing]") {
    const Rods rods = raft(beam);
    for (const auto& e : make_contact_elements({rods.tubes, {}, {}}, rods.q, {}, {})) {
        const auto particle = [&](const Tube& tube, double s, const double(&xi)[2]) -> Vec3 {
            const auto section = element_support(tube, s);
            return xi[0] * director(tube, rods.q, section, 1) +
                   xi[1] * director(tube, rods.q, section, 2);
        };
        const Vec3 a = particle(rods.tubes[e.surface_a], e.s_a, e.xi_a);
        const Vec3 b = particle(rods.tubes[e.surface_b], e.s_b, e.xi_b);
        const Vec3 apart = position(rods.tubes[e.surface_b], rods.q, e.s_b) -
                           position(rods.tubes[e.surface_a], rods.q, e.s_a);
        CHECK(std::abs((apart + b - a).dot(e.normal)) < 1e-12);
        CHECK(std::abs(a.norm() - b.norm()) < 1e-12);
        CHECK(a.dot(e.normal) > 0.9);
        CHECK(b.dot(e.normal) < -0.9);
    }
}

TEST_CASE("memory, penalty and side go from one update to the next", "[pairing]") {
    const Rods rods = raft(cable);
    auto first = make_contact_elements({rods.tubes, {}, {}}, rods.q, {}, {});
    for (auto& e : first) {
        e.slip = 0.003 * e.normal.unitOrthogonal();
        e.work = 1.25;
        e.stiffness = 777 + e.zone;
    }
    const auto second = make_contact_elements({rods.tubes, {}, {}}, rods.q, first, {});
    REQUIRE(second.size() == first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(identity(first[i]) == identity(second[i]));
        CHECK((first[i].slip - second[i].slip).norm() < 1e-15);
        CHECK(second[i].work == 1.25);
        CHECK(second[i].stiffness == first[i].stiffness);
        CHECK(first[i].zone == second[i].zone);
    }
}

TEST_CASE("all contact elements of a zone share the largest penalty", "[pairing]") {
    const Rods rods = raft(cable);
    auto first = make_contact_elements({rods.tubes, {}, {}}, rods.q, {}, {});
    for (std::size_t i = 0; i < first.size(); ++i)
        first[i].stiffness = 1000.0 + static_cast<double>(i);
    std::map<int, double> largest;
    for (const auto& e : first)
        largest[e.zone] = std::max(largest[e.zone], e.stiffness);
    for (const auto& e : make_contact_elements({rods.tubes, {}, {}}, rods.q, first, {}))
        CHECK(e.stiffness == largest.at(e.zone));
}

TEST_CASE("tubes pushed through each other keep their sides, if asked to", "[pairing]") {
    Rods rods;
    rods.add_straight(cable, 8, 1.0, {0, 0, 0}, {0, 0, 16});
    rods.add_straight(cable, 8, 1.0, {1.9, 0, 0}, {1.9, 0, 16});
    const auto before = make_contact_elements({rods.tubes, {}, {}}, rods.q, {}, {});
    REQUIRE_FALSE(before.empty());
    for (auto i = static_cast<std::size_t>(rods.tubes[1].first_unknown); i < rods.q.size(); i += 3)
        rods.q[i] = -0.3;
    PairingOptions options;
    for (const bool keep_side : {true, false}) {
        options.keep_side = keep_side;
        const Vec3 expected = keep_side ? Vec3::UnitX() : Vec3(-Vec3::UnitX());
        for (const auto& e : make_contact_elements({rods.tubes, {}, {}}, rods.q, before, options))
            CHECK((e.normal - expected).norm() < 1e-12);
    }
}

TEST_CASE("parts of the work add up to the whole", "[pairing]") {
    const Rods rods = raft(cable);
    const Surfaces surfaces{rods.tubes, {}, {{Plane{{0, -0.95, 0}, {0, 1, 0}}, 9}}};
    std::multiset<decltype(identity({}))> whole, parts;
    for (const auto& e : make_contact_elements(surfaces, rods.q, {}, {}))
        whole.insert(identity(e));
    for (int part = 0; part < 3; ++part) {
        PairingOptions options;
        options.part = part;
        options.num_parts = 3;
        for (const auto& e : make_contact_elements(surfaces, rods.q, {}, options))
            parts.insert(identity(e));
    }
    CHECK(whole == parts);
}

TEST_CASE("a rod on a plane touches it along its length", "[pairing]") {
    Rods rods;
    rods.add_straight(smooth_cable, 8, 1.0, {0, 0.9, 0}, {0, 0.9, 16});
    Rigid floor{Plane{{0, 0, 0}, {0, 1, 0}}, 5};
    floor.translation = {0.2, 0, 0};
    const auto elements = make_contact_elements({rods.tubes, {}, {floor}}, rods.q, {}, {});
    double length = 0;
    for (const auto& e : elements) {
        CHECK(against_rigid(e));
        CHECK(e.body_b == 5);
        CHECK((e.normal + Vec3::UnitY()).norm() < 1e-14);
        CHECK((e.wall - e.wall_start - Vec3(0.2, 0, 0)).norm() < 1e-14);
        length += e.weight;
    }
    CHECK(std::abs(length - 16) < 1e-9);
}

TEST_CASE("stations on a wall integrate cubics along elements of degree 2", "[pairing]") {
    Rods rods;
    rods.add_straight(quadratic_cable, 4, 1.0, {0, 0.99, 0}, {0, 0.99, 8});
    const Rigid floor{Plane{{0, 0, 0}, {0, 1, 0}}, 5};
    for (const double spacing : {1.0, 0.7, 0.5}) {
        PairingOptions options;
        options.spacing = spacing;
        for (int power = 0; power <= 3; ++power) {
            std::map<int, double> sums;
            for (const auto& e :
                 make_contact_elements({rods.tubes, {}, {floor}}, rods.q, {}, options)) {
                const double whole = std::floor(e.s_a);
                sums[static_cast<int>(whole)] += e.weight / 2 * std::pow(e.s_a - whole, power);
            }
            REQUIRE(sums.size() == 4);
            for (const auto& [element, sum] : sums)
                CHECK(std::abs(sum - 1.0 / (power + 1)) < 1e-14);
        }
    }
}

TEST_CASE("stacking order rules a crossing until it is separated, then geometry", "[pairing]") {
    for (const double height : {-0.5, 2.0}) { // of b over a; the order wants b outside
        Rods rods;
        rods.add_straight(cable, 8, 1.0, {10, -4, -8}, {10, 4, 8});
        rods.add_straight(cable, 8, 1.0, {10 + height, 4, -8}, {10 + height, -4, 8});
        const double l = rods.tubes[0].length();
        const Crossing crossing{0, 1, 0, l, 0, l, -1, {0, 0, 0}, {0, 0, 1}};
        const auto elements = make_contact_elements({rods.tubes, {crossing}, {}}, rods.q, {}, {});
        REQUIRE_FALSE(elements.empty());
        for (const auto& e : elements) {
            CHECK((e.crossing == 0) == (height < 0));
            CHECK(e.normal[0] > 0.5);
        }
    }
}

TEST_CASE("kept point stations keep their weight and follow the closest approach", "[pairing]") {
    Rods rods;
    rods.add_straight(smooth_cable, 10, 1.0, {0, 0, 0}, {0, 0, 20});
    rods.add_straight(smooth_cable, 10, 1.0, {1.98, -8, 4},
                      {1.98, 8, 15}); // 34.5 degrees: half sharp
    const auto points = [](const ContactElements& elements) {
        ContactElements out;
        for (const auto& e : elements)
            if (e.station == point_station)
                out.push_back(e);
        return out;
    };
    PairingOptions options;
    options.point_tolerance = 0.06;
    const auto before = make_contact_elements({rods.tubes, {}, {}}, rods.q, {}, options);
    REQUIRE(points(before).size() == 1);
    for (std::int32_t i = 0; i < rods.tubes[1].num_nodes(); ++i)
        rods.q[static_cast<std::size_t>(rods.tubes[1].unknown_of(i)) + 2] += 0.3;
    options.within_increment = true;
    const auto kept = points(make_contact_elements({rods.tubes, {}, {}}, rods.q, before, options));
    REQUIRE(kept.size() == 1);
    CHECK(kept[0].weight == points(before)[0].weight);
    CHECK(std::abs(kept[0].s_a - points(before)[0].s_a - 0.15) < 1e-6);
}

TEST_CASE("every pair is one process's own", "[pairing]") {
    for (std::int64_t a = 0; a < 5; ++a)
        for (std::int64_t b = 0; b < 5; ++b) {
            int owners = 0;
            for (int part = 0; part < 3; ++part) {
                PairingOptions options;
                options.part = part;
                options.num_parts = 3;
                owners += is_own(options, a, b);
            }
            CHECK(owners == 1);
        }
}

TEST_CASE("any number of threads makes the same contact elements, bit by bit", "[pairing]") {
    for (const auto& kind : all_kinds) {
        INFO(kind.name);
        Rods rods = raft(kind);
        Random random(3);
        rods.shake(random, 0.1);
        const double l = rods.tubes[0].length();
        const Crossing crossing{0, 3, 0, l, 0, l, 1, {-1, 0, 0}, {0, 0, 1}};
        const Surfaces surfaces{rods.tubes, {crossing}, {{Plane{{0, -0.95, 0}, {0, 1, 0}}, 9}}};
        auto previous = make_contact_elements(surfaces, rods.q, {}, {});
        for (auto& e : previous)
            e.slip = 0.003 * e.normal.unitOrthogonal();
        const auto expected = make_contact_elements(surfaces, rods.q, previous, {});
        std::set<bool> rigid;
        for (const auto& e : expected)
            rigid.insert(against_rigid(e));
        CHECK(rigid.size() == 2);
        for (const int num_threads : {2, 3, 50}) {
            PairingOptions options;
            options.num_threads = num_threads;
            const auto found = make_contact_elements(surfaces, rods.q, previous, options);
            REQUIRE(found.size() == expected.size());
            for (std::size_t i = 0; i < found.size(); ++i)
                CHECK(all_of(found[i]) == all_of(expected[i]));
        }
    }
}

TEST_CASE("weights of point stations grow and fade step by step on tubes that touched before",
          "[pairing]") {
    PairingOptions options;
    const auto crossed_at = [&](double angle, const ContactElements& before) {
        Rods rods;
        rods.add_straight(smooth_cable, 12, 1.0, {0, 0, -10}, {0, 0, 10});
        const Vec3 along(0, 10 * std::sin(angle), 10 * std::cos(angle));
        rods.add_straight(smooth_cable, 12, 1.0, Vec3(1.98, 0, 0) - along,
                          Vec3(1.98, 0, 0) + along);
        return make_contact_elements({rods.tubes, {}, {}}, rods.q, before, options);
    };
    const auto point_weight = [](const ContactElements& elements) {
        double weight = 0;
        for (const auto& e : elements)
            weight += e.station == point_station ? e.weight : 0;
        return weight;
    };
    CHECK(point_weight(crossed_at(0.2, {})) == 0);
    CHECK(point_weight(crossed_at(0.8, {})) > 0.9); // fresh tubes: at once

    auto elements = crossed_at(0.2, {});
    double weight = 0;
    for (int step = 0; weight < 0.9; ++step) {
        REQUIRE(step < 10);
        elements = crossed_at(0.8, elements);
        CHECK(point_weight(elements) > weight);
        CHECK(point_weight(elements) <= 2 * weight + 0.03);
        weight = point_weight(elements);
    }
    for (int step = 0; weight > 0; ++step) {
        REQUIRE(step < 10);
        elements = crossed_at(0.2, elements);
        CHECK(point_weight(elements) < weight);
        CHECK((point_weight(elements) >= 0.49 * weight || point_weight(elements) == 0));
        weight = point_weight(elements);
    }
}
