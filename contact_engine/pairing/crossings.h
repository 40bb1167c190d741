#pragma once

#include "stations.h"

namespace braidx {

/// A crossing of two tubes whose stacking order is prescribed (paper 1, 3.2 and 3.4.2): stretches of rest
/// arc length (mm) where they meet, and the direction from a to b that the order asks for.
struct Crossing {
    std::int32_t tube_a, tube_b;
    double low_a, high_a;
    double low_b, high_b;
    Vec3 normal;

    bool contains(double arc_a, double arc_b) const {
        return arc_a >= low_a && arc_a <= high_a && arc_b >= low_b && arc_b <= high_b;
    }
};

/// When a crossing counts as separated, and which stations act while it is not. Factors of radius_a + radius_b.
struct CrossingOptions {
    double separation = 0.7; ///< separated where the distance along the normal exceeds this
    double lateral = 0.4;    ///< a station acts where the centre lines, seen along the normal, are nearer than this
};

/// Stations of a crossing that is not separated yet, seen along its normal; none once it is separated.
std::vector<Station> crossing_stations(const std::vector<Tube>& tubes, Unknowns q, const Crossing& crossing,
                                       double spacing, const CrossingOptions& options);

/// Signed distance of b above a along the normal where the centre lines cross, seen along the normal (mm);
/// nothing where they do not cross in the windows.
std::optional<double> crossing_height(const std::vector<Tube>& tubes, Unknowns q, const Crossing& crossing);

} // namespace braidx
