#include "skin.h"

#include "skin_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace braidx {
namespace {

constexpr double cos_smooth = 0.6428; // of 50 degrees

/// Weights at the nodes of the reference facet.
std::vector<FacetWeights> weights_at_nodes(FacetKind kind) {
    std::vector<FacetWeights> out;
    for (int node = 0; node < num_facet_nodes(kind); ++node) {
        const auto [u, v] = facet_node(kind, node);
        out.push_back(facet_weights(kind, u, v));
    }
    return out;
}

/// Outward area vectors of all facets at all of their nodes.
std::vector<Vec3> areas_at_nodes(const Skin& skin, Unknowns q) {
    const auto weights = weights_at_nodes(skin.kind);
    std::vector<Vec3> out;
    out.reserve(skin.unknown.size());
    for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet)
        for (const auto& at : weights)
            out.push_back(facet_geometry(skin, q, facet, at).area());
    return out;
}

/// Gives one number to the nodes of facets that lie smoothly side by side at one place, directly or
/// by way of others.
void share_normals(Skin& skin, const std::vector<Vec3>& area) {
    std::vector<std::size_t> order(skin.unknown.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return skin.unknown[i]; });
    skin.normal_of.assign(skin.unknown.size(), -1);
    const auto spread = [&](auto&& self, std::size_t i,
                            std::span<const std::size_t> place) -> void {
        for (const auto j : place)
            if (skin.normal_of[j] < 0 &&
                area[i].dot(area[j]) > cos_smooth * area[i].norm() * area[j].norm()) {
                skin.normal_of[j] = skin.normal_of[i];
                self(self, j, place);
            }
    };
    for (auto first = order.begin(); first != order.end();) {
        const auto last = std::find_if(first, order.end(), [&](std::size_t i) {
            return skin.unknown[i] != skin.unknown[*first];
        });
        for (const auto i : std::span(first, last))
            if (skin.normal_of[i] < 0) {
                skin.normal_of[i] = skin.num_normals++;
                spread(spread, i, std::span(first, last));
            }
        first = last;
    }
}

/// Whether another facet has one of the two vertices of an edge, numbered along the outline.
bool touches_edge(const Skin& skin, std::int32_t facet, std::size_t edge, std::int32_t other) {
    const auto outline = facet_outline(skin.kind);
    for (const auto vertex : {outline[edge], outline[(edge + 1) % outline.size()]})
        for (int node = 0; node < skin.nodes_per_facet(); ++node)
            if (skin.unknown_of(facet, vertex) == skin.unknown_of(other, node))
                return true;
    return false;
}

void find_bulges(Skin& skin, Unknowns rest) {
    const auto normal = nodal_normals(skin, rest);
    const int count = skin.nodes_per_facet();
    for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet)
        for (int i = 0; i < count; ++i) {
            const auto number = skin.normal_of[static_cast<std::size_t>(facet * count + i)];
            const Vec3& n = normal[static_cast<std::size_t>(number)];
            const Vec3 x = vector_at(rest, skin.unknown_of(facet, i));
            for (int j = 0; j < count; ++j)
                skin.bulge.push_back(0.5 * n.dot(x - vector_at(rest, skin.unknown_of(facet, j))));
        }
}

void find_neighbours(Skin& skin) {
    const auto per_facet = static_cast<std::size_t>(skin.nodes_per_facet());
    std::unordered_map<std::int64_t, std::vector<std::int32_t>> facets_of;
    for (std::size_t i = 0; i < skin.unknown.size(); ++i)
        facets_of[skin.unknown[i]].push_back(static_cast<std::int32_t>(i / per_facet));
    skin.first_neighbour = {0};
    for (std::int32_t facet = 0; facet < skin.num_facets(); ++facet) {
        std::vector<std::int32_t> found;
        for (int node = 0; node < skin.nodes_per_facet(); ++node)
            for (const auto other : facets_of[skin.unknown_of(facet, node)])
                if (other != facet)
                    found.push_back(other);
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        skin.neighbour.insert(skin.neighbour.end(), found.begin(), found.end());
        skin.first_neighbour.push_back(static_cast<std::int32_t>(skin.neighbour.size()));
    }
}

} // namespace

