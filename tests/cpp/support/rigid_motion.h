#pragma once

#include "skin_contacts.h"

#include <Eigen/Geometry>

namespace braidx::test {

inline Mat3 random_rotation(Random& random) {
    return Eigen::AngleAxisd(random.uniform(-3, 3), random.unit()).toRotationMatrix();
}

/// x -> rotation x + translation, of everything.
struct RigidMotion {
    Mat3 rotation;
    Vec3 translation;

    RigidMotion(const Mat3& rotation, const Vec3& translation)
        : rotation(rotation), translation(translation) {}
    explicit RigidMotion(Random& random)
        : rotation(random_rotation(random)), translation(random.vector(5)) {}

    Vec3 operator()(const Vec3& x) const { return rotation * x + translation; }

    /// Unknowns of rods and skins; directors turn and stay where they are.
    Rods applied(const Rods& rods) const {
        Rods out = rods;
        for (std::size_t i = 0; i < out.q.size(); i += 3) {
            Eigen::Map<Vec3> x(out.q.data() + i);
            x = rotation * x;
            if (!is_director(rods, static_cast<std::int64_t>(i)))
                x += translation;
        }
        return out;
    }

    /// Forces on all unknowns.
    Vector turned(const Vector& forces) const {
        Vector out = forces;
        for (Eigen::Index i = 0; i < out.size(); i += 3)
            out.segment<3>(i) = rotation * out.segment<3>(i);
        return out;
    }

    static bool is_director(const Rods& rods, std::int64_t unknown) {
        for (const auto& tube : rods.tubes) {
            const auto within = unknown - tube.first_unknown;
            if (within >= 0 && within < std::int64_t{tube.num_nodes()} * tube.block)
                return within % tube.block > 0;
        }
        return false;
    }
};

/// Contacts of every kind: between tubes, on skins, against rigid surfaces.
inline std::vector<Contact> every_contact(double mu, double slide) {
    std::vector<Contact> out;
    unsigned seed = 30;
    for (const auto& kind : all_kinds) {
        out.push_back(random_contact(kind, smooth_beam, mu, slide, ++seed));
        out.push_back(random_contact_with_wall(kind, mu, slide, ++seed));
        for (const auto facets : {FacetKind::square9, FacetKind::triangle3})
            out.push_back(contact_on(tube_on_sheet(kind, facets), mu, slide));
    }
    for (const auto facets : {FacetKind::square4, FacetKind::triangle6}) {
        out.push_back(contact_on(two_sheets(facets, FacetKind::square9), mu, slide));
        out.push_back(contact_on(sheet_for_plane(facets), mu, slide, {plane_above()}));
    }
    return out;
}

} // namespace braidx::test
