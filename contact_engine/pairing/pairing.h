#pragma once

#include "../surfaces/rigid.h"
#include "contact_element.h"
#include "crossings.h"

#include <map>

namespace braidx {

/// How deep particles are in the skins of other solids in the configuration at rest, mm, by surface
/// and station: sections of a few edges stick out of the round ones they stand for. They count as
/// touching there, as if a mesh had been made to fit.
using RestOverlaps = std::map<std::pair<std::int32_t, std::int64_t>, double>;

/// How contact elements are made.
struct PairingOptions {
    SearchOptions search;
    CrossingOptions crossing;
    double spacing = 1.0; ///< of line stations, mm
    double point_tolerance =
        0.005; ///< approach that line stations may miss before a point station is added, mm
    bool within_increment = false; ///< not the first contact elements of an increment: point
                                   ///< stations are those of before, with their weights, and pairs
                                   ///< with a cable have turned as the first guess did
    double stiffness = 1000;       ///< first penalty per length of a new zone, N/mm per mm
    RestOverlaps rest_overlaps;
    double area_stiffness = 1000; ///< the same per area, for contact points of skins, N/mm per mm^2
    bool keep_side =
        true;     ///< tubes never pass through each other; off while a shape is being found
    int part = 0; ///< this process makes the pairs of tubes of one part
    int num_parts = 1;
    int num_threads = 1; ///< the contact elements are the same for any number
    int num_bodies = 1;
    std::vector<int> may_touch; ///< of body a and body b, num_bodies x num_bodies; empty: all may
};

/// Everything that may touch.
struct Surfaces {
    std::vector<Tube> tubes;
    std::vector<Crossing> crossings; ///< of tubes, with prescribed stacking order
    std::vector<Rigid> rigid;
    std::vector<Skin> skins = {};

    DeformableSurfaces deformable() const { return {tubes, skins}; }
};

/// Whether pairs of a tube or skin with another, or with a rigid surface of this number, are this
/// process's own. Of two skins the one with the lower number comes first, whichever is a.
bool is_own(const PairingOptions& options, std::int64_t surface, std::int64_t other);

/// Contact elements for the current configuration. Those of `previous` hand on slip, work, penalty
/// and the side; how pairs have turned is seen from the unknowns when the increment started,
/// `q_start`, by default the current ones.
ContactElements make_contact_elements(const Surfaces& surfaces, Unknowns q,
                                      const ContactElements& previous,
                                      const PairingOptions& options, Unknowns q_start = {});

} // namespace braidx
