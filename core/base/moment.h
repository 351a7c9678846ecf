// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#pragma once

#include <fmt/chrono.h>

#include <chrono>
#include <string>

namespace hygroloom {

/// UTC, as ISO 8601 writes it: "2026-01-31T12:00:00Z".
inline std::string date_now()
{
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

} // namespace hygroloom
