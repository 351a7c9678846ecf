// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where runs go: backends, each for one run at a time.
#pragma once

#include "core/solver/backend.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hygroloom {

/// Its queue guards it.
class RunPlaces {
public:
    /// Precondition: there is one at least.
    explicit RunPlaces(std::vector<std::unique_ptr<Backend>> backends);
    /// Each run opens a backend of its own, in its thread; so many at once. machine: the name of these backends, "cpu" or "cuda".
    RunPlaces(std::function<std::unique_ptr<Backend>()> open, std::string machine, std::size_t at_once)
        : open_(std::move(open)), machine_(std::move(machine)), at_once_(at_once)
    {
    }

    /// How many runs may be on. A device that failed is left out, unless it is the last.
    std::size_t at_once() const { return at_once_; }
    /// Places of the same name share what computes.
    const std::string& machine() const { return machine_; }
    /// Of the machine, that each run takes.
    double share() const { return 1.0 / static_cast<double>(at_once_); }
    bool has_free() const { return taken_ < at_once_; }
    /// Precondition: has_free(). nullptr: open() gives it.
    Backend* take();
    std::unique_ptr<Backend> open() const { return open_(); }
    /// backend: as take() gave it.
    void give_back(Backend* backend, bool failed);

private:
    std::function<std::unique_ptr<Backend>()> open_;
    std::vector<std::unique_ptr<Backend>> backends_;
    std::vector<Backend*> free_; ///< the next one last
    std::string machine_;
    std::size_t at_once_, taken_ = 0;
};

} // namespace hygroloom
