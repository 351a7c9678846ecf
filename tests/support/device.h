// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A device that is a CPU behind its name. Tests override what is to fail or to be late.
#pragma once

#include "core/solver/backend.h"

namespace hygroloom {

class Device : public Backend {
public:
    std::string name() const override { return "cuda"; }
    std::string device() const override { return "a device"; }
    void set_threads(int threads) override { cpu_->set_threads(threads); }
    void load(const Scene& scene) override { cpu_->load(scene); }
    double advance(double until) override { return cpu_->advance(until); }
    Frame frame() override { return cpu_->frame(); }
    void stay() override { cpu_->stay(); }
    std::vector<std::byte> state() override { return cpu_->state(); }
    void go_on_from(const std::vector<std::byte>& state) override { cpu_->go_on_from(state); }
    void squeeze(double share) override { cpu_->squeeze(share); }
    long liquid_steps() const override { return cpu_->liquid_steps(); }
    int particles() const override { return cpu_->particles(); }

protected:
    std::unique_ptr<Backend> cpu_ = make_cpu_backend();
};

} // namespace hygroloom
