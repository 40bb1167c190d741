#include "facet_projection.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace braidx {
namespace {

using Coordinates = Eigen::Vector2d;

constexpr int max_iterations = 25;
constexpr double converged = 1e-13; ///< step of reference coordinates
constexpr double astray = 1.5;      ///< how far beyond the facet an iteration may lead

/// One facet, and the point to be projected.
struct Projection {
    const Skin& skin;
    Unknowns q;
    std::int32_t facet;
    const Vec3& x;

    /// Half the squared distance, its gradient and second derivative.
    struct Distance {
        double value;
        Coordinates gradient;
        Eigen::Matrix2d hessian, definite; ///< exact, and without the curvature of the facet
    };

    Distance distance(const Coordinates& at) const {
        const auto w = facet_weights(skin.kind, at[0], at[1]);
        const auto g = facet_geometry(skin, q, facet, w);
        const Vec3 d = g.position - x;
        Distance out;
        out.value = 0.5 * d.squaredNorm();
        out.gradient = {g.du.dot(d), g.dv.dot(d)};
        const double uv = g.du.dot(g.dv);
        out.definite << g.du.squaredNorm(), uv, uv, g.dv.squaredNorm();
        const double bend_uv = combined(skin, q, facet, w.duv).dot(d);
        out.hessian << combined(skin, q, facet, w.duu).dot(d), bend_uv, bend_uv,
            combined(skin, q, facet, w.dvv).dot(d);
        out.hessian += out.definite;
        return out;
    }

    bool inside(const Coordinates& at) const {
        const double most = is_triangle(skin.kind) ? 1 - at[0] - at[1] : 1 - at.maxCoeff();
        return at.minCoeff() >= 0 && most >= 0;
    }

    /// Foot of the perpendicular, if there is one on the facet.
    std::optional<Coordinates> foot() const {
        Coordinates at = Coordinates::Constant(is_triangle(skin.kind) ? 1.0 / 3 : 0.5);
        for (int i = 0; i < max_iterations; ++i) {
            const auto d = distance(at);
            const bool convex = d.hessian(0, 0) > 0.2 * d.definite(0, 0) &&
                                d.hessian.determinant() > 0.04 * d.definite.determinant();
            const Coordinates step = -(convex ? d.hessian : d.definite).inverse() * d.gradient;
            if (!step.allFinite())
                return std::nullopt;
            at += step;
            if ((at.array() - 0.5).abs().maxCoeff() > astray)
                return std::nullopt;
            if (step.norm() < converged)
                break;
        }
        return inside(at) ? std::optional(at) : std::nullopt;
    }

    /// Nearest point of the straight way, in reference coordinates, from one vertex to another.
    Coordinates along(const Coordinates& from, const Coordinates& to) const {
        const Coordinates way = to - from;
        double t = 0.5;
        for (int i = 0; i < max_iterations; ++i) {
            const auto d = distance(from + t * way);
            const double definite = way.dot(d.definite * way), exact = way.dot(d.hessian * way);
            const double step = -way.dot(d.gradient) / (exact > 0.2 * definite ? exact : definite);
            const double next = std::clamp(t + step, 0.0, 1.0), moved = std::abs(next - t);
            t = next;
            if (moved < converged)
                break;
        }
        return from + t * way;
    }

    Coordinates nearest_of_edges() const {
        const auto outline = facet_outline(skin.kind);
        double best = std::numeric_limits<double>::infinity();
        Coordinates out = Coordinates::Zero();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const auto from = facet_node(skin.kind, outline[i]),
                       to = facet_node(skin.kind, outline[(i + 1) % outline.size()]);
            const Coordinates at = along({from[0], from[1]}, {to[0], to[1]});
            if (const double value = distance(at).value; value < best) {
                best = value;
                out = at;
            }
        }
        return out;
    }
};

} // namespace

FacetPoint closest_on_facet(const Skin& skin, Unknowns q, std::int32_t facet, const Vec3& x) {
    const Projection projection{skin, q, facet, x};
    const auto foot = projection.foot();
    const Coordinates at = foot ? *foot : projection.nearest_of_edges();
    return {facet, at[0], at[1]};
}

} // namespace braidx
