#pragma once

#include "contact_element.h"

#include <span>
#include <utility>

namespace braidx {

/// A direction before and after.
using Turned = std::pair<Vec3, Vec3>;

/// Rotation that takes one axis to where it went, and turns about it as other directions did: the
/// angle that fits them best, by the squares of their lengths across the axis. Without any it is
/// the smallest rotation.
Mat3 rotation_of(const Turned& axis, std::span<const Turned> others);

/// How the pair of particles of a contact element has turned as a whole between two states: a
/// rotation that follows every rigid motion exactly, and is the same when a and b are swapped.
///
/// - Two tubes turn with the mean of their tangents, and about it with the difference of their
///   tangents; where they are nearly parallel with the line between their centres.
/// - A tube on a skin or a rigid surface turns with its tangent, and about it as that surface does.
/// - A point of a skin turns with its own facet, whatever it touches.
///
/// All of these are directions at the element's own sections and places, which are material.
/// `rigid`: rotation of the rigid surface b, if it is one.
Mat3 turn_of(const DeformableSurfaces& surfaces, const ContactElement& element, Unknowns before,
             Unknowns after, const Mat3& rigid = Mat3::Identity());

} // namespace braidx
