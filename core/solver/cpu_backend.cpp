// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/scene/scene.h"
#include "core/solver/backend.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <algorithm>
#include <fstream>

namespace hygroloom {

namespace in_single {
std::unique_ptr<Backend> make_cpu_solver(); // cpu_solver.cpp
}
namespace in_double {
std::unique_ptr<Backend> make_cpu_solver();
}

namespace {

std::string processor_name()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
    return "processor";
}

/// Runs each scene in the precision it asks for.
class CpuBackend : public Backend {
public:
    std::string name() const override { return "cpu"; }
    std::string device() const override { return fmt::format("{}, {} thread{}", processor_name(), threads_, threads_ == 1 ? "" : "s"); }
    void set_threads(int threads) override
    {
        threads_ = threads > 0 ? std::min(threads, usable_threads()) : usable_threads(); // TBB warns on stderr where it is asked for more
        solver_->set_threads(threads_);
    }
    void load(const Scene& scene) override
    {
        if (scene.rules.double_precision != is_double_) {
            solver_ = scene.rules.double_precision ? in_double::make_cpu_solver() : in_single::make_cpu_solver();
            is_double_ = scene.rules.double_precision;
            solver_->set_threads(threads_);
            if (times_stages_) solver_->time_stages();
        }
        solver_->load(scene);
    }
    double advance(double until) override { return solver_->advance(until); }
    Frame frame() override { return solver_->frame(); }
    void stay() override { solver_->stay(); }
    std::vector<std::byte> state() override { return solver_->state(); }
    void go_on_from(const std::vector<std::byte>& state) override { solver_->go_on_from(state); }
    void squeeze(double share) override { solver_->squeeze(share); }
    long liquid_steps() const override { return solver_->liquid_steps(); }
    int particles() const override { return solver_->particles(); }
    void time_stages() override
    {
        times_stages_ = true;
        solver_->time_stages();
    }
    std::vector<StageTime> stage_times() override { return solver_->stage_times(); }

private:
    std::unique_ptr<Backend> solver_ = in_single::make_cpu_solver();
    bool is_double_ = false;
    bool times_stages_ = false;
    int threads_ = usable_threads();
};

} // namespace

int usable_threads() { return std::max(1, tbb::info::default_concurrency()); }

std::unique_ptr<Backend> make_cpu_backend() { return std::make_unique<CpuBackend>(); }

} // namespace hygroloom
