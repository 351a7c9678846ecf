// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The run of a worn garment from its parts to a recording and numbers, as command line, window and Python start it.
#pragma once

#include "core/wear/wear_metrics.h"
#include "core/wear/wear_recording.h"

namespace hygroloom {

/// What a garment's run gives in place of a sample's record and frames. All from the thread of the run.
struct WornCallbacks {
    std::function<void(const WearPlan&)> planned; ///< as learned, before the first step
    std::function<void(std::shared_ptr<const WearRecord>)> started;
    std::function<void(std::shared_ptr<const WearFrame>, const WearMetrics&)> frame; ///< with what all frames so far come to
};

/// A run that came to its end, with its numbers.
struct FinishedGarment {
    std::shared_ptr<const WearRecord> record;
    std::shared_ptr<const WearMetrics> metrics; ///< of the record's layout, which must outlive it
    std::shared_ptr<const WearFrame> last;
    std::vector<std::string> issues; ///< of its pattern, in sentences
    double wall = 0;                 ///< s
    GarmentTime estimated;           ///< before anything was learned
    bool fair = true;           ///< it had all threads, no other run of this process was on, and its device did not fail: see learn_time()
    std::string device_failure; ///< a sentence, after which the run went on on the CPU; empty: none
};

/// To the end, in the calling thread. Of the first callbacks those count that are the same for samples. Throws NotEnoughMemory before
/// anything runs, Cancelled within 0.2 s when asked to stop (the recording so far is complete and readable), DeviceError, FileError or
/// Error. Precondition: validate() found no error.
FinishedGarment run_garment(const GarmentParts& parts, const RunOptions& options, Backend& backend, RunControl& control,
                            const RunCallbacks& beside, const WornCallbacks& worn = {});

/// Takes up how long a garment's run took, where that was fair. Precondition: it was not paused.
void learn_time(const FinishedGarment& finished);

} // namespace hygroloom
