// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers from a recording: wetted radius, absorbency time, time series.
#pragma once

#include "core/sim/frame.h"
#include "core/sim/runner.h"

#include <optional>

namespace hygroloom {

enum class Face { top, bottom };

struct Circle {
    double x = 0, y = 0, radius = 0; ///< m
};

/// A segment counts as wet when liquid fills at least this share of its pores.
constexpr double wet_saturation = 0.05;

/// The smallest circle round the points (Welzl 1991); radius 0 for one point, negative for none.
Circle smallest_enclosing_circle(const std::vector<std::array<double, 2>>& points);

/// The smallest circle round the wet segments of a face.
Circle wetted_circle(const Textile& textile, const Frame& frame, Face face);

/// One value per frame for each series of the metrics file.
struct Series {
    std::vector<double> time, radius_top, radius_bottom, water_top, water_bottom, free_water, yarn_water, bound_water, evaporated,
        dripped, temperature_mean, temperature_min, temperature_max, regain_mean; ///< SI
};

struct Metrics {
    double maximum_wetted_radius_top = 0;    ///< m
    double maximum_wetted_radius_bottom = 0; ///< m
    std::optional<double> absorbency_time;   ///< s
    double wetted_area_ellipse_warp = 0;     ///< m, semi-axis along the warp, of the final stain on top
    double wetted_area_ellipse_weft = 0;     ///< m
    Series series;
    Ledger ledger;                           ///< at the end
    std::vector<std::string> notes;          ///< why a metric is missing
};

/// Collects metrics frame by frame, so that a run need not keep its frames.
class MetricsCollector {
public:
    void start(const RunRecord& run);
    void add(const Frame& frame);
    Metrics metrics() const { return metrics_; }

private:
    Textile textile_;
    Metrics metrics_;
    bool had_free_water_ = false;
};

/// contract.md section 4, as JSON text.
std::string metrics_json(const RunRecord& run, const Metrics& metrics);

} // namespace hygroloom
