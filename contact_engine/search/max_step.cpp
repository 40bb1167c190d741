#include "max_step.h"

#include "../parallel.h"
#include "../surfaces/finite.h"
#include "box_tree.h"
#include "chords.h"
#include "segment_distance.h"

#include <algorithm>

namespace braidx {
namespace {

/// Share of the first distance that is left where an advance ends (s of the paper).
constexpr double left = 0.1;

/// A chord, and how far its ends move in the step.
struct Moving {
    Chord chord;
    Vec3 start, end;

    Box swept() const {
        return Box::around(chord.start, chord.end)
            .joined(Box::around(chord.start + start, chord.end + end));
    }
};

std::vector<Moving> moving_chords(const std::vector<Tube>& tubes, Unknowns q, Unknowns dq) {
    std::vector<Moving> out;
    for (const Chord& c : chords_of(tubes, q)) {
        const Tube& tube = tubes[static_cast<std::size_t>(c.tube)];
        out.push_back({c, position(tube, dq, c.s), position(tube, dq, c.s + c.length)});
    }
    return out;
}

/// What a pair moves by as a whole brings it no nearer.
double fastest(const Moving& a, const Moving& b) {
    const Vec3 whole = 0.25 * (a.start + a.end + b.start + b.end);
    return std::max((a.start - whole).norm(), (a.end - whole).norm()) +
           std::max((b.start - whole).norm(), (b.end - whole).norm());
}

double distance_at(const Moving& a, const Moving& b, double share) {
    return segment_distance(a.chord.start + share * a.start, a.chord.end + share * a.end,
                            b.chord.start + share * b.start, b.chord.end + share * b.end)
        .distance;
}

/// Share of the step that a pair may make, at most `most`.
double advance(const Moving& a, const Moving& b, double most) {
    const double motion = fastest(a, b), first = distance_at(a, b, 0);
    if (first >= motion * most)
        return most;
    double share = 0;
    for (double apart = first; share == 0 || apart > left * first;
         apart = distance_at(a, b, share)) {
        const double next = share + (1 - left) * apart / motion;
        if (next >= most)
            return most;
        if (next == share)
            break;
        share = next;
    }
    return share;
}

} // namespace

double max_step(const std::vector<Tube>& tubes, Unknowns q, Unknowns dq,
                const SearchOptions& options,
                const std::function<bool(std::int32_t, std::int32_t)>& may_meet, int num_threads) {
    require_finite(q);
    require_finite(dq);
    const auto chords = moving_chords(tubes, q, dq);
    std::vector<Box> boxes;
    for (const auto& c : chords)
        boxes.push_back(c.swept());
    const BoxTree tree(boxes);
    const auto shares = parallel_map(chords.size(), num_threads, [&](std::size_t i) {
        double share = 1;
        tree.for_each_meeting(boxes[i], [&](std::int32_t other) {
            const auto j = static_cast<std::size_t>(other);
            const Chord &a = chords[i].chord, &b = chords[j].chord;
            if (j <= i || are_neighbours(tubes, a, b, options.self_exclusion) ||
                !may_meet(a.tube, b.tube))
                return;
            share = advance(chords[i], chords[j], share);
        });
        return share;
    });
    return shares.empty() ? 1.0 : std::ranges::min(shares);
}

} // namespace braidx
