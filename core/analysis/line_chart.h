// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Curves over one axis as a picture that scales (SVG).
#pragma once

#include <string>
#include <vector>

namespace hygroloom {

struct LineChart {
    struct Curve {
        std::string name;
        std::vector<double> values;        ///< one for each x
        bool points = false;               ///< circles instead of a line
        std::vector<double> low{}, high{}; ///< of the band round it, one for each x; empty: it has none
    };
    std::string title, x_label, y_label;
    std::vector<double> x; ///< rising, of points at least not falling
    std::vector<Curve> curves;
};

/// Curves differ by colour and by dashes; what is not finite leaves a gap. Precondition: at least two x.
std::string svg_of(const LineChart& chart);

} // namespace hygroloom
