#include "pattern.h"

#include "../parallel.h"
#include "../surfaces/rigid.h"
#include "asked.h"
#include "local_system.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <compare>

namespace braidx {
namespace {

using Keys = std::vector<std::uint64_t>;

/// The finite elements, or facets, that a contact element stands on: its vector unknowns depend on
/// nothing else.
struct Group {
    std::int32_t surface_a, element_a;
    std::int32_t surface_b = -1, element_b = 0; ///< -1: rigid surfaces are all alike, but for
    std::int64_t frame = -1;                    ///< what turns them
    auto operator<=>(const Group&) const = default;
};

/// Group of a contact element whose sections are moved by some elements, within the tubes.
Group group_of(const DeformableSurfaces& surfaces, const ContactElement& e, double by_a = 0,
               double by_b = 0) {
    const auto element = [&](std::int32_t surface, std::int32_t facet, double s) {
        return facet >= 0 ? facet : surfaces.tube(surface).element_of(s);
    };
    Group out{e.surface_a, element(e.surface_a, e.facet_a, e.s_a + by_a)};
    if (!against_rigid(e)) {
        out.surface_b = e.surface_b;
        out.element_b = element(e.surface_b, e.facet_b, e.s_b + by_b);
    }
    out.frame = e.frame;
    return out;
}

/// Groups of a contact element whose place on a skin b moves onto facets next to its own. Points of
/// a stay where they are.
std::vector<Group> groups_on_facets(const DeformableSurfaces& surfaces, const ContactElement& e,
                                    double reach) {
    std::vector<Group> out;
    if (reach <= 0 || e.facet_b < 0)
        return out;
    for (const auto facet :
         facets_within(surfaces.skin(e.surface_b), {e.facet_b, e.xi_b[0], e.xi_b[1]}, reach)) {
        out.push_back(group_of(surfaces, e));
        out.back().element_b = facet;
    }
    return out;
}

/// Vector unknowns of a group, in the order of local_system, and the rows that are asked for.
struct GroupUnknowns {
    std::array<std::int64_t, LocalSystem::capacity> number;
    int count = 0;
    Rows rows;

    GroupUnknowns(const DeformableSurfaces& surfaces, const Group& group) {
        add_side(surfaces, group.surface_a, group.element_a);
        const int count_a = count;
        if (group.surface_b >= 0)
            add_side(surfaces, group.surface_b, group.element_b);
        for (int i = 0; group.frame >= 0 && i < Rigid::frame_vectors; ++i)
            number[count++] = group.frame + 3 * i;
        rows = asked_rows(surfaces, group.surface_a, group.surface_b, count_a, count);
    }

    std::size_t num_blocks() const {
        return static_cast<std::size_t>(rows.end - rows.begin) * static_cast<std::size_t>(count);
    }

    /// Calls visit(key) for each block, row by row.
    template <class Visit> void for_each_block(const Visit& visit) const {
        for (int i = rows.begin; i < rows.end; ++i)
            for (int j = 0; j < count; ++j)
                visit(std::uint64_t(number[i] / 3) << 32 | std::uint64_t(number[j] / 3));
    }

private:
    void add_side(const DeformableSurfaces& surfaces, std::int32_t surface, std::int32_t element) {
        if (surfaces.is_skin(surface))
            add_facet(surfaces.skin(surface), element);
        else
            add_element(surfaces.tube(surface), element);
    }

    void add_facet(const Skin& skin, std::int32_t facet) {
        for (int node = 0; node < skin.nodes_per_facet(); ++node)
            number[count++] = skin.unknown_of(facet, node);
    }

