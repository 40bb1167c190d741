#pragma once

#include "close_pairs.h"

#include <functional>

namespace braidx {

/// Largest share of a step, at most 1, on the way to which no two centre lines pass through each
/// other.
///
/// Chords of the centre lines at q move straight, by the step dq of the unknowns. Each pair of them
/// advances by what it is apart over the fastest motion of any two of its points, again and again,
/// until the distance is a tenth of what it was (additive continuous collision detection: M. Li et
/// al., Codimensional incremental potential contact, 2021). So the share is never too large, and
/// less than a tenth smaller than it could be along that way. Chords of one tube that are no pair
/// (SearchOptions) do not count, nor do tubes that never meet.
double max_step(const std::vector<Tube>& tubes, Unknowns q, Unknowns dq,
                const SearchOptions& options,
                const std::function<bool(std::int32_t, std::int32_t)>& may_meet,
                int num_threads = 1);

} // namespace braidx
