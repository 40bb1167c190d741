#include "skin_builder.h"

#include "../parallel.h"
#include "../surfaces/skin_edges.h"
#include "end_stations.h"
#include "rules.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace braidx {
namespace {

/// Surfaces face each other where the cosine of their normals is below this.
constexpr double facing = -0.2;
/// Largest sine of the angle between a smooth normal and the way to the point that it belongs to:
/// beyond, the point lies beside the surface. Facets that meet smoothly do so at up to 50 degrees.
constexpr double sine_beside = 0.766;
/// The same on the rim of a surface that is open there.
constexpr double sine_rim = 0.05;
/// Depth below a place, as a share of the skin's radius, from which on it is asked whether a
/// point is at another wall, and distance of a nearer one, as a share of the distance of that
/// place.
constexpr double deep = 0.2, much_nearer = 0.5;
/// A tube may lie on an edge; its centre is still above the surface beside that edge.
constexpr double cosine_above = 0.2;
/// Centres of tubes nearer to a skin than this share of their radius: the way to them is no normal.
constexpr double too_near = 0.2;

bool is_beside(const SkinPlace& place) {
    const double along = (place.offset - place.height() * place.normal).norm();
    return along > sine_beside * place.offset.norm() + 1e-9;
}

/// Where a surface ends, what lies beyond is beside it: what is nearest there says nothing.
bool is_beyond_rim(const Skin& skin, const SkinPlace& place) {
    const double along = (place.offset - place.height() * place.normal).norm();
    return is_on_rim(skin, place.at) && along > sine_rim * place.offset.norm() + 1e-9;
}

/// The largest distance at which places on a skin are of interest, mm.
double reach_of(const Skin& skin, const Surfaces& surfaces, const PairingOptions& options) {
    double reach = std::max(skin.radius, options.search.margin);
    for (const auto& tube : surfaces.tubes)
        reach = std::max(reach, tube.radius + options.search.margin);
    return reach;
}

/// Mean area of the contact points of a facet, mm^2.
double mean_area(const Skin& skin, std::int32_t facet) {
    const auto count = skin.points_per_facet();
    const auto first = skin.area.begin() + std::int64_t{facet} * count;
    return std::accumulate(first, first + count, 0.0) / count;
}

/// Share of its area that a contact point of a stands for, against a facet of b: half of it where
/// points of both are as dense, more where those of a are denser. Sparse points load the nodes of a
/// fine mesh unevenly.
double share_of(double area_a, double area_b) {
    return area_b * area_b / (area_a * area_a + area_b * area_b);
}

/// Whether a point deep below a place on a skin is much nearer to another one, at a wall that does
/// not face it or at an open end: then that place is the far wall, seen from within.
bool is_at_another_wall(const CurrentSkin& onto, const SkinPlace& place, const Vec3& x) {
    if (place.height() > -deep * onto.skin().radius)
        return false;
    const auto nearest = onto.closest(x, [](const SkinPlace&) { return true; });
    return nearest && nearest->offset.norm() < much_nearer * place.offset.norm();
}

bool overlap(const Box& a, const Box& b, double apart) {
    return ((a.low - b.high).array() <= apart).all() && ((b.low - a.high).array() <= apart).all();
}

} // namespace

SkinBuilder::SkinBuilder(const Surfaces& surfaces, Unknowns q, const Builder& builder,
                         const PairingOptions& options)
    : surfaces_(surfaces.deformable()), q_(q), builder_(builder), options_(options) {
    auto made = parallel_map(surfaces.skins.size(), options.num_threads, [&](std::size_t i) {
        const auto& skin = surfaces.skins[i];
        return std::optional(CurrentSkin(skin, q, reach_of(skin, surfaces, options)));
    });
    for (auto& skin : made)
        current_.push_back(std::move(*skin));
}

void SkinBuilder::add_points(std::int32_t a, std::int32_t b, ContactElements& out) const {
    const auto &from = current(a), &onto = current(b);
    const double margin = options_.search.margin, depth = onto.skin().radius,
                 reach = std::max(margin, depth);
    for (std::int64_t k = 0; k < from.skin().num_points(); ++k) {
        const auto point = from.point(k);
        if (onto.box().distance_to(point.position) > reach)
            continue;
        const auto place = onto.closest(point.position, [&](const SkinPlace& p) {
            const double height = p.height();
            return height <= margin && height >= -depth && point.normal.dot(p.normal) < facing &&
                   !is_beside(p) && !is_beyond_rim(onto.skin(), p);
        });
        if (!place || is_at_another_wall(onto, *place, point.position))
            continue;
        const double share = share_inside_edges(onto.skin(), place->at) *
                             share_of(mean_area(from.skin(), point.at.facet),
                                      mean_area(onto.skin(), place->at.facet));
        if (share == 0)
            continue;
        out.push_back({.surface_a = a,
                       .surface_b = b,
                       .s_a = 0,
                       .s_b = 0,
                       .station = k,
                       .normal = -place->normal,
                       .weight = share * from.skin().area[static_cast<std::size_t>(k)],
                       .stiffness = 0,
                       .facet_a = point.at.facet,
                       .facet_b = place->at.facet,
                       .xi_a = {point.at.u, point.at.v},
                       .xi_b = {place->at.u, place->at.v},
                       .allowance = rest_overlap(a, k) - place->shift.dot(place->normal) +
                                    point.rise * point.normal.dot(place->normal)});
    }
}

