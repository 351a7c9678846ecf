// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run was, for its recording and for those who show it.
#pragma once

#include "core/plan/model_plan.h"
#include "core/plan/switched_part.h"
#include "core/run/answers_code.h"

#include <optional>

namespace hygroloom {

/// What a hand did to a cloth while it ran, which its experiment does not repeat: the last time of each, s.
struct HandActs {
    std::optional<double> tilted, squeezed;
    std::optional<double> wiped; ///< liquid that stood on it ran off when it was squeezed
};

/// Everything that describes a run but its frames.
struct RunRecord {
    Design design;
    std::string fabric;
    std::string experiment;
    ModelPlan plan;
    Textile textile; ///< as frames show it: in cells where the plan says so
    std::uint64_t seed = 1;
    int threads = 0;
    std::string backend;                   ///< "cpu", "cuda"
    std::string device;                    ///< in words, and where it went on when that failed
    std::vector<SwitchedPart> switched_on; ///< parts that the plan had left out, in order of time; also those kept off
    HandActs acts;
    double unsolved_lines = 0;          ///< see Frame; of recordings, at the last frame
    std::string date;                   ///< of its beginning in UTC, as 2026-11-22T18:40:12Z; empty: a recording of an older version
    std::string answers = answers_code; ///< of the program that ran it; empty: a recording of an older version
    double wall = 0;                    ///< s, of the run; 0 while it runs
    double recorded_in = 0;             ///< s of these, that it waited for its recording
    bool alone = true;                  ///< whether no other run of this process was on beside it
};

} // namespace hygroloom
