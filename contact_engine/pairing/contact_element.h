#pragma once

#include "../surfaces/deformable.h"

#include <vector>

namespace braidx {

/// A pair of particles predicted to meet (paper 1, 2.3.1), with its frozen normal and its memory.
struct ContactElement {
    std::int32_t surface_a; ///< a tube or a skin, see DeformableSurfaces
    std::int32_t surface_b; ///< or -1 - number of a rigid surface
    int body_b = 0;         ///< body of b, for friction per pair of bodies
    double s_a, s_b;        ///< material coordinates of both sections, in elements (tubes)
    std::int64_t station; ///< identity along the pair of tubes, see stations.h; on skins: number of
                          ///< the contact point of a
    Vec3 normal;          ///< unit, from a to b; of an element that follows: when it was made
    int follows = 0;  ///< 0: sections and normal are frozen; +1, -1: they follow the tubes, which
                      ///< run the same way (+1) or opposite ways (-1), see assembly/facing.h
    double weight;    ///< length of the contact line it stands for, mm; where a is a skin: area,
                      ///< mm^2, of which points of two skins share
    double stiffness; ///< penalty per length, N/mm per mm, or per area; equal within a proximity
                      ///< zone
    double multiplier = 0; ///< normal force at gap 0, N/mm (MPa where penalties are per area); see
                           ///< update_multipliers
    std::int32_t facet_a = -1, facet_b = -1; ///< facets of skins
    double xi_a[2] = {0, 0}; ///< transverse coordinates of the surface particles (beams), mm;
    double xi_b[2] = {0, 0}; ///< reference coordinates on facets
    double round_a = 0, round_b = 0; ///< at ends of tubes, which are half spheres: square of the
                                     ///< cosine between normal and axis of the section
    Vec3 slip = Vec3::Zero(); ///< remembered reversible slip of b against a, mm, in the directions
                              ///< that were when the increment started
    Mat3 turn = Mat3::Identity();   ///< how the pair has turned as a whole since then, see turn.h;
                                    ///< none between increments
    double work = 0;                ///< work dissipated by friction so far, N mm = mJ
    Vec3 wall = Vec3::Zero();       ///< particle of a rigid surface b now, mm
    Vec3 wall_start = Vec3::Zero(); ///< and when the increment started
    std::int64_t frame = -1;        ///< of a rigid surface b, see Rigid; -1: none
    Vec3 in_frame = Vec3::Zero();   ///< coordinates of its particle there, mm
    double allowance = 0; ///< added to the gap: sections of a crossing that do not face each other,
                          ///< overlaps at rest, smooth surfaces above facets, mm
    std::int32_t zone = -1; ///< number of the proximity zone
    std::int32_t crossing =
        -1; ///< crossing whose stacking order gives the normal, -1: geometry does
};

inline bool against_rigid(const ContactElement& element) {
    return element.surface_b < 0;
}

/// Whether an element stands for an area, and its penalty is per area: its a is a point of a skin.
inline bool is_per_area(const ContactElement& element) {
    return element.facet_a >= 0;
}

using ContactElements = std::vector<ContactElement>;

} // namespace braidx
