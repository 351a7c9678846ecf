// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether a run had the machine for itself, as far as this process knows.
#pragma once

#include <atomic>

namespace hygroloom {

/// Of a run, as long as it lives: whether there was another of this process.
class Presence {
public:
    Presence() : others_(running_++ > 0)
    {
        if (others_) ++meetings_;
        meetings_before_ = meetings_;
    }
    ~Presence() { --running_; }
    Presence(const Presence&) = delete;
    Presence& operator=(const Presence&) = delete;
    bool alone() const { return !others_ && meetings_ == meetings_before_; }

private:
    inline static std::atomic<int> running_ = 0;
    inline static std::atomic<long> meetings_ = 0; ///< runs that began beside another
    bool others_;
    long meetings_before_;
};

} // namespace hygroloom
