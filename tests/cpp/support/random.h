#pragma once

#include "types.h"

#include <random>

namespace braidx::test {

/// Numbers that are the same on every run: `std::uniform_real_distribution` differs between
/// libraries.
class Random {
public:
    explicit Random(unsigned seed = 1) : bits_(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(bits_()) / 4294967295.0;
    }
    int integer(int low, int high) {
        return low + static_cast<int>(bits_() % static_cast<unsigned>(high - low + 1));
    }
    bool chance(double probability) { return uniform(0, 1) < probability; }

    /// Components between -size and size.
    Vec3 vector(double size) {
        const double x = uniform(-size, size), y = uniform(-size, size);
        return {x, y, uniform(-size, size)};
    }
    Vec3 unit() {
        for (;;)
            if (const Vec3 v = vector(1); v.norm() > 0.1 && v.norm() < 1)
                return v.normalized();
    }

private:
    std::mt19937 bits_;
};

} // namespace braidx::test
