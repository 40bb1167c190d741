#pragma once

#include "skin.h"

namespace braidx {

/// Distances of a place to the edges of its facet in reference coordinates, in the order of the
/// outline.
std::array<double, 4> distances_to_edges(const Skin& skin, const FacetPoint& at);

/// Whether a place is on an edge of its facet.
bool is_on_edge(const Skin& skin, const FacetPoint& at);

/// Whether a place is on the rim of the surface.
bool is_on_rim(const Skin& skin, const FacetPoint& at);

/// Share of its area with which a contact point counts that meets a place: 1, but near a sharp edge
/// it falls to 0 at the edge, continuously over the whole smooth part of the surface, so that
/// points slide off without a jump of their force.
double share_inside_edges(const Skin& skin, const FacetPoint& at);

/// Finds the rim and the sharp edges of a skin at rest, whose normals are shared already.
void find_edges(Skin& skin, Unknowns rest);

} // namespace braidx
