#include "half_width.h"

#include <algorithm>
#include <cmath>

namespace braidx {

// With n = w.w and d = c.c, h = sqrt(n / d): derivatives of n and d first, then of their quotient
// F, then of its root.
HalfWidth half_width(const std::array<Vec3, 2>& g, const Vec3& normal) {
    const double c[2] = {g[0].dot(normal), g[1].dot(normal)};
    const Vec3 w = c[0] * g[0] + c[1] * g[1];
    const double d = std::max(c[0] * c[0] + c[1] * c[1], 1e-12);
    const double f = std::max(w.squaredNorm() / d, 1e-12), h = std::sqrt(f);
    HalfWidth out;
    out.value = h;
    Vec3 half_n[2], half_d[2], half_f[2];
    for (int a = 0; a < 2; ++a) {
        half_n[a] = w.dot(g[a]) * normal + c[a] * w;
        half_d[a] = c[a] * normal;
        half_f[a] = (half_n[a] - f * half_d[a]) / d;
        out.gradient[a] = half_f[a] / h;
    }
    for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
            Vec3 along = g[a].dot(g[b]) * normal + c[b] * g[a];
            Mat3 half = c[a] * g[b] * normal.transpose();
            half.diagonal().array() += c[a] * c[b];
            if (a == b) {
                along += w;
                half += (w - f * normal) * normal.transpose();
            }
            half += normal * along.transpose();
            half -= 2 * (half_f[a] * half_d[b].transpose() + half_d[a] * half_f[b].transpose());
            out.hessian[a][b] = half / (d * h) - half_f[a] * half_f[b].transpose() / (h * h * h);
        }
    return out;
}

} // namespace braidx
