// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a frame costs that is recorded: of a cloth of 1568 segments beside its bytes, and of one whose frames hold changes.
#include "tests/support/crafted_recording.h"

#include <benchmark/benchmark.h>

#include <filesystem>
#include <thread>

using namespace hygroloom;

namespace {

constexpr int frames_before = 1000;

struct Place {
    std::string path = (std::filesystem::temp_directory_path() / "bench.hygrorec").string();
    ~Place() { std::filesystem::remove(path); }
};

RunRecord run_of(double side_mm)
{
    RunRecord run = small_run();
    run.design.experiments[0].sample_mm = {side_mm, side_mm};
    run.plan.region = region_of_sample(run.design.fabrics[0], side_mm, side_mm);
    run.textile = build_textile(run.design, run.design.fabrics[0], run.plan.region);
    return run;
}

Frame moved(Frame frame, int number)
{
    frame.time = frame.ledger.time = 0.1 * number;
    frame.saturation[static_cast<std::size_t>(number) % frame.saturation.size()] += 0.25F;
    return frame;
}

/// One at a time, behind a thousand others: each takes effect by itself.
void alone(benchmark::State& state)
{
    const RunRecord run = run_of(static_cast<double>(state.range(0)));
    const Place place;
    RecordingWriter writer(place.path, run);
    const Frame frame = small_frame(run, 0);
    int number = 0;
    for (; number < frames_before; ++number) writer.append(moved(frame, number));
    for (auto _ : state) {
        std::this_thread::sleep_for(std::chrono::milliseconds(210));
        const auto begin = std::chrono::steady_clock::now();
        writer.append(moved(frame, number++));
        state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    writer.finish(1);
    state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(place.path)) / number;
}
BENCHMARK(alone)->Arg(1)->Arg(8)->Arg(40)->UseManualTime()->Iterations(25)->Unit(benchmark::kMillisecond);

/// As quickly as they are taken.
void burst(benchmark::State& state)
{
    const RunRecord run = run_of(static_cast<double>(state.range(0)));
    const Place place;
    RecordingWriter writer(place.path, run);
    const Frame frame = small_frame(run, 0);
    int number = 0;
    for (auto _ : state) writer.append(moved(frame, number++));
    writer.finish(1);
    state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(place.path)) / number;
}
BENCHMARK(burst)->Arg(1)->Arg(8)->Arg(40)->Iterations(1000)->Unit(benchmark::kMillisecond);

} // namespace
