// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What an experiment is, in rows of a report: type, liquid, how it comes to the cloth, climate, duration, fidelity.
#pragma once

#include "core/analysis/comparison.h"

#include <string>
#include <utility>
#include <vector>

namespace hygroloom {

using ExperimentRows = std::vector<std::pair<std::string, std::string>>; ///< name and text

ExperimentRows experiment_rows(const RunRecord& run, const Experiment& experiment, const ReaderUnits& units);
/// Of a garment's.
ExperimentRows experiment_rows(const WornCandidate& worn, const ReaderUnits& units);

} // namespace hygroloom
