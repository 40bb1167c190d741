#pragma once

#include "../types.h"
#include "facet.h"

#include <vector>

namespace braidx {

/// The facets of one solid that may touch: a yarn, the core, a body with a mesh.
///
/// Facets are oriented: (dx/du) x (dx/dv) points out of the solid. Contact is tested at the
/// quadrature points of facets (facet_quadrature), numbered facet by facet.
struct Skin {
    FacetKind kind = FacetKind::square4;
    std::vector<std::int64_t> unknown; ///< engine number of the first unknown of each facet's nodes
    int body = 0;                      ///< number of the body, for friction per pair of bodies
    int group = -1;     ///< surfaces of one group, from 0, are never paired: pieces of one yarn
    bool dense = false; ///< more contact points per facet, see facet_quadrature
    /// How deep a particle may be inside before it counts as on the far side, mm.
    double radius = 1;
    /// How far the surface of each facet is outside its nodes, mm; empty: nowhere. Nodes of a
    /// polygon with the area of a circle lie outside that circle: negative.
    std::vector<double> offset;
    std::vector<double> area; ///< rest area that each contact point stands for, mm^2
    /// Of each flat facet, nodes x nodes: its form in the weights of a place is how far the smooth
    /// surface through the nodes is above the facet at rest, mm. Empty where facets are taken as
    /// they are, and of degree 2.
    std::vector<double> bulge;
    /// Nodes of facets that share a normal: those at one place that lie smoothly side by side.
    std::vector<std::int32_t> normal_of;
    std::int32_t num_normals = 0;
    /// Facets that share a node with a facet: from first_neighbour[facet] to that of the next.
    std::vector<std::int32_t> neighbour, first_neighbour;
    /// Edges of each facet, bit by bit along its outline, that no other facet shares: where the
    /// surface ends.
    std::vector<std::uint8_t> rim;
    /// Likewise edges where the surface bends away sharply, and vertices where such edges of the
    /// same smooth part of the surface end.
    std::vector<std::uint8_t> sharp_edges, sharp_vertices;

    int nodes_per_facet() const { return num_facet_nodes(kind); }
    std::span<const QuadraturePoint> quadrature() const { return facet_quadrature(kind, dense); }
    int points_per_facet() const { return static_cast<int>(quadrature().size()); }
    std::int32_t num_facets() const {
        return static_cast<std::int32_t>(unknown.size()) / nodes_per_facet();
    }
    std::int64_t num_points() const { return std::int64_t{num_facets()} * points_per_facet(); }
    std::int64_t unknown_of(std::int32_t facet, int node) const {
        return unknown[static_cast<std::size_t>(facet) *
                           static_cast<std::size_t>(nodes_per_facet()) +
                       static_cast<std::size_t>(node)];
    }
};

/// A place on a skin.
struct FacetPoint {
    std::int32_t facet;
    double u, v;
};

/// The facet and coordinates of a contact point.
FacetPoint contact_point(const Skin& skin, std::int64_t number);

/// A skin whose contact areas, and sharp edges, are those of the positions `rest`. Facets that meet
/// at less than 50 degrees are smooth there; flat ones stand for a smooth surface if it is
/// `smooth`.
Skin make_skin(FacetKind kind, std::vector<std::int64_t> unknown, int body, double radius,
               int group, Unknowns rest, bool dense = false, bool smooth = true,
               std::vector<double> offset = {});

/// The facet of a place, and those that a particle may move onto when its coordinates change by up
/// to `reach`.
std::vector<std::int32_t> facets_within(const Skin& skin, const FacetPoint& at, double reach);

/// Position of a point, and its derivatives with both coordinates.
struct FacetGeometry {
    Vec3 position, du, dv;
    Vec3 area() const { return du.cross(dv); } ///< outward, mm^2 per reference area
};
FacetGeometry facet_geometry(const Skin& skin, Unknowns q, std::int32_t facet,
                             const FacetWeights& weights);

/// Sum of weights times nodes of a facet.
Vec3 combined(const Skin& skin, Unknowns q, std::int32_t facet,
              const FacetWeights::Values& weights);

/// Normals of nodes, shared as `normal_of` says: means of those of the facets, weighted by area,
/// unit vectors.
std::vector<Vec3> nodal_normals(const Skin& skin, Unknowns q);

/// Unit normal out of the solid, interpolated from those of the nodes: continuous across smooth
/// edges.
Vec3 smooth_normal(const Skin& skin, const std::vector<Vec3>& nodal, std::int32_t facet,
                   const FacetWeights& weights);

/// Height of the surface that a skin stands for above a place on a facet, along its normal, mm:
/// the facet's offset, and on flat facets the bulge, half of the weighted sum of (x_i - x) . n_i
/// with the nodes' normals n_i. That is exact for spheres and cylinders up to the square of the
/// sag, zero at the nodes, and continuous across smooth edges. It is that of the shape at rest,
/// which facets carry along: of the present shape it would change with every force.
double rise(const Skin& skin, std::int32_t facet, const FacetWeights& weights);

} // namespace braidx
