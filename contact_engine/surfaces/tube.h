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
/// those at its other end.
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
    int group = -1; ///< surfaces of one group, from 0, are never paired: pieces of one yarn

    bool is_polygon() const { return degree == 1 && !smooth; }
    bool is_periodic() const { return beyond > 0; }
    std::int32_t first_element() const { return -beyond; }
    std::int32_t end_element() const { return num_elements + beyond; } ///< one past the last
    /// Rest arc lengths of the two ends of all that there is, mm.
    double low() const { return first_element() * element_length; }
    double high() const { return end_element() * element_length; }
    double length() const { return num_elements * element_length; }
    std::int32_t num_nodes() const { return num_elements * degree + 1; }
    bool has_directors() const { return block == 9; }
    /// Finite element that holds s; the first one where s is not a number.
    std::int32_t element_of(double s) const {
        return static_cast<std::int32_t>(
            std::fmin(std::fmax(std::floor(s), first_element()), end_element() - 1));
    }
    std::int64_t unknown_of(std::int32_t node) const {
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
/// (Catmull-Rom, with linear extrapolation past the ends), the element's own shape functions
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

/// Interpolated director (1 or 2) of a beam at s.
Vec3 director(const Tube& tube, Unknowns q, const Support& support, int which);

} // namespace braidx
