#pragma once

#include "pairing/pairing.h"
#include "support/contact.h"
#include "support/patches.h"

namespace braidx::test {

/// Makes the contact elements of all that there is anew.
inline ContactElements pair_up(const Rods& rods, const ContactElements& previous = {},
                               const PairingOptions& options = {},
                               const std::vector<Rigid>& rigid = {}) {
    return make_contact_elements({rods.tubes, {}, rigid, rods.skins}, rods.q, previous, options);
}

/// Gap of an element now.
inline double gap(const Rods& rods, const ContactElement& e) {
    return local_system(rods.surfaces(), e, rods.q).gap;
}

/// Two sheets, facets of different kinds and sizes, the upper one `depth` deep in the lower one.
inline Rods two_sheets(FacetKind below, FacetKind above, double depth = 0.02) {
    Rods rods;
    add_rectangle(rods, below, {3, 2}, {0, 0, 0}, {3, 0, 0}, {0, 2, 0});
    add_rectangle(rods, above, {2, 2}, {0.4, 0.3, -depth}, {0, 1.5, 0}, {2, 0, 0});
    return rods;
}

/// A tube along x on a sheet.
inline Rods tube_on_sheet(const Kind& kind, FacetKind facets, double depth = 0.02) {
    Rods rods;
    rods.add_straight(kind, 4, 0.5, {0.3, 1, 0.5 - depth}, {2.7, 1.1, 0.5 - depth});
    add_rectangle(rods, facets, {3, 2}, {0, 0, 0}, {3, 0, 0}, {0, 2, 0});
    return rods;
}

/// A sheet below a plane, which it penetrates; the plane has moved along x by 0.05 mm.
inline Rods sheet_for_plane(FacetKind facets) {
    Rods rods;
    add_rectangle(rods, facets, {2, 2}, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    return rods;
}
inline Rigid plane_above(double depth = 0.02) {
    return {Plane{{0, 0, -depth}, -Vec3::UnitZ()}, 1, Vec3::Zero(), Vec3::Zero(), {0.05, 0, 0}};
}

/// Contact in the middle of an increment: unknowns shaken by `unrest`, and slid from a start by
/// up to `slide`.
inline Contact contact_on(Rods rods, double mu, double slide, const std::vector<Rigid>& rigid = {},
                          double unrest = 0.01) {
    Contact out{std::move(rods), {}, {}, laws_with(mu)};
    Random random(17);
    out.rods.shake(random, unrest);
    out.elements = pair_up(out.rods, {}, {}, rigid);
    for (auto& e : out.elements) {
        const Vec3 slip = random.vector(2e-3);
        e.slip = slip - slip.dot(e.normal) * e.normal;
    }
    out.laws.reversible_slip = 0.02;
    out.start = out.rods.q;
    for (auto& value : out.start)
        value += random.uniform(-slide, slide);
    return out;
}

} // namespace braidx::test
