// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run of a garment is expected to take.
#pragma once

#include "ui/results/run_subject.h"

namespace hygroloom {

/// Cuts the garment into cells for it, which takes a while where they are fine. Empty once the turn is outdated.
RunForecast garmentForecast(const Design& design, const std::string& wear, const std::filesystem::path& base, Fidelity fidelity,
                            const std::string& machine, const NewestJob::Turn& turn);

} // namespace hygroloom
