// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One run, whatever its subject: what is asked for, and what came of it.
#pragma once

#include "core/analysis/measured_run.h"
#include "core/design/unknowns.h"
#include "core/wear/garment_run.h"

#include <exception>

namespace hygroloom {

/// An experiment on a sample of a fabric or, where it is of the type wear, on its garment.
struct RunJob {
    std::shared_ptr<const Design> design;
    std::string experiment;
    std::string fabric{};              ///< of a garment: that all panels are cut from; empty: it is as it is
    std::filesystem::path base{};      ///< folder of the project, from where it names a garment's files
    RunOptions how{};                  ///< its seed is that of all replicates
    int replicate = 0, replicates = 1; ///< number, and how many there are: see Replicate
    RunCallbacks beside{};
    MeasuredFrame measured{}; ///< of a sample
    WornCallbacks worn{};
    bool times_count = true; ///< estimates of time learn from it, where it had the machine for itself and was not paused
};

/// Of a job that came to its end either sample or garment is there.
struct RunResult {
    Drawn drawn; ///< what was run
    std::optional<FinishedRun> sample;
    std::optional<FinishedGarment> garment;
    std::exception_ptr error; ///< why it came to no end; of one that was stopped Cancelled
    std::string device;       ///< in words; empty: it came to none
    double wall = 0;          ///< s, with what came before its first step

    bool ended() const { return sample || garment; }
    /// Why it failed, in a sentence; empty where it did not, or was stopped.
    std::string failure() const;
    /// After which it went on on the CPU, a sentence; empty: its device held.
    const std::string& device_failure() const { return garment ? garment->device_failure : sample->device_failure; }
};

/// Runs it to its end in the calling thread. Throws Cancelled within 0.2 s when asked to stop, NotEnoughMemory before anything runs,
/// DeviceError, FileError or Error. Precondition: validate() found no error.
RunResult run_job(const RunJob& job, Backend& backend, RunControl& control);

/// The memory (bytes) that it takes, by its plan; 0 where the run will say why it cannot be. Throws FileError of what a garment names.
double bytes_of(const RunJob& job);

} // namespace hygroloom
