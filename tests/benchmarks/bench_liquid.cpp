// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a step of the free liquid costs: a drop in the air, and the same drop lying on textile F of the paper.
#include "core/sim/cpu_executor.h"
#include "core/sim/solver.h"
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

} // namespace
