#pragma once

#include "../search/proximity_zones.h"

#include <optional>

namespace braidx {

/// A place on the intermediate geometry where a contact element stands.
///
/// The mean curve of two tubes is parametrised by the mean rest arc length m = (S_a + o S_b) / 2, o
/// the orientation. Line stations are the middles of cells [k, k + 1] spacing of m, cut at the ends
/// of the tubes: they are fixed in the material, the same from one update to the next, and the same
/// when a and b are swapped. A point station stands where the distance is smallest, for curves that
/// cross.
struct Station {
    double s_a, s_b;    ///< material coordinates, in elements
    double weight;      ///< length of the contact line it stands for, mm
    std::int64_t index; ///< k of a line station, or point_station
};
inline constexpr std::int64_t point_station = INT64_MAX;

/// Two tubes and the metric in which they are compared: the plane normal to a direction, or all of
/// space.
struct TubePair {
    const Tube& a;
    const Tube& b;
    Unknowns q;
    int orientation;
    Mat3 metric = Mat3::Identity();

    /// The section of b that faces the section of a at mean arc length m: on a plane normal to the
    /// mean tangent. Arguments and result: half the difference (S_a - o S_b) / 2, mm.
    std::optional<double> facing(double mean, double half_difference) const;

    /// Closest points near the rest arc lengths given, mm; nothing where they leave the tubes.
    std::optional<std::pair<double, double>> closest(double arc_a, double arc_b) const;

    /// Station at rest arc lengths (mm).
    Station station(double arc_a, double arc_b, double weight, std::int64_t index) const;

    /// Vector from a to b at a station, mm.
    Vec3 across(const Station& station) const;
};

/// Line stations of the cells that the element pairs cover.
std::vector<Station> line_stations(const TubePair& tubes, const std::vector<ElementPair>& pairs,
                                   double spacing);

/// Adds a point station unless one stands nearer than half its length already.
void add_point(std::vector<Station>& points, const TubePair& tubes, const Station& point);

/// Point stations at the interior minima of the distance along line stations (sorted by index),
/// where the curves cross at an angle that makes line stations miss more than `tolerance` (mm) of
/// the approach.
std::vector<Station> point_stations(const TubePair& tubes, const std::vector<Station>& line,
                                    double spacing, double tolerance);

} // namespace braidx
