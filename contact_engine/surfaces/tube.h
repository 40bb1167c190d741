#pragma once

#include "../types.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace braidx {

/// A tube of round section around a curve of finite elements: a cable, or a beam with two
/// directors.
///
/// Material coordinates `s` count elements: s = 0 at the first node, s = num_elements at the last
/// one. The tube of a periodic sample goes on past both for `beyond` elements, whose nodes repeat
/// those at its other end. A closed tube has no ends: its first node follows its last one, and s
/// counts on round it. It is looked at once around, from `joint` to joint + num_elements.
struct Tube {
    std::int64_t first_unknown; ///< engine number of the first unknown of the first node
    std::int32_t num_elements;
    int degree;              ///< degree of the finite elements, 1 or 2
    int block;               ///< unknowns per node: 3 (cable) or 9 (beam: x, g1, g2)
    double radius;           ///< mm
    double element_length;   ///< rest length of an element, mm (mean)
    int body;                ///< number of the body, for friction per pair of bodies
    bool smooth;             ///< C1 contact geometry through the nodes (degree 1 only)
    bool is_image = false;   ///< its equilibrium repeats that of another tube, by symmetry: nobody
                             ///< asks for the rows of its unknowns in residual and tangent
    std::int32_t beyond = 0; ///< elements past either end, for contact across the ends of a sample
    int group = -1;         ///< surfaces of one group, from 0, are never paired: pieces of one yarn
    bool is_closed = false; ///< of num_elements * degree nodes
    bool round_ends = false; ///< whether its ends touch, as half spheres of its radius

    /// Not at a node, where contacts may be by symmetry, and on either side but for round-off.
    static constexpr double joint = 0.31;

    bool is_polygon() const { return degree == 1 && !smooth; }
    bool is_periodic() const { return beyond > 0; }
    bool has_ends() const { return round_ends && !is_periodic() && !is_closed; }
    std::int32_t first_element() const { return -beyond; }
    /// One past the last; the first element of a closed tube comes again as its last one.
    std::int32_t end_element() const { return num_elements + beyond + (is_closed ? 1 : 0); }
    /// Material coordinates of the two ends of all that there is.
    double first() const { return is_closed ? joint : first_element(); }
    double end() const { return is_closed ? joint + num_elements : end_element(); }
    /// Rest arc lengths there, mm.
    double low() const { return first() * element_length; }
    double high() const { return end() * element_length; }
    /// The nearest place that there is; a closed tube goes on past its joint.
    double inside(double s) const { return is_closed ? s : std::clamp(s, first(), end()); }
    /// The same place, counted once around.
    double once_around(double s) const {
        return is_closed ? s - num_elements * std::floor((s - joint) / num_elements) : s;
    }
    /// Elements from one place to another, by the shorter way.
    double apart(double s, double t) const {
        const double along = std::abs(s - t);
        return is_closed ? std::abs(along - num_elements * std::round(along / num_elements))
                         : along;
    }
    double length() const { return num_elements * element_length; }
    std::int32_t num_nodes() const { return num_elements * degree + 1; }
    bool has_directors() const { return block == 9; }
    /// Finite element that holds s; the first one where s is not a number.
    std::int32_t element_of(double s) const {
        const std::int32_t more = is_closed ? num_elements : 0; // what sections may go past a joint
        return static_cast<std::int32_t>(
            std::fmin(std::fmax(std::floor(s), first_element() - more), end_element() - 1 + more));
    }
    std::int64_t unknown_of(std::int32_t node) const {
        if (is_closed) {
            const std::int32_t count = num_elements * degree;
            node = (node % count + count) % count;
        }
        return first_unknown + std::int64_t{node} * block;
    }
};

/// Nodes that carry a particle, their weights, and the derivative of the weights with s.
struct Support {
    int count = 0;
    std::array<std::int32_t, 4> node{};
    std::array<double, 4> weight{};
    std::array<double, 4> slope{};
    std::array<double, 4> bend{}; ///< second derivative with s (contact geometry only)
};

/// Weights of the finite element's own shape functions at s (directors, and positions of rough
/// tubes).
Support element_support(const Tube& tube, double s);

/// Weights of the contact geometry at s: C1 through four nodes where the tube is smooth
/// (Catmull-Rom; at ends of rods parabolas through three nodes), the element's own shape functions
/// otherwise.
Support contact_support(const Tube& tube, double s);

/// Centre line at s, mm.
Vec3 position(const Tube& tube, Unknowns q, double s);

/// Centre line and its derivative with the rest arc length, at s.
struct CurvePoint {
    Vec3 position;
    Vec3 tangent;
};

/// Second derivative of the contact geometry with the rest arc length, at s.
Vec3 curve_bend(const Tube& tube, Unknowns q, double s);

CurvePoint curve_point(const Tube& tube, Unknowns q, double s);

/// Which end of a tube s is at, -1 or 1; 0 between ends, and where ends do not touch.
int end_at(const Tube& tube, double s);

/// How far a direction leans out beyond the end of a tube at s: its cosine with the outward
/// tangent; 0 where end_at is.
double lean(const Tube& tube, Unknowns q, double s, const Vec3& direction);

/// Interpolated director (1 or 2) of a beam at s.
Vec3 director(const Tube& tube, Unknowns q, const Support& support, int which);

} // namespace braidx
