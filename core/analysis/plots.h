// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which series of a run are drawn together, with their names and units. Reports and the window's charts read this.
#pragma once

#include "core/analysis/run_metrics.h"
#include "core/design/experiment.h"

#include <vector>

namespace hygroloom {

struct Curve {
    const char* name; ///< "top"
    std::vector<double> Series::*values;
    bool over_start = false; ///< less the water that the cloth held at the start
    bool in_reports_only = false;
};

/// Curves of factor times series plus offset.
struct Plot {
    const char* title; ///< "Wetted radius"
    const char* unit;
    std::vector<Curve> curves;
    double factor = 1, offset = 0;
    bool from_zero = true; ///< whether the axis begins at 0
};

enum class PlotName { radius, height, content, water, faces, temperature, regain };
const Plot& plot_named(PlotName name);
/// In that order.
const std::vector<Plot>& all_plots();

/// Where the water is; in a test of the fibres' uptake, how much they hold.
const Plot& water_plot(ExperimentType type);

/// A curve's values in the plot's unit. water_initial: kg, that the cloth held at the start.
std::vector<double> plotted(const Plot& plot, const Curve& curve, const Series& series, double water_initial);
std::vector<double> plotted(const Plot& plot, const Curve& curve, const Metrics& metrics);

} // namespace hygroloom
