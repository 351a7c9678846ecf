// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A bar on a terminal's stderr while files are written.
#pragma once

#include "app/cli_print.h"

#include "core/base/text.h"

#include <fmt/format.h>

#include <chrono>
#include <unistd.h>

namespace hygroloom {

/// Cleared when it ends. Without a terminal, or quiet, there is none.
class FileBar {
public:
    explicit FileBar(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO)) {}
    ~FileBar() { clear(); }
    FileBar(const FileBar&) = delete;
    FileBar& operator=(const FileBar&) = delete;

    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
    void clear()
    {
        if (shown_) draw_line("");
        shown_ = false;
    }
    /// The finished share; drawn ten times a second at most.
    void show(double share)
    {
        if (!shown_ || seconds() < drawn_ + 0.1) return;
        drawn_ = seconds();
        constexpr int width = 30;
        const int full = static_cast<int>(share * width);
        const std::optional<double> to_go = time_left(share, drawn_);
        const std::string left = to_go ? fmt::format(", about {:.0f} s left", *to_go) : std::string();
        draw_line(fmt::format("[{}{}] {:.0f} %, {:.0f} s{}", std::string(static_cast<std::size_t>(full), '#'),
                              std::string(static_cast<std::size_t>(width - full), '.'), 100 * share, drawn_, left));
    }

private:
    bool shown_;
    double drawn_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace hygroloom
