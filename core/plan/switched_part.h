// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A part of the physics that a run switched on though its plan had left it out.
#pragma once

#include <optional>
#include <string>

namespace hygroloom {

/// A part that the plan had left out and that the run switched on, or would have.
struct SwitchedPart {
    std::string name;
    double time = 0;  ///< s, of the frame from which on it is modelled
    double share = 0; ///< of the water at stake, or of a rate, that it would reach in the run, estimated at that time
    double limit = 0; ///< the share that may be left out
    std::optional<double> estimate =
        std::nullopt;          ///< the share that the plan had expected at most; none: it follows a part that the plan had left out too
    std::string kept_off = {}; ///< why it was not switched on, in words; empty: it was
};

/// One sentence: when, and with which number against which limit.
std::string in_words(const SwitchedPart& part);

} // namespace hygroloom
