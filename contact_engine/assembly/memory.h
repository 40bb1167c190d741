#pragma once

#include "reaction.h"

namespace braidx {

/// What an increment did.
struct Committed {
    double work = 0;        ///< dissipated in the increment, N mm
    double penetration = 0; ///< deepest, mm, at least 0
};
/// Accepts an increment: contact elements remember their reversible slip, and the work dissipated
/// grows by R_T . (slip - remembered slip). Elements out of touch forget their slip.
Committed commit(const DeformableSurfaces& surfaces, ContactElements& elements, Unknowns q,
                 Unknowns q_start, const ContactLaws& laws, int num_threads = 1);

/// Where a proximity zone penetrates deeper than `tolerance` (mm), penalties of all that do, or are
/// about to, grow so that they will not, by `growth` at most. Returns the number of zones changed.
/// `elsewhere`: deepest penetration of other processes, which count like one's own.
/// `held`: of each unknown, whether it cannot move; empty: none. Elements both of whose sides are
/// at held nodes do not count: no penalty would open them.
int adapt_stiffness(const DeformableSurfaces& surfaces, ContactElements& elements, Unknowns q,
                    double tolerance, double growth, double elsewhere = 0, int num_threads = 1,
                    std::span<const bool> held = {});

/// Multipliers become the normal forces at q (augmented Lagrangian): the same forces then need less
/// penetration. Penetrations fall by the share of the penalty in the stiffness of what touches.
void update_multipliers(const DeformableSurfaces& surfaces, ContactElements& elements, Unknowns q,
                        Unknowns q_start, const ContactLaws& laws, int num_threads = 1);

/// Deepest penetration, mm, at least 0.
double deepest_penetration(const DeformableSurfaces& surfaces, const ContactElements& elements,
                           Unknowns q, int num_threads = 1);

/// Sums of normal forces, N.
struct NormalForces {
    double rigid = 0; ///< on rigid surfaces
    double all = 0;
};
NormalForces sum_normal_forces(const DeformableSurfaces& surfaces, const ContactElements& elements,
                               Unknowns q, Unknowns q_start, const ContactLaws& laws,
                               int num_threads = 1);

/// Sum of the logarithms of penalties, and their number: the geometric mean.
struct LogStiffness {
    double sum = 0;
    std::int64_t count = 0;
};
/// Of all penalties per length, or of all per area.
LogStiffness sum_log_stiffness(const ContactElements& elements, bool per_area);

/// Multiplies the penalties of all contact elements, and their multipliers.
void scale_stiffness(ContactElements& elements, double factor);

} // namespace braidx
