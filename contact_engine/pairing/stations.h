#pragma once

#include "../search/proximity_zones.h"

#include <optional>

namespace braidx {

/// A place on the intermediate geometry where a contact element stands.
///
/// The mean curve of two tubes is parametrised by the mean rest arc length m = (S_a + o S_b) / 2, o
/// the orientation. Line stations are the middles of cells [k, k + 1] spacing of m, cut at the ends
/// of the tubes: they are fixed in the material, the same from one update to the next, and the same
/// when a and b are swapped. Of the stations of periodic tubes, each of which occurs once more a
/// period away, those are kept whose mean distance from a place near the first nodes is within one
/// period; their cells divide it. A point station stands where the distance is smallest, for curves
/// that cross.
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

    /// How sharp a minimum of the distance is at rest arc lengths (mm): lowest eigenvalue of its
    /// second derivative times the distance, per squared arc length. Straight lines that cross at
    /// an angle have 1 - cos(angle); a curve that winds around the other has 0, and no closest
    /// point.
    double sharpness(double arc_a, double arc_b) const;

    /// Station at rest arc lengths (mm).
    Station station(double arc_a, double arc_b, double weight, std::int64_t index) const;

    /// Vector from a to b at a station, mm.
    Vec3 across(const Station& station) const;
};

/// Length of the cells of line stations of two tubes when about `spacing` is wanted, mm.
double cell_length(const Tube& a, const Tube& b, double spacing);

/// Whether a station is the one that is kept among those that are periods apart.
bool is_kept(const Tube& a, const Tube& b, const Station& station);

/// Line stations of the cells that the element pairs cover.
std::vector<Station> line_stations(const TubePair& tubes, const std::vector<ElementPair>& pairs,
                                   double spacing);

/// Adds a point station unless one stands nearer than half a spacing already.
void add_point(std::vector<Station>& points, const TubePair& tubes, const Station& point,
               double spacing);

/// Part of a weight that is wanted where line stations miss this much of a distance, over what they
/// may miss: from nothing at 0.6 to all at 1.2, smoothly. Stations that came and went at once would
/// keep a rope from coming to rest.
double grown(double missed);

/// Weight of a point station at a closest approach, mm. It grows from nothing to a whole spacing
/// with what line stations miss of the approach, over `tolerance` (mm). At an end of a tube they
/// miss more by as much as the way leans out of it.
double point_weight(const TubePair& tubes, double arc_a, double arc_b, double spacing,
                    double tolerance);

/// Point station at the closest approach near rest arc lengths (mm). Nothing where line stations
/// see the approach well enough.
std::optional<Station> point_station_near(const TubePair& tubes, double arc_a, double arc_b,
                                          double spacing, double tolerance);

/// Point stations at the interior minima of the distance along line stations (sorted by index).
std::vector<Station> point_stations(const TubePair& tubes, const std::vector<Station>& line,
                                    double spacing, double tolerance);

/// Line and point stations together. A point station stands for a stretch of the mean curve as long
/// as its weight, with itself in the middle; line stations stand for what is left of their cells.
std::vector<Station> share_length(std::vector<Station> line, const std::vector<Station>& points,
                                  const TubePair& tubes);

} // namespace braidx
