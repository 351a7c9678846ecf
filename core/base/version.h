// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where results come from, as recordings, metrics and reports say it.
#pragma once

namespace hygroloom {

const char* program_version(); ///< "0.1.0"
const char* program_commit();  ///< of the source, "unknown" without its history

} // namespace hygroloom
