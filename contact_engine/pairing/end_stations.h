#pragma once

#include "stations.h"

namespace braidx {

/// Ends of tubes that touch are half spheres of the tube's radius: what is nearest to a tube beyond
/// its end is nearest to its last point. Contact elements stand there while the way to the other
/// surface leans out beyond the end.

/// Weight of a station of a tube at s that meets a surface in a direction, mm: a whole spacing; at
/// an end what is `grown` of it, as stations half a spacing away miss half of lean times spacing,
/// over `tolerance` (mm).
double weight_at(const Tube& tube, Unknowns q, double s, const Vec3& direction, double spacing,
                 double tolerance);

/// Closest points of two tubes near rest arc lengths (mm), one of them an end that the way to the
/// other leans out of. Nothing where there is none, and none of a tube with itself.
std::optional<std::pair<double, double>> closest_at_ends(const TubePair& tubes, double arc_a,
                                                         double arc_b);

/// Closest points of two tubes, between ends or at them.
std::optional<std::pair<double, double>> closest_anywhere(const TubePair& tubes, double arc_a,
                                                          double arc_b);

/// Adds point stations at ends in a zone of element pairs.
void add_end_stations(std::vector<Station>& points, const TubePair& tubes,
                      const std::vector<ElementPair>& pairs, double spacing, double tolerance);

} // namespace braidx
