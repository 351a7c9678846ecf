// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reports in the units of who reads them. Files for programs never change theirs.
#pragma once

#include <functional>
#include <string>

namespace hygroloom {

struct ReaderUnit {
    std::string unit;
    double per_one = 1; ///< of the number in its own unit
    double at_zero = 0;
    bool inverse = false; ///< a yarn count: per_one over the number
    double of(double number) const { return inverse ? per_one / number : per_one * number + at_zero; }
};

/// The reader's unit of numbers in a unit; an empty function leaves all in their own.
using ReaderUnits = std::function<ReaderUnit(const std::string& unit)>;

inline ReaderUnit reader_unit(const ReaderUnits& units, const std::string& unit) { return units ? units(unit) : ReaderUnit{unit}; }

} // namespace hygroloom
