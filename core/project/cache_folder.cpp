// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/cache_folder.h"

#include <cstdlib>

namespace hygroloom {

std::filesystem::path cache_folder()
{
    const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
    if (cache && *cache) return std::filesystem::path(cache) / "hygroloom";
    return home && *home ? std::filesystem::path(home) / ".cache" / "hygroloom" : std::filesystem::path();
}

} // namespace hygroloom
