#include "assembly/asked.h"
#include "support/contact.h"

#include <catch2/catch_test_macros.hpp>

using namespace braidx;
using namespace braidx::test;

namespace {

/// Copy in which some tubes are images: bit t of the set stands for tube t.
Contact with_images(Contact contact, unsigned images) {
    for (unsigned t = 0; t < contact.rods.tubes.size(); ++t)
        contact.rods.tubes[t].is_image = images >> t & 1u;
    return contact;
}

/// Tube that an unknown belongs to.
const Tube& owner(const std::vector<Tube>& tubes, std::int64_t unknown) {
    return *std::ranges::find_if(tubes, [&](const Tube& t) {
        return unknown >= t.first_unknown && unknown < t.unknown_of(t.num_nodes());
    });
}

constexpr unsigned all_images = 8;

} // namespace

TEST_CASE("rows that are asked for do not miss those of images", "[asked]") {
    const Contact whole = mixed_contacts();
    const Vector residual = whole.residual();
    const Matrix tangent = whole.tangent(FrictionTangent::consistent);
    for (unsigned images = 1; images < all_images; ++images) {
        INFO("images " << images);
        const Contact some = with_images(whole, images);
        const Vector asked_residual = some.residual();
        const Matrix asked_tangent = some.tangent(FrictionTangent::consistent);
        for (Eigen::Index i = 0; i < residual.size(); ++i) {
            if (owner(some.rods.tubes, i).is_image) {
                CHECK(asked_tangent.row(i).norm() == 0);
                continue;
            }
            CHECK(std::abs(asked_residual[i] - residual[i]) <= 1e-14 * residual.norm());
            CHECK((asked_tangent.row(i) - tangent.row(i)).norm() <= 1e-14 * tangent.norm());
        }
    }
}

TEST_CASE("contact elements between images are left out, and rows of images", "[asked]") {
    const Contact whole = mixed_contacts();
    CHECK(asked_elements(whole.rods.tubes, whole.elements).size() == whole.elements.size());
    for (unsigned images = 0; images < all_images; ++images) {
        const Contact some = with_images(whole, images);
        const auto& tubes = some.rods.tubes;
        const auto pattern = make_pattern(tubes, some.elements, 0.1);
        for (const auto row : pattern.row)
            CHECK_FALSE(owner(tubes, row).is_image);
        std::vector<std::size_t> expected;
        for (std::size_t e = 0; e < some.elements.size(); ++e) {
            const auto& element = some.elements[e];
            const bool of_a = !tubes[element.surface_a].is_image;
            const bool of_b = element.surface_b >= 0 && !tubes[element.surface_b].is_image;
            if (of_a || of_b)
                expected.push_back(e);
            CHECK((pattern.first_slot.at(e) >= 0) == (of_a || of_b));
        }
        CHECK(asked_elements(tubes, some.elements) == expected);
    }
    CHECK(with_images(whole, all_images - 1).residual().norm() == 0);
}

TEST_CASE("threads change sums by round-off only, and not from call to call", "[assemble]") {
    for (const unsigned images : {0u, 2u}) {
        const Contact contact = with_images(mixed_contacts(), images);
        const auto consistent = FrictionTangent::consistent;
        const Vector residual = contact.residual();
        const Matrix tangent = contact.tangent(consistent);
        CHECK(residual.norm() > 1);
        for (const int num_threads : {2, 3, 100}) {
            INFO(num_threads << " threads");
            const Vector found = contact.residual(contact.rods.q, num_threads);
            const Matrix found_tangent = contact.tangent(consistent, num_threads);
            CHECK((found - residual).norm() < 1e-13 * residual.norm());
            CHECK((found_tangent - tangent).norm() < 1e-13 * tangent.norm());
            CHECK(contact.residual(contact.rods.q, num_threads) == found);
            CHECK(contact.tangent(consistent, num_threads) == found_tangent);
        }
    }
}
