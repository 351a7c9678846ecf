// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A running scene on the CPU. Compiled twice, for particles in single and in double precision: see HL_PRECISION.
#include "core/solver/backend.h"
#include "core/solver/cpu_executor.h"
#include "core/solver/solver.h"

namespace hygroloom::inline HL_PRECISION {
namespace {

class CpuSolver : public Backend {
public:
    std::string name() const override { return "cpu"; }
    std::string device() const override { return ""; }
    void set_threads(int threads) override { solver_.executor().set_threads(threads); }
    void load(const Scene& scene) override { solver_.load(scene); }
    double advance(double until) override { return solver_.advance(until, 0.05); }
    Frame frame() override { return solver_.frame(); }
    std::vector<std::byte> state() override { return solver_.state(); }
    void go_on_from(const std::vector<std::byte>& state) override { solver_.go_on_from(state); }
    long liquid_steps() const override { return solver_.liquid_steps(); }
    int particles() const override { return solver_.particles(); }
    void time_stages() override { solver_.time_stages(); }
    std::vector<StageTime> stage_times() override { return solver_.executor().stage_times(); }

private:
    Solver<CpuExecutor> solver_;
};

} // namespace

std::unique_ptr<Backend> make_cpu_solver() { return std::make_unique<CpuSolver>(); }

} // namespace hygroloom::inline HL_PRECISION
