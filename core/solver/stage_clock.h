// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the time of a run goes, stage by stage. Wall time: a stage that runs on many threads counts once.
#pragma once

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace hygroloom {

/// What one stage took, all its calls together.
struct StageTime {
    std::string name;
    double seconds = 0;
    long calls = 0;
};

/// Adds up the times of stages. Used from one thread.
class StageClock {
public:
    void add(const char* name, double seconds)
    {
        StageTime& stage = stages_[name];
        stage.seconds += seconds;
        ++stage.calls;
    }
    /// The longest first.
    std::vector<StageTime> times() const
    {
        std::vector<StageTime> list;
        for (const auto& [name, stage] : stages_) list.push_back({name, stage.seconds, stage.calls});
        std::sort(list.begin(), list.end(), [](const StageTime& a, const StageTime& b) { return a.seconds > b.seconds; });
        return list;
    }

private:
    std::map<std::string, StageTime> stages_;
};

/// Times its own life for a clock; without one it does nothing.
class StageLap {
public:
    StageLap(StageClock* clock, const char* name) : clock_(clock), name_(name)
    {
        if (clock_) start_ = std::chrono::steady_clock::now();
    }
    ~StageLap()
    {
        if (clock_) clock_->add(name_, std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count());
    }
    StageLap(const StageLap&) = delete;
    StageLap& operator=(const StageLap&) = delete;

private:
    StageClock* clock_;
    const char* name_;
    std::chrono::steady_clock::time_point start_{};
};

} // namespace hygroloom
