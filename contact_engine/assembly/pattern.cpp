#include "pattern.h"

#include "local_system.h"

#include <algorithm>
#include <array>

namespace braidx {
namespace {

using Unknown = std::array<std::int64_t, LocalSystem::capacity>;

/// Vector unknowns of a contact element, in the order of local_system.
int vector_unknowns(const std::vector<Tube>& tubes, const ContactElement& element,
                    Unknown& unknown) {
    int count = 0;
    const auto add_side = [&](const Tube& tube, double s) {
        const Support centre = contact_support(tube, s);
        for (int i = 0; i < centre.count; ++i)
            unknown[count++] = tube.unknown_of(centre.node[i]);
        if (!tube.has_directors())
            return;
        const Support section = element_support(tube, s);
        for (int which = 1; which <= 2; ++which)
            for (int i = 0; i < section.count; ++i)
                unknown[count++] = tube.unknown_of(section.node[i]) + 3 * which;
    };
    add_side(tubes[element.tube_a], element.s_a);
    if (!against_rigid(element))
        add_side(tubes[element.tube_b], element.s_b);
    return count;
}

} // namespace

Pattern make_pattern(const std::vector<Tube>& tubes, const ContactElements& elements) {
    Pattern out;
    std::vector<std::uint64_t> keys; // one per slot: (row, col) in vector unknowns
    Unknown current{}, last{};
    int last_count = -1;
    for (const auto& element : elements) {
        const int count = vector_unknowns(tubes, element, current);
        if (count != last_count ||
            !std::equal(current.begin(), current.begin() + count, last.begin())) {
            last = current;
            last_count = count;
            for (int i = 0; i < count; ++i)
                for (int j = 0; j < count; ++j)
                    keys.push_back(std::uint64_t(current[i] / 3) << 32 |
                                   std::uint64_t(current[j] / 3));
        }
        out.first_slot.push_back(static_cast<std::int64_t>(keys.size()) - count * count);
    }
    auto unique = keys;
    std::ranges::sort(unique);
    unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
    out.slot.reserve(keys.size());
    for (const auto key : keys)
        out.slot.push_back(
            static_cast<std::int32_t>(std::ranges::lower_bound(unique, key) - unique.begin()));
    for (const auto key : unique) {
        out.row.push_back(3 * static_cast<std::int64_t>(key >> 32));
        out.col.push_back(3 * static_cast<std::int64_t>(key & 0xffffffffu));
    }
    return out;
}

} // namespace braidx
