#pragma once

#include "../search/proximity_zones.h"
#include "history.h"
#include "pairing.h"

namespace braidx {

/// Makes the contact elements of one zone, wall or crossing at a time, which share one penalty. All
/// that it knows stays as it is, so that threads may use it together.
class Builder {
public:
    /// Unknowns now, and when the increment started.
    Builder(const DeformableSurfaces& surfaces, Unknowns q, Unknowns q_start,
            const ContactElements& previous, const PairingOptions& options)
        : surfaces_(surfaces), q_(q), q_start_(q_start), options_(options),
          history_(previous, surfaces) {}

    ContactElements zone(const ProximityZone& zone, const std::vector<Station>& stations) const;

    /// The tube `a` may touch a rigid surface anywhere: one proximity zone per tube.
    ContactElements wall(std::int32_t a, const Rigid& rigid, std::int32_t number) const;

    ContactElements crossing(const Crossing& crossing, std::int32_t number,
                             const std::vector<OrientedStation>& stations) const;

    /// Elements of one zone with their memory, the particles of beams, how they have turned, and
    /// one penalty. `rigid`: how the rigid surface b, if it is one, has turned.
    ContactElements finished(ContactElements elements, const Mat3& rigid = Mat3::Identity()) const;

    /// Elements on a rigid surface, with their particles there.
    ContactElements finished(ContactElements elements, const Rigid& rigid) const;

    const History& history() const { return history_; }

private:
    ContactElement complete(ContactElement element, const Mat3& rigid) const;
    bool has_cable(const ContactElement& element) const;
    void round_ends(ContactElement& element) const;
    void place_particles(ContactElement& element) const;
    Vec3 centre_to_centre(std::int32_t a, std::int32_t b, const Station& s) const;
    void share_stiffness(ContactElements& elements) const;

    DeformableSurfaces surfaces_;
    Unknowns q_, q_start_;
    const PairingOptions& options_;
    History history_;
};

} // namespace braidx
