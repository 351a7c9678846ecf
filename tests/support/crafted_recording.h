// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings as a stranger would make them: a valid one whose values, fields and tables get other types, sizes and contents, as bytes
// choose.
#pragma once

#include "core/run/recording.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hygroloom {

/// Takes decisions from bytes, one after another; from none, the first.
class Choices {
public:
    Choices(const std::uint8_t* bytes, std::size_t count) : bytes_(bytes), left_(count) {}
    /// Less than the number of choices.
    std::size_t of(std::size_t choices)
    {
        if (left_ == 0 || choices == 0) return 0;
        --left_;
        return *bytes_++ % choices;
    }
    bool any_left() const { return left_ > 0; }

private:
    const std::uint8_t* bytes_;
    std::size_t left_;
};

/// Of a drop on a small cloth, made up.
RunRecord small_run();
Frame small_frame(const RunRecord& run, int number);

/// A valid one of three frames, with a part that came on and some particles.
void write_small_recording(const std::string& path);

/// What a recording holds that can be changed.
struct CraftTargets {
    std::vector<const char*> numbers, texts, fields; ///< in its table "meta"
    std::vector<const char*> columns;                ///< of its three frames
    std::vector<const char*> jsons;                  ///< texts that are JSON
};
const CraftTargets& targets_of_a_sample();

/// Changes some of what stands in the recording at a path. Returns what it did, in words.
std::string craft(const std::string& path, Choices choices, const CraftTargets& targets = targets_of_a_sample());

/// Runs SQL on a recording, as a stranger could; what SQLite refuses is left undone.
bool craft_by_sql(const std::string& path, const std::string& sql);

} // namespace hygroloom
