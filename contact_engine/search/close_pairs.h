#pragma once

#include "../surfaces/tube.h"

#include <vector>

namespace braidx {

/// Two elements of tubes that are close; tube_a <= tube_b, and element_a < element_b on one tube.
struct ElementPair {
    std::int32_t tube_a, tube_b;
    std::int32_t element_a, element_b;
    double s_a, s_b; ///< material coordinates of the closest points of chords of the centre lines
    double distance; ///< between these points, mm
};

/// Which pairs of elements may meet.
struct SearchOptions {
    double margin = 0.5; ///< pairs up to radius_a + radius_b + margin (mm) apart are found
    double self_exclusion =
        4.0; ///< on one tube, neighbours nearer than this many radii along it are no pair
};

/// What a search took: numbers of tests, for measurements.
struct SearchCost {
    std::size_t boxes = 0;  ///< whether two boxes meet
    std::size_t chords = 0; ///< how far two chords are apart
};

/// All close pairs, sorted by tubes, then elements. None is missed: chords of the centre lines are
/// searched, each with how far its stretch of the true curve may be from it, the sagitta. Pairs a
/// little farther apart than the options say may be among them, by the sagittas of their chords.
/// Throws std::invalid_argument where an unknown is not finite.
std::vector<ElementPair> close_pairs(const std::vector<Tube>& tubes, Unknowns q,
                                     const SearchOptions& options, int num_threads = 1,
                                     SearchCost* cost = nullptr);

} // namespace braidx
