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

/// Orbit of three points of the triangle: two coordinates `near`, one what is left.
template <std::size_t N>
void add_orbit(std::array<QuadraturePoint, N>& out, std::size_t first, double near, double weight) {
    const double far = 1 - 2 * near;
    out[first] = {near, near, weight};
    out[first + 1] = {far, near, weight};
    out[first + 2] = {near, far, weight};
}

/// Exact to degree 4; weights sum to 1/2 (Dunavant 1985).
std::array<QuadraturePoint, 6> triangle6_points() {
    std::array<QuadraturePoint, 6> out{};
    add_orbit(out, 0, 0.44594849091596489, 0.11169079483900573);
    add_orbit(out, 3, 0.09157621350977073, 0.05497587182766094);
    return out;
}

/// Exact to degree 6 (Dunavant 1985).
std::array<QuadraturePoint, 12> triangle12_points() {
    std::array<QuadraturePoint, 12> out{};
    add_orbit(out, 0, 0.249286745170910, 0.5 * 0.116786275726379);
    add_orbit(out, 3, 0.063089014491502, 0.5 * 0.050844906370207);
    const double a = 0.310352451033784, b = 0.636502499121399, c = 1 - a - b,
                 weight = 0.5 * 0.082851075618374;
    const double pairs[6][2] = {{a, b}, {b, a}, {a, c}, {c, a}, {b, c}, {c, b}};
    for (std::size_t i = 0; i < 6; ++i)
        out[6 + i] = {pairs[i][0], pairs[i][1], weight};
    return out;
}

/// Gauss points on [-1, 1] from the left to the middle, and their weights.
struct HalfRule {
    std::array<double, 2> at, weight;
};
template <std::size_t N> HalfRule half_rule() {
    if constexpr (N == 2)
        return {{-1 / std::sqrt(3.0), 0}, {1, 0}};
    if constexpr (N == 3)
        return {{-std::sqrt(0.6), 0}, {5.0 / 9, 8.0 / 9}};
    const double root = 2 * std::sqrt(1.2), other = std::sqrt(30.0) / 36;
    return {{-std::sqrt((3 + root) / 7), -std::sqrt((3 - root) / 7)}, {0.5 - other, 0.5 + other}};
}

/// Product of N x N Gauss points on [0, 1], exact to degree 2 N - 1.
template <std::size_t N> std::array<QuadraturePoint, N * N> square_points() {
    const auto rule = half_rule<N>();
    std::array<double, N> at{}, weight{};
    for (std::size_t i = 0; i < (N + 1) / 2; ++i) {
        at[i] = 0.5 + 0.5 * rule.at[i];
        at[N - 1 - i] = 0.5 - 0.5 * rule.at[i];
        weight[i] = weight[N - 1 - i] = 0.5 * rule.weight[i];
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

std::span<const QuadraturePoint> facet_quadrature(FacetKind kind, bool dense) {
    static const auto triangle6 = triangle6_points();
    static const auto triangle12 = triangle12_points();
    static const auto square4 = square_points<2>();
    static const auto square9 = square_points<3>();
    static const auto square16 = square_points<4>();
    const std::span<const QuadraturePoint> triangles[] = {triangle3_points, triangle6, triangle12},
                                           squares[] = {square4, square9, square16};
    const int which = facet_degree(kind) - 1 + dense;
    return is_triangle(kind) ? triangles[which] : squares[which];
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
