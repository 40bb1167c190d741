#include "pairing/history.h"
#include "support/rods.h"

#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

ContactElement element_at(double s_a, double s_b, std::int64_t station, const Vec3& normal) {
    ContactElement e{};
    e.surface_a = 0;
    e.surface_b = 1;
    e.s_a = s_a;
    e.s_b = s_b;
    e.station = station;
    e.normal = normal;
    return e;
}

Rods two_rods() {
    Rods rods;
    rods.add_straight(cable, 10, 1.0, {0, 0, 0}, {0, 0, 20});
    rods.add_straight(cable, 10, 1.0, {2, 0, 0}, {2, 0, 30});
    return rods;
}

} // namespace

TEST_CASE("the predecessor is the nearest of the same tubes and station", "[history]") {
    const Rods rods = two_rods();
    ContactElements old;
    old.push_back(element_at(2.0, 2.0, 5, Vec3::UnitX()));
    old.push_back(element_at(3.0, 3.0, 5, Vec3::UnitX()));
    old.push_back(element_at(3.1, 3.0, 6, Vec3::UnitX()));
    old.push_back(element_at(3.1, 3.0, 5, Vec3::UnitX()));
    old.back().surface_b = 2;
    const History history(old, rods.tubes);
    CHECK(history.predecessor(element_at(3.1, 3.0, 5, Vec3::UnitX()), 1.0) == &old[1]);
    CHECK(history.predecessor(element_at(2.2, 2.0, 5, Vec3::UnitX()), 1.0) == &old[0]);
    CHECK(history.predecessor(element_at(3.1, 3.0, 7, Vec3::UnitX()), 1.0) == nullptr);
    CHECK(history.predecessor(element_at(6.0, 3.0, 5, Vec3::UnitX()), 1.0) == nullptr);
    CHECK(history.predecessor(element_at(3.0, 3.5, 5, Vec3::UnitX()), 1.0) == nullptr); // 1.5 mm
}

TEST_CASE("nothing is inherited from nothing", "[history]") {
    const Rods rods = two_rods();
    const ContactElements none;
    const History history(none, rods.tubes);
    CHECK(history.predecessor(element_at(1, 1, 0, Vec3::UnitX()), 1e9) == nullptr);
}

TEST_CASE("walls keep to themselves", "[history]") {
    const Rods rods = two_rods();
    ContactElements old;
    for (const int wall : {0, 1}) {
        old.push_back(element_at(2, 0, 4, Vec3::UnitX()));
        old.back().surface_b = -1 - wall;
    }
    const History history(old, rods.tubes);
    auto element = element_at(2, 0, 4, Vec3::UnitX());
    element.surface_b = -2;
    CHECK(history.predecessor(element, 1.0) == &old[1]);
}

TEST_CASE("memory is handed on", "[history]") {
    auto old = element_at(2, 2, 5, Vec3::UnitX());
    old.slip = {0, 0.003, 0.004};
    old.work = 3.5;
    old.stiffness = 4321;
    old.multiplier = 8.5;
    auto element = element_at(2, 2, 5, Vec3(0.8, 0.6, 0));
    inherit(element, old, true);
    CHECK(element.slip == old.slip); // in the directions of the start of the increment
    CHECK(element.work == 3.5);
    CHECK(element.stiffness == 4321);
    CHECK(element.multiplier == 8.5);
}

TEST_CASE("the normal keeps its side, whatever the centres say", "[history]") {
    Random random(2);
    for (int i = 0; i < 20; ++i) {
        const auto old = element_at(2, 2, 5, random.unit());
        const Vec3 tilted = (old.normal + 0.5 * random.unit()).normalized();
        auto through = element_at(2, 2, 5, -tilted); // the centres have passed each other
        inherit(through, old, true);
        CHECK((through.normal - tilted).norm() < 1e-15);
        auto free = element_at(2, 2, 5, -tilted); // not asked to keep it
        inherit(free, old, false);
        CHECK((free.normal + tilted).norm() < 1e-15);
        auto same = element_at(2, 2, 5, tilted);
        inherit(same, old, true);
        CHECK((same.normal - tilted).norm() < 1e-15);
    }
}

TEST_CASE("a stacking order and a wall overrule the remembered side", "[history]") {
    const auto old = element_at(2, 2, 5, Vec3::UnitX());
    auto ordered = element_at(2, 2, 5, -Vec3::UnitX());
    ordered.crossing = 3;
    inherit(ordered, old, true);
    CHECK(ordered.normal == -Vec3::UnitX());
    auto wall = element_at(2, 2, 5, -Vec3::UnitX());
    wall.surface_b = -1;
    inherit(wall, old, true);
    CHECK(wall.normal == -Vec3::UnitX());
}
