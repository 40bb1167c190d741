#pragma once

#include "contact_element.h"

#include <unordered_map>

namespace braidx {

/// Finds the predecessor of a contact element: the same station of the same two tubes.
class History {
  public:
    History(const ContactElements& previous, const std::vector<Tube>& tubes);

    /// Nearest previous element with the same tubes and station within `reach` (mm of arc length), or none.
    const ContactElement* predecessor(const ContactElement& element, double reach) const;

  private:
    const ContactElements& previous_;
    const std::vector<Tube>& tubes_;
    std::unordered_multimap<std::int64_t, std::size_t> by_tubes_;
};

/// Hands on memory: slip (turned with the normal), work and penalty; and, if asked, the side: a normal found
/// from geometry never flips.
void inherit(ContactElement& element, const ContactElement& predecessor, bool keep_side);

} // namespace braidx
