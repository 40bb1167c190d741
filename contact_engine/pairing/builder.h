#pragma once

#include "../search/proximity_zones.h"
#include "history.h"
#include "pairing.h"

namespace braidx {

/// Makes the contact elements of one zone, wall or crossing at a time, which share one penalty. All
/// that it knows stays as it is, so that threads may use it together.
class Builder {
public:
    Builder(const std::vector<Tube>& tubes, Unknowns q, const ContactElements& previous,
            const PairingOptions& options)
        : tubes_(tubes), q_(q), options_(options), history_(previous, tubes) {}

    ContactElements zone(const ProximityZone& zone, const std::vector<Station>& stations) const;

    /// The tube `a` may touch a rigid surface anywhere: one proximity zone per tube.
    ContactElements wall(std::int32_t a, const Rigid& rigid, std::int32_t number) const;

    ContactElements crossing(const Crossing& crossing, std::int32_t number,
                             const std::vector<OrientedStation>& stations) const;

    const History& history() const { return history_; }

private:
    ContactElement complete(ContactElement element) const;
    Vec3 centre_to_centre(std::int32_t a, std::int32_t b, const Station& s) const;
    void share_stiffness(ContactElements& elements) const;

    const std::vector<Tube>& tubes_;
    Unknowns q_;
    const PairingOptions& options_;
    History history_;
};

} // namespace braidx
