#pragma once

#include "../types.h"

namespace braidx {

/// Coordinates from here on, mm, are taken for the outcome of a computation that diverged. Fourth
/// powers of lengths, which the search forms, stay far below the largest number.
inline constexpr double too_far = 1e30;

/// Throws std::invalid_argument, which names the first of the unknowns that is not a number, or not
/// below `too_far`.
void require_finite(Unknowns q);

} // namespace braidx