double SkinBuilder::rest_overlap(std::int32_t surface, std::int64_t station) const {
    const auto at = options_.rest_overlaps.find({surface, station});
    return at == options_.rest_overlaps.end() ? 0 : at->second;
}

ContactElements SkinBuilder::skins(std::int32_t a, std::int32_t b) const {
    ContactElements out;
    const double reach =
        std::max({options_.search.margin, current(a).skin().radius, current(b).skin().radius});
    if (!overlap(current(a).box(), current(b).box(), reach))
        return out;
    add_points(a, b, out);
    add_points(b, a, out);
    return builder_.finished(std::move(out));
}

ContactElements SkinBuilder::tube(std::int32_t a, std::int32_t skin_b) const {
    const Tube& tube = surfaces_.tube(a);
    const auto& onto = current(skin_b);
    const double reach = tube.radius + options_.search.margin;
    ContactElements out;
    const auto count = static_cast<std::int64_t>(std::ceil(tube.length() / options_.spacing));
    const double spacing = tube.length() / static_cast<double>(count);
    for (std::int64_t k = 0; k < count + (tube.has_ends() ? 2 : 0); ++k) {
        // In the middles of even cells, and at the ends.
        const double s = k < count ? (static_cast<double>(k) + 0.5) * spacing / tube.element_length
                         : k == count ? tube.first_element()
                                      : tube.end_element();
        const Vec3 x = position(tube, q_, s);
        if (onto.box().distance_to(x) > reach)
            continue;
        const auto place = onto.closest(x, [&](const SkinPlace& p) {
            const double distance = p.offset.norm();
            if (is_beyond_rim(onto.skin(), p))
                return false;
            return p.height() > cosine_above * distance
                       ? distance <= reach
                       : distance <= onto.skin().radius && !is_beside(p);
        });
        if (!place)
            continue;
        const bool use_way = place->height() > too_near * tube.radius;
        const Vec3 normal = use_way ? Vec3(-place->offset.normalized()) : Vec3(-place->normal);
        const double weight = weight_at(tube, q_, s, normal, spacing, options_.point_tolerance);
        if (weight == 0)
            continue;
        out.push_back({.surface_a = a,
                       .surface_b = skin_b,
                       .s_a = s,
                       .s_b = 0,
                       .station = k,
                       .normal = normal,
                       .weight = weight,
                       .stiffness = 0,
                       .facet_b = place->at.facet,
                       .xi_b = {place->at.u, place->at.v},
                       .allowance = rest_overlap(a, k) + place->shift.dot(normal)});
    }
    return builder_.finished(std::move(out));
}

ContactElements SkinBuilder::wall(std::int32_t skin_a, const Rigid& rigid,
                                  std::int32_t number) const {
    const auto& from = current(skin_a);
    ContactElements out;
    for (std::int64_t k = 0; k < from.skin().num_points(); ++k) {
        const auto point = from.point(k);
        const auto wall = rigid.nearest(point.position);
        if ((point.position - wall.position).dot(wall.normal) > options_.search.margin ||
            point.normal.dot(wall.normal) >= facing)
            continue;
        out.push_back({.surface_a = skin_a,
                       .surface_b = -1 - number,
                       .body_b = rigid.body,
                       .s_a = 0,
                       .s_b = 0,
                       .station = k,
                       .normal = -wall.normal,
                       .weight = from.skin().area[static_cast<std::size_t>(k)],
                       .stiffness = 0,
                       .facet_a = point.at.facet,
                       .xi_a = {point.at.u, point.at.v},
                       .wall = wall.position,
                       .allowance = point.rise * point.normal.dot(wall.normal)});
    }
    return builder_.finished(std::move(out), rigid);
}

std::vector<ContactElements> skin_parts(const Surfaces& surfaces, Unknowns q,
                                        const Builder& builder, const PairingOptions& options) {
    if (surfaces.skins.empty())
        return {};
    const SkinBuilder skins(surfaces, q, builder, options);
    const auto all = surfaces.deformable();
    const auto first = all.num_tubes(),
               end = first + static_cast<std::int32_t>(surfaces.skins.size());
    std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
    for (auto b = first; b < end; ++b) {
        for (std::int32_t a = 0; a < b; ++a)
            if (is_own(options, a, b) && may_touch(options, all, a, b))
                pairs.emplace_back(a, b);
        for (std::int32_t k = 0; k < static_cast<std::int32_t>(surfaces.rigid.size()); ++k)
            if (is_own(options, b, k) &&
                may_touch(options, all.body(b), surfaces.rigid[static_cast<std::size_t>(k)].body))
                pairs.emplace_back(b, -1 - k);
    }
    return parallel_map(pairs.size(), options.num_threads, [&](std::size_t i) {
        const auto [a, b] = pairs[i];
        if (b < 0)
            return skins.wall(a, surfaces.rigid[static_cast<std::size_t>(-1 - b)], -1 - b);
        return all.is_skin(a) ? skins.skins(a, b) : skins.tube(a, b);
    });
}

} // namespace braidx
