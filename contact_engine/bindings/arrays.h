#pragma once

#include "../types.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// NumPy arrays at the border: views of arguments without a copy, new arrays for results.
namespace braidx::bindings {

namespace nb = nanobind;

template <class T> using In = nb::ndarray<const T, nb::numpy, nb::c_contig, nb::device::cpu>;
template <class T> using InOut = nb::ndarray<T, nb::numpy, nb::c_contig, nb::device::cpu>;

template <class T> std::span<const T> view(const In<T>& array) {
    return {array.data(), array.size()};
}
template <class T> std::span<T> view(const InOut<T>& array) {
    return {array.data(), array.size()};
}

/// Throws std::invalid_argument unless `holds`: "NAME is GOT; WANTED is wanted", with what is
/// wanted written one after the other.
template <class Got, class... Wanted>
void require(bool holds, const std::string& name, const Got& got, const Wanted&... wanted) {
    if (holds)
        return;
    std::ostringstream message;
    message << name << " is " << got << "; ";
    (message << ... << wanted) << " is wanted";
    throw std::invalid_argument(message.str());
}

/// The shape of an array as NumPy writes it; sizes below 0 are any number n.
template <class Sizes> std::string written_shape(const Sizes& sizes) {
    std::string out;
    for (const auto size : sizes)
        out += (out.empty() ? "" : ", ") + (size < 0 ? "n" : std::to_string(size));
    return "(" + out + (sizes.size() == 1 ? ",)" : ")");
}
template <class Array> std::vector<std::int64_t> shape_of(const Array& array) {
    std::vector<std::int64_t> out;
    for (std::size_t axis = 0; axis < array.ndim(); ++axis)
        out.push_back(static_cast<std::int64_t>(array.shape(axis)));
    return out;
}

/// Whether an array has this shape; -1: any size.
template <class Array>
void require_shape(const Array& array, const std::string& name,
                   const std::vector<std::int64_t>& wanted) {
    const auto got = shape_of(array);
    bool fits = got.size() == wanted.size();
    for (std::size_t axis = 0; fits && axis < got.size(); ++axis)
        fits = wanted[axis] < 0 || wanted[axis] == got[axis];
    require(fits, name, "an array of shape " + written_shape(got), written_shape(wanted));
}

inline Vec3 vector3(const In<double>& array, const char* name) {
    require_shape(array, name, {3});
    const Vec3 out = Eigen::Map<const Vec3>(array.data());
    require(out.allFinite(), name, out.transpose(), "a finite vector");
    return out;
}

inline Vec3 direction(const In<double>& array, const char* name) {
    const Vec3 out = vector3(array, name);
    require(out.norm() > 0, name, out.transpose(), "a vector with a direction");
    return out.normalized();
}

/// A new NumPy array of the given shape, filled by fill(data).
template <class T, class Fill>
auto make_array(std::initializer_list<std::size_t> shape, const Fill& fill) {
    std::size_t size = 1;
    for (const auto n : shape)
        size *= n;
    auto* data = new T[size]();
    nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<T*>(p); });
    fill(data);
    return nb::ndarray<nb::numpy, T>(data, shape.size(), shape.begin(), owner);
}

} // namespace braidx::bindings
