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

/// Identifies a block by its row and column, in vector unknowns.
std::uint64_t block_key(std::int64_t row, std::int64_t col) {
    return std::uint64_t(row / 3) << 32 | std::uint64_t(col / 3);
}

/// Calls visit(unknowns, count, fresh) for each contact element; fresh: not those of the one
/// before.
template <class Visit>
void for_each_group(const std::vector<Tube>& tubes, const ContactElements& elements,
                    const Visit& visit) {
    Unknown current{}, last{};
    int last_count = -1;
    for (const auto& element : elements) {
        const int count = vector_unknowns(tubes, element, current);
        const bool fresh = count != last_count ||
                           !std::equal(current.begin(), current.begin() + count, last.begin());
        visit(current, count, fresh);
        last = current;
        last_count = count;
    }
}

void add_keys(std::vector<std::uint64_t>& keys, const std::vector<Tube>& tubes,
              const ContactElements& elements) {
    for_each_group(tubes, elements, [&](const Unknown& unknown, int count, bool fresh) {
        if (!fresh)
            return;
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j)
                keys.push_back(block_key(unknown[i], unknown[j]));
    });
}

void sort_unique(std::vector<std::uint64_t>& keys) {
    std::ranges::sort(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

ContactElements moved(const std::vector<Tube>& tubes, ContactElements elements, double by_a,
                      double by_b) {
    const auto within = [](const Tube& tube, double s) {
        return std::clamp(s, 0.0, double(tube.num_elements));
    };
    for (auto& e : elements) {
        e.s_a = within(tubes[e.tube_a], e.s_a + by_a);
        if (!against_rigid(e))
            e.s_b = within(tubes[e.tube_b], e.s_b + by_b);
    }
    return elements;
}

} // namespace

Pattern make_pattern(const std::vector<Tube>& tubes, const ContactElements& elements,
                     double reach) {
    Pattern out;
    add_keys(out.key, tubes, elements);
    if (reach > 0)
        for (const double by_a : {-reach, reach})
            for (const double by_b : {-reach, reach}) {
                sort_unique(out.key);
                add_keys(out.key, tubes, moved(tubes, elements, by_a, by_b));
            }
    sort_unique(out.key);
    for (const auto key : out.key) {
        out.row.push_back(3 * static_cast<std::int64_t>(key >> 32));
        out.col.push_back(3 * static_cast<std::int64_t>(key & 0xffffffffu));
    }
    place(out, tubes, elements);
    return out;
}

bool place(Pattern& pattern, const std::vector<Tube>& tubes, const ContactElements& elements) {
    pattern.slot.clear();
    pattern.first_slot.clear();
    bool complete = true;
    std::size_t begin = 0;
    for_each_group(tubes, elements, [&](const Unknown& unknown, int count, bool fresh) {
        if (fresh) {
            begin = pattern.slot.size();
            for (int i = 0; i < count && complete; ++i)
                for (int j = 0; j < count; ++j) {
                    const auto key = block_key(unknown[i], unknown[j]);
                    const auto at = std::ranges::lower_bound(pattern.key, key);
                    complete = complete && at != pattern.key.end() && *at == key;
                    pattern.slot.push_back(static_cast<std::int32_t>(at - pattern.key.begin()));
                }
        }
        pattern.first_slot.push_back(static_cast<std::int64_t>(begin));
    });
    return complete;
}

} // namespace braidx
