#pragma once

#include "pairing.h"

namespace braidx {

/// Whether two bodies may touch.
inline bool may_touch(const PairingOptions& options, int body_a, int body_b) {
    return options.may_touch.empty() ||
           options.may_touch[static_cast<std::size_t>(body_a * options.num_bodies + body_b)] != 0;
}

/// Whether two tubes or skins may touch: not those of one group, but a tube may touch itself.
inline bool may_touch(const PairingOptions& options, const DeformableSurfaces& surfaces,
                      std::int32_t a, std::int32_t b) {
    const int group = surfaces.group(a);
    return (a == b || group < 0 || group != surfaces.group(b)) &&
           may_touch(options, surfaces.body(a), surfaces.body(b));
}

} // namespace braidx
