#pragma once

#include "skin.h"
#include "tube.h"

#include <span>

namespace braidx {

/// View of all surfaces that have unknowns. They are numbered together, tubes first, then skins.
class DeformableSurfaces {
public:
    DeformableSurfaces() = default;
    DeformableSurfaces(const std::vector<Tube>& tubes) : tubes_(tubes) {}
    DeformableSurfaces(const std::vector<Tube>& tubes, const std::vector<Skin>& skins)
        : tubes_(tubes), skins_(skins) {}

    std::int32_t num_tubes() const { return static_cast<std::int32_t>(tubes_.size()); }
    bool is_skin(std::int32_t surface) const { return surface >= num_tubes(); }
    const Tube& tube(std::int32_t surface) const {
        return tubes_[static_cast<std::size_t>(surface)];
    }
    const Skin& skin(std::int32_t surface) const {
        return skins_[static_cast<std::size_t>(surface - num_tubes())];
    }

    int body(std::int32_t surface) const {
        return is_skin(surface) ? skin(surface).body : tube(surface).body;
    }
    int group(std::int32_t surface) const {
        return is_skin(surface) ? skin(surface).group : tube(surface).group;
    }
    bool is_image(std::int32_t surface) const {
        return !is_skin(surface) && tube(surface).is_image;
    }

private:
    std::span<const Tube> tubes_;
    std::span<const Skin> skins_;
};

} // namespace braidx
