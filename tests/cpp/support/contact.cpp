#include "contact.h"

namespace braidx::test {
namespace {

/// A contact element somewhere on the tubes; its allowance is set so that it penetrates by `depth`.
ContactElement random_element(Random& random, const std::vector<Tube>& tubes, Unknowns q, bool wall,
                              double depth) {
    const Tube& a = tubes.front();
    const Tube& b = tubes.back();
    ContactElement e{};
    e.surface_b = wall ? -1 : 1;
    e.body_b = 1;
    e.s_a = random.uniform(0, a.num_elements);
    e.s_b = wall ? 0 : random.uniform(0, b.num_elements);
    e.normal = random.unit();
    e.weight = random.uniform(0.2, 1.5);
    e.stiffness = random.uniform(200, 900);
    for (int i = 0; i < 2; ++i) {
        e.xi_a[i] = a.has_directors() ? random.uniform(-0.7, 0.7) : 0;
        e.xi_b[i] = !wall && b.has_directors() ? random.uniform(-0.7, 0.7) : 0;
    }
    if (wall) {
        e.wall = random.vector(3);
        e.wall_start = e.wall - random.vector(1e-4);
    }
    e.allowance = -depth - local_system(tubes, e, q).gap;
    return e;
}

Contact fill(Rods rods, bool wall, double mu, double slide, Random& random) {
    Contact out{std::move(rods), {}, {}, laws_with(mu)};
    out.laws.regularisation = 0.05;
    out.laws.reversible_slip = 0.02;
    for (int i = 0; i < 6; ++i) {
        const double depth = random.uniform(0.1, 0.9) * out.laws.regularisation + (i % 2) * 0.06;
        out.elements.push_back(random_element(random, out.rods.tubes, out.rods.q, wall, depth));
        const Vec3& normal = out.elements.back().normal;
        const Vec3 slip = random.vector(1e-4);
        out.elements.back().slip = slip - slip.dot(normal) * normal;
    }
    Rods moved = out.rods;
    moved.shake(random, slide);
    out.start = moved.q;
    return out;
}

} // namespace

Vector Contact::residual(const std::vector<double>& q, int num_threads) const {
    Vector out = Vector::Zero(static_cast<Eigen::Index>(q.size()));
    add_residual(rods.surfaces(), elements, q, start, laws, {out.data(), q.size()}, num_threads);
    return out;
}

Matrix Contact::tangent(FrictionTangent tangent, int num_threads) const {
    const auto pattern = make_pattern(rods.surfaces(), elements, 0, num_threads);
    std::vector<double> values(9 * pattern.row.size());
    add_tangent(rods.surfaces(), elements, pattern, rods.q, start, laws, tangent, values,
                num_threads);
    const auto n = static_cast<Eigen::Index>(rods.q.size());
    Matrix out = Matrix::Zero(n, n);
    for (std::size_t block = 0; block < pattern.row.size(); ++block)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                out(pattern.row[block] + i, pattern.col[block] + j) +=
                    values[9 * block + static_cast<std::size_t>(3 * i + j)];
    return out;
}

double Contact::energy(const std::vector<double>& q) const {
    const auto lagged = normal_forces(rods.surfaces(), elements, rods.q, start, laws);
    return contact_energy(rods.surfaces(), elements, q, start, laws, lagged);
}

Matrix Contact::finite_difference_tangent(double step) const {
    const auto n = static_cast<Eigen::Index>(rods.q.size());
    Matrix out(n, n);
    auto q = rods.q;
    for (std::size_t j = 0; j < q.size(); ++j) {
        q[j] = rods.q[j] + step;
        const Vector ahead = residual(q);
        q[j] = rods.q[j] - step;
        out.col(static_cast<Eigen::Index>(j)) = (ahead - residual(q)) / (2 * step);
        q[j] = rods.q[j];
    }
    return out;
}

Vector Contact::finite_difference_gradient(double step) const {
    Vector out(static_cast<Eigen::Index>(rods.q.size()));
    auto q = rods.q;
    for (std::size_t j = 0; j < q.size(); ++j) {
        q[j] = rods.q[j] + step;
        const double ahead = energy(q);
        q[j] = rods.q[j] - step;
        out[static_cast<Eigen::Index>(j)] = (ahead - energy(q)) / (2 * step);
        q[j] = rods.q[j];
    }
    return out;
}

ContactLaws laws_with(double mu, int num_bodies) {
    ContactLaws laws;
    laws.num_bodies = num_bodies;
    laws.friction.assign(static_cast<std::size_t>(num_bodies * num_bodies), mu);
    return laws;
}

Contact random_contact(const Kind& kind_a, const Kind& kind_b, double mu, double slide,
                       unsigned seed) {
    Random random(seed);
    Rods rods;
    rods.add_straight(kind_a, 3, 1.0, {0, 0, 0}, {0, 0, 6});
    rods.add_straight(kind_b, 2, 0.8, {1.7, -2, 1}, {1.7, 2, 3});
    rods.shake(random, 0.2);
    return fill(std::move(rods), false, mu, slide, random);
}

Contact mixed_contacts() {
    auto out = random_contact(smooth_beam, quadratic_cable, 0.2, 0.1, 3);
    out.rods.add_straight(smooth_cable, 6, 1.0, {0, 0, 0}, {0, 6, 0});
    out.laws.num_bodies = 3;
    out.laws.friction.assign(9, 0.2);
    const auto between = out.elements;
    for (const auto& e : between) {
        auto with_third = e, with_wall = e, with_itself = e;
        with_third.surface_b = 2;
        with_wall.surface_b = -1;
        with_itself.surface_a = with_itself.surface_b = 2; // sections that share nodes
        with_itself.s_b = with_itself.s_a + 1;
        for (const auto& more : {with_third, with_wall, with_itself})
            out.elements.push_back(more);
    }
    out.start = out.rods.q;
    return out;
}

Contact random_contact_with_wall(const Kind& kind, double mu, double slide, unsigned seed) {
    Random random(seed);
    Rods rods;
    rods.add_straight(kind, 4, 1.0, {0, 0, 0}, {0, 0, 6});
    rods.shake(random, 0.2);
    return fill(std::move(rods), true, mu, slide, random);
}

} // namespace braidx::test
