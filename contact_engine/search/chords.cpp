#include "chords.h"

#include <cmath>

namespace braidx {
namespace {

/// Sagitta of a chord, in radii of the tube: so little that few pairs are found in vain.
constexpr double flat = 0.1;

/// Length of a chord, in radii of the tube: the box of a longer one, where it runs askew to the
/// axes, would be mostly empty.
constexpr double slender = 8;

/// Chords of one element at most: a curve that asks for more has lost its shape, and is enclosed
/// loosely.
constexpr double most = 64;

/// How far an element is from the chord of its ends at most: an eighth of the largest second
/// derivative with s, the error of linear interpolation. That derivative varies linearly.
double sagitta_of(const Tube& tube, Unknowns q, std::int32_t element) {
    const Vec3 first = curve_bend(tube, q, element), middle = curve_bend(tube, q, element + 0.5);
    const double largest = std::max(first.norm(), (2 * middle - first).norm());
    return largest * tube.element_length * tube.element_length / 8;
}

void add_chords(std::vector<Chord>& out, const Tube& tube, std::int32_t number, Unknowns q,
                std::int32_t element) {
    Vec3 start = position(tube, q, element);
    const double sagitta = sagitta_of(tube, q, element),
                 length = (position(tube, q, element + 1) - start).norm();
    const double count = std::ceil(std::clamp(
        std::max(std::sqrt(sagitta / (flat * tube.radius)), length / (slender * tube.radius)), 1.0,
        most));
    for (int i = 0; i < count; ++i) {
        const Vec3 end = position(tube, q, element + (i + 1) / count);
        out.push_back({number, element, element + i / count, 1 / count, start, end,
                       sagitta / (count * count)});
        start = end;
    }
}

} // namespace

bool are_neighbours(const std::vector<Tube>& tubes, const Chord& a, const Chord& b,
                    double self_exclusion) {
    const Tube& tube = tubes[static_cast<std::size_t>(a.tube)];
    return a.tube == b.tube && (tube.apart(a.element, b.element) - 1) * tube.element_length <
                                   self_exclusion * tube.radius;
}

std::vector<Chord> chords_of(const std::vector<Tube>& tubes, Unknowns q) {
    std::vector<Chord> out;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(tubes.size()); ++t)
        for (auto e = tubes[t].first_element(); e < tubes[t].end_element(); ++e)
            add_chords(out, tubes[t], t, q, e);
    return out;
}

} // namespace braidx
