#pragma once

#include "../pairing/contact_element.h"

#include <vector>

namespace braidx {

/// Unique 3x3 blocks of the contact tangent, and where each contact element adds to them. Rows of
/// images (Tube) have none.
struct Pattern {
    std::vector<std::int64_t> row, col;   ///< engine numbers of the first unknowns of each block
    std::vector<std::uint64_t> key;       ///< of each block, ascending: see block_key
    std::vector<std::int32_t> slot;       ///< block of every pair of an asked row and a column, by
                                          ///< groups of contact elements, one after another
    std::vector<std::int64_t> first_slot; ///< per contact element: where its group begins in `slot`
};

/// Contact elements on the same finite elements share a group, so that a zone costs little more
/// than one element.
///
/// With a `reach` (in elements, or reference coordinates of facets) there are blocks, too, for
/// sections that far away: the pattern will hold when contact elements have moved a little, and a
/// matrix with its symbolic factorisation can be kept.
Pattern make_pattern(const DeformableSurfaces& surfaces, const ContactElements& elements,
                     double reach = 0, int num_threads = 1);

/// Finds the places of other contact elements in a pattern. Returns false, and leaves it unfit for
/// use, where it lacks blocks that they need.
bool place(Pattern& pattern, const DeformableSurfaces& surfaces, const ContactElements& elements,
           int num_threads = 1);

} // namespace braidx
