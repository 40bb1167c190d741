#pragma once

#include "close_pairs.h"

namespace braidx {

/// A proximity zone (paper 1, 2.3.1): stretches of two curves that run close to each other, as the
/// connected set of its close element pairs.
struct ProximityZone {
    std::int32_t tube_a, tube_b;
    int orientation; ///< +1 if the curves run the same way, -1 if opposite ways
    std::vector<ElementPair> pairs;
};

/// Zones of sorted close pairs: pairs whose elements are equal or neighbours on both curves belong
/// together.
std::vector<ProximityZone> proximity_zones(const std::vector<Tube>& tubes, Unknowns q,
                                           const std::vector<ElementPair>& pairs);

} // namespace braidx
