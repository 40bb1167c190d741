#include "skin_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace braidx {
namespace {

constexpr double on_edge = 1e-9; // reference coordinates: round-off of projections

/// Distance from a sharp edge, in reference coordinates, over which points lose their share. No
/// contact point of a facet is nearer to its edges (0.053 at least): faces that coincide share all
/// of their area.
constexpr double fading = 0.05;

/// An edge of a facet, numbered along its outline.
struct Edge {
    std::int32_t facet;
    std::size_t number;
};

/// Local node at an end (0 or 1) of an edge.
int end_node(const Skin& skin, const Edge& edge, std::size_t end) {
    const auto outline = facet_outline(skin.kind);
    return outline[(edge.number + end) % outline.size()];
}

std::int32_t normal_at(const Skin& skin, const Edge& edge, std::size_t end) {
    return skin.normal_of[static_cast<std::size_t>(edge.facet * skin.nodes_per_facet() +
                                                   end_node(skin, edge, end))];
}

Vec3 middle(const Skin& skin, Unknowns q, std::int32_t facet) {
    const double third = is_triangle(skin.kind) ? 1.0 / 3 : 0.5;
    return combined(skin, q, facet, facet_weights(skin.kind, third, third).value);
}

/// Whether two facets that share an edge have a normal each there, and bend away from each other.
bool is_sharp(const Skin& skin, Unknowns rest, const Edge& a, const Edge& b) {
    const auto same = [&](std::size_t end) {
        return normal_at(skin, a, end) == normal_at(skin, b, 0) ||
               normal_at(skin, a, end) == normal_at(skin, b, 1);
    };
    if (same(0) || same(1))
        return false;
    const double third = is_triangle(skin.kind) ? 1.0 / 3 : 0.5;
    const Vec3 out =
        facet_geometry(skin, rest, a.facet, facet_weights(skin.kind, third, third)).area();
    const auto vertex = skin.unknown_of(a.facet, end_node(skin, a, 0));
    return (middle(skin, rest, b.facet) - vector_at(rest, vertex)).dot(out) < 0;
}

/// Distance to a vertex in reference coordinates: along the edges that end there as that to the
/// edges of other facets that do.
double distance_to_vertex(const Skin& skin, const FacetPoint& at, std::size_t number) {
    const auto [u, v] = facet_node(skin.kind, facet_outline(skin.kind)[number]);
    const double apart_u = std::abs(at.u - u), apart_v = std::abs(at.v - v);
    if (!is_triangle(skin.kind))
        return std::max(apart_u, apart_v);
    return u + v == 0 ? apart_u + apart_v : std::max(apart_u, apart_v);
}

} // namespace

std::array<double, 4> distances_to_edges(const Skin& skin, const FacetPoint& at) {
    if (is_triangle(skin.kind))
        return {at.v, 1 - at.u - at.v, at.u, 1};
    return {at.v, 1 - at.u, 1 - at.v, at.u};
}

bool is_on_edge(const Skin& skin, const FacetPoint& at) {
    return std::ranges::min(distances_to_edges(skin, at)) < on_edge;
}

bool is_on_rim(const Skin& skin, const FacetPoint& at) {
    const auto distance = distances_to_edges(skin, at);
    const unsigned rim = skin.rim[static_cast<std::size_t>(at.facet)];
    for (std::size_t edge = 0; edge < distance.size(); ++edge)
        if ((rim >> edge & 1u) != 0 && distance[edge] < on_edge)
            return true;
    return false;
}

double share_inside_edges(const Skin& skin, const FacetPoint& at) {
    const auto facet = static_cast<std::size_t>(at.facet);
    const auto distance = distances_to_edges(skin, at);
    double nearest = fading;
    for (std::size_t i = 0; i < facet_outline(skin.kind).size(); ++i) {
        if ((skin.sharp_edges[facet] >> i & 1u) != 0)
            nearest = std::min(nearest, distance[i]);
        if ((skin.sharp_vertices[facet] >> i & 1u) != 0)
            nearest = std::min(nearest, distance_to_vertex(skin, at, i));
    }
    return std::max(0.0, nearest / fading);
}

void find_edges(Skin& skin, Unknowns rest) {
    const auto count = facet_outline(skin.kind).size();
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Edge>> edges;
    for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet)
        for (std::size_t i = 0; i < count; ++i) {
            const Edge edge{facet, i};
            edges[std::minmax({skin.unknown_of(facet, end_node(skin, edge, 0)),
                               skin.unknown_of(facet, end_node(skin, edge, 1))})]
                .push_back(edge);
        }
    const auto facets = static_cast<std::size_t>(skin.num_facets());
    skin.rim.assign(facets, 0);
    skin.sharp_edges.assign(facets, 0);
    skin.sharp_vertices.assign(facets, 0);
    std::set<std::int32_t> sharp; // normals of vertices where sharp edges end
    const auto mark = [](std::uint8_t& bits, std::size_t bit) {
        bits = static_cast<std::uint8_t>(bits | 1u << bit);
    };
    for (const auto& [vertices, sides] : edges)
        for (const auto& edge : sides) {
            const auto facet = static_cast<std::size_t>(edge.facet);
            if (sides.size() == 1)
                mark(skin.rim[facet], edge.number);
            if (sides.size() != 2 || !is_sharp(skin, rest, sides[0], sides[1]))
                continue;
            mark(skin.sharp_edges[facet], edge.number);
            sharp.insert({normal_at(skin, edge, 0), normal_at(skin, edge, 1)});
        }
    for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet)
        for (std::size_t i = 0; i < count; ++i)
            if (sharp.contains(normal_at(skin, {facet, i}, 0)))
                mark(skin.sharp_vertices[static_cast<std::size_t>(facet)], i);
}

} // namespace braidx
