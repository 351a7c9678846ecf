// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How fast fibres of textile F are written, and the disk's own speed beside it: zeros through the same buffers, synced as an export is.
// TMPDIR says where.
#include "core/project/atomic_file.h"
#include "core/project/mesh_file.h"
#include "core/project/output_file.h"
#include "core/project/project_file.h"

#include <benchmark/benchmark.h>

#include <sys/resource.h>

using namespace hygroloom;

namespace {

std::filesystem::path place(const char* ending)
{
    return std::filesystem::temp_directory_path() / (std::string("hygroloom-bench") + ending);
}

void count(benchmark::State& state, double bytes)
{
    state.counters["MB/s"] = benchmark::Counter(1e-6 * bytes, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["MB"] = 1e-6 * bytes;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_MB"] = 1.024e-3 * static_cast<double>(usage.ru_maxrss);
}

/// Argument: side in mm.
void write(benchmark::State& state, const char* ending)
{
    static const Design design = read_project(HYGROLOOM_SOURCE_DIR "/resources/examples/textile-F.hygro");
    const Fabric& fabric = design.fabrics[0];
    const auto mm = static_cast<double>(state.range(0));
    const Textile textile = build_textile(design, fabric, region_of_sample(fabric, mm, mm));
    ExportOptions options;
    options.mesh = {MeshDetail::fibre, 8, 6, true, true, 1};
    double bytes = 0;
    for (auto _ : state) bytes = static_cast<double>(export_textile(textile, fabric, options, place(ending)).bytes);
    count(state, bytes);
    const double area = 1e4 * textile.ends() * textile.warp.pitch * textile.picks() * textile.weft.pitch;
    state.counters["s/cm2"] = benchmark::Counter(area, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    std::filesystem::remove(place(ending));
}

/// Argument: MB.
void disk(benchmark::State& state)
{
    const std::string zeros(std::size_t(4) << 20, '\0');
    const auto bytes = static_cast<std::uint64_t>(state.range(0)) * 1000000;
    for (auto _ : state)
        write_file_with(place(".zeros"), [&](const std::filesystem::path& path) {
            OutputFile file(path, path.string());
            for (std::uint64_t at = 0; at < bytes; at += zeros.size()) file.write_at(at, zeros.data(), zeros.size());
            file.close();
        });
    count(state, static_cast<double>(bytes));
    std::filesystem::remove(place(".zeros"));
}

void ply(benchmark::State& state) { write(state, ".ply"); }
void glb(benchmark::State& state) { write(state, ".glb"); }
BENCHMARK(disk)->Arg(1000)->Arg(4000)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);
BENCHMARK(ply)->Arg(20)->Arg(40)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);
BENCHMARK(glb)->Arg(20)->Arg(35)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

} // namespace
