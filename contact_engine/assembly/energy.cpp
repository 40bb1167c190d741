#include "energy.h"

#include "../parallel.h"
#include "asked.h"

#include <numeric>

namespace braidx {
namespace {

/// How much of a contact element's energy counts: each side whose rows are asked for has half.
double share(const DeformableSurfaces& surfaces, const ContactElement& e) {
    if (against_rigid(e))
        return surfaces.is_image(e.surface_a) ? 0.0 : 1.0;
    return 0.5 * (surfaces.is_image(e.surface_a) ? 0 : 1) +
           0.5 * (surfaces.is_image(e.surface_b) ? 0 : 1);
}

} // namespace

std::vector<double> normal_forces(const DeformableSurfaces& surfaces,
                                  const ContactElements& elements, Unknowns q, Unknowns q_start,
                                  const ContactLaws& laws, int num_threads) {
    return parallel_map(elements.size(), num_threads, [&](std::size_t e) {
        return reaction(surfaces, elements[e], q, q_start, laws).normal_force;
    });
}

double contact_energy(const DeformableSurfaces& surfaces, const ContactElements& elements,
                      Unknowns q, Unknowns q_start, const ContactLaws& laws,
                      std::span<const double> lagged, int num_threads) {
    const auto asked = asked_elements(surfaces, elements);
    const auto each = parallel_map(asked.size(), num_threads, [&](std::size_t k) {
        const auto& element = elements[asked[k]];
        const Reaction r = reaction(surfaces, element, q, q_start, laws);
        const double friction =
            lagged.empty() ? 0 : lagged[asked[k]] * r.friction.potential(r.slip);
        return share(surfaces, element) * (r.energy + friction);
    });
    return std::accumulate(each.begin(), each.end(), 0.0);
}

} // namespace braidx
