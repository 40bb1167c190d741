#include "assembly/assemble.h"
#include "assembly/memory.h"
#include "pairing/pairing.h"

#include <algorithm>
#include <cmath>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/vector.h>

NB_MAKE_OPAQUE(std::vector<braidx::Tube>)
NB_MAKE_OPAQUE(std::vector<braidx::Crossing>)
NB_MAKE_OPAQUE(braidx::ContactElements)

namespace nb = nanobind;
using namespace nb::literals;
using namespace braidx;

namespace {

template <class T> using In = nb::ndarray<const T, nb::numpy, nb::c_contig, nb::device::cpu>;
template <class T> using InOut = nb::ndarray<T, nb::numpy, nb::c_contig, nb::device::cpu>;

template <class T> std::span<const T> view(const In<T>& array) {
    return {array.data(), array.size()};
}
template <class T> std::span<T> view(const InOut<T>& array) {
    return {array.data(), array.size()};
}

Vec3 vector3(const In<double>& array) {
    return Eigen::Map<const Vec3>(array.data());
}

/// A new NumPy array of the given shape, filled by fill(data).
template <class T, class Fill>
auto make_array(std::initializer_list<std::size_t> shape, const Fill& fill) {
    std::size_t size = 1;
    for (const auto n : shape)
        size *= n;
    auto* data = new T[size]();
    nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<T*>(p); });
    fill(data);
    return nb::ndarray<nb::numpy, T>(data, shape.size(), shape.begin(), owner);
}

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

std::vector<Tube> make_tubes(const In<std::int64_t>& first_unknown,
                             const In<std::int32_t>& num_elements, const In<std::int32_t>& degree,
                             const In<std::int32_t>& block, const In<double>& radius,
                             const In<double>& element_length, const In<std::int32_t>& body,
                             bool smooth) {
    std::vector<Tube> tubes;
    for (std::size_t i = 0; i < radius.size(); ++i)
        tubes.push_back({first_unknown.data()[i], num_elements.data()[i], degree.data()[i],
                         block.data()[i], radius.data()[i], element_length.data()[i],
                         body.data()[i], smooth});
    return tubes;
}

std::vector<Crossing> make_crossings(const In<std::int32_t>& tubes, const In<double>& windows,
                                     const In<std::int32_t>& order, const In<double>& axis) {
    const Vec3 point = Eigen::Map<const Vec3>(axis.data()),
               direction = Eigen::Map<const Vec3>(axis.data() + 3);
    std::vector<Crossing> out;
    for (std::size_t i = 0; i < tubes.size() / 2; ++i) {
        const auto* t = tubes.data() + 2 * i;
        const auto* w = windows.data() + 4 * i;
        out.push_back(
            {t[0], t[1], w[0], w[1], w[2], w[3], order.data()[i], point, direction.normalized()});
    }
    return out;
}

nb::dict element_arrays(const ContactElements& elements) {
    using E = ContactElement;
    nb::dict out;
    out["tubes"] = gather<std::int32_t>(elements, 2,
                                        [](const E& e, auto i) { return i ? e.tube_b : e.tube_a; });
    out["s"] = gather<double>(elements, 2, [](const E& e, auto i) { return i ? e.s_b : e.s_a; });
    out["station"] = gather<std::int64_t>(elements, 1, [](const E& e, auto) { return e.station; });
    out["normal"] = gather<double>(elements, 3, [](const E& e, auto i) { return e.normal[i]; });
    out["weight"] = gather<double>(elements, 1, [](const E& e, auto) { return e.weight; });
    out["stiffness"] = gather<double>(elements, 1, [](const E& e, auto) { return e.stiffness; });
    out["xi"] = gather<double>(
        elements, 4, [](const E& e, auto i) { return i < 2 ? e.xi_a[i] : e.xi_b[i - 2]; });
    out["slip"] = gather<double>(elements, 3, [](const E& e, auto i) { return e.slip[i]; });
    out["work"] = gather<double>(elements, 1, [](const E& e, auto) { return e.work; });
    out["body_b"] = gather<std::int32_t>(elements, 1, [](const E& e, auto) { return e.body_b; });
    out["wall"] = gather<double>(
        elements, 6, [](const E& e, auto i) { return i < 3 ? e.wall[i] : e.wall_start[i - 3]; });
    out["allowance"] = gather<double>(elements, 1, [](const E& e, auto) { return e.allowance; });
    out["follows"] = gather<std::int32_t>(elements, 1, [](const E& e, auto) { return e.follows; });
    out["zone"] = gather<std::int32_t>(elements, 1, [](const E& e, auto) { return e.zone; });
    out["crossing"] =
        gather<std::int32_t>(elements, 1, [](const E& e, auto) { return e.crossing; });
    return out;
}

