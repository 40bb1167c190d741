#include "assembly/assemble.h"
#include "assembly/memory.h"
#include "bindings/checks.h"
#include "bindings/crossings.h"
#include "bindings/elements.h"
#include "bindings/energy.h"
#include "bindings/rigid.h"
#include "pairing/pairing.h"
#include "pairing/rules.h"
#include "search/max_step.h"

#include <algorithm>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

NB_MAKE_OPAQUE(std::vector<braidx::Tube>)
NB_MAKE_OPAQUE(std::vector<braidx::Skin>)
NB_MAKE_OPAQUE(std::vector<braidx::Crossing>)
NB_MAKE_OPAQUE(braidx::ContactElements)

using namespace nanobind::literals;
using namespace braidx;
using namespace braidx::bindings;

namespace {

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
    nb::class_<Skin>(m, "Skin").def_prop_ro("num_points", &Skin::num_points);
    nb::class_<OwnedSurfaces>(m, "Surfaces").def(nb::init<std::vector<Tube>>());
    nb::implicitly_convertible<std::vector<Tube>, OwnedSurfaces>();
    nb::class_<std::vector<Crossing>>(m, "Crossings")
        .def("__len__", [](const std::vector<Crossing>& c) { return c.size(); });
    bind_rigid(m);
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
        .def_rw("within_increment", &PairingOptions::within_increment)
        .def_rw("stiffness", &PairingOptions::stiffness)
        .def_rw("area_stiffness", &PairingOptions::area_stiffness)
        .def_rw("keep_side", &PairingOptions::keep_side)
        .def_rw("part", &PairingOptions::part)
        .def_rw("num_parts", &PairingOptions::num_parts)
        .def_rw("num_threads", &PairingOptions::num_threads)
        .def_rw("num_bodies", &PairingOptions::num_bodies)
        .def_rw("may_touch", &PairingOptions::may_touch);
    nb::class_<ContactLaws>(m, "ContactLaws")
        .def(nb::init<>())
        .def_rw("regularisation", &ContactLaws::regularisation)
        .def_rw("reversible_slip", &ContactLaws::reversible_slip)
        .def_rw("gap_step", &ContactLaws::gap_step)
        .def_rw("sliding", &ContactLaws::sliding)
        .def_rw("num_bodies", &ContactLaws::num_bodies)
        .def_rw("friction", &ContactLaws::friction);

