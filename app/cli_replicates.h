// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// --replicates: runs of cloths that the descriptions leave open.
#pragma once

#include "app/cli_run.h"

namespace hygroloom {

/// whose: "" or " of each fabric".
void add_replicates_option(CLI::App& verb, int& replicates, const std::string& whose);

} // namespace hygroloom
