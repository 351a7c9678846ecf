// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is common to all formats: which can hold what, how large it gets, and the files put in place at the end.
#include "core/project/mesh_file.h"
#include "core/base/error.h"
#include "core/base/free_memory.h"
#include "core/base/text.h"
#include "core/design/weave_analysis.h"
#include "core/project/atomic_file.h"
#include "core/project/export_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>

namespace hygroloom {
namespace {

constexpr MeshFormatTraits all_formats[] = {
    {MeshFormat::obj, ".obj", "OBJ", false, true, true, true},           {MeshFormat::ply, ".ply", "PLY", false, true, true, true},
    {MeshFormat::stl, ".stl", "STL", false, false, false, true},         {MeshFormat::glb, ".glb", "GLB", false, true, true, true},
    {MeshFormat::gltf, ".gltf", "glTF", false, true, true, true},        {MeshFormat::fbx, ".fbx", "FBX", false, false, true, false},
    {MeshFormat::collada, ".dae", "Collada", false, false, true, false}, {MeshFormat::bcc, ".bcc", "BCC", true, true, false, true},
    {MeshFormat::usda, ".usda", "USD", true, true, true, true},
};
const MeshFormatTraits& traits(MeshFormat format)
{
    return *std::find_if(std::begin(all_formats), std::end(all_formats), [&](const MeshFormatTraits& f) { return f.format == format; });
}

std::string lower(std::string text)
{
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 'a' - 'A');
    return text;
}

std::string refusal(const ExportJob& job, const ExportEstimate& size, const GltfLayout& layout)
{
    const MeshFormatTraits& format = traits(job.format);
    const MeshDetail detail = job.options.mesh.detail;
    if (format.curves && detail == MeshDetail::yarn)
        return fmt::format("{} files hold curves, not yarn surfaces; choose the detail centreline or fibre.", format.name);
    if (!format.lines && detail == MeshDetail::centreline)
        return fmt::format("{} files are written with triangles only; write centrelines as .obj, .ply, .glb, .gltf, .bcc or .usda.",
                           format.name);
    if (!format.colors && job.wet())
        return fmt::format("{} files are written without colours of vertices; write a water map as .ply, .obj, .glb, .gltf, .fbx, .dae or "
                           ".usda.",
                           format.name);
    constexpr std::size_t most_vertices = std::numeric_limits<std::int32_t>::max();
    if ((job.format == MeshFormat::ply || job.format == MeshFormat::obj) && size.vertices > most_vertices)
        return fmt::format("The mesh would have {:.1f} thousand million vertices, and {} files number up to 2.1; write .gltf, or take a "
                           "smaller piece.",
                           1e-9 * static_cast<double>(size.vertices), format.name);
    if (job.format == MeshFormat::stl && size.triangles > std::numeric_limits<std::uint32_t>::max())
        return fmt::format(
            "The mesh would have {:.1f} thousand million triangles, and an STL file counts up to 4.2; write .gltf, or take a "
            "smaller piece.",
            1e-9 * static_cast<double>(size.triangles));
    if (job.format == MeshFormat::glb && size.bytes > std::numeric_limits<std::uint32_t>::max())
        return fmt::format(
            "A GLB file ends at 4 GiB (4.294 GB), and this one would have {:.3f} GB; write .gltf or .ply, or take a smaller piece.",
            1e-3 * std::ceil(1e-6 * size.bytes));
    if (job.format == MeshFormat::gltf && layout.yarn_too_large)
        return "One yarn alone would have more than the 2 GiB of a glTF buffer; write .ply, or take a smaller piece.";
    if (format.streamed && size.memory > largest_stream_memory)
        return fmt::format(
            "One yarn alone is so long and fine that the pieces in the making would take {} of memory, and at most {} are used; "
            "take fewer samples or sides, or a smaller piece.",
            bytes_text(size.memory), bytes_text(largest_stream_memory));
    if (!format.streamed && size.memory > largest_scene_memory)
        return fmt::format("The {} file would take about {} of memory while it is made, and at most {} are used. Write .obj, .ply, .stl, "
                           ".glb or .gltf, which need little, or take fewer samples or sides, or a smaller piece.",
                           format.name, bytes_text(size.memory), bytes_text(largest_scene_memory));
    return {};
}

/// FNV-1a.
std::uint32_t fingerprint(const std::string& text)
{
    std::uint32_t hash = 2166136261u;
    for (char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash;
}

/// Of the files beside the main one, without blanks and the like: an OBJ names its materials up to the first blank, and not every reader of
/// glTF decodes a URI.
std::string companion_stem(const std::string& name)
{
    constexpr std::size_t longest = 200; // bytes; a disk takes names of 255, and something follows
    std::string stem = cut_text(name, longest);
    for (char& c : stem)
        if (static_cast<unsigned char>(c) <= ' ' || std::strchr("%#?&<>\"\\", c)) c = '_';
    if (stem != name) stem += fmt::format("-{:08x}", fingerprint(name)); // "a b" and "a_b" have files of their own
    return stem;
}

/// Whose size is known within a quarter only.
bool is_text(MeshFormat format)
{
    return format != MeshFormat::ply && format != MeshFormat::stl && format != MeshFormat::glb && format != MeshFormat::gltf &&
           format != MeshFormat::bcc;
}

} // namespace

std::span<const MeshFormatTraits> mesh_formats() { return all_formats; }

MeshFormat mesh_format_of(const std::filesystem::path& path)
{
    const std::string ending = lower(path.extension().string());
    std::string known;
    for (const MeshFormatTraits& format : all_formats) {
        if (ending == format.ending) return format.format;
        known += fmt::format("{}{}", known.empty() ? "" : &format == std::end(all_formats) - 1 ? " or " : ", ", format.ending);
    }
    throw Error("A mesh or curves are written as " + known + "; \"" + path.filename().string() + "\" ends otherwise.");
}

TextileRegion region_of_repeats(const Fabric& fabric, int across, int along)
{
    const Weave weave = reduced(fabric.weave);
    const auto threads = [](int repeat, const std::vector<YarnRun>& order, int count) {
        long period = 0;
        for (const YarnRun& run : order) period += run.count;
        return std::lcm(static_cast<long>(repeat), std::max(period, 1L)) * count;
    };
    const long ends = threads(weave.ends(), fabric.warp_order, across), picks = threads(weave.picks(), fabric.weft_order, along);
    if (ends > largest_yarn_order || picks > largest_yarn_order)
        throw Error(
            fmt::format("These repeats have {} ends and {} picks; at most {} of each are exported. Take fewer repeats, or give a size.",
                        ends, picks, largest_yarn_order));
    return {0, 0, static_cast<int>(ends), static_cast<int>(picks)};
}

Color water_color(double saturation)
{
    constexpr Color stops[] = {undyed, {181, 212, 238}, {104, 165, 217}, {40, 106, 182}, {8, 42, 108}};
    const double at = (saturation >= 0 ? std::min(saturation, 1.0) : 0.0) * 4; // not a number is dry
    const auto low = std::min(static_cast<std::size_t>(at), std::size_t(3));
    const auto mix = [&](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(a + (b - a) * (at - static_cast<double>(low))));
    };
    const Color &a = stops[low], &b = stops[low + 1];
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

double linear_light(std::uint8_t value)
{
    const double s = value / 255.0; // IEC 61966-2-1
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

ExportJob export_job(const Textile& textile, const Fabric& fabric, const ExportOptions& options, MeshFormat format)
{
    ExportJob job{textile, options, format, {}, {}, {}, {}, nullptr};
    if (!options.saturation.empty()) {
        if (options.saturation.size() != static_cast<std::size_t>(textile.segments()))
            throw Error(fmt::format("The water map has {} segments, the textile {}.", options.saturation.size(), textile.segments()));
        for (float saturation : options.saturation) job.water.push_back(water_color(static_cast<double>(saturation)));
        job.materials.push_back({"water", {255, 255, 255}});
        job.material_of_yarn.assign(static_cast<std::size_t>(textile.ends() + textile.picks()), 0);
        return job;
    }
    std::map<std::string, int> known;
    for_each_yarn(textile, [&](YarnKind kind, int yarn) {
        const int number = textile.yarn_number(kind, yarn);
        const bool warp = kind == YarnKind::warp;
        const std::string name = number > 0 ? fmt::format("extra_{}", number) : warp ? "warp" : "weft";
        const auto [place, fresh] = known.emplace(name, static_cast<int>(job.materials.size()));
        if (fresh) job.materials.push_back({name, yarn_in(fabric, warp, number).color.value_or(undyed)});
        job.material_of_yarn.push_back(place->second);
    });
    return job;
}

void tell(const ExportJob& job, double share)
{
    if (job.progress && *job.progress && !(*job.progress)(std::min(share, 1.0))) throw Cancelled();
}

int ExportJob::segment_of_point(YarnKind kind, int yarn, std::size_t point) const
{
    const bool warp = kind == YarnKind::warp;
    const int crossings = warp ? textile.picks() : textile.ends();
    const int at = std::min(static_cast<int>(point / static_cast<std::size_t>(options.mesh.samples_per_crossing)), crossings - 1);
    return warp ? textile.segment(kind, yarn, at) : textile.segment(kind, at, yarn);
}

void for_each_piece(const ExportJob& job, const std::function<void(const YarnMesh&)>& take)
{
    const auto all = static_cast<double>(stream_size(job.textile, job.options.mesh).vertices);
    double done = 0;
    const auto took = [&](const YarnMesh& piece) {
        take(piece);
        done += static_cast<double>(piece.segment_of_vertex.size());
        tell(job, done / all);
    };
    tell(job, 0);
    if (!job.lines()) {
        stream_mesh(job.textile, job.options.mesh, [&](const YarnMesh& piece) {
            took(piece);
            return true;
        });
        return;
    }
    for_each_yarn(job.textile, [&](YarnKind kind, int yarn) {
        YarnMesh piece;
        MiddleLine line = yarn_line(job.textile, kind, yarn, job.options.mesh.samples_per_crossing);
        piece.positions = std::move(line.positions);
        const std::size_t points = piece.positions.size() / 3;
        for (std::size_t i = 0; i < points; ++i) piece.segment_of_vertex.push_back(job.segment_of_point(kind, yarn, i));
        piece.groups.push_back({std::move(line.name), kind, yarn, 0, points, 0, 0});
        took(piece);
    });
}

ExportEstimate export_estimate(const Textile& textile, const Fabric& fabric, const ExportOptions& options, MeshFormat format)
{
    const ExportJob job = export_job(textile, fabric, options, format);
    ExportEstimate size;
    if (format == MeshFormat::obj && !job.wet()) size.files = 2;
    size.yarns = static_cast<std::size_t>(textile.ends() + textile.picks());
    if (static_cast<double>(textile.ends()) * textile.picks() > most_crossings) {
        size.refusal = fmt::format("The piece has {} x {} crossings; at most {:.0f} million are exported. Take a smaller piece.",
                                   textile.ends(), textile.picks(), 1e-6 * most_crossings);
        return size;
    }
    if (job.lines() || traits(format).curves) {
        for_each_yarn(textile, [&](YarnKind kind, int yarn) {
            const CurveCount count = curve_count(job, kind, yarn);
            size.curves += count.curves;
            size.vertices += count.points;
        });
    } else {
        const MeshSize mesh = stream_size(textile, options.mesh);
        size.vertices = mesh.vertices;
        size.triangles = mesh.triangles;
        if (traits(format).streamed) size.memory = stream_memory(textile, options.mesh);
    }
    GltfLayout layout;
    switch (format) {
    case MeshFormat::obj: size.bytes = obj_bytes(job, size); break;
    case MeshFormat::ply: size.bytes = ply_bytes(job, size); break;
    case MeshFormat::stl: size.bytes = stl_bytes(size); break;
    case MeshFormat::glb:
    case MeshFormat::gltf: {
        layout = gltf_layout(job);
        if (format == MeshFormat::gltf) size.files = 1 + layout.buffers.size();
        for (std::uint64_t buffer : layout.buffers) size.bytes += static_cast<double>(buffer);
        const bool glb = format == MeshFormat::glb;
        std::vector<std::string> names;
        if (!glb)
            for (std::size_t i = 0; i < layout.buffers.size(); ++i) names.push_back("cloth.bin");
        const std::size_t json = gltf_json(job, layout, names).size();
        size.bytes += static_cast<double>(glb ? glb_overhead + (json + 3) / 4 * 4 : json);
        break;
    }
    case MeshFormat::bcc: size.bytes = bcc_bytes(size); break;
    case MeshFormat::usda: size.bytes = usda_bytes(job, size); break;
    default: size.bytes = scene_bytes(job, size); size.memory = scene_memory(job, size);
    }
    size.most_bytes = is_text(format) ? 1.25 * size.bytes : size.bytes;
    size.refusal = refusal(job, size, layout);
    return size;
}

std::vector<std::filesystem::path> files_of_export(const std::filesystem::path& path, const ExportEstimate& size)
{
    std::vector<std::filesystem::path> files{path};
    const std::string stem = companion_stem(path.stem().string());
    const std::string ending = mesh_format_of(path) == MeshFormat::gltf ? ".bin" : ".mtl";
    for (std::size_t i = 1; i < size.files; ++i)
        files.push_back(path.parent_path() / (stem + (i == 1 ? std::string() : fmt::format("-{}", i)) + ending));
    return files;
}

Exported export_textile(const Textile& textile, const Fabric& fabric, const ExportOptions& options, const std::filesystem::path& path,
                        const ExportProgress& progress)
{
    const MeshFormat format = mesh_format_of(path);
    ExportJob job = export_job(textile, fabric, options, format);
    job.shown = path.string();
    job.progress = &progress;
    const ExportEstimate size = export_estimate(textile, fabric, options, format);
    if (!size.refusal.empty()) throw Error(size.refusal);
    ask_for_memory("This export", size.memory, {false, "Take a smaller piece."});
    std::error_code failure;
    const auto space = std::filesystem::space(path.has_parent_path() ? path.parent_path() : std::filesystem::path("."), failure);
    if (!failure && size.most_bytes > static_cast<double>(space.available))
        throw FileError(fmt::format("{}: The file would have up to {}, and the disk has {} left.", path.string(),
                                    bytes_text(size.most_bytes), bytes_text(static_cast<double>(space.available))));

    Exported exported{files_of_export(path, size), 0};
    std::vector<std::filesystem::path> files(exported.files.begin() + 1, exported.files.end());
    std::vector<std::string> names;
    names.reserve(files.size());
    for (const auto& file : files) names.push_back(file.filename().string());
    files.push_back(path);
    write_files_with(files, [&](const std::vector<std::filesystem::path>& temporary) {
        const std::filesystem::path& main = temporary.back();
        switch (format) {
        case MeshFormat::obj: write_obj(job, main, names.empty() ? "" : temporary[0], names.empty() ? "" : names[0]); break;
        case MeshFormat::ply: write_ply(job, main); break;
        case MeshFormat::stl: write_stl(job, main); break;
        case MeshFormat::glb: write_glb(job, main); break;
        case MeshFormat::gltf: write_gltf(job, main, {temporary.begin(), temporary.end() - 1}, names); break;
        case MeshFormat::bcc: write_bcc(job, main); break;
        case MeshFormat::usda: write_usda(job, main); break;
        default: write_scene(job, main);
        }
        tell(job, 1);
    });
    for (const auto& file : exported.files) exported.bytes += std::filesystem::file_size(file);
    return exported;
}

} // namespace hygroloom
