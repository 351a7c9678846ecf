// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a step of the yarn network costs per segment, beside a copy of the bytes it must touch; and what visiting only the cloth near the
// water saves. Textile F of the paper, draft's radial cells.
#include "core/solver/cpu_executor.h"
#include "core/solver/solver.h"
#include "tests/benchmarks/scenes.h"

#include <benchmark/benchmark.h>

#include <cstring>

using namespace hygroloom;

namespace {

/// Argument: side of the sample in mm.
void step(benchmark::State& state, bool everything, int threads, Closure closure = Closure::paper)
{
    const Scene scene = wet_cloth(static_cast<double>(state.range(0)), everything, closure);
    Solver<CpuExecutor> solver;
    solver.executor().set_threads(threads);
    solver.load(scene);
    double time = solver.advance(0.1, 1e9);
    constexpr int steps = 10;
    for (auto _ : state) time = solver.advance(time + steps * scene.rules.network_step, 1e9);
    const double visits = static_cast<double>(steps) * scene.cloth.segments();
    state.counters["s/segment"] = benchmark::Counter(visits, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["least bytes/segment"] = least_bytes(scene);
    state.counters["least B/s"] = benchmark::Counter(visits * least_bytes(scene), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(step, everything, true, 0)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(step, everything_with_pores, true, 0, Closure::pores)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(step, everything_one_thread, true, 1)->Arg(20)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(step, wicking_alone, false, 0)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Half of the bytes read, half written.
void copy(benchmark::State& state)
{
    const std::vector<char> from(1 << 28, 1);
    std::vector<char> to(from.size());
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), from.size());
        benchmark::ClobberMemory();
    }
    state.counters["B/s"] = benchmark::Counter(2.0 * static_cast<double>(from.size()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(copy)->UseRealTime();

/// The first five seconds of a small pool on a large sample. Argument: side of the sample in mm.
void pool(benchmark::State& state, bool growth)
{
    const Scene scene = scene_of(pool_on_textile_f(static_cast<double>(state.range(0)), 2), {{"growth", growth}});
    for (auto _ : state) {
        Solver<CpuExecutor> solver;
        solver.executor().set_threads(0);
        solver.load(scene);
        solver.advance(5, 1e9);
        state.counters["visited share"] = static_cast<double>(solver.visited_segments()) / scene.cloth.segments();
    }
}
BENCHMARK_CAPTURE(pool, near_the_water, true)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(pool, everywhere, false)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
