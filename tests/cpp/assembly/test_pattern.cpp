#include "support/contact.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <set>

using namespace braidx;
using namespace braidx::test;

namespace {

using Block = std::pair<std::int64_t, std::int64_t>;

} // namespace

TEST_CASE("blocks of the pattern are unique, sorted and complete", "[pattern]") {
    const auto contact = mixed_contacts();
    const auto pattern = make_pattern(contact.rods.tubes, contact.elements);
    std::vector<Block> found;
    for (std::size_t i = 0; i < pattern.row.size(); ++i)
        found.emplace_back(pattern.row[i], pattern.col[i]);
    std::set<Block> expected;
    for (const auto& e : contact.elements) {
        const auto system = local_system(contact.rods.tubes, e, contact.rods.q);
        for (int i = 0; i < system.count; ++i)
            for (int j = 0; j < system.count; ++j)
                expected.emplace(system.unknown[i], system.unknown[j]);
    }
    CHECK(found == std::vector<Block>(expected.begin(), expected.end()));
}

TEST_CASE("each contact element adds to the blocks of its own unknowns", "[pattern]") {
    const auto contact = mixed_contacts();
    const auto pattern = make_pattern(contact.rods.tubes, contact.elements);
    REQUIRE(pattern.first_slot.size() == contact.elements.size());
    for (std::size_t e = 0; e < contact.elements.size(); ++e) {
        const auto system = local_system(contact.rods.tubes, contact.elements[e], contact.rods.q);
        auto slot = static_cast<std::size_t>(pattern.first_slot[e]);
        for (int i = 0; i < system.count; ++i)
            for (int j = 0; j < system.count; ++j) {
                const auto block = static_cast<std::size_t>(pattern.slot.at(slot++));
                CHECK(pattern.row[block] == system.unknown[i]);
                CHECK(pattern.col[block] == system.unknown[j]);
            }
    }
}

TEST_CASE("contact elements on the same finite elements share a group", "[pattern]") {
    auto contact = random_contact(beam, beam, 0, 0, 5);
    contact.elements.resize(1);
    const auto one = make_pattern(contact.rods.tubes, contact.elements);
    contact.elements.assign(20, contact.elements[0]);
    const auto many = make_pattern(contact.rods.tubes, contact.elements);
    CHECK(many.slot == one.slot);
    CHECK(many.row == one.row);
}

TEST_CASE("no contact, no pattern", "[pattern]") {
    const auto pattern = make_pattern({}, {});
    CHECK(pattern.row.empty());
    CHECK(pattern.slot.empty());
}

TEST_CASE("a pattern with reach has a place for sections that moved less", "[pattern]") {
    auto contact = mixed_contacts();
    auto pattern = make_pattern(contact.rods.tubes, contact.elements, 0.3);
    for (auto& e : contact.elements) {
        e.s_a = std::clamp(e.s_a + 0.25, 0.0, double(contact.rods.tubes[e.surface_a].num_elements));
        if (!against_rigid(e))
            e.s_b = std::max(e.s_b - 0.25, 0.0);
    }
    REQUIRE(place(pattern, contact.rods.tubes, contact.elements));
    for (std::size_t e = 0; e < contact.elements.size(); ++e) {
        const auto system = local_system(contact.rods.tubes, contact.elements[e], contact.rods.q);
        auto slot = static_cast<std::size_t>(pattern.first_slot.at(e));
        for (int i = 0; i < system.count; ++i)
            for (int j = 0; j < system.count; ++j, ++slot) {
                const auto block = static_cast<std::size_t>(pattern.slot.at(slot));
                CHECK(pattern.row.at(block) == system.unknown[i]);
                CHECK(pattern.col.at(block) == system.unknown[j]);
            }
    }
}

TEST_CASE("a pattern tells when it lacks a block", "[pattern]") {
    Contact contact = random_contact(smooth_cable, smooth_cable, 0, 0, 5);
    contact.elements.resize(1);
    auto& e = contact.elements[0];
    e.s_a = 0.5;
    auto pattern = make_pattern(contact.rods.tubes, contact.elements, 0.3);
    e.s_a = contact.rods.tubes[e.surface_a].num_elements - 0.5;
    CHECK_FALSE(place(pattern, contact.rods.tubes, contact.elements));
}

TEST_CASE("any number of threads lays out the same pattern", "[pattern]") {
    const auto contact = mixed_contacts();
    const auto expected = make_pattern(contact.rods.tubes, contact.elements, 0.3);
    for (const int num_threads : {2, 3, 40}) {
        const auto found = make_pattern(contact.rods.tubes, contact.elements, 0.3, num_threads);
        CHECK(found.key == expected.key);
        CHECK(found.slot == expected.slot);
        CHECK(found.first_slot == expected.first_slot);
    }
}
