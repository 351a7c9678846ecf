// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A running scene on the CPU, to be used without compiling the stages again.
#pragma once

#include "core/base/portable.h"
#include "core/solver/backend.h"

namespace hygroloom::inline HL_PRECISION {

class CpuSolver : public Backend {
public:
    CpuSolver();
    ~CpuSolver() override;
    std::string name() const override { return "cpu"; }
    std::string device() const override { return ""; }
    void set_threads(int threads) override;
    void load(const Scene& scene) override;
    double advance(double until) override { return advance(until, 0.05); }
    double advance(double until, double wall_seconds); ///< see Solver
    Frame frame() override;
    void stay() override;
    std::vector<std::byte> state() override;
    void go_on_from(const std::vector<std::byte>& state) override;
    void squeeze(double share) override;
    long liquid_steps() const override;
    int particles() const override;
    void time_stages() override;
    std::vector<StageTime> stage_times() override;
    long listings() const;  ///< how often neighbours were listed
    int visited_segments(); ///< in the last step

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace hygroloom::inline HL_PRECISION
