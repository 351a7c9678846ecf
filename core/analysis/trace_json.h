// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A replicate's curves and maps in the file of replicates: four digits of a curve's values, tenths of g/m2 of a map's cells.
#pragma once

#include "core/analysis/run_trace.h"
#include "core/project/json_reader.h"

namespace hygroloom {

ProjectJson trace_value(const RunTrace& trace);
/// Trusts nothing. Throws FileError: where, what is wrong, what is allowed.
RunTrace trace_from(const ProjectJson& value, const std::string& file, const std::string& path);

} // namespace hygroloom
