// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How fast the textile is made: meshes of yarns and fibres, and the network that is simulated. Textile F of the paper.
#include "core/geometry/mesh_stream.h"
#include "core/project/project_file.h"
#include "core/run/plan_run.h"
#include "core/scene/scene.h"

#include <benchmark/benchmark.h>

using namespace hygroloom;

namespace {

const Design& textile_f()
{
    static const Design design = read_project(HYGROLOOM_SOURCE_DIR "/resources/examples/textile-F.hygro");
    return design;
}

Textile swatch(double mm)
{
    const Fabric& fabric = textile_f().fabrics[0];
    return build_textile(textile_f(), fabric, region_of_sample(fabric, mm, mm));
}

/// Argument: side in mm.
void mesh(benchmark::State& state, const MeshRequest& request)
{
    const Textile textile = swatch(static_cast<double>(state.range(0)));
    const double area = textile.ends() * textile.warp.pitch * textile.picks() * textile.weft.pitch;
    std::size_t vertices = 0, bytes = 0;
    for (auto _ : state) {
        vertices = bytes = 0;
        stream_mesh(textile, request, [&](const YarnMesh& piece) {
            vertices += piece.segment_of_vertex.size();
            bytes += 4 * (piece.positions.size() + piece.normals.size() + piece.uvs.size() + piece.segment_of_vertex.size() +
                          piece.indices.size());
            benchmark::DoNotOptimize(piece.positions.data());
            return true;
        });
    }
    state.counters["vertices/s"] = benchmark::Counter(static_cast<double>(vertices), benchmark::Counter::kIsIterationInvariantRate);
    state.counters["s/cm2"] = benchmark::Counter(1e4 * area, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["bytes/vertex"] = static_cast<double>(bytes) / static_cast<double>(vertices);
    state.counters["vertices"] = static_cast<double>(vertices);
}

void fibre_mesh(benchmark::State& state) { mesh(state, {MeshDetail::fibre, 8, 6, true, true, 1}); }
void yarn_mesh(benchmark::State& state) { mesh(state, {MeshDetail::yarn, 8, 12, true, true, 1}); }
BENCHMARK(fibre_mesh)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(yarn_mesh)->Arg(10)->Arg(40)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Fibres of what a close view shows, in one mesh.
void fibre_window(benchmark::State& state)
{
    const Textile textile = swatch(20);
    const int side = static_cast<int>(state.range(0));
    std::size_t vertices = 0;
    for (auto _ : state) {
        const YarnMesh mesh = mesh_fibres(textile, {20, 20, side, side}, {});
        vertices = mesh.segment_of_vertex.size();
        benchmark::DoNotOptimize(mesh.positions.data());
    }
    state.counters["vertices/s"] = benchmark::Counter(static_cast<double>(vertices), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(fibre_window)->Arg(4)->Arg(16)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The segments of a simulation. Argument: side in mm.
void network(benchmark::State& state)
{
    Experiment experiment = textile_f().experiments[0];
    experiment.sample_mm = {static_cast<double>(state.range(0)), static_cast<double>(state.range(0))};
    experiment.droplets.clear();
    const Fabric& fabric = textile_f().fabrics[0];
    double segments = 0, bytes = 0;
    for (auto _ : state) {
        const ModelPlan plan = plan_run(textile_f(), fabric, experiment, Fidelity::draft, {});
        const Scene scene = build_scene(textile_f(), build_textile(textile_f(), fabric, plan.region), experiment, plan, 1);
        segments = scene.cloth.segments();
        bytes = static_cast<double>(scene.cloth.length.size() * sizeof(double) + scene.cloth.shift.size() * sizeof(float) +
                                    scene.cloth.warp_up.size());
        benchmark::DoNotOptimize(scene.cloth.length.data());
    }
    state.counters["segments"] = segments;
    state.counters["bytes"] = bytes;
}
BENCHMARK(network)->Arg(80)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
