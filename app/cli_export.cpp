// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// export: a piece of a fabric as a mesh, as curves or as pictures for other programs.
#include "app/cli.h"
#include "app/cli_bar.h"
#include "app/cli_interrupt.h"
#include "app/cli_textures.h"

#include "core/base/text.h"
#include "core/project/mesh_file.h"
#include "core/run/recording.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace hygroloom {
namespace {

struct ExportVerbOptions : ProjectOptions {
    std::string detail = "yarn";
    std::string size;
    std::string repeats;
    std::string water;
    double time = -1;
    std::string output;
    int samples = 0; ///< 0: by the detail
    int sides = 0;
    bool open_ends = false;
    bool no_flyaways = false;
    bool estimate = false;
    std::uint64_t seed = 1;
    bool textures = false;
    double dpi = TextureRequest{}.dpi;
    double wet = TextureRequest{}.wet_share;
};

/// "AxB", each more than 0 and up to most.
template <typename Number> std::array<Number, 2> pair_from(const std::string& text, Number most, const char* wanted)
{
    std::array<Number, 2> pair{};
    const char* const end = text.data() + text.size();
    const auto [middle, failure] = std::from_chars(text.data(), end, pair[0]);
    if (failure == std::errc() && middle != end && *middle == 'x') {
        const auto [last, second_failure] = std::from_chars(middle + 1, end, pair[1]);
        if (second_failure == std::errc() && last == end && pair[0] > 0 && pair[1] > 0 && pair[0] <= most && pair[1] <= most) return pair;
    }
    throw Stop(exit_usage, fmt::format("{}; given is \"{}\".", wanted, text));
}

MeshDetail detail_from(const ExportVerbOptions& options)
{
    if (options.detail == "centreline") return MeshDetail::centreline;
    if (options.detail == "yarn") return MeshDetail::yarn;
    if (options.detail == "fibre") return MeshDetail::fibre;
    throw Stop(exit_usage, "--detail: This must be centreline, yarn or fibre; given is \"" + options.detail + "\".");
}

MeshRequest request_from(const ExportVerbOptions& options, const Textile& textile, MeshDetail detail)
{
    MeshRequest request = smooth_request(textile, detail);
    if (options.samples > 0) request.samples_per_crossing = options.samples;
    if (options.sides > 0) request.sides = options.sides;
    request.flyaways = !options.no_flyaways;
    request.capped = !options.open_ends;
    request.seed = options.seed;
    return request;
}

/// What is exported.
struct Piece {
    Fabric fabric;
    Textile textile;
    std::vector<float> saturation;
};

Piece wet_piece(const ExportVerbOptions& options)
{
    if (!options.size.empty() || !options.repeats.empty())
        throw Stop(exit_usage, "--water exports the simulated piece; leave out --size-mm and --repeats.");
    try {
        const Recording recording(options.water);
        if (recording.frames() == 0) throw Stop(exit_invalid, options.water + ": The recording has no frames.");
        const RunRecord& run = recording.run();
        ExportVerbOptions own = options;
        if (own.fabric.empty()) own.fabric = run.fabric;
        const Design design = load_project(own);
        require_valid(design, own);
        Piece piece{chosen_fabric(design, own), run.textile, {}};
        const auto recorded =
            std::find_if(run.design.fabrics.begin(), run.design.fabrics.end(), [&](const Fabric& f) { return f.name == run.fabric; });
        if (recorded == run.design.fabrics.end() || !(*recorded == piece.fabric))
            throw Stop(
                exit_invalid,
                fmt::format(
                    "{}: The fabric \"{}\" of the recording differs from \"{}\" of the project. Run the simulation again, or give the "
                    "project of the recording.",
                    options.water, run.fabric, piece.fabric.name));
        const Frame frame = recording.frame(frame_at(recording, options.water, options.time));
        piece.saturation = frame.saturation;
        if (!options.quiet) print_note("Water at {:.4g} s.\n", frame.time);
        if (!options.quiet && run.plan.shown_ends > 0)
            print_note("The recording shows cells; each is exported as one wide yarn in place of about {} ends or picks.\n",
                       run.textile.yarns_per_cell());
        return piece;
    } catch (const FileError& error) {
        throw Stop(exit_invalid, error.what());
    }
}

Piece dry_piece(const ExportVerbOptions& options)
{
    if (options.time >= 0) throw Stop(exit_usage, "--time is a time in a recording; give the recording with --water.");
    if (!options.size.empty() && !options.repeats.empty()) throw Stop(exit_usage, "Give either --size-mm or --repeats.");
    std::array<double, 2> size{5, 5};
    std::array<int, 2> repeats{0, 0};
    if (!options.size.empty())
        size = pair_from(options.size, 2000.0, "--size-mm: This must be width x height in mm, up to 2000, such as 10x5");
    if (!options.repeats.empty())
        repeats = pair_from(options.repeats, 100000,
                            "--repeats: This must be repeats along the weft x along the warp, up to 100000, such as 2x2");
    const Design design = load_project(options);
    const FittedFabrics fitted = require_valid(design, options);
    const Fabric& fabric = chosen_fabric(design, options);
    const auto place = static_cast<std::size_t>(&fabric - design.fabrics.data());
    TextileRegion region;
    try {
        region = repeats[0] > 0 ? region_of_repeats(fabric, repeats[0], repeats[1]) : region_of_sample(fabric, size[0], size[1]);
    } catch (const Error& error) {
        throw Stop(exit_usage, std::string("--repeats: ") + error.what());
    }
    return {fabric, build_textile(fabric, *fitted[place], region), {}};
}

/// Warns of too few samples along twisted fibres.
void warn_of_twist(const Textile& textile, const MeshRequest& mesh)
{
    const int smooth = smooth_samples(textile);
    if (mesh.samples_per_crossing < smooth)
        print_note("At this twist {} samples per crossing are too coarse; use {}.\n", mesh.samples_per_crossing, smooth);
}

std::string size_text(const Textile& textile, const ExportEstimate& size)
{
    const bool curves = size.curves > 0;
    return fmt::format("{} ends and {} picks, {} {}, {} {}, about {}.\n", textile.ends(), textile.picks(), size.vertices,
                       curves ? "points" : "vertices", curves ? size.curves : size.triangles, curves ? "curves" : "triangles",
                       bytes_text(size.bytes));
}

/// Writes the file and prints its name, or the JSON with what was written.
void write_piece(const Piece& piece, const ExportOptions& how, const ExportVerbOptions& options, nlohmann::ordered_json json)
{
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    FileBar bar(options.quiet);
    const auto progress = [&](double share) {
        bar.show(share);
        return !cancel;
    };
    Exported exported;
    try {
        exported = export_textile(piece.textile, piece.fabric, how, options.output, progress);
    } catch (const Cancelled&) {
        throw Stop(exit_cancelled, "Cancelled. No file was written.");
    }
    bar.clear();
    for (const auto& file : exported.files) {
        json["files"].push_back(file.string());
        if (!options.json) print_result("{}\n", file.string());
    }
    json["bytes"] = exported.bytes;
    json["seconds"] = bar.seconds();
    if (options.json) print_json(json);
}

int export_pictures(const ExportVerbOptions& options)
{
    const ExportVerbOptions usual;
    if (options.detail != usual.detail || !options.size.empty() || !options.water.empty() || options.time >= 0 || options.samples > 0 ||
        options.sides > 0 || options.open_ends || options.no_flyaways || options.estimate)
        throw Stop(exit_usage, "--textures takes --fabric, --dpi, --wet, --repeats and -o.");
    TextureRequest request{options.dpi, 1, 1, options.wet};
    if (!options.repeats.empty()) {
        const auto repeats = pair_from(options.repeats, 100000,
                                       "--repeats: This must be repeats along the weft x along the warp, up to 100000, such as 2x2");
        request.across = repeats[0];
        request.along = repeats[1];
    }
    return export_textures(options, request, options.output);
}

int export_piece(const ExportVerbOptions& options)
{
    if (options.textures) return export_pictures(options);
    if (CLI::detail::to_lower(std::filesystem::path(options.output).extension().string()) == ".wif") {
        if (options.estimate || !options.water.empty())
            throw Stop(exit_usage, "--estimate and --water are for meshes and curves, not for a draft (.wif).");
        return export_wif(options, options.output);
    }
    const MeshDetail detail = detail_from(options);
    MeshFormat format{};
    try {
        format = mesh_format_of(options.output);
    } catch (const Error& error) {
        throw Stop(exit_usage, std::string("-o: ") + error.what());
    }
    const Piece piece = options.water.empty() ? dry_piece(options) : wet_piece(options);
    const ExportOptions how{request_from(options, piece.textile, detail), piece.saturation};
    if (detail == MeshDetail::fibre && !options.quiet) warn_of_twist(piece.textile, how.mesh);
    const ExportEstimate size = export_estimate(piece.textile, piece.fabric, how, format);
    if (options.estimate ? !options.json : !options.quiet) (options.estimate ? write_result : write_note)(size_text(piece.textile, size));
    if (!size.refusal.empty()) throw Stop(exit_usage, "-o " + options.output + ": " + size.refusal);
    nlohmann::ordered_json json{{"format", "hygroloom-export"}, {"version", 1},
                                {"file", options.output},       {"detail", options.detail},
                                {"ends", piece.textile.ends()}, {"picks", piece.textile.picks()},
                                {"vertices", size.vertices},    {"faces", size.triangles},
                                {"curves", size.curves}};
    if (!options.estimate) {
        write_piece(piece, how, options, json);
        return exit_ok;
    }
    json["bytes"] = std::round(size.bytes);
    if (options.json) print_json(json);
    return exit_ok;
}

} // namespace

