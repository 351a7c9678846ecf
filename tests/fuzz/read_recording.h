// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What both fuzzers of recordings do with a file: all that the program does with one of a stranger.
#pragma once

#include "core/analysis/metrics.h"
#include "core/analysis/metrics_json.h"
#include "core/base/error.h"
#include "core/run/recording.h"

namespace hygroloom {

/// Refuses it with a FileError, or measures its good frames. Any other exception is a fault.
inline void read_recording(const std::string& path)
{
    try {
        Recording recording(path);
        MetricsCollector collector;
        collector.start(recording.run());
        recording.read_frames([&](const Frame& frame) {
            collector.add(frame);
            return true;
        });
        if (recording.frames() > 0) metrics_json(recording.run(), collector.metrics());
    } catch (const FileError&) {
        // said to the person
    }
}

} // namespace hygroloom
