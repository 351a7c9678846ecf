// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Inputs of a report: what a project file holds, in words with units.
#pragma once

#include "core/analysis/page.h"
#include "core/analysis/reader_units.h"
#include "core/project/project_json.h"

#include <string>
#include <utility>
#include <vector>

namespace hygroloom {

/// "warp, linear density" and "14.8 tex", in the order of the file: of a fabric, an experiment, a material, a garment. Of what has no
/// value in the file there is no row.
std::vector<std::pair<std::string, std::string>> inputs_in_words(const ProjectJson& value, const ReaderUnits& units = {});

/// The same as a table under its title.
PageBlocks table_of_inputs(const char* title, const ProjectJson& value, const ReaderUnits& units = {});

} // namespace hygroloom
