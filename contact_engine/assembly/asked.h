#pragma once

#include "../pairing/contact_element.h"

namespace braidx {

/// Whether anybody asks for rows of a contact element: not if all of them belong to images.
inline bool is_asked(const DeformableSurfaces& surfaces, const ContactElement& element) {
    return !surfaces.is_image(element.surface_a) ||
           (!against_rigid(element) && !surfaces.is_image(element.surface_b));
}

/// Numbers of the contact elements whose rows are asked for.
inline std::vector<std::size_t> asked_elements(const DeformableSurfaces& surfaces,
                                               const ContactElements& elements) {
    std::vector<std::size_t> out;
    for (std::size_t e = 0; e < elements.size(); ++e)
        if (is_asked(surfaces, elements[e]))
            out.push_back(e);
    return out;
}

/// A range of the vector unknowns of a contact element.
struct Rows {
    int begin, end;
    bool contains(int i) const { return i >= begin && i < end; }
};

/// The rows that are asked for of `count` vector unknowns between two surfaces, the first `count_a`
/// of which belong to a. A rigid surface, surface_b < 0, has none.
inline Rows asked_rows(const DeformableSurfaces& surfaces, std::int32_t surface_a,
                       std::int32_t surface_b, int count_a, int count) {
    const bool without_b = surface_b >= 0 && surfaces.is_image(surface_b);
    return {surfaces.is_image(surface_a) ? count_a : 0, without_b ? count_a : count};
}

} // namespace braidx
