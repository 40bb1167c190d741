#include "close_pairs.h"

#include "../parallel.h"
#include "../surfaces/finite.h"
#include "box_tree.h"
#include "chords.h"
#include "segment_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

namespace braidx {
namespace {

/// Finds the pairs of one chord with those that come after it.
class Search {
public:
    struct Result {
        std::vector<ElementPair> pairs;
        SearchCost cost;
    };

    Search(const std::vector<Tube>& tubes, Unknowns q, const SearchOptions& options)
        : tubes_(tubes), options_(options), chords_(chords_of(tubes, q)), tree_(boxes()) {}

    std::size_t num_chords() const { return chords_.size(); }

    Result pairs_of(std::size_t i) const {
        Result out;
        const Chord& a = chords_[i];
        out.cost.boxes = tree_.for_each_meeting(box(a), [&](std::int32_t j) {
            const Chord& b = chords_[static_cast<std::size_t>(j)];
            if (static_cast<std::size_t>(j) <= i ||
                are_neighbours(tubes_, a, b, options_.self_exclusion))
                return;
            ++out.cost.chords;
            if (const auto pair = test(a, b))
                out.pairs.push_back(*pair);
        });
        return out;
    }

private:
    /// Of a tube around the chord that is half the margin thicker.
    Box box(const Chord& c) const {
        return Box::around(c.start, c.end)
            .inflated(tubes_[c.tube].radius + 0.5 * options_.margin + c.sagitta);
    }

    std::vector<Box> boxes() const {
        std::vector<Box> out;
        for (const auto& c : chords_)
            out.push_back(box(c));
        return out;
    }

    std::optional<ElementPair> test(const Chord& a, const Chord& b) const {
        const auto closest = segment_distance(a.start, a.end, b.start, b.end);
        const double reach = tubes_[a.tube].radius + tubes_[b.tube].radius + options_.margin;
        if (closest.distance > reach + a.sagitta + b.sagitta)
            return std::nullopt;
        return ElementPair{a.tube,
                           b.tube,
                           a.element,
                           b.element,
                           a.s + closest.t_a * a.length,
                           b.s + closest.t_b * b.length,
                           closest.distance};
    }

    const std::vector<Tube>& tubes_;
    const SearchOptions& options_;
    std::vector<Chord> chords_;
    BoxTree tree_;
};

/// Of several pairs of chords of the same elements, leaves the nearest.
void sort_and_merge(std::vector<ElementPair>& pairs) {
    const auto elements = [](const ElementPair& p) {
        return std::tuple(p.tube_a, p.tube_b, p.element_a, p.element_b);
    };
    std::ranges::sort(pairs, {}, [&](const ElementPair& p) {
        return std::tuple_cat(elements(p), std::tuple(p.distance, p.s_a, p.s_b));
    });
    const auto rest = std::ranges::unique(pairs, {}, elements);
    pairs.erase(rest.begin(), rest.end());
}

} // namespace

std::vector<ElementPair> close_pairs(const std::vector<Tube>& tubes, Unknowns q,
                                     const SearchOptions& options, int num_threads,
                                     SearchCost* cost) {
    require_finite(q);
    const Search search(tubes, q, options);
    const auto found = parallel_map(search.num_chords(), num_threads,
                                    [&](std::size_t i) { return search.pairs_of(i); });
    std::vector<ElementPair> out;
    for (const auto& [pairs, spent] : found) {
        out.insert(out.end(), pairs.begin(), pairs.end());
        if (cost)
            *cost = {cost->boxes + spent.boxes, cost->chords + spent.chords};
    }
    sort_and_merge(out);
    return out;
}

} // namespace braidx
