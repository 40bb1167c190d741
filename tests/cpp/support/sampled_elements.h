#pragma once

#include "rods.h"

#include <vector>

namespace braidx::test {

/// Points on the true centre line of an element, by formulas of their own: Hermite's for curves
/// through the nodes, Neville's for elements of degree 2.
struct SampledElement {
    std::int32_t tube, element;
    std::vector<Vec3> points;
    double step; ///< largest distance of two points that follow each other, mm
};

/// All elements, with count + 1 points each.
std::vector<SampledElement> sampled_elements(const Rods& rods, int count);

/// Smallest distance of points, mm: not below that of the curves, nor above it by more than half of
/// the steps.
double sampled_distance(const SampledElement& a, const SampledElement& b);

} // namespace braidx::test
