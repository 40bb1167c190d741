#pragma once

#include <array>
#include <span>

namespace braidx {

/// Facets of solids by their number of nodes: triangles and quadrilaterals of degree 1 or 2.
///
/// Reference triangle (0,0), (1,0), (0,1); reference square (0,0), (1,0), (0,1), (1,1). Nodes in
/// the order of DOLFINx: vertices, then the middles of edges, then the interior. Edges of the
/// triangle: v1v2, v0v2, v0v1; of the square: v0v1, v0v2, v1v3, v2v3.
enum class FacetKind { triangle3 = 3, square4 = 4, triangle6 = 6, square9 = 9 };

inline constexpr int max_facet_nodes = 9;

inline bool is_triangle(FacetKind kind) {
    return kind == FacetKind::triangle3 || kind == FacetKind::triangle6;
}
inline int facet_degree(FacetKind kind) {
    return kind == FacetKind::triangle3 || kind == FacetKind::square4 ? 1 : 2;
}
inline int num_facet_nodes(FacetKind kind) {
    return static_cast<int>(kind);
}

/// Weights of the nodes of a facet at a point, and their derivatives with both coordinates.
struct FacetWeights {
    using Values = std::array<double, max_facet_nodes>;
    Values value{}, du{}, dv{}, duu{}, duv{}, dvv{};
};

FacetWeights facet_weights(FacetKind kind, double u, double v);

/// A point of the reference facet, and the reference area that it stands for.
struct QuadraturePoint {
    double u, v, weight;
};

/// Points at which contact is tested, Gauss points: on triangles three (degree 1) or six, on
/// squares 2x2 (degree 1) or 3x3. Dense ones, for facets that do not match those they meet: six or
/// twelve, 3x3 or 4x4.
std::span<const QuadraturePoint> facet_quadrature(FacetKind kind, bool dense = false);

/// Coordinates of a vertex or node of the reference facet.
std::array<double, 2> facet_node(FacetKind kind, int node);

/// Vertices once around the facet: three or four of them.
std::span<const int> facet_outline(FacetKind kind);

} // namespace braidx
