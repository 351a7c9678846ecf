// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a study's point takes beside its run: 50 points of a drop that stands as a cap, run one by one and as a study, one thread.
#include "core/analysis/measured_run.h"
#include "core/project/project_json.h"
#include "core/study/study_run.h"
#include "core/verify/set_ups.h"
#include "tests/support/places.h"

#include <benchmark/benchmark.h>

#include <filesystem>

using namespace hygroloom;

namespace {

constexpr std::size_t points = 50;

Design design()
{
    Design design = drop_on_cotton(2, 0.001, 35);
    design.experiments[0].sample_mm = {8, 8};
    return design;
}

Study study()
{
    Study study;
    study.fidelity = Fidelity::live;
    study.points = points;
    set_knob(study.knobs, "free_liquid", "cap");
    Factor factor;
    factor.path = "fabrics[0].contact_angle_deg";
    factor.distribution.low = 20;
    factor.distribution.high = 60;
    study.factors.push_back(factor);
    return study;
}

void runs_alone(benchmark::State& state)
{
    const Design base = design();
    const Study of = study();
    const StudyPoints at = study_points(of, base);
    const auto backend = make_cpu_backend();
    RunControl control;
    RunOptions how;
    how.fidelity = Fidelity::live;
    how.knobs = of.knobs;
    how.threads = 1;
    for (auto _ : state)
        for (std::size_t point = 0; point < at.size(); ++point) {
            const Design there = with_point(of, json_from_design(base), at, point).design;
            run_and_measure(there, base.fabrics[0].name, base.experiments[0].name, how, *backend, control);
        }
    state.counters["s/point"] = benchmark::Counter(points, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void runs_of_a_study(benchmark::State& state)
{
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "hygroloom-bench-study";
    RunQueue queue;
    for (auto _ : state) {
        std::filesystem::remove_all(folder);
        run_study(design(), study(), folder, {}, queue, cpu_places(), false, {});
    }
    std::filesystem::remove_all(folder);
    state.counters["s/point"] = benchmark::Counter(points, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK(runs_alone)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(runs_of_a_study)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
