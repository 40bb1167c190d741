#pragma once

#include "../surfaces/deformable.h"
#include "arrays.h"

/// Tubes and skins as Python holds them.
namespace braidx::bindings {

/// Owner of all surfaces that have unknowns; tubes alone become one where it is asked for.
struct OwnedSurfaces {
    std::vector<Tube> tubes;
    std::vector<Skin> skins;

    operator DeformableSurfaces() const { return {tubes, skins}; }
};

inline std::vector<Tube> make_tubes(const In<std::int64_t>& first_unknown,
                                    const In<std::int32_t>& num_elements,
                                    const In<std::int32_t>& degree, const In<std::int32_t>& block,
                                    const In<double>& radius, const In<double>& element_length,
                                    const In<std::int32_t>& body, const In<bool>& is_image,
                                    bool smooth, int beyond, const std::vector<int>& group,
                                    const std::vector<int>& closed, bool round_ends) {
    std::vector<Tube> tubes;
    for (std::size_t i = 0; i < radius.size(); ++i)
        tubes.push_back({first_unknown.data()[i], num_elements.data()[i], degree.data()[i],
                         block.data()[i], radius.data()[i], element_length.data()[i],
                         body.data()[i], smooth, is_image.data()[i], beyond,
                         group.empty() ? -1 : group.at(i), !closed.empty() && closed.at(i) != 0,
                         round_ends});
    return tubes;
}

/// A skin from facets, shape (num_facets, nodes per facet), rest positions in all unknowns, and how
/// far the surface is outside the nodes of each facet, shape (num_facets,) or (0,).
inline Skin skin_from_arrays(const In<std::int64_t>& facets, int body, double radius, int group,
                             const In<double>& rest, bool dense, bool smooth,
                             const In<double>& offset) {
    const auto nodes = facets.ndim() == 2 ? facets.shape(1) : 0;
    if (nodes != 3 && nodes != 4 && nodes != 6 && nodes != 9)
        throw nb::value_error("facets: give 3, 4, 6 or 9 nodes per facet, in an array of two axes");
    if (offset.size() != 0 && offset.size() != facets.shape(0))
        throw nb::value_error("offset: give one number per facet, or none");
    return make_skin(static_cast<FacetKind>(nodes), {facets.data(), facets.data() + facets.size()},
                     body, radius, group, view(rest), dense, smooth,
                     {offset.data(), offset.data() + offset.size()});
}

} // namespace braidx::bindings
