#pragma once

#include "../surfaces/tube.h"

#include <vector>

namespace braidx {

/// A stretch of the centre line of an element, from s to s + length, as the chord of its ends.
struct Chord {
    std::int32_t tube, element;
    double s, length; ///< material coordinates
    Vec3 start, end;
    double sagitta; ///< no point of the stretch is farther than this from the chord, mm
};

/// Whether two chords are on one tube, nearer along it than `self_exclusion` radii: they are no
/// pair.
bool are_neighbours(const std::vector<Tube>& tubes, const Chord& a, const Chord& b,
                    double self_exclusion);

/// Chords of all elements: as many for an element as its bend and its length ask for.
std::vector<Chord> chords_of(const std::vector<Tube>& tubes, Unknowns q);

} // namespace braidx
