// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How long this machine's own runs took, kept between sessions, so that estimates of time learn from them.
#pragma once

#include "core/run/run_record.h"

#include <filesystem>

namespace hygroloom {

/// The user's: times.json in cache_folder(); empty where there is none.
std::filesystem::path usual_learned_times();

/// Which file of this process holds them; empty, as at the start: none is kept and none is used. A file that cannot be read counts as
/// empty, one that cannot be written changes nothing.
void keep_learned_times(const std::filesystem::path& file);

/// Takes up a run that came to its end, with all threads and without a pause, while no other run of this process was on. The newest 60 of a
/// backend stay.
void learn_time(const RunRecord& run);

/// What is estimated of a run of a garment, which has no plan of a sample.
struct GarmentTime {
    Fidelity fidelity = Fidelity::standard;
    double seconds = 0;  ///< before anything is learned
    std::string learned; ///< what it was corrected by, in a sentence; empty: it was not
};
/// As learn_time() of a sample.
void learn_time(const GarmentTime& estimated, double seconds_taken, const std::string& backend, const std::string& device);
void expect_as_learned(GarmentTime& estimated, const std::string& backend);

/// Multiplies the plan's expected time by what runs of its kind took here against their own estimates, and says so. Precondition: expect().
void expect_as_learned(ModelPlan& plan, const std::string& backend);

} // namespace hygroloom
