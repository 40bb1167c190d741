#include "facet.h"

#include <cmath>

namespace braidx {
namespace {

/// Lagrange polynomials on [0, 1] with nodes 0, 1 (degree 1) or 0, 1, 1/2 (degree 2), and
/// derivatives.
struct Line {
    std::array<double, 3> value{}, first{}, second{};
};

Line line(int degree, double t) {
    if (degree == 1)
        return {{1 - t, t, 0}, {-1, 1, 0}, {}};
    return {{(1 - t) * (1 - 2 * t), t * (2 * t - 1), 4 * t * (1 - t)},
            {4 * t - 3, 4 * t - 1, 4 - 8 * t},
            {4, 4, -8}};
}

/// Numbers of the polynomials in u and v whose product belongs to each node of a square.
constexpr std::array<std::array<int, 2>, 9> square_nodes = {
    {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}, {1, 2}, {2, 1}, {2, 2}}};

FacetWeights square_weights(FacetKind kind, double u, double v) {
    const Line along_u = line(facet_degree(kind), u), along_v = line(facet_degree(kind), v);
    FacetWeights out;
    for (std::size_t n = 0; n < static_cast<std::size_t>(num_facet_nodes(kind)); ++n) {
        const auto i = static_cast<std::size_t>(square_nodes[n][0]),
                   j = static_cast<std::size_t>(square_nodes[n][1]);
        out.value[n] = along_u.value[i] * along_v.value[j];
        out.du[n] = along_u.first[i] * along_v.value[j];
        out.dv[n] = along_u.value[i] * along_v.first[j];
        out.duu[n] = along_u.second[i] * along_v.value[j];
        out.duv[n] = along_u.first[i] * along_v.first[j];
        out.dvv[n] = along_u.value[i] * along_v.second[j];
    }
    return out;
}

FacetWeights triangle_weights(FacetKind kind, double u, double v) {
    const double w = 1 - u - v;
    if (kind == FacetKind::triangle3)
        return {{w, u, v}, {-1, 1, 0}, {-1, 0, 1}, {}, {}, {}};
    return {{w * (2 * w - 1), u * (2 * u - 1), v * (2 * v - 1), 4 * u * v, 4 * w * v, 4 * w * u},
            {1 - 4 * w, 4 * u - 1, 0, 4 * v, -4 * v, 4 * (w - u)},
            {1 - 4 * w, 0, 4 * v - 1, 4 * u, 4 * (w - v), -4 * u},
            {4, 4, 0, 0, 0, -8},
            {4, 0, 0, 4, -4, -4},
            {4, 0, 4, 0, -8, 0}};
}

constexpr std::array<QuadraturePoint, 3> triangle3_points = {
    {{1.0 / 6, 1.0 / 6, 1.0 / 6}, {2.0 / 3, 1.0 / 6, 1.0 / 6}, {1.0 / 6, 2.0 / 3, 1.0 / 6}}};

/// Two orbits of three points (Strang and Fix), whose weights sum to 1/2.
std::array<QuadraturePoint, 6> triangle6_points() {
    std::array<QuadraturePoint, 6> out{};
    const double near[] = {0.44594849091596489, 0.09157621350977073},
                 weight[] = {0.11169079483900573, 0.05497587182766094};
    for (std::size_t orbit = 0; orbit < 2; ++orbit) {
        const double a = near[orbit], far = 1 - 2 * a, w = weight[orbit];
        out[3 * orbit] = {a, a, w};
        out[3 * orbit + 1] = {far, a, w};
        out[3 * orbit + 2] = {a, far, w};
    }
    return out;
}

/// Product of Gauss points on [0, 1].
template <std::size_t N> std::array<QuadraturePoint, N * N> square_points() {
    const double half = N == 2 ? 0.5 / std::sqrt(3.0) : 0.5 * std::sqrt(0.6);
    std::array<double, N> at{}, weight{};
    at.front() = 0.5 - half;
    at.back() = 0.5 + half;
    weight.front() = weight.back() = N == 2 ? 0.5 : 5.0 / 18;
    if constexpr (N == 3) {
        at[1] = 0.5;
        weight[1] = 8.0 / 18;
    }
    std::array<QuadraturePoint, N * N> out{};
    for (std::size_t j = 0; j < N; ++j)
        for (std::size_t i = 0; i < N; ++i)
            out[N * j + i] = {at[i], at[j], weight[i] * weight[j]};
    return out;
}

} // namespace

FacetWeights facet_weights(FacetKind kind, double u, double v) {
    return is_triangle(kind) ? triangle_weights(kind, u, v) : square_weights(kind, u, v);
}

std::span<const QuadraturePoint> facet_quadrature(FacetKind kind) {
    static const auto triangle6 = triangle6_points();
    static const auto square4 = square_points<2>();
    static const auto square9 = square_points<3>();
    switch (kind) {
    case FacetKind::triangle3:
        return triangle3_points;
    case FacetKind::triangle6:
        return triangle6;
    case FacetKind::square4:
        return square4;
    default:
        return square9;
    }
}

std::array<double, 2> facet_node(FacetKind kind, int node) {
    constexpr std::array<double, 2> triangle[] = {{0, 0},     {1, 0},   {0, 1},
                                                  {0.5, 0.5}, {0, 0.5}, {0.5, 0}};
    if (is_triangle(kind))
        return triangle[node];
    constexpr double at[] = {0, 1, 0.5};
    const auto& [i, j] = square_nodes[static_cast<std::size_t>(node)];
    return {at[i], at[j]};
}

std::span<const int> facet_outline(FacetKind kind) {
    static constexpr int triangle[] = {0, 1, 2}, square[] = {0, 1, 3, 2};
    if (is_triangle(kind))
        return triangle;
    return square;
}

} // namespace braidx
