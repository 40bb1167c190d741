#include "rods.h"

#include <Eigen/Geometry>

namespace braidx::test {
namespace {

void append(std::vector<double>& q, const Vec3& v) {
    q.insert(q.end(), v.data(), v.data() + 3);
}

void append_directors(std::vector<double>& q, const Vec3& tangent) {
    const Vec3 up = std::abs(tangent[0]) < 0.8 ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 g1 = (up - up.dot(tangent) * tangent).normalized();
    append(q, g1);
    append(q, tangent.cross(g1));
}

} // namespace

void Rods::add(const Kind& kind, int num_elements, double radius,
               const std::function<Vec3(double)>& curve) {
    const int num_steps = num_elements * kind.degree, body = static_cast<int>(tubes.size());
    const auto first = static_cast<std::int64_t>(q.size());
    double length = 0;
    for (int i = 0; i <= num_steps; ++i) {
        const double t = static_cast<double>(i) / num_steps;
        append(q, curve(t));
        if (kind.block == 9)
            append_directors(q, (curve(t + 1e-6) - curve(t - 1e-6)).normalized());
        if (i > 0)
            length += (curve(t) - curve(t - 1.0 / num_steps)).norm();
    }
    tubes.push_back({first, num_elements, kind.degree, kind.block, radius, length / num_elements,
                     body, kind.smooth});
}

void Rods::add_straight(const Kind& kind, int num_elements, double radius, const Vec3& from,
                        const Vec3& to) {
    add(kind, num_elements, radius, [&](double t) -> Vec3 { return from + t * (to - from); });
}

void Rods::shake(Random& random, double size) {
    for (auto& value : q)
        value += random.uniform(-size, size);
}

void Rods::turn_sections(Random& random) {
    for (const auto& tube : tubes)
        for (std::int32_t i = 0; tube.has_directors() && i < tube.num_nodes(); ++i) {
            const Vec3 g1 = random.unit();
            const auto first = tube.unknown_of(i);
            Eigen::Map<Vec3>(q.data() + first + 3) = g1;
            Eigen::Map<Vec3>(q.data() + first + 6) = g1.cross(random.unit()).normalized();
        }
}

} // namespace braidx::test
