#include "support/patches.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace braidx;
using namespace braidx::test;

namespace {

double difference(const FacetWeights::Values& ahead, const FacetWeights::Values& behind,
                  const FacetWeights::Values& slope, double step) {
    double worst = 0;
    for (std::size_t n = 0; n < slope.size(); ++n)
        worst = std::max(worst, std::abs((ahead[n] - behind[n]) / (2 * step) - slope[n]));
    return worst;
}

double factorial(int n) {
    return std::tgamma(n + 1.0);
}

/// Integral of u^i v^j over the reference facet.
double exact_integral(FacetKind kind, int i, int j) {
    return is_triangle(kind) ? factorial(i) * factorial(j) / factorial(i + j + 2)
                             : 1.0 / ((i + 1) * (j + 1));
}

} // namespace

TEST_CASE("weights of a facet sum to one, and are one at their own node", "[facet]") {
    Random random(1);
    for (const auto kind : all_facets) {
        for (int i = 0; i < 20; ++i) {
            const auto w = facet_weights(kind, random.uniform(0, 1), random.uniform(0, 1));
            double sum = 0, sum_du = 0, sum_dv = 0;
            for (std::size_t n = 0; n < max_facet_nodes; ++n) {
                sum += w.value[n];
                sum_du += w.du[n];
                sum_dv += w.dv[n];
            }
            CHECK(std::abs(sum - 1) < 1e-14);
            CHECK(std::abs(sum_du) + std::abs(sum_dv) < 1e-13);
        }
        for (int node = 0; node < num_facet_nodes(kind); ++node) {
            const auto [u, v] = facet_node(kind, node);
            const auto w = facet_weights(kind, u, v);
            for (int n = 0; n < num_facet_nodes(kind); ++n)
                CHECK(std::abs(w.value[static_cast<std::size_t>(n)] - (n == node)) < 1e-15);
        }
    }
}

TEST_CASE("derivatives of weights are those of finite differences", "[facet]") {
    Random random(2);
    constexpr double h = 1e-5;
    for (const auto kind : all_facets)
        for (int i = 0; i < 10; ++i) {
            const double u = random.uniform(0, 1), v = random.uniform(0, 1);
            const auto w = facet_weights(kind, u, v);
            const auto pu = facet_weights(kind, u + h, v), mu = facet_weights(kind, u - h, v),
                       pv = facet_weights(kind, u, v + h), mv = facet_weights(kind, u, v - h);
            CHECK(difference(pu.value, mu.value, w.du, h) < 1e-9);
            CHECK(difference(pv.value, mv.value, w.dv, h) < 1e-9);
            CHECK(difference(pu.du, mu.du, w.duu, h) < 1e-9);
            CHECK(difference(pv.du, mv.du, w.duv, h) < 1e-9);
            CHECK(difference(pv.dv, mv.dv, w.dvv, h) < 1e-9);
        }
}

TEST_CASE("middles of edges are where DOLFINx has them", "[facet]") {
    using Place = std::array<double, 2>;
    CHECK(facet_node(FacetKind::triangle6, 3) == Place{0.5, 0.5}); // v1v2
    CHECK(facet_node(FacetKind::triangle6, 4) == Place{0, 0.5});   // v0v2
    CHECK(facet_node(FacetKind::triangle6, 5) == Place{0.5, 0});   // v0v1
    CHECK(facet_node(FacetKind::square9, 4) == Place{0.5, 0});     // v0v1
    CHECK(facet_node(FacetKind::square9, 5) == Place{0, 0.5});     // v0v2
    CHECK(facet_node(FacetKind::square9, 6) == Place{1, 0.5});     // v1v3
    CHECK(facet_node(FacetKind::square9, 7) == Place{0.5, 1});     // v2v3
    CHECK(facet_node(FacetKind::square9, 8) == Place{0.5, 0.5});
}

TEST_CASE("contact points integrate polynomials of their degree", "[facet]") {
    struct Rule {
        FacetKind kind;
        bool dense;
        int degree;
    };
    const Rule rules[] = {{FacetKind::triangle3, false, 2}, {FacetKind::square4, false, 3},
                          {FacetKind::triangle6, false, 4}, {FacetKind::square9, false, 5},
                          {FacetKind::triangle3, true, 4},  {FacetKind::square4, true, 5},
                          {FacetKind::triangle6, true, 6},  {FacetKind::square9, true, 7}};
    for (const auto& [kind, dense, degree] : rules)
        for (int i = 0; i <= degree; ++i)
            for (int j = 0; i + j <= degree; ++j) {
                double sum = 0;
                for (const auto& p : facet_quadrature(kind, dense)) {
                    sum += p.weight * std::pow(p.u, i) * std::pow(p.v, j);
                    CHECK((p.u > 0 && p.v > 0 && p.u < 1 && p.v < 1 && p.weight > 0));
                }
                CHECK(std::abs(sum - exact_integral(kind, i, j)) < 1e-14);
            }
}
