#pragma once

#include "contact_element.h"

#include <unordered_map>

namespace braidx {

/// Finds the predecessor of a contact element: the same station of the same two tubes.
class History {
public:
    History(const ContactElements& previous, const std::vector<Tube>& tubes);

    /// Nearest previous element with the same tubes and station within `reach` (mm of arc length),
    /// or none.
    const ContactElement* predecessor(const ContactElement& element, double reach) const;

    /// Calls visit(element) for every previous element between two tubes.
    template <class Visit>
    void for_each(std::int32_t tube_a, std::int32_t tube_b, const Visit& visit) const {
        const auto [first, last] = by_tubes_.equal_range(key(tube_a, tube_b));
        for (auto at = first; at != last; ++at)
            visit(previous_[at->second]);
    }

private:
    static std::int64_t key(std::int32_t tube_a, std::int32_t tube_b) {
        return std::int64_t{tube_a} * (std::int64_t{1} << 32) + tube_b;
    }

    const ContactElements& previous_;
    const std::vector<Tube>& tubes_;
    std::unordered_multimap<std::int64_t, std::size_t> by_tubes_;
};

/// Hands on memory: slip (turned with the normal), work and penalty; and, if asked, the side: a
/// normal found from geometry never flips.
void inherit(ContactElement& element, const ContactElement& predecessor, bool keep_side);

} // namespace braidx
