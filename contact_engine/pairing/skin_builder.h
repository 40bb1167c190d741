#pragma once

#include "../search/current_skin.h"
#include "builder.h"

namespace braidx {

/// Makes the contact elements of pairs in which skins take part, one zone per pair of surfaces.
/// Threads may use it together.
///
/// A contact point of a skin meets the nearest place of the other surface that it faces; normals
/// and places are those of this update. Of two skins each has its points tested against the other,
/// and they share the area, the denser ones with more of it: nothing changes when a and b are
/// swapped. A tube meets a skin at
/// stations along the tube: where they touch is narrower than facets.
class SkinBuilder {
public:
    SkinBuilder(const Surfaces& surfaces, Unknowns q, const Builder& builder,
                const PairingOptions& options);

    /// Two skins, by their numbers among surfaces.
    ContactElements skins(std::int32_t a, std::int32_t b) const;
    ContactElements tube(std::int32_t a, std::int32_t skin_b) const;
    ContactElements wall(std::int32_t skin_a, const Rigid& rigid, std::int32_t number) const;

private:
    const CurrentSkin& current(std::int32_t surface) const {
        return current_[static_cast<std::size_t>(surface - surfaces_.num_tubes())];
    }
    double rest_overlap(std::int32_t surface, std::int64_t station) const;
    void add_points(std::int32_t a, std::int32_t b, ContactElements& out) const;

    DeformableSurfaces surfaces_;
    Unknowns q_;
    const Builder& builder_;
    const PairingOptions& options_;
    std::vector<CurrentSkin> current_;
};

/// Contact elements of all pairs of a skin with a skin, a tube or a rigid surface that are this
/// process's own.
std::vector<ContactElements> skin_parts(const Surfaces& surfaces, Unknowns q,
                                        const Builder& builder, const PairingOptions& options);

} // namespace braidx
