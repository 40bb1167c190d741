#pragma once

#include "../assembly/energy.h"
#include "checks.h"

#include <algorithm>

namespace braidx::bindings {

inline void bind_energy(nb::module_& m) {
    using namespace nanobind::literals;
    m.def(
        "normal_forces",
        [](const OwnedSurfaces& surfaces, const ContactElements& elements, const In<double>& q,
           const In<double>& q_start, const ContactLaws& laws, int num_threads) {
            require_state(surfaces, elements, q, q_start, laws);
            const auto forces =
                normal_forces(surfaces, elements, view(q), view(q_start), laws, num_threads);
            return make_array<double>({forces.size()},
                                      [&](double* out) { std::ranges::copy(forces, out); });
        },
        "surfaces"_a, "elements"_a, "q"_a, "q_start"_a, "laws"_a, "num_threads"_a = 1);
    m.def(
        "contact_energy",
        [](const OwnedSurfaces& surfaces, const ContactElements& elements, const In<double>& q,
           const In<double>& q_start, const ContactLaws& laws, const In<double>& lagged,
           int num_threads) {
            require_state(surfaces, elements, q, q_start, laws);
            require(lagged.size() == elements.size(), "lagged",
                    "an array of shape " + written_shape(shape_of(lagged)), "one of ",
                    elements.size(), " forces");
            return contact_energy(surfaces, elements, view(q), view(q_start), laws, view(lagged),
                                  num_threads);
        },
        "surfaces"_a, "elements"_a, "q"_a, "q_start"_a, "laws"_a, "lagged"_a, "num_threads"_a = 1,
        without_gil);
}

} // namespace braidx::bindings
