// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers from the frames of a run: what laboratories report of each type of experiment, and time series.
#pragma once

#include "core/analysis/run_metrics.h"
#include "core/base/message.h"
#include "core/run/runner.h"

#include <cstdint>

namespace hygroloom {

enum class Face { top, bottom };

struct Circle {
    double x = 0, y = 0, radius = 0; ///< m
};

/// The smallest circle round the points (Welzl 1991); radius 0 for one point, negative for none.
Circle smallest_enclosing_circle(const std::vector<std::array<double, 2>>& points);

/// The smallest circle round the wet segments of a face.
Circle wetted_circle(const Textile& textile, const Frame& frame, Face face);

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
    void watch_free_water(const Frame& frame);
    void note_hand(const HandActs& acts);

    Textile textile_;
    Experiment experiment_;
    Bundling bundling_;
    Metrics metrics_;
    std::array<double, 2> absorbed_before_{0, 0}; ///< kg, top and bottom: of the test's water, by the fibres before the first frame
    std::vector<float> regain_at_start_;
    TesterPins pins_;                          ///< of moisture_management only
    std::optional<Message> falls_through_;     ///< see falls_through()
    bool assumes_depth_ = false;               ///< of a face's finish
    std::optional<double> edge_time_;          ///< s, when water was first seen where the sample ends
    double unsolved_lines_ = 0;                ///< see Frame
    std::vector<std::array<double, 2>> stain_; ///< m, wet places on top in the last frame
    std::vector<std::uint8_t> was_wet_;        ///< 1: each segment, in any frame so far
    std::vector<WetEnd> wet_ends_;             ///< where frames show cells, how far each end was wet in any frame so far
    double last_wetted_ = 0;                   ///< s, when the last of them got wet
    bool had_free_water_ = false;
    std::optional<double> wiped_; ///< s, see HandActs
    double delivered_ = 0;        ///< kg, by the last frame
};

} // namespace hygroloom
