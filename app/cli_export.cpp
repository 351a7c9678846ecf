// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// export: a piece of a fabric as a mesh for other programs.
#include "app/cli.h"

#include "core/project/mesh_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <charconv>

namespace hygroloom {
namespace {

struct ExportOptions : ProjectOptions {
    std::string detail = "yarn";
    std::string size = "5x5";
    std::string output;
    MeshOptions mesh;
};

std::array<double, 2> size_from(const std::string& text)
{
    std::array<double, 2> size{};
    const char* const end = text.data() + text.size();
    const auto [middle, failure] = std::from_chars(text.data(), end, size[0]);
    if (failure == std::errc() && middle != end && *middle == 'x') {
        const auto [last, second_failure] = std::from_chars(middle + 1, end, size[1]);
        if (second_failure == std::errc() && last == end && size[0] > 0 && size[1] > 0 && size[0] <= 2000 && size[1] <= 2000) return size;
    }
    throw Stop(exit_usage, "--size-mm: Give width x height in mm, up to 2000, as 10x5; given is \"" + text + "\".");
}

int export_mesh(const ExportOptions& options)
{
    if (options.output.ends_with(".wif") || options.output.ends_with(".WIF")) return export_wif(options, options.output);
    if (options.detail == "fibre")
        throw Stop(exit_usage, "This version exports centrelines and yarns; fibres come later. Use --detail yarn.");
    if (options.detail != "yarn" && options.detail != "centreline")
        throw Stop(exit_usage, "--detail: Must be centreline or yarn; given is \"" + options.detail + "\".");
    MeshOptions mesh = options.mesh;
    mesh.detail = options.detail == "yarn" ? MeshDetail::yarn : MeshDetail::centreline;
    const auto [width, height] = size_from(options.size);
    MeshFormat format{};
    try {
        format = mesh_format_of(options.output);
    } catch (const Error& error) {
        throw Stop(exit_usage, error.what());
    }
    const Design design = load_project(options);
    require_valid(design, options);
    const Fabric& fabric = chosen_fabric(design, options);
    const TextileRegion region = region_of_sample(fabric, width, height);
    const Textile textile = build_textile(design, fabric, region);
    const MeshFileSize size = mesh_file_size(textile, format, mesh);
    if (!options.quiet)
        fmt::print(stderr, "{} ends and {} picks, {} vertices, {} {}, about {:.1f} MB.\n", region.ends, region.picks, size.vertices,
                   size.triangles, mesh.detail == MeshDetail::yarn ? "triangles" : "pieces of line", 1e-6 * size.bytes);
    write_mesh(textile, mesh, options.output);
    if (options.json)
        fmt::print("{}\n", nlohmann::ordered_json{{"file", options.output},
                                                  {"ends", region.ends},
                                                  {"picks", region.picks},
                                                  {"vertices", size.vertices},
                                                  {"faces", size.triangles}}
                               .dump(2));
    else
        fmt::print("{}\n", options.output);
    return exit_ok;
}

} // namespace

void add_export(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<ExportOptions>();
    CLI::App& export_verb = *app.add_subcommand("export", "A piece of a fabric as a mesh (OBJ, PLY, STL in mm; GLB in metres), or its draft (WIF)");
    export_verb.footer("Example: hygroloom-cli export cloth.hygro --detail yarn --size-mm 5x5 -o cloth.obj");
    add_project_options(export_verb, *options, false);
    export_verb.add_option("--detail", options->detail, "centreline or yarn");
    export_verb.add_option("--size-mm", options->size, "Width along the weft x height along the warp");
    export_verb.add_option("--samples", options->mesh.samples_per_crossing, "Rings per crossing")->check(CLI::Range(1, 100));
    export_verb.add_option("--sides", options->mesh.sides, "Sides of a yarn")->check(CLI::Range(3, 200));
    export_verb.add_option("-o,--output", options->output, "The file; its ending says the format")->required();
    export_verb.callback([&verb, options] { verb = [options] { return export_mesh(*options); }; });
}

} // namespace hygroloom
