#pragma once

#include "../surfaces/tube.h"

#include <vector>

namespace braidx {

/// Two elements of tubes that are close; tube_a <= tube_b, and element_a < element_b on one tube.
struct ElementPair {
    std::int32_t tube_a, tube_b;
    std::int32_t element_a, element_b;
    double s_a, s_b; ///< material coordinates of the closest points
    double distance; ///< between centre lines, mm
};

/// Which pairs of elements may meet.
struct SearchOptions {
    double margin = 0.5; ///< pairs up to radius_a + radius_b + margin (mm) apart are found
    double self_exclusion =
        4.0; ///< on one tube, neighbours nearer than this many radii along it are no pair
};

/// All close pairs, through a hashed grid of inflated element boxes; sorted by tubes, then
/// elements.
std::vector<ElementPair> close_pairs(const std::vector<Tube>& tubes, Unknowns q,
                                     const SearchOptions& options, int num_threads = 1);

/// The same by testing every pair: the oracle of the tests.
std::vector<ElementPair> close_pairs_brute_force(const std::vector<Tube>& tubes, Unknowns q,
                                                 const SearchOptions& options);

} // namespace braidx