template <class T> const T* column(const nb::dict& arrays, const char* name) {
    return nb::cast<In<T>>(arrays[name], false).data();
}

ContactElements elements_from_arrays(const nb::dict& arrays) {
    const auto* tubes = column<std::int32_t>(arrays, "tubes");
    const auto *s = column<double>(arrays, "s"), *normal = column<double>(arrays, "normal"),
               *weight = column<double>(arrays, "weight"),
               *stiffness = column<double>(arrays, "stiffness"), *xi = column<double>(arrays, "xi"),
               *slip = column<double>(arrays, "slip"), *work = column<double>(arrays, "work"),
               *allowance = column<double>(arrays, "allowance"),
               *wall = column<double>(arrays, "wall");
    const auto* station = column<std::int64_t>(arrays, "station");
    const auto *zone = column<std::int32_t>(arrays, "zone"),
               *body_b = column<std::int32_t>(arrays, "body_b"),
               *follows = column<std::int32_t>(arrays, "follows"),
               *crossing = column<std::int32_t>(arrays, "crossing");
    ContactElements out(nb::cast<In<double>>(arrays["weight"]).size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = {.tube_a = tubes[2 * i],
                  .tube_b = tubes[2 * i + 1],
                  .body_b = body_b[i],
                  .s_a = s[2 * i],
                  .s_b = s[2 * i + 1],
                  .station = station[i],
                  .normal = Eigen::Map<const Vec3>(normal + 3 * i),
                  .follows = follows[i],
                  .weight = weight[i],
                  .stiffness = stiffness[i],
                  .xi_a = {xi[4 * i], xi[4 * i + 1]},
                  .xi_b = {xi[4 * i + 2], xi[4 * i + 3]},
                  .slip = Eigen::Map<const Vec3>(slip + 3 * i),
                  .work = work[i],
                  .wall = Eigen::Map<const Vec3>(wall + 6 * i),
                  .wall_start = Eigen::Map<const Vec3>(wall + 6 * i + 3),
                  .allowance = allowance[i],
                  .zone = zone[i],
                  .crossing = crossing[i]};
    return out;
}

nb::dict contact_results(const std::vector<Tube>& tubes, const ContactElements& elements,
                         const In<double>& q, const In<double>& q_start, const ContactLaws& laws) {
    const auto n = elements.size();
    std::vector<Reaction> reactions;
    for (const auto& e : elements)
        reactions.push_back(reaction(tubes, e, view(q), view(q_start), laws));
    nb::dict out;
    const auto scalar = [&](const auto& get) {
        return make_array<double>({n}, [&](double* p) {
            for (const auto& r : reactions)
                *p++ = get(r);
        });
    };
    const auto vector = [&](const auto& get) {
        return make_array<double>({n, 3}, [&](double* p) {
            for (std::size_t i = 0; i < n; ++i)
                Eigen::Map<Vec3>(p + 3 * i) = get(i);
        });
    };
    out["gap"] = scalar([](const Reaction& r) { return r.system.gap; });
    out["normal_force"] = scalar([](const Reaction& r) { return r.normal_force; });
    out["friction_force"] = vector([&](std::size_t i) { return reactions[i].friction_force; });
    out["position"] = vector([&](std::size_t i) -> Vec3 {
        const auto& e = elements[i];
        if (against_rigid(e))
            return e.wall;
        return 0.5 * (position(tubes[e.tube_a], view(q), e.s_a) +
                      position(tubes[e.tube_b], view(q), e.s_b));
    });
    return out;
}

auto heights(const std::vector<Tube>& tubes, const std::vector<Crossing>& crossings,
             const In<double>& q) {
    return make_array<double>({crossings.size()}, [&](double* out) {
        for (const auto& c : crossings)
            *out++ = crossing_height(tubes, view(q), c).value_or(NAN);
    });
}

auto pair_arrays(const std::vector<ElementPair>& pairs) {
    return make_array<std::int32_t>({pairs.size(), 4}, [&](std::int32_t* out) {
        for (const auto& p : pairs)
            for (const auto value : {p.tube_a, p.tube_b, p.element_a, p.element_b})
                *out++ = value;
    });
}

} // namespace