void add_export(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<ExportVerbOptions>();
    CLI::App& export_verb =
        *app.add_subcommand("export", "Write a piece of a fabric as a mesh or as curves, its draft (WIF), or its repeat as textures");
    export_verb.footer("Example: hygroloom-cli export cloth.hygro --fabric \"Textile F\" --detail yarn --size-mm 5x5 -o cloth.obj\n"
                       "Meshes: .obj .ply .stl in mm; .glb .gltf .dae in m, .fbx in cm. Curves: .bcc .usda. The draft: .wif.\n"
                       "`export cloth.hygro --textures --dpi 1200 -o FOLDER` writes one repeat as pictures that tile: colour, normals, "
                       "roughness, opacity, dry and wet, with materials for glTF and OBJ.\n"
                       "Ctrl-C leaves no file.");
    add_project_options(export_verb, *options, false);
    export_verb.add_option("--detail", options->detail, "What is drawn")->type_name("{centreline,yarn,fibre}");
    export_verb.add_option("--size-mm", options->size, "Width along the weft x height along the warp, mm; 5x5 when left out");
    export_verb.add_option("--repeats", options->repeats, "Repeats along the weft x along the warp, instead of a size");
    export_verb
        .add_option("--samples", options->samples,
                    "Rings per crossing; when left out 12 for yarns, 8 or as many as the twist needs for fibres")
        ->default_str("")
        ->check(CLI::Range(1, most_samples));
    export_verb.add_option("--sides", options->sides, "Sides of the cross-section; when left out 12 for yarns, 6 for fibres")
        ->default_str("")
        ->check(CLI::Range(3, most_sides));
    export_verb.add_flag("--open-ends", options->open_ends, "Leave the ends of yarns or fibres open");
    export_verb.add_flag("--no-flyaways", options->no_flyaways, "Leave out loops and hairs");
    export_verb.add_option("--seed", options->seed, "Seed of the random numbers of the fibres")->check(seed_validator());
    export_verb.add_option("--water", options->water, "Recording (.hygrorec) whose water colours its own piece of cloth")
        ->type_name("FILE");
    export_verb.add_option("--time", options->time, "Time in the recording, s; the end when left out")
        ->default_str("")
        ->check(time_validator());
    CLI::Option* textures =
        export_verb.add_flag("--textures", options->textures, "Write a folder of pictures of one repeat, and materials, instead of a mesh");
    export_verb.add_option("--dpi", options->dpi, "With --textures: pixels per inch")->check(CLI::Range(10.0, 20000.0))->needs(textures);
    export_verb.add_option("--wet", options->wet, "With --textures: share of the surface that water covers in the wet pictures")
        ->check(CLI::Range(0.0, 1.0))
        ->needs(textures);
    export_verb.add_flag("--estimate", options->estimate, "Print the size and write nothing");
    export_verb.add_option("-o,--output", options->output, "File to write; its ending sets the format. With --textures a folder")
        ->required()
        ->type_name("FILE");
    export_verb.callback([&verb, options] { verb = [options] { return export_piece(*options); }; });
}

} // namespace hygroloom
