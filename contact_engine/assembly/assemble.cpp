#include "assemble.h"

#include "../parallel.h"
#include "asked.h"
#include "sliding.h"

#include <optional>

namespace braidx {
namespace {

/// Gradient of the friction force of a contact element: with the slip, and with the gap.
struct FrictionGradient {
    Mat3 with_slip = Mat3::Zero();
    Vec3 with_gap = Vec3::Zero();
};

FrictionGradient friction_gradient(const Reaction& r, const Vec3& normal, FrictionTangent tangent) {
    FrictionGradient out;
    if (r.friction.coefficient <= 0)
        return out;
    const Mat3 plane = Mat3::Identity() - normal * normal.transpose();
    out.with_slip = r.normal_force * r.friction.direction_gradient(r.slip, plane) * plane;
    if (tangent == FrictionTangent::consistent)
        out.with_gap = -r.stiffness * r.friction.direction(r.slip);
    return out;
}

Mat3 block(const Reaction& r, const FrictionGradient& friction, int i, int j) {
    const auto& s = r.system;
    Mat3 out = r.stiffness * s.gap_weight[i] * s.gap_weight[j].transpose();
    if (r.friction.coefficient > 0) {
        out += s.slip_weight[i] * s.slip_weight[j] * friction.with_slip;
        out += s.slip_weight[i] * friction.with_gap * s.gap_weight[j].transpose();
    }
    return out;
}

/// Adds a block of nine values, row by row.
void add(std::span<double> values, std::int32_t slot, const Mat3& block) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data() +
                                                             9 * std::int64_t{slot}) += block;
}

/// Adds the curvature of half widths: R_N share (second derivative). Directors are among the
/// unknowns of the element's own sections.
void add_half_widths(const Reaction& r, const Rows& rows, const std::int32_t* slot,
                     std::span<double> values) {
    const auto& s = r.system;
    for (int k = 0; k < s.num_sections; ++k) {
        const auto& section = s.sections[k];
        if (!rows.contains(section.director[0]))
            continue;
        for (int a = 0; a < 2; ++a)
            for (int b = 0; b < 2; ++b)
                add(values,
                    slot[(section.director[a] - rows.begin) * s.count_frozen + section.director[b]],
                    r.normal_force * section.share * section.half_width.hessian[a][b]);
    }
}

/// Lets threads call add(i, sums) for every i of [0, count): the first one with the sums
/// themselves, the others with sums of their own, which are added in the end.
template <class Add>
void add_all(std::size_t count, int num_threads, std::span<double> sums, const Add& add) {
    std::vector<std::vector<double>> others(static_cast<std::size_t>(std::max(num_threads, 1)));
    parallel_chunks(count, num_threads, [&](std::size_t chunk, std::size_t i, std::size_t end) {
        if (chunk > 0)
            others[chunk].resize(sums.size());
        for (const auto mine = chunk > 0 ? std::span(others[chunk]) : sums; i < end; ++i)
            add(i, mine);
    });
    parallel_chunks(sums.size(), num_threads, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (const auto& other : others)
            for (std::size_t i = begin; i < std::min(end, other.size()); ++i)
                sums[i] += other[i];
    });
}

} // namespace

void add_residual(const DeformableSurfaces& surfaces, const ContactElements& elements, Unknowns q,
                  Unknowns q_start, const ContactLaws& laws, std::span<double> residual,
                  int num_threads) {
    const auto asked = asked_elements(surfaces, elements);
    add_all(asked.size(), num_threads, residual, [&](std::size_t k, std::span<double> sums) {
        const Reaction r = reaction(surfaces, elements[asked[k]], q, q_start, laws);
        if (!r.acts())
            return;
        const auto& s = r.system;
        for (int i = 0; i < s.count; ++i)
            Eigen::Map<Vec3>(sums.data() + s.unknown[i]) +=
                s.slip_weight[i] * r.friction_force - r.normal_force * s.gap_weight[i];
    });
}

void add_tangent(const DeformableSurfaces& surfaces, const ContactElements& elements,
                 const Pattern& pattern, Unknowns q, Unknowns q_start, const ContactLaws& laws,
                 FrictionTangent tangent, std::span<double> values, int num_threads) {
    const auto asked = asked_elements(surfaces, elements);
    add_all(asked.size(), num_threads, values, [&](std::size_t k, std::span<double> sums) {
        const auto& element = elements[asked[k]];
        const Reaction r = reaction(surfaces, element, q, q_start, laws);
        if (!r.acts())
            return;
        const auto& system = r.system;
        const auto friction = friction_gradient(r, element.normal, tangent);
        std::optional<Sliding> sliding;
        if (laws.sliding && system.facing.distance > 0)
            sliding.emplace(surfaces, element, q, system);
        // Unknowns that came in as sections moved on have no place in the pattern yet: Newton does
        // without.
        const Rows rows = asked_rows(surfaces, element.surface_a, element.surface_b, system.count_a,
                                     system.count_frozen);
        const std::int32_t* const slots = pattern.slot.data() + pattern.first_slot[asked[k]];
        const std::int32_t* slot = slots;
        for (int i = rows.begin; i < rows.end; ++i)
            for (int j = 0; j < system.count_frozen; ++j) {
                Mat3 part = block(r, friction, i, j);
                if (sliding)
                    part -= r.normal_force * sliding->block(i, j);
                add(sums, *slot++, part);
            }
        add_half_widths(r, rows, slots, sums);
    });
}

} // namespace braidx
