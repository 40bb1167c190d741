#pragma once

#include "local_system.h"

namespace braidx {

/// Second derivative of the distance of two centre lines whose sections follow each other
/// (facing.h), as 3x3 blocks between vector unknowns: what a frozen pair of sections and a frozen
/// normal leave out. Without it, Newton's method would have to be started anew after each change of
/// sections and normals, and this repetition diverges where a yarn that bends sharply over another
/// slides along it.
class Sliding {
public:
    Sliding(const DeformableSurfaces& surfaces, const ContactElement& element, Unknowns q,
            const LocalSystem& system);

    /// d2(distance) / dX_i dX_j, times the side.
    Mat3 block(int i, int j) const;

private:
    using Vectors = std::array<Vec3, LocalSystem::capacity>;

    void solve(int count, double aa, double ab, double bb);

    LocalSystem::Weights centre_{}, slope_a_{}, slope_b_{};
    Vectors row_a_, row_b_; ///< right-hand sides, then derivatives of the arc lengths of a and b
    Vec3 normal_, tangent_a_, tangent_b_;
    Mat3 turn_; ///< derivative of the normal with the vector between the sections
};

} // namespace braidx
