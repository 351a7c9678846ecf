// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The one file that a new commit compiles anew: its definitions come from core/CMakeLists.txt.
#include "core/base/version.h"

namespace hygroloom {

const char* program_version() { return HYGROLOOM_VERSION; }
const char* program_commit() { return HYGROLOOM_COMMIT; }

} // namespace hygroloom
