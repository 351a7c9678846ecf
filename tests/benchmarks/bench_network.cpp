// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a step of the yarn network costs per segment, beside a copy of the bytes it must touch; and what visiting only the cloth near the
// water saves. Textile F of the paper, draft's radial cells.
#include "core/project/project_file.h"
#include "core/sim/cpu_executor.h"
#include "core/sim/solver.h"

#include <benchmark/benchmark.h>

#include <cstring>

using namespace hygroloom;

namespace {

Design pool_on_textile_f(double sample_mm, double volume_ul)
{
    Design design = read_project(HYGROLOOM_SOURCE_DIR "/resources/examples/textile-F.hygro");
    Experiment experiment = standard_experiment(ExperimentType::moisture_management);
    experiment.name = "pool";
    experiment.sample_mm = {sample_mm, sample_mm};
    experiment.volume_ul = volume_ul;
    experiment.feed_s = 1;
    design.experiments = {experiment};
    return design;
}

Scene scene_of(const Design& design, const ForcedParts& forced)
{
    const ModelPlan plan = plan_model(design, design.fabrics[0], design.experiments[0], Fidelity::draft, forced);
    return build_scene(design, build_textile(design, design.fabrics[0], plan.region), design.experiments[0], plan, 1);
}

/// Doubles of a segment that a step with every part reads or writes at least once: length, pores, flux and uptake; liquid, vapour, warmth,
/// evaporated, released, lost and every shell there and back. Without wicking's partners: length, pores, liquid and flux.
double least_bytes(const Scene& scene) { return 8.0 * (scene.vapour ? 4 + 2 * (6 + scene.fibre_shells) : 6); }

/// Every segment wet, steps of one length, each with its exchange with fibres and air. Argument: side of the sample in mm.
void step(benchmark::State& state, bool everything, int threads)
{
    const auto side = static_cast<double>(state.range(0));
    Scene scene =
        scene_of(pool_on_textile_f(side, 1), {{"growth", false}, {"sorption", everything}, {"vapour", everything}, {"heat", everything}});
    scene.pools.clear();
    scene.step_error = 0;
    scene.network_step = scene.calm_network_step = 0.01;
    const double pores = scene.yarns[0].pore_area * scene.climate.density;
    for (std::size_t i = 0; i < static_cast<std::size_t>(scene.segments()); ++i)
        scene.initial_liquid.push_back((0.2 + 0.3 * static_cast<double>(i % 97) / 97) * pores * scene.length[i]);
    Solver<CpuExecutor> solver;
    solver.executor().set_threads(threads);
    solver.load(scene);
    double time = solver.advance(0.1, 1e9);
    constexpr int steps = 10;
    for (auto _ : state) time = solver.advance(time + steps * scene.network_step, 1e9);
    const double visits = static_cast<double>(steps) * scene.segments();
    state.counters["s/segment"] = benchmark::Counter(visits, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["least bytes/segment"] = least_bytes(scene);
    state.counters["least B/s"] = benchmark::Counter(visits * least_bytes(scene), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_CAPTURE(step, everything, true, 0)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond)->UseRealTime();
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
        state.counters["visited share"] = static_cast<double>(solver.visited_segments()) / scene.segments();
    }
}
BENCHMARK_CAPTURE(pool, near_the_water, true)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(pool, everywhere, false)->Arg(20)->Arg(80)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
