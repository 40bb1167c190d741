#pragma once

#include "../surfaces/rigid.h"
#include "arrays.h"

/// Rigid surfaces from Python.
namespace braidx::bindings {

inline double length(double value, const char* name) {
    require(value > 0 && std::isfinite(value), name, value, "a length above 0");
    return value;
}

inline auto distances(const Rigid& rigid, const In<double>& points) {
    require_shape(points, "points", {-1, 3});
    return make_array<double>({points.shape(0)}, [&](double* out) {
        for (std::size_t i = 0; i < points.shape(0); ++i) {
            const Vec3 x = Eigen::Map<const Vec3>(points.data() + 3 * i);
            const auto nearest = rigid.nearest(x);
            out[i] = (x - nearest.position).dot(nearest.normal);
        }
    });
}

/// Rigid surfaces and what makes them; all lengths in mm.
inline void bind_rigid(nb::module_& m) {
    using namespace nb::literals;
    nb::class_<Rigid>(m, "Rigid")
        .def("distances", &distances, "points"_a,
             "Signed distances of points, shape (n, 3), negative within the solid, mm.");
    m.def(
        "make_plane",
        [](const In<double>& point, const In<double>& normal, int body) {
            return Rigid{Plane{vector3(point, "point"), direction(normal, "normal")}, body};
        },
        "point"_a, "normal"_a, "body"_a);
    m.def(
        "make_cylinder",
        [](const In<double>& point, const In<double>& axis, double radius, bool hollow, int body) {
            return Rigid{Cylinder{vector3(point, "point"), direction(axis, "axis"),
                                  length(radius, "radius"), hollow},
                         body};
        },
        "point"_a, "axis"_a, "radius"_a, "hollow"_a, "body"_a);
    m.def(
        "make_sheave",
        [](const In<double>& centre, const In<double>& axis, double radius, double groove_radius,
           int body) {
            return Rigid{Sheave{vector3(centre, "centre"), direction(axis, "axis"),
                                length(radius, "radius"), length(groove_radius, "groove_radius")},
                         body};
        },
        "centre"_a, "axis"_a, "radius"_a, "groove_radius"_a, "body"_a);
    m.def(
        "moved",
        [](const Rigid& rigid, const In<double>& pivot, const In<double>& rotation,
           const In<double>& translation) {
            return Rigid{rigid.shape, rigid.body, vector3(pivot, "pivot"),
                         vector3(rotation, "rotation"), vector3(translation, "translation")};
        },
        "rigid"_a, "pivot"_a, "rotation"_a, "translation"_a);
    m.def(
        "turned_by",
        [](Rigid rigid, std::int64_t frame) {
            require(!std::holds_alternative<Plane>(rigid.shape), "rigid", "a plane",
                    "a cylinder or a sheave, which a frame may turn about its axis");
            require(frame >= 0 && frame % 3 == 0, "frame", frame,
                    "the number of a first unknown, a multiple of three");
            rigid.frame = frame;
            return rigid;
        },
        "rigid"_a, "frame"_a);
}

} // namespace braidx::bindings
