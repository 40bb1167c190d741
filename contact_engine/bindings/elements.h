#pragma once

#include "../parallel.h"
#include "checks.h"

/// Contact elements as a dictionary of arrays and back, and their results.
namespace braidx::bindings {

template <class T, class Get>
auto gather(const ContactElements& elements, std::size_t width, const Get& get) {
    const auto fill = [&](T* out) {
        for (const auto& e : elements)
            for (std::size_t i = 0; i < width; ++i)
                *out++ = static_cast<T>(get(e, i));
    };
    return width == 1 ? make_array<T>({elements.size()}, fill)
                      : make_array<T>({elements.size(), width}, fill);
}

inline nb::dict element_arrays(const ContactElements& elements) {
    using E = ContactElement;
    nb::dict out;
    out["tubes"] = gather<std::int32_t>(
        elements, 2, [](const E& e, auto i) { return i ? e.surface_b : e.surface_a; });
    out["s"] = gather<double>(elements, 2, [](const E& e, auto i) { return i ? e.s_b : e.s_a; });
    out["facet"] = gather<std::int32_t>(
        elements, 2, [](const E& e, auto i) { return i ? e.facet_b : e.facet_a; });
    out["station"] = gather<std::int64_t>(elements, 1, [](const E& e, auto) { return e.station; });
    out["normal"] = gather<double>(elements, 3, [](const E& e, auto i) { return e.normal[i]; });
    out["weight"] = gather<double>(elements, 1, [](const E& e, auto) { return e.weight; });
    out["stiffness"] = gather<double>(elements, 1, [](const E& e, auto) { return e.stiffness; });
    out["multiplier"] = gather<double>(elements, 1, [](const E& e, auto) { return e.multiplier; });
    out["xi"] = gather<double>(
        elements, 4, [](const E& e, auto i) { return i < 2 ? e.xi_a[i] : e.xi_b[i - 2]; });
    out["round"] =
        gather<double>(elements, 2, [](const E& e, auto i) { return i ? e.round_b : e.round_a; });
    out["slip"] = gather<double>(elements, 3, [](const E& e, auto i) { return e.slip[i]; });
    out["work"] = gather<double>(elements, 1, [](const E& e, auto) { return e.work; });
    out["body_b"] = gather<std::int32_t>(elements, 1, [](const E& e, auto) { return e.body_b; });
    out["wall"] = gather<double>(
        elements, 6, [](const E& e, auto i) { return i < 3 ? e.wall[i] : e.wall_start[i - 3]; });
    out["frame"] = gather<std::int64_t>(elements, 1, [](const E& e, auto) { return e.frame; });
    out["in_frame"] = gather<double>(elements, 3, [](const E& e, auto i) { return e.in_frame[i]; });
    out["allowance"] = gather<double>(elements, 1, [](const E& e, auto) { return e.allowance; });
    out["follows"] = gather<std::int32_t>(elements, 1, [](const E& e, auto) { return e.follows; });
    out["zone"] = gather<std::int32_t>(elements, 1, [](const E& e, auto) { return e.zone; });
    out["crossing"] =
        gather<std::int32_t>(elements, 1, [](const E& e, auto) { return e.crossing; });
    return out;
}

/// A column of a dictionary of arrays: `width` numbers for each of `count` elements.
template <class T>
const T* column(const nb::dict& arrays, const char* name, std::int64_t count,
                std::int64_t width = 1) {
    require(arrays.contains(name), name, "missing", "an array of it");
    In<T> array;
    require(nb::try_cast(arrays[name], array, false), name, "no array of the right type",
            "one as `arrays` gives it");
    require_shape(array, name,
                  width == 1 ? std::vector{count} : std::vector<std::int64_t>{count, width});
    return array.data();
}

/// Arrays as `element_arrays` gives them, of a checkpoint perhaps.
inline ContactElements elements_from_arrays(const nb::dict& arrays) {
    require(arrays.contains("weight"), "weight", "missing", "an array of it");
    const auto n = static_cast<std::int64_t>(nb::len(nb::object(arrays["weight"])));
    const auto* tubes = column<std::int32_t>(arrays, "tubes", n, 2);
    const auto *s = column<double>(arrays, "s", n, 2),
               *normal = column<double>(arrays, "normal", n, 3),
               *weight = column<double>(arrays, "weight", n),
               *stiffness = column<double>(arrays, "stiffness", n),
               *multiplier = column<double>(arrays, "multiplier", n),
               *xi = column<double>(arrays, "xi", n, 4),
               *slip = column<double>(arrays, "slip", n, 3),
               *work = column<double>(arrays, "work", n),
               *allowance = column<double>(arrays, "allowance", n),
               *wall = column<double>(arrays, "wall", n, 6),
               *in_frame = column<double>(arrays, "in_frame", n, 3),
               *round = column<double>(arrays, "round", n, 2);
    const auto *station = column<std::int64_t>(arrays, "station", n),
               *frame = column<std::int64_t>(arrays, "frame", n);
    const auto *zone = column<std::int32_t>(arrays, "zone", n),
               *body_b = column<std::int32_t>(arrays, "body_b", n),
               *follows = column<std::int32_t>(arrays, "follows", n),
               *facet = column<std::int32_t>(arrays, "facet", n, 2),
               *crossing = column<std::int32_t>(arrays, "crossing", n);
    ContactElements out(static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = {.surface_a = tubes[2 * i],
                  .surface_b = tubes[2 * i + 1],
                  .body_b = body_b[i],
                  .s_a = s[2 * i],
                  .s_b = s[2 * i + 1],
                  .station = station[i],
                  .normal = Eigen::Map<const Vec3>(normal + 3 * i),
                  .follows = follows[i],
                  .weight = weight[i],
                  .stiffness = stiffness[i],
                  .multiplier = multiplier[i],
                  .facet_a = facet[2 * i],
                  .facet_b = facet[2 * i + 1],
                  .xi_a = {xi[4 * i], xi[4 * i + 1]},
                  .xi_b = {xi[4 * i + 2], xi[4 * i + 3]},
                  .round_a = round[2 * i],
                  .round_b = round[2 * i + 1],
                  .slip = Eigen::Map<const Vec3>(slip + 3 * i),
                  .work = work[i],
                  .wall = Eigen::Map<const Vec3>(wall + 6 * i),
                  .wall_start = Eigen::Map<const Vec3>(wall + 6 * i + 3),
                  .frame = frame[i],
                  .in_frame = Eigen::Map<const Vec3>(in_frame + 3 * i),
                  .allowance = allowance[i],
                  .zone = zone[i],
                  .crossing = crossing[i]};
    return out;
}

/// Where an element acts: at the rigid surface, on the skin that a tube lies on, in the middle
/// between two tubes or two skins.
inline Vec3 contact_position(const DeformableSurfaces& surfaces, const ContactElement& e,
                             Unknowns q) {
    if (against_rigid(e))
        return e.wall;
    const auto at = [&](std::int32_t surface, std::int32_t facet, double s, const double(&xi)[2]) {
        if (facet < 0)
            return position(surfaces.tube(surface), q, s);
        const Skin& skin = surfaces.skin(surface);
        return combined(skin, q, facet, facet_weights(skin.kind, xi[0], xi[1]).value);
    };
    const Vec3 b = at(e.surface_b, e.facet_b, e.s_b, e.xi_b);
    if (e.facet_a < 0 && e.facet_b >= 0)
        return b;
    return 0.5 * (at(e.surface_a, e.facet_a, e.s_a, e.xi_a) + b);
}

inline nb::dict contact_results(const OwnedSurfaces& surfaces, const ContactElements& elements,
                                const In<double>& q, const In<double>& q_start,
                                const ContactLaws& laws, int num_threads) {
    struct Result {
        double gap, normal_force, energy;
        Vec3 friction_force, position;
    };
    require_state(surfaces, elements, q, q_start, laws);
    const auto n = elements.size();
    const auto results = parallel_map(n, num_threads, [&](std::size_t i) -> Result {
        const auto& e = elements[i];
        const Reaction r = reaction(surfaces, e, view(q), view(q_start), laws);
        return {r.system.gap, r.normal_force, r.energy, r.friction_force,
                contact_position(surfaces, e, view(q))};
    });
    const auto scalar = [&](double Result::* member) {
        return make_array<double>({n}, [&](double* p) {
            for (const auto& result : results)
                *p++ = result.*member;
        });
    };
    const auto vector = [&](Vec3 Result::* member) {
        return make_array<double>({n, 3}, [&](double* p) {
            for (std::size_t i = 0; i < n; ++i)
                Eigen::Map<Vec3>(p + 3 * i) = results[i].*member;
        });
    };
    nb::dict out;
    out["per_area"] = make_array<bool>({n}, [&](bool* p) {
        for (const auto& e : elements)
            *p++ = is_per_area(e);
    });
    out["gap"] = scalar(&Result::gap);
    out["normal_force"] = scalar(&Result::normal_force);
    out["energy"] = scalar(&Result::energy);
    out["friction_force"] = vector(&Result::friction_force);
    out["position"] = vector(&Result::position);
    return out;
}

} // namespace braidx::bindings
