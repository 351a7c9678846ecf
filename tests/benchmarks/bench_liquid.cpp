// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a step of the free liquid costs: a drop in the air, and the same drop lying on textile F of the paper; and how that grows with the
// number of particles.
#include "core/solver/cpu_executor.h"
#include "core/solver/solver.h"
#include "tests/benchmarks/scenes.h"

#include <benchmark/benchmark.h>

#include <chrono>

using namespace hygroloom;

namespace {

/// Arguments: particles, fall in mm (a short one has the drop on the cloth after the warm-up), threads. Counts rounds of the pressure
/// loop and listings of neighbours per step.
void liquid_step(benchmark::State& state)
{
    Solver<CpuExecutor> solver;
    solver.executor().set_threads(static_cast<int>(state.range(2)));
    solver.load(drop_scene(static_cast<int>(state.range(0)), static_cast<double>(state.range(1))));
    const bool lies = state.range(1) < 5;
    double time = solver.advance(lies ? 0.03 : 0.004, 1e9);
    constexpr double burst = 1e-4; // s
    const long steps = solver.liquid_steps(), rounds = solver.pressure_rounds(), listings = solver.listings();
    for (auto _ : state) {
        const long before = solver.liquid_steps();
        const auto start = std::chrono::steady_clock::now();
        time = solver.advance(time + burst, 1e9);
        const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        state.SetIterationTime(wall / static_cast<double>(std::max(1L, solver.liquid_steps() - before)));
    }
    const auto all = static_cast<double>(std::max(1L, solver.liquid_steps() - steps));
    state.counters["rounds"] = static_cast<double>(solver.pressure_rounds() - rounds) / all;
    state.counters["listings"] = static_cast<double>(solver.listings() - listings) / all;
    state.counters["s/particle"] = benchmark::Counter(static_cast<double>(state.range(0)),
                                                      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(liquid_step)
    ->ArgNames({"particles", "fall_mm", "threads"})
    ->Args({1000, 10, 0})
    ->Args({8000, 10, 0})
    ->Args({8000, 10, 1})
    ->Args({64000, 10, 0})
    ->Args({8000, 0, 0})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// The same number of steps after its release for drops of any number of particles (argument): smaller particles take smaller steps and
/// relax within fewer seconds. So soon every step lists neighbours, without a skin, of all drops alike. Listing is the share of s/particle
/// that is spent on it, the rest is what a step costs that lists nothing, on these lists.
void liquid_step_after_release(benchmark::State& state)
{
    const auto particles = static_cast<double>(state.range(0));
    Solver<CpuExecutor> solver;
    solver.load(drop_scene(static_cast<int>(state.range(0)), 10));
    const double burst = 2e-4 * std::sqrt(8000 / particles); // s, five steps
    double time = 0;
    while (solver.liquid_steps() < 40) time = solver.advance(time + burst, 1e9);
    solver.time_stages();
    const long steps = solver.liquid_steps(), listings = solver.listings();
    for (auto _ : state) {
        const long before = solver.liquid_steps();
        const auto start = std::chrono::steady_clock::now();
        for (const double end = time + burst; time < end - 1e-9 * burst;) time = solver.advance(end, 1e9);
        const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        state.SetIterationTime(wall / static_cast<double>(std::max(1L, solver.liquid_steps() - before)));
    }
    const auto all = static_cast<double>(std::max(1L, solver.liquid_steps() - steps));
    double listing = 0, rest = 0;
    for (const StageTime& stage : solver.executor().stage_times()) {
        const bool lists = stage.name == "find box" || stage.name == "find cell" || stage.name == "sort" || stage.name == "reorder" ||
                           stage.name == "neighbours";
        (lists ? listing : rest) += stage.seconds / (all * particles);
    }
    state.counters["listings"] = static_cast<double>(solver.listings() - listings) / all;
    state.counters["listing"] = listing;
    state.counters["rest"] = rest;
    state.counters["s/particle"] = listing + rest;
}
BENCHMARK(liquid_step_after_release)
    ->ArgName("particles")
    ->Arg(1000)
    ->Arg(8000)
    ->Arg(64000)
    ->Arg(1000000)
    ->Iterations(5)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
