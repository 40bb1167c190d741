#pragma once

#include "../assembly/reaction.h"
#include "../pairing/pairing.h"
#include "arrays.h"
#include "surfaces.h"

/// What arrays and objects from Python must be: std::invalid_argument, a ValueError there, says
/// which is not.
namespace braidx::bindings {

/// Other Python threads go on while the engine works on arrays and objects of its own.
inline constexpr nb::call_guard<nb::gil_scoped_release> without_gil;

/// Whether the unknowns are those of the surfaces at least: bodies without contact may follow.
inline void require_unknowns(const OwnedSurfaces& surfaces, const In<double>& q, const char* name) {
    require(q.ndim() == 1 && std::cmp_greater_equal(q.size(), surfaces.num_unknowns), name,
            "an array of shape " + written_shape(shape_of(q)), "(n,) with n at least ",
            surfaces.num_unknowns, " for the unknowns of tubes and skins");
}

/// Whether friction is given for all pairs of bodies, or for none.
inline void require_bodies(std::size_t size, int num_bodies, int num_present, const char* name) {
    require(size == 0 ||
                (num_bodies >= num_present && size == static_cast<std::size_t>(num_bodies) *
                                                          static_cast<std::size_t>(num_bodies)),
            name, std::to_string(size) + " numbers",
            "num_bodies x num_bodies, with num_bodies = ", num_bodies, " at least ", num_present,
            ", the bodies there are");
}

/// Whether a side of a contact element is on a tube, or on a facet of a skin, that there is.
inline bool is_on(const DeformableSurfaces& surfaces, std::int32_t num_surfaces,
                  std::int32_t surface, std::int32_t facet) {
    if (surface < 0 || surface >= num_surfaces)
        return false;
    return surfaces.is_skin(surface) ? facet >= 0 && facet < surfaces.skin(surface).num_facets()
                                     : facet < 0;
}

inline void require_elements(const OwnedSurfaces& surfaces, const ContactElements& elements,
                             const char* name = "elements") {
    const auto count = static_cast<std::int32_t>(surfaces.tubes.size() + surfaces.skins.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const auto& e = elements[i];
        const bool fits = is_on(surfaces, count, e.surface_a, e.facet_a) &&
                          (against_rigid(e) || is_on(surfaces, count, e.surface_b, e.facet_b));
        if (!fits)
            throw std::invalid_argument(
                std::string(name) + ": number " + std::to_string(i) + " is between surfaces " +
                std::to_string(e.surface_a) + " and " + std::to_string(e.surface_b) + ", facets " +
                std::to_string(e.facet_a) + " and " + std::to_string(e.facet_b) + "; there are " +
                std::to_string(surfaces.tubes.size()) + " tubes and, after them, " +
                std::to_string(surfaces.skins.size()) + " skins");
    }
}

inline void require_options(const OwnedSurfaces& surfaces, const std::vector<Rigid>& rigid,
                            const PairingOptions& options) {
    require(options.spacing > 0, "options.spacing", options.spacing, "a length above 0");
    require(options.num_parts >= 1, "options.num_parts", options.num_parts, "at least 1");
    int num_bodies = surfaces.num_bodies;
    for (const auto& r : rigid)
        num_bodies = std::max(num_bodies, r.body + 1);
    require_bodies(options.may_touch.size(), options.num_bodies, num_bodies, "options.may_touch");
}

/// Whether a frame, if there is one, is among the unknowns.
inline void require_frame(std::int64_t frame, const In<double>& q, const char* name) {
    const auto end = frame + 3 * Rigid::frame_vectors;
    require(frame < 0 || std::cmp_less_equal(end, q.size()), name, frame,
            "a first unknown of twelve, of ", q.size());
}

/// Whether contact elements are between surfaces that there are, and frames among the unknowns.
inline void require_elements(const OwnedSurfaces& surfaces, const ContactElements& elements,
                             const In<double>& q) {
    require_elements(surfaces, elements);
    for (const auto& e : elements)
        require_frame(e.frame, q, "a frame of elements");
}

/// What forces between contact elements are computed from.
inline void require_state(const OwnedSurfaces& surfaces, const ContactElements& elements,
                          const In<double>& q, const In<double>& q_start, const ContactLaws& laws) {
    require_elements(surfaces, elements, q);
    require_unknowns(surfaces, q, "q");
    require_unknowns(surfaces, q_start, "q_start");
    require_shape(q_start, "q_start", shape_of(q));
    int num_bodies = surfaces.num_bodies;
    for (const auto& e : elements)
        num_bodies = std::max(num_bodies, e.body_b + 1);
    require_bodies(laws.friction.size(), laws.num_bodies, num_bodies, "laws.friction");
}

} // namespace braidx::bindings
