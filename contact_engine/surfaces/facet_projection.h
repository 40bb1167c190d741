#pragma once

#include "skin.h"

namespace braidx {

/// Point of a facet that is nearest to x: Newton's method inside, and along the edges where the
/// foot of the perpendicular lies beyond them.
FacetPoint closest_on_facet(const Skin& skin, Unknowns q, std::int32_t facet, const Vec3& x);

} // namespace braidx
