#pragma once

#include "contact_element.h"

#include <algorithm>
#include <ranges>
#include <tuple>
#include <utility>

namespace braidx {

/// Finds the predecessor of a contact element: the same station of the same two surfaces.
class History {
public:
    History(const ContactElements& previous, const DeformableSurfaces& surfaces);

    /// Nearest previous element with the same surfaces and station within `reach` (mm of arc length
    /// of tubes), or none; on periodic tubes a period away is as near. Wherever on a skin b a
    /// particle of a is now, it is the same particle.
    const ContactElement* predecessor(const ContactElement& element, double reach) const;

    /// Whether two surfaces had contact elements.
    bool knows(std::int32_t surface_a, std::int32_t surface_b) const;

    /// Calls visit(element) for every previous element of a station of two surfaces, the last one
    /// first.
    template <class Visit>
    void for_each(std::int32_t surface_a, std::int32_t surface_b, std::int64_t station,
                  const Visit& visit) const {
        const Place place{surface_a, surface_b, station};
        const auto found = std::ranges::equal_range(places_, place, {}, &Entry::first);
        for (const auto& entry : std::views::reverse(found))
            visit(previous_[entry.second]);
    }

private:
    double along_tubes(const ContactElement& old, const ContactElement& element) const;

    using Place = std::tuple<std::int32_t, std::int32_t, std::int64_t>;
    using Entry = std::pair<Place, std::size_t>;

    const ContactElements& previous_;
    DeformableSurfaces surfaces_;
    std::vector<Entry> places_; ///< ascending
};

/// Hands on memory: slip (in the directions of the start of the increment), work, multiplier and
/// penalty; and, if asked, the side: a normal found from the geometry of tubes never flips, but for
/// what the pair has turned.
void inherit(ContactElement& element, const ContactElement& predecessor, bool keep_side);

} // namespace braidx
