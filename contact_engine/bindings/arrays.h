#pragma once

#include "../types.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <span>

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

inline Vec3 vector3(const In<double>& array) {
    return Eigen::Map<const Vec3>(array.data());
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
