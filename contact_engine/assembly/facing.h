#pragma once

#include "../pairing/contact_element.h"

namespace braidx {

/// Where a contact element stands for given unknowns: sections, normal and distance of the centre
/// lines.
///
/// Line elements keep their mean arc length and stay on a plane normal to the mean tangent; point
/// elements stay at the closest approach. Either way the distance does not change at first order
/// when the sections move, so that its gradient is that of fixed sections, and only its second
/// derivative knows of their motion.
struct Facing {
    double s_a, s_b;
    Vec3 normal;     ///< unit, from a to b, on the element's side
    double side;     ///< +1, or -1 where the centre lines have passed through each other
    double distance; ///< of the centre lines, mm, positive
};

/// The element's own sections and normal where it does not follow, or where it cannot.
Facing facing(const DeformableSurfaces& surfaces, const ContactElement& element, Unknowns q);

/// From now on sections and normals stay as they were made.
void freeze_sections(ContactElements& elements);

} // namespace braidx
