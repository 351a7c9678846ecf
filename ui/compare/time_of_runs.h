// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The time that many runs will still take, from those that have ended.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace hygroloom {

/// A run under way.
struct TimedRun {
    double expected = 0; ///< s, by its plan or an earlier run of it; 0: not known
    double wall = 0;     ///< s, since it began
    double share = 0;    ///< of its time that is simulated, which passes unevenly: a drop that falls takes longest
};

class TimeOfRuns {
public:
    /// Simulated share and seconds since it began.
    using Course = std::vector<std::pair<double, double>>;

    /// Takes up a run that came to its end. Those that failed or were cancelled tell nothing.
    void add(double expected, double wall, const Course& course);
    /// s, for those under way and those that wait, of which so many go on at once; none: too early to say.
    std::optional<double> left(const std::vector<TimedRun>& running, const std::vector<double>& waiting, int at_once) const;

private:
    double passed(double share) const;

    static constexpr std::size_t steps = 20;
    double walls_ = 0, known_walls_ = 0, known_expected_ = 0;
    int ended_ = 0;
    std::array<double, steps + 1> courses_{}; ///< summed over the runs: the share of the wall time at equal steps of the simulated one
};

} // namespace hygroloom
