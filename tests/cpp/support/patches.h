#pragma once

#include "support/rods.h"

namespace braidx::test {

inline constexpr FacetKind all_facets[] = {FacetKind::triangle3, FacetKind::square4,
                                           FacetKind::triangle6, FacetKind::square9};

/// Numbers of cells along both parameters of a surface.
struct Cells {
    int u, v;
};

/// Adds a skin on a surface x(u, v), u and v from 0 to 1, whose normal is dx/du x dx/dv; its nodes
/// come after all other unknowns. The number of its body is that of the surface.
void add_patch(Rods& rods, FacetKind kind, Cells cells,
               const std::function<Vec3(double, double)>& surface, double radius = 1);

/// A rectangle from a corner along two sides.
void add_rectangle(Rods& rods, FacetKind kind, Cells cells, const Vec3& corner, const Vec3& along_u,
                   const Vec3& along_v, double radius = 1);

/// A cylinder about the z axis through `base`, seen from outside, closed around by nodes of its
/// own.
void add_cylinder(Rods& rods, FacetKind kind, Cells cells, const Vec3& base, double radius,
                  double height);

/// The six faces of a box; nodes of edges and corners are shared.
void add_box(Rods& rods, FacetKind kind, int cells, const Vec3& low, const Vec3& high,
             double radius = 1);

} // namespace braidx::test
