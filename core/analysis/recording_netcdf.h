// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The recording of a sample as a NetCDF file for other programs.
#pragma once

#include "core/analysis/run_metrics.h"
#include "core/run/recording.h"

#include <filesystem>
#include <functional>

namespace hygroloom {

/// With the names and units that Python's read_recording() gives: water_map (time, side, y, x) of cells of so many crossings; values of the
/// segments (time, segment) and where these lie; series and ledger (time). metrics: of all its frames. progress gets the share that is done
/// and returns whether to go on; otherwise throws Cancelled. What has the name stays until the file is whole. Throws FileError.
void write_netcdf(const Recording& recording, const Metrics& metrics, int crossings_per_cell, const std::filesystem::path& path,
                  const std::function<bool(double)>& progress);

} // namespace hygroloom
