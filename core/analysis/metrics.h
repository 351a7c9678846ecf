// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers from the frames of a run: what laboratories report of each type of experiment, and time series.
#pragma once

#include "core/analysis/laboratory.h"
#include "core/analysis/management.h"
#include "core/run/runner.h"
#include "core/scene/frame.h"

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

/// One value per frame for each series of the metrics file. The water of a face is what it has beyond what its fibres held before any came;
/// less than nothing only where they have given some of that to the air.
struct Series {
    std::vector<double> time, radius_top, radius_bottom, water_top, water_bottom, free_water, yarn_water, bound_water, evaporated, dripped,
        temperature_mean, temperature_min, temperature_max, regain_mean; ///< SI
    std::vector<double> air_temperature;                                 ///< K
    std::vector<double> wick_height;                                     ///< m, of vertical_wicking only
    std::vector<double> content_top, content_bottom; ///< % of the dry mass, of moisture_management only: see management_radius
};

struct Metrics {
    double maximum_wetted_radius_top = 0;    ///< m
    double maximum_wetted_radius_bottom = 0; ///< m
    std::optional<double> absorbency_time;   ///< s
    double wetted_area_ellipse_warp = 0;     ///< m, semi-axis along the warp, of the final stain on top
    double wetted_area_ellipse_weft = 0;     ///< m
    std::optional<ManagementIndices> management;
    std::optional<WickingResult> wicking;
    std::optional<double> horizontal_rate; ///< m2/s: area of the stain over the time in which it grew to 95 % of it (AATCC 198)
    std::optional<DryingResult> drying;
    std::optional<ConditioningResult> conditioning;
    Series series;
    Ledger ledger;                  ///< at the end
    std::vector<std::string> notes; ///< what limits a metric, in sentences
};

/// The water content of a face is read within this distance of the sample's middle, m: the tester's inner ring.
constexpr double management_radius = 5e-3;

/// Collects metrics frame by frame, so that a run need not keep its frames.
class MetricsCollector {
public:
    void start(const RunRecord& run);
    void add(const Frame& frame);
    /// A part was switched on while running. Those of a recording are in the record that it starts with.
    void add(const SwitchedPart& part);
    /// Of the frames so far.
    Metrics metrics() const;

private:
    Textile textile_;
    Experiment experiment_;
    Metrics metrics_;
    std::array<double, 2> absorbed_before_{0, 0}; ///< kg, top and bottom: of the test's water, by the fibres before the first frame
    std::vector<float> regain_at_start_;
    std::optional<double> edge_time_; ///< s, when water was first seen where the sample ends
    bool had_free_water_ = false;
};

} // namespace hygroloom
