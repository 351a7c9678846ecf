// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/sim/backend.h"
#include "core/sim/cpu_executor.h"
#include "core/sim/solver.h"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace hygroloom {
namespace {

std::string processor_name()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
    return "processor";
}

class CpuBackend : public Backend {
public:
    std::string name() const override { return "cpu"; }
    std::string device() const override { return fmt::format("{}, {} thread(s)", processor_name(), threads_); }
    void set_threads(int threads) override
    {
        const int all = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
        threads_ = threads > 0 ? threads : all;
        solver_.executor().set_threads(threads_);
    }
    void load(const Scene& scene) override { solver_.load(scene); }
    double advance(double until) override { return solver_.advance(until, 0.05); }
    Frame frame() override { return solver_.frame(); }
    std::vector<std::byte> state() override { return solver_.state(); }
    void go_on_from(const std::vector<std::byte>& state) override { solver_.go_on_from(state); }
    long liquid_steps() const override { return solver_.liquid_steps(); }
    int particles() const override { return solver_.particles(); }
    void time_stages() override { solver_.executor().time_stages(); }
    std::vector<StageTime> stage_times() override { return solver_.executor().stage_times(); }

private:
    Solver<CpuExecutor> solver_;
    int threads_ = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

} // namespace

std::unique_ptr<Backend> make_cpu_backend() { return std::make_unique<CpuBackend>(); }

} // namespace hygroloom