NB_MODULE(braidx_engine, m) {
    m.doc() = "Contact engine of braidx: arrays in, arrays out. Units: mm, N, MPa.";

    nb::class_<std::vector<Tube>>(m, "Tubes");
    nb::class_<std::vector<Crossing>>(m, "Crossings")
        .def("__len__", [](const std::vector<Crossing>& c) { return c.size(); });
    nb::class_<Rigid>(m, "Rigid");
    nb::class_<ContactElements>(m, "ContactElements")
        .def(nb::init<>())
        .def("__len__", [](const ContactElements& e) { return e.size(); })
        .def("copy", [](const ContactElements& e) { return e; })
        .def("arrays", &element_arrays)
        .def_static("from_arrays", &elements_from_arrays, "arrays"_a);
    nb::class_<Pattern>(m, "Pattern").def("blocks", [](const Pattern& p) {
        const auto copy = [](const std::vector<std::int64_t>& v) {
            return make_array<std::int64_t>({v.size()},
                                            [&](auto* out) { std::ranges::copy(v, out); });
        };
        return nb::make_tuple(copy(p.row), copy(p.col));
    });

    nb::class_<SearchOptions>(m, "SearchOptions")
        .def(nb::init<>())
        .def_rw("margin", &SearchOptions::margin)
        .def_rw("self_exclusion", &SearchOptions::self_exclusion);
    nb::class_<CrossingOptions>(m, "CrossingOptions")
        .def(nb::init<>())
        .def_rw("separation", &CrossingOptions::separation)
        .def_rw("by_point", &CrossingOptions::by_point)
        .def_rw("lateral", &CrossingOptions::lateral);
    nb::class_<PairingOptions>(m, "PairingOptions")
        .def(nb::init<>())
        .def_rw("search", &PairingOptions::search)
        .def_rw("crossing", &PairingOptions::crossing)
        .def_rw("spacing", &PairingOptions::spacing)
        .def_rw("point_tolerance", &PairingOptions::point_tolerance)
        .def_rw("stiffness", &PairingOptions::stiffness)
        .def_rw("follow", &PairingOptions::follow)
        .def_rw("keep_side", &PairingOptions::keep_side)
        .def_rw("part", &PairingOptions::part)
        .def_rw("num_parts", &PairingOptions::num_parts);
    nb::class_<ContactLaws>(m, "ContactLaws")
        .def(nb::init<>())
        .def_rw("regularisation", &ContactLaws::regularisation)
        .def_rw("reversible_slip", &ContactLaws::reversible_slip)
        .def_rw("gap_step", &ContactLaws::gap_step)
        .def_rw("sliding", &ContactLaws::sliding)
        .def_rw("num_bodies", &ContactLaws::num_bodies)
        .def_rw("friction", &ContactLaws::friction);

    m.def("make_tubes", &make_tubes, "first_unknown"_a, "num_elements"_a, "degree"_a, "block"_a,
          "radius"_a, "element_length"_a, "body"_a, "smooth"_a);
    m.def("make_crossings", &make_crossings, "tubes"_a, "windows"_a, "order"_a, "axis"_a);
    m.def(
        "make_contact_elements",
        [](const std::vector<Tube>& tubes, const std::vector<Crossing>& crossings,
           const std::vector<Rigid>& rigid, const In<double>& q, const ContactElements& previous,
           const PairingOptions& options) {
            return make_contact_elements({tubes, crossings, rigid}, view(q), previous, options);
        },
        "tubes"_a, "crossings"_a, "rigid"_a, "q"_a, "previous"_a, "options"_a);
    m.def(
        "make_plane",
        [](const In<double>& point, const In<double>& normal, int body) {
            return Rigid{Plane{vector3(point), vector3(normal).normalized()}, body};
        },
        "point"_a, "normal"_a, "body"_a);
    m.def(
        "make_cylinder",
        [](const In<double>& point, const In<double>& axis, double radius, bool hollow, int body) {
            return Rigid{Cylinder{vector3(point), vector3(axis).normalized(), radius, hollow},
                         body};
        },
        "point"_a, "axis"_a, "radius"_a, "hollow"_a, "body"_a);
    m.def(
        "make_sheave",
        [](const In<double>& centre, const In<double>& axis, double radius, double groove_radius,
           int body) {
            return Rigid{Sheave{vector3(centre), vector3(axis).normalized(), radius, groove_radius},
                         body};
        },
        "centre"_a, "axis"_a, "radius"_a, "groove_radius"_a, "body"_a);
    m.def(
        "moved",
        [](const Rigid& rigid, const In<double>& pivot, const In<double>& rotation,
           const In<double>& translation) {
            return Rigid{rigid.shape, rigid.body, vector3(pivot), vector3(rotation),
                         vector3(translation)};
        },
        "rigid"_a, "pivot"_a, "rotation"_a, "translation"_a);
    m.def("make_pattern", &make_pattern, "tubes"_a, "elements"_a);
    m.def(
        "add_residual",
        [](const std::vector<Tube>& tubes, const ContactElements& elements, const In<double>& q,
           const In<double>& q_start, const ContactLaws& laws, const InOut<double>& residual) {
            add_residual(tubes, elements, view(q), view(q_start), laws, view(residual));
        },
        "tubes"_a, "elements"_a, "q"_a, "q_start"_a, "laws"_a, "residual"_a);
    m.def(
        "add_tangent",
        [](const std::vector<Tube>& tubes, const ContactElements& elements, const Pattern& pattern,
           const In<double>& q, const In<double>& q_start, const ContactLaws& laws, bool symmetric,
           const InOut<double>& values) {
            add_tangent(tubes, elements, pattern, view(q), view(q_start), laws,
                        symmetric ? FrictionTangent::symmetric : FrictionTangent::consistent,
                        view(values));
        },
        "tubes"_a, "elements"_a, "pattern"_a, "q"_a, "q_start"_a, "laws"_a, "symmetric"_a,
        "values"_a);
    m.def(
        "commit",
        [](const std::vector<Tube>& tubes, ContactElements& elements, const In<double>& q,
           const In<double>& q_start, const ContactLaws& laws) {
            const auto done = commit(tubes, elements, view(q), view(q_start), laws);
            return nb::make_tuple(done.work, done.penetration);
        },
        "tubes"_a, "elements"_a, "q"_a, "q_start"_a, "laws"_a);
    m.def(
        "adapt_stiffness",
        [](const std::vector<Tube>& tubes, ContactElements& elements, const In<double>& q,
           double tolerance,
           double growth) { return adapt_stiffness(tubes, elements, view(q), tolerance, growth); },
        "tubes"_a, "elements"_a, "q"_a, "tolerance"_a, "growth"_a);
    m.def("contact_results", &contact_results, "tubes"_a, "elements"_a, "q"_a, "q_start"_a,
          "laws"_a);
    m.def("crossing_heights", &heights, "tubes"_a, "crossings"_a, "q"_a);
    m.def(
        "close_pairs",
        [](const std::vector<Tube>& tubes, const In<double>& q, const SearchOptions& options,
           bool brute_force) {
            return pair_arrays(brute_force ? close_pairs_brute_force(tubes, view(q), options)
                                           : close_pairs(tubes, view(q), options));
        },
        "tubes"_a, "q"_a, "options"_a, "brute_force"_a);
}