    void add_element(const Tube& tube, std::int32_t element) {
        const Support centre = contact_support(tube, element);
        for (int i = 0; i < centre.count; ++i)
            number[count++] = tube.unknown_of(centre.node[i]);
        if (!tube.has_directors())
            return;
        const Support section = element_support(tube, element);
        for (int which = 1; which <= 2; ++which)
            for (int i = 0; i < section.count; ++i)
                number[count++] = tube.unknown_of(section.node[i]) + 3 * which;
    }
};

template <class T> void sort_unique(std::vector<T>& items) {
    std::ranges::sort(items);
    items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// All groups that contact elements belong to, and those within reach of their sections.
std::vector<Group> groups_within(const DeformableSurfaces& surfaces,
                                 const ContactElements& elements, double reach) {
    std::vector<Group> out;
    const auto add = [&](const Group& group) {
        if (out.empty() || out.back() != group)
            out.push_back(group);
    };
    for (const auto e : asked_elements(surfaces, elements))
        add(group_of(surfaces, elements[e]));
    if (reach > 0)
        for (const double by_a : {-reach, reach})
            for (const double by_b : {-reach, reach})
                for (const auto e : asked_elements(surfaces, elements))
                    add(group_of(surfaces, elements[e], by_a, by_b));
    for (const auto e : asked_elements(surfaces, elements))
        for (const auto& group : groups_on_facets(surfaces, elements[e], reach))
            add(group);
    sort_unique(out);
    return out;
}

/// Keys of all blocks of groups, ascending.
Keys keys_of(const DeformableSurfaces& surfaces, const std::vector<Group>& groups,
             int num_threads) {
    std::vector<Keys> parts(static_cast<std::size_t>(std::max(num_threads, 1)));
    parallel_chunks(groups.size(), num_threads, [&](std::size_t chunk, auto begin, auto end) {
        for (auto g = begin; g < end; ++g)
            GroupUnknowns(surfaces, groups[g]).for_each_block([&](std::uint64_t key) {
                parts[chunk].push_back(key);
            });
        sort_unique(parts[chunk]);
    });
    Keys out = std::move(parts[0]);
    for (std::size_t chunk = 1; chunk < parts.size(); ++chunk) {
        Keys both;
        std::ranges::set_union(out, parts[chunk], std::back_inserter(both));
        out = std::move(both);
    }
    return out;
}

} // namespace

Pattern make_pattern(const DeformableSurfaces& surfaces, const ContactElements& elements,
                     double reach, int num_threads) {
    Pattern out;
    out.key = keys_of(surfaces, groups_within(surfaces, elements, reach), num_threads);
    for (const auto key : out.key) {
        out.row.push_back(3 * static_cast<std::int64_t>(key >> 32));
        out.col.push_back(3 * static_cast<std::int64_t>(key & 0xffffffffu));
    }
    place(out, surfaces, elements, num_threads);
    return out;
}

bool place(Pattern& pattern, const DeformableSurfaces& surfaces, const ContactElements& elements,
           int num_threads) {
    std::vector<Group> groups;
    std::vector<std::int64_t> begin;
    std::int64_t size = 0;
    pattern.first_slot.assign(elements.size(), -1);
    for (const auto e : asked_elements(surfaces, elements)) {
        const auto group = group_of(surfaces, elements[e]);
        if (groups.empty() || group != groups.back()) {
            groups.push_back(group);
            begin.push_back(size);
            size += GroupUnknowns(surfaces, group).num_blocks();
        }
        pattern.first_slot[e] = begin.back();
    }
    pattern.slot.resize(size);
    std::atomic<bool> complete = true;
    parallel_chunks(groups.size(), num_threads, [&](std::size_t, auto first, auto last) {
        for (auto g = first; g < last && complete; ++g) {
            auto* slot = pattern.slot.data() + begin[g];
            auto at = pattern.key.begin();
            GroupUnknowns(surfaces, groups[g]).for_each_block([&](std::uint64_t key) {
                // Nodes of a tube follow each other, and so do their blocks: often it is the next.
                if (at == pattern.key.end() || ++at == pattern.key.end() || *at != key)
                    at = std::ranges::lower_bound(pattern.key, key);
                if (at == pattern.key.end() || *at != key)
                    complete = false;
                *slot++ = static_cast<std::int32_t>(at - pattern.key.begin());
            });
        }
    });
    return complete;
}

} // namespace braidx
