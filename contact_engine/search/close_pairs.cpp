#include "close_pairs.h"

#include "../parallel.h"
#include "segment_distance.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace braidx {
namespace {

struct Segment {
    std::int32_t tube, element;
    Vec3 start, end;
};

struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
};

struct CellHash {
    std::size_t operator()(const Cell& c) const {
        return static_cast<std::size_t>(c.x * 73856093 ^ c.y * 19349663 ^ c.z * 83492791);
    }
};

std::vector<Segment> segments_of(const std::vector<Tube>& tubes, Unknowns q) {
    std::vector<Segment> out;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(tubes.size()); ++t)
        for (auto e = tubes[t].first_element(); e < tubes[t].end_element(); ++e) {
            const auto at = [&](std::int32_t node) {
                return vector_at(q, tubes[t].unknown_of(node));
            };
            out.push_back({t, e, at(e * tubes[t].degree), at((e + 1) * tubes[t].degree)});
        }
    return out;
}

double reach(const std::vector<Tube>& tubes, const Segment& a, const Segment& b, double margin) {
    return tubes[a.tube].radius + tubes[b.tube].radius + margin;
}

bool neighbours(const std::vector<Tube>& tubes, const Segment& a, const Segment& b,
                double self_exclusion) {
    if (a.tube != b.tube)
        return false;
    const Tube& tube = tubes[a.tube];
    const double apart = (std::abs(a.element - b.element) - 1) * tube.element_length;
    return apart < self_exclusion * tube.radius;
}

std::optional<ElementPair> test_pair(const std::vector<Tube>& tubes, const Segment& first,
                                     const Segment& second, const SearchOptions& options) {
    const bool ordered =
        std::tie(first.tube, first.element) < std::tie(second.tube, second.element);
    const Segment& a = ordered ? first : second;
    const Segment& b = ordered ? second : first;
    if (neighbours(tubes, a, b, options.self_exclusion))
        return std::nullopt;
    const auto closest = segment_distance(a.start, a.end, b.start, b.end);
    if (closest.distance > reach(tubes, a, b, options.margin))
        return std::nullopt;
    return ElementPair{a.tube,
                       b.tube,
                       a.element,
                       b.element,
                       a.element + closest.t_a,
                       b.element + closest.t_b,
                       closest.distance};
}

void sort_pairs(std::vector<ElementPair>& pairs) {
    std::ranges::sort(pairs, {}, [](const ElementPair& p) {
        return std::tuple(p.tube_a, p.tube_b, p.element_a, p.element_b);
    });
}

/// Boxes of elements, inflated by radius and half the margin, as ranges of cells of a grid.
class Grid {
public:
    Grid(const std::vector<Tube>& tubes, const std::vector<Segment>& segments, double margin) {
        double size = margin;
        for (const auto& s : segments)
            size = std::max(size, (s.end - s.start).cwiseAbs().maxCoeff() +
                                      2 * tubes[s.tube].radius + margin);
        size_ = size;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const auto& s = segments[i];
            const Vec3 inflation = Vec3::Constant(tubes[s.tube].radius + 0.5 * margin);
            low_.push_back(cell(s.start.cwiseMin(s.end) - inflation));
            high_.push_back(cell(s.start.cwiseMax(s.end) + inflation));
            for (auto x = low_[i].x; x <= high_[i].x; ++x)
                for (auto y = low_[i].y; y <= high_[i].y; ++y)
                    for (auto z = low_[i].z; z <= high_[i].z; ++z)
                        members_[{x, y, z}].push_back(static_cast<std::int32_t>(i));
        }
        for (const auto& entry : members_)
            cells_.push_back(&entry);
    }

    std::size_t num_cells() const { return cells_.size(); }

    /// Calls visit(i, j) for two segments whose boxes share a cell: in all cells once for every
    /// two.
    template <class Visit> void for_each_candidate(std::size_t cell, const Visit& visit) const {
        const auto& [c, ids] = *cells_[cell];
        for (std::size_t i = 0; i < ids.size(); ++i)
            for (std::size_t j = i + 1; j < ids.size(); ++j)
                if (c == first_shared(ids[i], ids[j]))
                    visit(ids[i], ids[j]);
    }

private:
    Cell cell(const Vec3& x) const {
        const auto index = [this](double v) {
            return static_cast<std::int64_t>(std::floor(v / size_));
        };
        return {index(x[0]), index(x[1]), index(x[2])};
    }

    Cell first_shared(std::int32_t i, std::int32_t j) const {
        return {std::max(low_[i].x, low_[j].x), std::max(low_[i].y, low_[j].y),
                std::max(low_[i].z, low_[j].z)};
    }

    double size_ = 1.0;
    std::vector<Cell> low_, high_;
    using Members = std::unordered_map<Cell, std::vector<std::int32_t>, CellHash>;
    Members members_;
    std::vector<const Members::value_type*> cells_;
};

} // namespace

std::vector<ElementPair> close_pairs(const std::vector<Tube>& tubes, Unknowns q,
                                     const SearchOptions& options, int num_threads) {
    const auto segments = segments_of(tubes, q);
    const Grid grid(tubes, segments, options.margin);
    const auto found = parallel_map(grid.num_cells(), num_threads, [&](std::size_t cell) {
        std::vector<ElementPair> pairs;
        grid.for_each_candidate(cell, [&](std::int32_t i, std::int32_t j) {
            if (const auto pair = test_pair(tubes, segments[i], segments[j], options))
                pairs.push_back(*pair);
        });
        return pairs;
    });
    std::vector<ElementPair> out;
    for (const auto& pairs : found)
        out.insert(out.end(), pairs.begin(), pairs.end());
    sort_pairs(out);
    return out;
}

std::vector<ElementPair> close_pairs_brute_force(const std::vector<Tube>& tubes, Unknowns q,
                                                 const SearchOptions& options) {
    const auto segments = segments_of(tubes, q);
    std::vector<ElementPair> out;
    for (std::size_t i = 0; i < segments.size(); ++i)
        for (std::size_t j = i + 1; j < segments.size(); ++j)
            if (const auto pair = test_pair(tubes, segments[i], segments[j], options))
                out.push_back(*pair);
    sort_pairs(out);
    return out;
}

} // namespace braidx
