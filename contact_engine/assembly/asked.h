#pragma once

#include "../pairing/contact_element.h"

namespace braidx {

/// Whether anybody asks for rows of a contact element: not if all of them belong to images.
inline bool is_asked(const std::vector<Tube>& tubes, const ContactElement& element) {
    return !tubes[element.tube_a].is_image ||
           (!against_rigid(element) && !tubes[element.tube_b].is_image);
}

/// Numbers of the contact elements whose rows are asked for.
inline std::vector<std::size_t> asked_elements(const std::vector<Tube>& tubes,
                                               const ContactElements& elements) {
    std::vector<std::size_t> out;
    for (std::size_t e = 0; e < elements.size(); ++e)
        if (is_asked(tubes, elements[e]))
            out.push_back(e);
    return out;
}

/// A range of the vector unknowns of a contact element.
struct Rows {
    int begin, end;
    bool contains(int i) const { return i >= begin && i < end; }
};

/// The rows that are asked for of `count` vector unknowns between two tubes, the first `count_a` of
/// which belong to a. A rigid surface, tube_b < 0, has none.
inline Rows asked_rows(const std::vector<Tube>& tubes, std::int32_t tube_a, std::int32_t tube_b,
                       int count_a, int count) {
    const bool without_b = tube_b >= 0 && tubes[tube_b].is_image;
    return {tubes[tube_a].is_image ? count_a : 0, without_b ? count_a : count};
}

} // namespace braidx
