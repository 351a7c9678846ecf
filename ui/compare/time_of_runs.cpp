// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/time_of_runs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hygroloom {

namespace {

/// Of a course with its end, in order of both.
double wallAt(const TimeOfRuns::Course& course, double share)
{
    std::pair<double, double> before{0, 0};
    for (const auto& point : course) {
        if (point.first >= share) {
            const double width = point.first - before.first;
            return width > 0 ? std::lerp(before.second, point.second, (share - before.first) / width) : point.second;
        }
        before = point;
    }
    return before.second;
}

} // namespace

void TimeOfRuns::add(double expected, double wall, const Course& course)
{
    if (!(wall > 0)) { return; }
    walls_ += wall;
    ++ended_;
    if (expected > 0) {
        known_walls_ += wall;
        known_expected_ += expected;
    }
    Course whole;
    for (const auto& [share, seconds] : course) {
        if (share < 1 && seconds < wall) { whole.emplace_back(share, seconds); }
    }
    whole.emplace_back(1, wall);
    for (std::size_t k = 0; k <= steps; ++k) { courses_[k] += wallAt(whole, static_cast<double>(k) / steps) / wall; }
}

/// Of the wall time of a run: as in those that ended, else as the simulated one.
double TimeOfRuns::passed(double share) const
{
    const double at = std::clamp(share, 0.0, 1.0) * steps;
    if (ended_ == 0) { return at / steps; }
    const auto k = std::min(static_cast<std::size_t>(at), steps - 1);
    return std::lerp(courses_[k], courses_[k + 1], at - static_cast<double>(k)) / ended_;
}

std::optional<double> TimeOfRuns::left(const std::vector<TimedRun>& running, const std::vector<double>& waiting, int at_once) const
{
    if (running.empty() && waiting.empty()) { return 0.0; }
    constexpr double least = 0.02; // of a run, before which its pace tells nothing
    double pace = known_expected_ > 0 ? known_walls_ / known_expected_ : 1;
    const double mean = ended_ > 0 ? walls_ / ended_ : 0;
    const auto seconds_of = [&](double expected) { return expected > 0 ? pace * expected : mean; };
    double sum = 0, longest = 0, totals = 0, of_running = 0, expected = 0;
    for (const TimedRun& run : running) {
        const double share = passed(run.share), prior = std::max(seconds_of(run.expected), run.wall);
        const bool known = seconds_of(run.expected) > 0;
        if (!known && share < least) { return std::nullopt; }
        // The farther it is, the more its own pace counts.
        const double own = known ? std::min(1.0, 2 * share) : 1.0;
        const double total = share < least ? prior : std::pow(prior, 1 - own) * std::pow(run.wall / share, own);
        const double to_go = std::max(0.0, total - run.wall);
        sum += to_go;
        longest = std::max(longest, to_go);
        of_running += total;
        if (share >= least && run.expected > 0) {
            totals += total;
            expected += run.expected;
        }
    }
    // Before the first has ended, those that wait are like those under way.
    if (ended_ == 0 && expected > 0) { pace = totals / expected; }
    const double like = ended_ > 0 ? mean : running.empty() ? 0 : of_running / static_cast<double>(running.size());
    for (const double each : waiting) {
        const double seconds = each > 0 ? pace * each : like;
        if (!(seconds > 0)) { return std::nullopt; }
        sum += seconds;
        longest = std::max(longest, seconds);
    }
    const auto lanes = std::clamp<double>(at_once, 1, static_cast<double>(running.size() + waiting.size()));
    return std::max(longest, sum / lanes);
}

} // namespace hygroloom