    m.def("make_tubes", &make_tubes, "first_unknown"_a, "num_elements"_a, "degree"_a, "block"_a,
          "radius"_a, "element_length"_a, "body"_a, "is_image"_a, "smooth"_a, "beyond"_a = 0,
          "group"_a = std::vector<int>{}, "closed"_a = std::vector<int>{}, "round_ends"_a = false);
    m.def("make_skin", &skin_from_arrays, "facets"_a, "body"_a, "radius"_a, "group"_a, "rest"_a,
          "dense"_a, "smooth"_a, "offset"_a);
    m.def(
        "make_surfaces",
        [](const std::vector<Tube>& tubes, const nb::list& skins) {
            std::vector<Skin> all;
            for (const auto skin : skins)
                all.push_back(nb::cast<const Skin&>(skin));
            return OwnedSurfaces(tubes, std::move(all));
        },
        "tubes"_a, "skins"_a);
    m.def("make_crossings", &make_crossings, "tubes"_a, "windows"_a, "order"_a, "axis"_a);
    m.def(
        "make_contact_elements",
        [](const OwnedSurfaces& surfaces, const std::vector<Crossing>& crossings,
           const std::vector<Rigid>& rigid, const In<double>& q, const In<double>& q_start,
           const ContactElements& previous, const PairingOptions& options) {
            require_unknowns(surfaces, q, "q");
            require_unknowns(surfaces, q_start, "q_start");
            require_elements(surfaces, previous, "previous");
            require_crossings(surfaces.tubes, crossings);
            require_options(surfaces, rigid, options);
            for (const auto& r : rigid)
                require_frame(r.frame, q, "a frame of rigid");
            return make_contact_elements({surfaces.tubes, crossings, rigid, surfaces.skins},
                                         view(q), previous, options, view(q_start));
        },
        "surfaces"_a, "crossings"_a, "rigid"_a, "q"_a, "q_start"_a, "previous"_a, "options"_a,
        without_gil);
    m.def(
        "set_rest_overlaps",
        [](PairingOptions& options, const In<std::int32_t>& surface,
           const In<std::int64_t>& station, const In<double>& depth) {
            require_shape(depth, "depth", {-1});
            require_shape(surface, "surface", shape_of(depth));
            require_shape(station, "station", shape_of(depth));
            options.rest_overlaps.clear();
            for (std::size_t i = 0; i < depth.size(); ++i) {
                auto& deepest = options.rest_overlaps[{surface.data()[i], station.data()[i]}];
                deepest = std::max(deepest, depth.data()[i]);
            }
        },
        "options"_a, "surface"_a, "station"_a, "depth"_a);
    m.def(
        "is_own",
        [](const PairingOptions& options, const In<std::int64_t>& tube,
           const In<std::int64_t>& other) {
            require_shape(tube, "tube", {-1});
            require_shape(other, "other", shape_of(tube));
            return make_array<bool>({tube.size()}, [&](bool* out) {
                for (std::size_t i = 0; i < tube.size(); ++i)
                    out[i] = is_own(options, tube.data()[i], other.data()[i]);
            });
        },
        "options"_a, "tube"_a, "other"_a);
    m.def(
        "cell_lengths",
        [](const std::vector<Tube>& tubes, const In<std::int64_t>& a, const In<std::int64_t>& b,
           double spacing) {
            require_shape(a, "a", {-1});
            require_shape(b, "b", shape_of(a));
            const auto tube = [&](std::int64_t number) {
                require(number >= 0 && std::cmp_less(number, tubes.size()), "a tube", number,
                        "a number from 0, below ", tubes.size());
                return tubes[static_cast<std::size_t>(number)];
            };
            return make_array<double>({a.size()}, [&](double* out) {
                for (std::size_t i = 0; i < a.size(); ++i)
                    out[i] = cell_length(tube(a.data()[i]), tube(b.data()[i]), spacing);
            });
        },
        "tubes"_a, "a"_a, "b"_a, "spacing"_a);
    m.def(
        "make_pattern",
        [](const OwnedSurfaces& surfaces, const ContactElements& elements, double reach,
           int num_threads) {
            require_elements(surfaces, elements);
            return make_pattern(surfaces, elements, reach, num_threads);
        },
        "surfaces"_a, "elements"_a, "reach"_a = 0.0, "num_threads"_a = 1, without_gil);
    m.def(
        "place",
        [](Pattern& pattern, const OwnedSurfaces& surfaces, const ContactElements& elements,
           int num_threads) {
            require_elements(surfaces, elements);
            return place(pattern, surfaces, elements, num_threads);
        },
        "pattern"_a, "surfaces"_a, "elements"_a, "num_threads"_a = 1, without_gil);
    m.def(
        "add_residual",
        [](const OwnedSurfaces& surfaces, const ContactElements& elements, const In<double>& q,
           const In<double>& q_start, const ContactLaws& laws, const InOut<double>& residual,
           int num_threads) {
            require_state(surfaces, elements, q, q_start, laws);
            require_shape(residual, "residual", shape_of(q));
            add_residual(surfaces, elements, view(q), view(q_start), laws, view(residual),
                         num_threads);
        },
        "surfaces"_a, "elements"_a, "q"_a, "q_start"_a, "laws"_a, "residual"_a.noconvert(),
        "num_threads"_a = 1, without_gil);
    m.def(
        "add_tangent",
        [](const OwnedSurfaces& surfaces, const ContactElements& elements, const Pattern& pattern,
           const In<double>& q, const In<double>& q_start, const ContactLaws& laws, bool symmetric,
           const InOut<double>& values, int num_threads) {
            require_state(surfaces, elements, q, q_start, laws);
            require(pattern.first_slot.size() == elements.size(), "pattern",
                    "one of " + std::to_string(pattern.first_slot.size()) + " elements",
                    "one of these ", elements.size());
            require(values.size() == 9 * pattern.row.size(), "values",
                    "an array of shape " + written_shape(shape_of(values)), "one of ",
                    9 * pattern.row.size(), " numbers");
            add_tangent(surfaces, elements, pattern, view(q), view(q_start), laws,
                        symmetric ? FrictionTangent::symmetric : FrictionTangent::consistent,
                        view(values), num_threads);
        },
        "surfaces"_a, "elements"_a, "pattern"_a, "q"_a, "q_start"_a, "laws"_a, "symmetric"_a,
        "values"_a.noconvert(), "num_threads"_a = 1, without_gil);
    bind_energy(m);
    m.def(
        "commit",
        [](const OwnedSurfaces& surfaces, ContactElements& elements, const In<double>& q,
           const In<double>& q_start, const ContactLaws& laws, int num_threads) {
            require_state(surfaces, elements, q, q_start, laws);
            const auto done = commit(surfaces, elements, view(q), view(q_start), laws, num_threads);
            return std::pair(done.work, done.penetration);
        },
        "surfaces"_a, "elements"_a, "q"_a, "q_start"_a, "laws"_a, "num_threads"_a = 1, without_gil);
    m.def(
        "adapt_stiffness",
        [](const OwnedSurfaces& surfaces, ContactElements& elements, const In<double>& q,
           double tolerance, double growth, double elsewhere, int num_threads,
           const std::optional<In<bool>>& held) {
            require_elements(surfaces, elements, q);
            require_unknowns(surfaces, q, "q");
            if (held)
                require_shape(*held, "held", shape_of(q));
            return adapt_stiffness(surfaces, elements, view(q), tolerance, growth, elsewhere,
                                   num_threads, held ? view(*held) : std::span<const bool>{});
        },
        "surfaces"_a, "elements"_a, "q"_a, "tolerance"_a, "growth"_a, "elsewhere"_a = 0.0,
        "num_threads"_a = 1, "held"_a = nb::none(), without_gil);
    m.def(
        "update_multipliers",
        [](const OwnedSurfaces& surfaces, ContactElements& elements, const In<double>& q,
           const In<double>& q_start, const ContactLaws& laws, int num_threads) {
            require_state(surfaces, elements, q, q_start, laws);
            update_multipliers(surfaces, elements, view(q), view(q_start), laws, num_threads);
        },
        "surfaces"_a, "elements"_a, "q"_a, "q_start"_a, "laws"_a, "num_threads"_a = 1, without_gil);
    m.def(
        "deepest_penetration",
        [](const OwnedSurfaces& surfaces, const ContactElements& elements, const In<double>& q,
           int num_threads) {
            require_elements(surfaces, elements, q);
            require_unknowns(surfaces, q, "q");
            return deepest_penetration(surfaces, elements, view(q), num_threads);
        },
        "surfaces"_a, "elements"_a, "q"_a, "num_threads"_a = 1, without_gil);
    m.def(
        "sum_normal_forces",
        [](const OwnedSurfaces& surfaces, const ContactElements& elements, const In<double>& q,
           const In<double>& q_start, const ContactLaws& laws, int num_threads) {
            require_state(surfaces, elements, q, q_start, laws);
            const auto sums =
                sum_normal_forces(surfaces, elements, view(q), view(q_start), laws, num_threads);
            return std::pair(sums.rigid, sums.all);
        },
        "surfaces"_a, "elements"_a, "q"_a, "q_start"_a, "laws"_a, "num_threads"_a = 1, without_gil);
    m.def(
        "max_step",
        [](const OwnedSurfaces& surfaces, const In<double>& q, const In<double>& dq,
           const PairingOptions& options) {
            require_unknowns(surfaces, q, "q");
            require_shape(dq, "dq", shape_of(q));
            require_options(surfaces, {}, options);
            const auto may_meet = [&](std::int32_t a, std::int32_t b) {
                return may_touch(options, surfaces, a, b);
            };
            return max_step(surfaces.tubes, view(q), view(dq), options.search, may_meet,
                            options.num_threads);
        },
        "surfaces"_a, "q"_a, "dq"_a, "options"_a, without_gil);
    m.def("freeze_sections", &freeze_sections, "elements"_a);
    m.def(
        "sum_log_stiffness",
        [](const ContactElements& elements, bool per_area) {
            const auto logs = sum_log_stiffness(elements, per_area);
            return std::pair(logs.sum, logs.count);
        },
        "elements"_a, "per_area"_a);
    m.def("scale_stiffness", &scale_stiffness, "elements"_a, "factor"_a);
    m.def("contact_results", &contact_results, "surfaces"_a, "elements"_a, "q"_a, "q_start"_a,
          "laws"_a, "num_threads"_a = 1);
    m.def("crossing_heights", &heights, "tubes"_a, "crossings"_a, "q"_a);
    m.def(
        "close_pairs",
        [](const std::vector<Tube>& tubes, const In<double>& q, const SearchOptions& options) {
            require_unknowns(OwnedSurfaces(tubes), q, "q");
            return pair_arrays(close_pairs(tubes, view(q), options));
        },
        "tubes"_a, "q"_a, "options"_a);
}
