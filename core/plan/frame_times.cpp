// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/frame_times.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// s, since the last drop of a feed fell; 0 where it flows evenly.
double since_drop(const Experiment& experiment, double time)
{
    const int drops = drops_of_feed(experiment);
    if (drops == 0) return 0;
    const double interval = experiment.feed_s / drops;
    return time - interval * std::floor(time / interval + 1e-9);
}

} // namespace

std::vector<double> frame_times(const Experiment& experiment, double interval)
{
    std::vector<double> times{0};
    const double end = experiment.duration_s;
    if (uses_field(experiment.type, "feed_s")) {
        const double fed = std::min(experiment.feed_s, end), fine = std::max(0.1, fed / 200);
        const long count = fine < interval ? std::lround(std::ceil(fed / fine - 1e-9)) : 0;
        constexpr double lively = 0.6 + 1e-9, calm = 0.5; // s after a drop, s apart
        const long stride = std::max(1L, std::lround(std::floor(std::min(calm, interval) / fine + 1e-9)));
        for (long k = 1; k <= count; ++k) {
            const double time = k == count ? fed : static_cast<double>(k) * fine;
            if (k == count || k % stride == 0 || since_drop(experiment, time) <= lively) times.push_back(time);
        }
    }
    // The coarse ones lie where they would without: at whole intervals.
    const long coarse = std::lround(std::ceil(end / interval - 1e-9));
    for (long k = 1; k < coarse; ++k)
        if (static_cast<double>(k) * interval > times.back() * (1 + 1e-9)) times.push_back(static_cast<double>(k) * interval);
    if (times.back() < end) times.push_back(end);
    return times;
}

double frames_of(const ModelPlan& plan)
{
    if (plan.counts.frames > 0) return plan.counts.frames;
    const double more = plan.counts.type == name_of(ExperimentType::moisture_management) ? 200 : 0;
    return plan.counts.duration / std::max(1e-9, plan.frame_interval) + more;
}

double shown_segments(const ModelPlan& plan) { return plan.shown_ends > 0 ? 2.0 * plan.shown_ends * plan.shown_picks : plan.segments; }

double recording_seconds(const ModelPlan& plan)
{
    constexpr double frame = 3e-4, segment = 1.2e-7; // s; of a frame, and to pack the fields of a segment of it
    return frames_of(plan) * (frame + segment * shown_segments(plan));
}

double seconds_to_wait(const ModelPlan& plan, bool recorded) { return plan.expected_seconds + (recorded ? recording_seconds(plan) : 0); }

} // namespace hygroloom
