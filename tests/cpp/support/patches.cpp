#include "patches.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace braidx::test {
namespace {

using Surface = std::function<Vec3(double, double)>;

/// Facets of one skin while they are being collected; nodes at one place are one.
class Collector {
public:
    Collector(Rods& rods, FacetKind kind) : rods_(rods), kind_(kind) {}

    void add(Cells cells, const Surface& surface) {
        for (int j = 0; j < cells.v; ++j)
            for (int i = 0; i < cells.u; ++i)
                for (int half = 0; half < (is_triangle(kind_) ? 2 : 1); ++half)
                    add_facet(cells, i, j, half == 1, surface);
    }

    Skin skin(int body, double radius) const {
        return make_skin(kind_, unknown_, body, radius, -1, rods_.q);
    }

private:
    void add_facet(Cells cells, int i, int j, bool upper, const Surface& surface) {
        for (int node = 0; node < num_facet_nodes(kind_); ++node) {
            const auto [u, v] = facet_node(kind_, node);
            unknown_.push_back(unknown_at(
                surface((i + (upper ? 1 - u : u)) / cells.u, (j + (upper ? 1 - v : v)) / cells.v)));
        }
    }

    std::int64_t unknown_at(const Vec3& x) {
        const auto rounded = [](double value) { return std::llround(1e6 * value); };
        const auto [at, fresh] = places_.try_emplace({rounded(x[0]), rounded(x[1]), rounded(x[2])},
                                                     static_cast<std::int64_t>(rods_.q.size()));
        if (fresh)
            rods_.q.insert(rods_.q.end(), x.data(), x.data() + 3);
        return at->second;
    }

    Rods& rods_;
    FacetKind kind_;
    std::vector<std::int64_t> unknown_;
    std::map<std::tuple<long long, long long, long long>, std::int64_t> places_;
};

void add_skin(Rods& rods, const Collector& facets, double radius) {
    const auto body = static_cast<int>(rods.tubes.size() + rods.skins.size());
    rods.skins.push_back(facets.skin(body, radius));
}

Surface rectangle(const Vec3& corner, const Vec3& along_u, const Vec3& along_v) {
    return [=](double u, double v) -> Vec3 { return corner + u * along_u + v * along_v; };
}

} // namespace

void add_patch(Rods& rods, FacetKind kind, Cells cells, const Surface& surface, double radius) {
    Collector facets(rods, kind);
    facets.add(cells, surface);
    add_skin(rods, facets, radius);
}

void add_rectangle(Rods& rods, FacetKind kind, Cells cells, const Vec3& corner, const Vec3& along_u,
                   const Vec3& along_v, double radius) {
    add_patch(rods, kind, cells, rectangle(corner, along_u, along_v), radius);
}

void add_cylinder(Rods& rods, FacetKind kind, Cells cells, const Vec3& base, double radius,
                  double height) {
    const auto surface = [=](double u, double v) -> Vec3 {
        const double angle = 2 * std::numbers::pi * u;
        return base + Vec3(radius * std::cos(angle), radius * std::sin(angle), height * v);
    };
    add_patch(rods, kind, cells, surface, radius);
}

void add_box(Rods& rods, FacetKind kind, int cells, const Vec3& low, const Vec3& high,
             double radius) {
    const Vec3 size = high - low;
    const Vec3 x(size[0], 0, 0), y(0, size[1], 0), z(0, 0, size[2]);
    Collector facets(rods, kind);
    const std::tuple<Vec3, Vec3, Vec3> faces[] = {
        {low, y, x}, {low + z, x, y}, {low, x, z}, {low + y, z, x}, {low, z, y}, {low + x, y, z}};
    for (const auto& [corner, along_u, along_v] : faces)
        facets.add({cells, cells}, rectangle(corner, along_u, along_v));
    add_skin(rods, facets, radius);
}

} // namespace braidx::test
