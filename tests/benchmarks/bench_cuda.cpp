// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The same steps on a GPU: one scene, several side by side, and as large as they come. Does nothing where there is no GPU.
#include "core/base/error.h"
#include "gpu/backends.h"
#include "tests/benchmarks/scenes.h"

#include <benchmark/benchmark.h>
#include <cuda_runtime.h>

#include <barrier>
#include <chrono>
#include <thread>

using namespace hygroloom;

namespace {

void advance_to(Backend& backend, double time)
{
    for (double reached = 0; reached < time;) reached = backend.advance(time);
}

bool has_gpu(benchmark::State& state)
{
    for (const BackendInfo& info : find_backends())
        if (info.name == "cuda" && info.usable) return true;
    state.SkipWithError("no GPU");
    return false;
}

/// Scenes that advance side by side, each in a thread of its own.
class SideBySide {
public:
    SideBySide(const Scene& scene, int count, double warm_up) : gate_(count + 1), until_(warm_up)
    {
        while (static_cast<int>(backends_.size()) < count) backends_.push_back(make_backend("cuda"));
        for (auto& backend : backends_)
            threads_.emplace_back([this, &backend, &scene] {
                backend->load(scene);
                for (;;) {
                    advance_to(*backend, until_);
                    gate_.arrive_and_wait(); // all are there
                    gate_.arrive_and_wait(); // what comes next is known
                    if (until_ <= 0) return;
                }
            });
        gate_.arrive_and_wait();
    }
    ~SideBySide()
    {
        go_on_to(0);
        for (std::thread& thread : threads_) thread.join();
    }
    SideBySide(const SideBySide&) = delete;
    SideBySide& operator=(const SideBySide&) = delete;

    std::size_t count() const { return backends_.size(); }
    /// Seconds until all of them are there.
    double advance(double until)
    {
        const auto start = std::chrono::steady_clock::now();
        go_on_to(until);
        gate_.arrive_and_wait();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    double mean_steps() const
    {
        double steps = 0;
        for (const auto& backend : backends_) steps += static_cast<double>(backend->liquid_steps());
        return steps / static_cast<double>(backends_.size());
    }

private:
    void go_on_to(double until)
    {
        until_ = until;
        gate_.arrive_and_wait();
    }

    std::vector<std::unique_ptr<Backend>> backends_;
    std::barrier<> gate_;
    double until_;
    std::vector<std::thread> threads_;
};

/// Arguments: particles, fall in mm (a short one has the drop on the cloth after the warm-up), scenes. The time of one step of all scenes.
void liquid_step(benchmark::State& state)
{
    if (!has_gpu(state)) return;
    const bool lies = state.range(1) < 5;
    double time = lies ? 0.03 : 0.004;
    const auto particles = static_cast<int>(state.range(0)), scenes = static_cast<int>(state.range(2));
    SideBySide drops(drop_scene(particles, static_cast<double>(state.range(1))), scenes, time);
    constexpr double burst = 3e-3; // s
    double wall = 0, steps = 0;
    for (auto _ : state) {
        const double before = drops.mean_steps(), taken = drops.advance(time += burst), done = drops.mean_steps() - before;
        state.SetIterationTime(taken / done);
        wall += taken;
        steps += done;
    }
    state.counters["particle-steps/s"] = steps * particles * static_cast<double>(drops.count()) / wall;
    state.counters["scenes"] = static_cast<double>(drops.count());
}
BENCHMARK(liquid_step)
    ->ArgNames({"particles", "fall_mm", "scenes"})
    ->Args({8000, 10, 1})
    ->Args({8000, 10, 4})
    ->Args({8000, 10, 16})
    ->Args({8000, 10, 32})
    ->Args({8000, 10, 64})
    ->Args({2000, 10, 1})
    ->Args({2000, 10, 64})
    ->Args({8000, 0, 1})
    ->Args({8000, 0, 16})
    ->Args({64000, 10, 1})
    ->Args({1000000, 10, 1})
    ->Iterations(10)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

/// What each stage of a step takes alone, in us per call and, as "times", calls per step. Arguments: particles, fall in mm.
void liquid_stages(benchmark::State& state)
{
    if (!has_gpu(state)) return;
    const double time = state.range(1) < 5 ? 0.03 : 0.004;
    const Scene scene = drop_scene(static_cast<int>(state.range(0)), static_cast<double>(state.range(1)));
    const std::unique_ptr<Backend> backend = make_backend("cuda");
    backend->time_stages();
    for (auto _ : state) {
        backend->load(scene);
        advance_to(*backend, time);
    }
    const auto steps = static_cast<double>(backend->liquid_steps()) * static_cast<double>(state.iterations());
    double sum = 0;
    for (const StageTime& stage : backend->stage_times()) {
        sum += stage.seconds;
        state.counters[stage.name] = 1e6 * stage.seconds / static_cast<double>(stage.calls);
        state.counters[stage.name + " times"] = static_cast<double>(stage.calls) / steps;
    }
    state.counters["all, us/step"] = 1e6 * sum / steps;
}
BENCHMARK(liquid_stages)->ArgNames({"particles", "fall_mm"})->Args({8000, 10})->Args({8000, 0})->Args({1000000, 10})->Iterations(1);

/// Argument: side of the sample in mm.
void network_step(benchmark::State& state, bool everything, Closure closure = Closure::paper)
{
    if (!has_gpu(state)) return;
    const Scene scene = wet_cloth(static_cast<double>(state.range(0)), everything, closure);
    const std::unique_ptr<Backend> backend = make_backend("cuda");
    backend->load(scene);
    double time = 0.1;
    advance_to(*backend, time);
    constexpr int steps = 10;
    for (auto _ : state) {
        advance_to(*backend, time += steps * wet_cloth_step);
        cudaDeviceSynchronize();
    }
    const double visits = static_cast<double>(steps) * scene.cloth.segments();
    state.counters["s/segment"] = benchmark::Counter(visits, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["least B/s"] = benchmark::Counter(visits * least_bytes(scene), benchmark::Counter::kIsIterationInvariantRate);
    std::size_t left = 0, all = 0;
    cudaMemGetInfo(&left, &all);
    state.counters["GB in use"] = static_cast<double>(all - left) * 1e-9;
}
BENCHMARK_CAPTURE(network_step, everything, true)->Arg(20)->Arg(80)->Arg(1000)->Iterations(5)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(network_step, everything_with_pores, true, Closure::pores)
    ->Arg(80)
    ->Arg(1000)
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(network_step, wicking_alone, false)->Arg(80)->Arg(1000)->Iterations(5)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Half of the bytes read, half written.
void copy(benchmark::State& state)
{
    if (!has_gpu(state)) return;
    constexpr std::size_t bytes = std::size_t(1) << 31;
    void *from = nullptr, *to = nullptr;
    if (cudaMalloc(&from, bytes) != cudaSuccess || cudaMalloc(&to, bytes) != cudaSuccess) state.SkipWithError("no memory");
    for (auto _ : state) {
        cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToDevice);
        cudaDeviceSynchronize();
    }
    cudaFree(from);
    cudaFree(to);
    state.counters["B/s"] = benchmark::Counter(2.0 * static_cast<double>(bytes), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(copy)->UseRealTime();

} // namespace
