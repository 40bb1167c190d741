#include "assemble.h"

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
void add_half_widths(const Reaction& r, const std::int32_t* slot, std::span<double> values) {
    const auto& s = r.system;
    for (int k = 0; k < s.num_sections; ++k)
        for (int a = 0; a < 2; ++a)
            for (int b = 0; b < 2; ++b) {
                const auto& section = s.sections[k];
                add(values, slot[section.director[a] * s.count_frozen + section.director[b]],
                    r.normal_force * section.share * section.half_width.hessian[a][b]);
            }
}

} // namespace

void add_residual(const std::vector<Tube>& tubes, const ContactElements& elements, Unknowns q,
                  Unknowns q_start, const ContactLaws& laws, std::span<double> residual) {
    for (const auto& element : elements) {
        const Reaction r = reaction(tubes, element, q, q_start, laws);
        if (!r.acts())
            continue;
        const auto& s = r.system;
        for (int i = 0; i < s.count; ++i)
            Eigen::Map<Vec3>(residual.data() + s.unknown[i]) +=
                s.slip_weight[i] * r.friction_force - r.normal_force * s.gap_weight[i];
    }
}

void add_tangent(const std::vector<Tube>& tubes, const ContactElements& elements,
                 const Pattern& pattern, Unknowns q, Unknowns q_start, const ContactLaws& laws,
                 FrictionTangent tangent, std::span<double> values) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const Reaction r = reaction(tubes, elements[e], q, q_start, laws);
        if (!r.acts())
            continue;
        const auto& system = r.system;
        const auto friction = friction_gradient(r, elements[e].normal, tangent);
        std::optional<Sliding> sliding;
        if (laws.sliding && system.facing.distance > 0)
            sliding.emplace(tubes, elements[e], q, system);
        // Unknowns that came in as sections moved on have no place in the pattern yet: Newton does
        // without.
        const std::int32_t* slot = pattern.slot.data() + pattern.first_slot[e];
        for (int i = 0; i < system.count_frozen; ++i)
            for (int j = 0; j < system.count_frozen; ++j) {
                Mat3 part = block(r, friction, i, j);
                if (sliding)
                    part -= r.normal_force * sliding->block(i, j);
                add(values, *slot++, part);
            }
        add_half_widths(r, pattern.slot.data() + pattern.first_slot[e], values);
    }
}

} // namespace braidx
