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
Committed commit(const std::vector<Tube>& tubes, ContactElements& elements, Unknowns q,
                 Unknowns q_start, const ContactLaws& laws);

/// Penalty of each proximity zone grows until its deepest penetration is under `tolerance` (mm); a
/// zone grows by `growth` at most per call. Returns the number of zones changed.
int adapt_stiffness(const std::vector<Tube>& tubes, ContactElements& elements, Unknowns q,
                    double tolerance, double growth);

} // namespace braidx
