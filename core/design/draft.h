// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A weaving draft: which shaft carries each end, and which shafts each pick lifts. Indices count from 0 here, from 1 in files and texts.
#pragma once

#include <string>
#include <vector>

namespace hygroloom {

constexpr int largest_repeat = 2000; ///< ends, picks of a weave
constexpr int most_shafts = 2000;    ///< also treadles

struct Draft {
    int shafts = 0;
    int treadles = 0;                        ///< 0 with a liftplan
    std::vector<std::vector<int>> threading; ///< per end its shafts: one as a rule, none when it is not threaded
    std::vector<std::vector<int>> tie_up;    ///< per treadle the shafts tied to it
    std::vector<std::vector<int>> treadling; ///< per pick the treadles pressed; several add up
    std::vector<std::vector<int>> liftplan;  ///< per pick the shafts; when not empty, tie_up and treadling are
    bool rising_shed = true;                 ///< false: the named shafts sink, the others rise
    std::vector<std::string> private_lines;  ///< what other programs wrote into the file it came from, verbatim

    int ends() const { return static_cast<int>(threading.size()); }
    int picks() const { return static_cast<int>(liftplan.empty() ? treadling.size() : liftplan.size()); }
    bool operator==(const Draft&) const = default;
};

/// What is wrong with it in a sentence that names the place ("threading[3]: ..."), empty when it can be drawn down.
/// Threads may number up to most_threads in each system.
std::string fault_in(const Draft& draft, int most_threads = largest_repeat);

/// The same weave with each pick's shafts listed, and with a tie-up of as few treadles as there are different picks.
/// Precondition: fault_in() finds nothing.
Draft with_liftplan(const Draft& draft);
Draft with_tie_up(const Draft& draft);

} // namespace hygroloom
