// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers of the core as numpy arrays that take over their memory.
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <memory>
#include <vector>

namespace hygroloom::python {

namespace py = pybind11;

template <typename Holder, typename Number>
py::array_t<Number> array_over(std::unique_ptr<Holder> holder, const Number* first, std::vector<py::ssize_t> shape)
{
    const py::capsule owner(holder.release(), [](void* memory) { delete static_cast<Holder*>(memory); });
    return py::array_t<Number>(std::move(shape), first, owner);
}

/// Of the shape, whose product is the number of values.
template <typename Number> py::array_t<Number> array_of(std::vector<Number> values, std::vector<py::ssize_t> shape)
{
    auto holder = std::make_unique<std::vector<Number>>(std::move(values));
    const Number* const first = holder->data();
    return array_over(std::move(holder), first, std::move(shape));
}

template <typename Number> py::array_t<Number> array_of(std::vector<Number> values)
{
    const auto count = static_cast<py::ssize_t>(values.size());
    return array_of(std::move(values), {count});
}

/// A row for each place.
template <typename Number, std::size_t n> py::array_t<Number> array_of(std::vector<std::array<Number, n>> values)
{
    const auto count = static_cast<py::ssize_t>(values.size());
    auto holder = std::make_unique<std::vector<std::array<Number, n>>>(std::move(values));
    const Number* const first = holder->empty() ? nullptr : holder->front().data();
    return array_over(std::move(holder), first, {count, static_cast<py::ssize_t>(n)});
}

} // namespace hygroloom::python