std::vector<std::int32_t> facets_within(const Skin& skin, const FacetPoint& at, double reach) {
    const auto distance = distances_to_edges(skin, at);
    const auto num_edges = facet_outline(skin.kind).size();
    std::vector<std::int32_t> out = {at.facet};
    const auto f = static_cast<std::size_t>(at.facet);
    for (auto i = skin.first_neighbour[f]; i < skin.first_neighbour[f + 1]; ++i) {
        const auto other = skin.neighbour[static_cast<std::size_t>(i)];
        bool near = false;
        for (std::size_t edge = 0; edge < num_edges && !near; ++edge)
            near = distance[edge] <= reach && touches_edge(skin, at.facet, edge, other);
        if (near)
            out.push_back(other);
    }
    return out;
}

FacetPoint contact_point(const Skin& skin, std::int64_t number) {
    const auto per_facet = skin.points_per_facet();
    const auto& at = skin.quadrature()[static_cast<std::size_t>(number % per_facet)];
    return {static_cast<std::int32_t>(number / per_facet), at.u, at.v};
}

Skin make_skin(FacetKind kind, std::vector<std::int64_t> unknown, int body, double radius,
               int group, Unknowns rest, bool dense, bool smooth, std::vector<double> offset) {
    Skin out;
    out.kind = kind;
    out.unknown = std::move(unknown);
    out.body = body;
    out.radius = radius;
    out.group = group;
    out.dense = dense;
    out.offset = std::move(offset);
    for (std::int32_t facet = 0; facet < out.num_facets(); ++facet)
        for (const auto& p : out.quadrature()) {
            const auto at = facet_geometry(out, rest, facet, facet_weights(kind, p.u, p.v));
            out.area.push_back(p.weight * at.area().norm());
        }
    share_normals(out, areas_at_nodes(out, rest));
    if (smooth && facet_degree(kind) == 1)
        find_bulges(out, rest);
    find_neighbours(out);
    find_edges(out, rest);
    return out;
}

Vec3 combined(const Skin& skin, Unknowns q, std::int32_t facet,
              const FacetWeights::Values& weights) {
    Vec3 out = Vec3::Zero();
    for (int n = 0; n < skin.nodes_per_facet(); ++n)
        out += weights[static_cast<std::size_t>(n)] * vector_at(q, skin.unknown_of(facet, n));
    return out;
}

FacetGeometry facet_geometry(const Skin& skin, Unknowns q, std::int32_t facet,
                             const FacetWeights& weights) {
    FacetGeometry out{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    for (int n = 0; n < skin.nodes_per_facet(); ++n) {
        const Vec3 x = vector_at(q, skin.unknown_of(facet, n));
        const auto i = static_cast<std::size_t>(n);
        out.position += weights.value[i] * x;
        out.du += weights.du[i] * x;
        out.dv += weights.dv[i] * x;
    }
    return out;
}

std::vector<Vec3> nodal_normals(const Skin& skin, Unknowns q) {
    const auto area = areas_at_nodes(skin, q);
    std::vector<Vec3> out(static_cast<std::size_t>(skin.num_normals), Vec3::Zero());
    for (std::size_t i = 0; i < area.size(); ++i)
        out[static_cast<std::size_t>(skin.normal_of[i])] += area[i];
    for (auto& normal : out)
        normal.normalize();
    return out;
}

Vec3 smooth_normal(const Skin& skin, const std::vector<Vec3>& nodal, std::int32_t facet,
                   const FacetWeights& weights) {
    Vec3 out = Vec3::Zero();
    const auto first =
        static_cast<std::size_t>(facet) * static_cast<std::size_t>(skin.nodes_per_facet());
    for (std::size_t n = 0; n < static_cast<std::size_t>(skin.nodes_per_facet()); ++n)
        out += weights.value[n] * nodal[static_cast<std::size_t>(skin.normal_of[first + n])];
    return out.normalized();
}

double rise(const Skin& skin, std::int32_t facet, const FacetWeights& weights) {
    double out = skin.offset.empty() ? 0 : skin.offset[static_cast<std::size_t>(facet)];
    if (skin.bulge.empty())
        return out;
    const auto count = static_cast<std::size_t>(skin.nodes_per_facet());
    const double* form = skin.bulge.data() + static_cast<std::size_t>(facet) * count * count;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
            out += weights.value[i] * weights.value[j] * form[count * i + j];
    return out;
}

} // namespace braidx
