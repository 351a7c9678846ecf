// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_textures.h"

#include "app/cli_bar.h"
#include "app/cli_interrupt.h"
#include "app/cli_run.h"

#include "core/project/mesh_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hygroloom {

int export_textures(const ProjectOptions& options, const TextureRequest& request, const std::string& folder)
{
    const Design design = load_project(options);
    const FittedFabrics fitted = require_valid(design, options);
    const Fabric& fabric = chosen_fabric(design, options);
    const auto place = static_cast<std::size_t>(&fabric - design.fabrics.data());
    TextureSize size;
    Textile textile;
    try {
        textile = build_textile(fabric, *fitted[place], region_of_repeats(fabric, request.across, request.along));
        size = texture_size(textile, request.dpi);
    } catch (const Error& error) {
        throw Stop(exit_usage, std::string("--textures: ") + error.what());
    }
    make_folder(folder);
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    FileBar bar(options.quiet);
    std::vector<std::string> files;
    try {
        files = write_textures(textile, fabric, request, folder, [&](double share) {
            bar.show(share);
            return !cancel;
        });
    } catch (const Cancelled&) {
        throw Stop(exit_cancelled, "Cancelled. No file was written.");
    }
    bar.clear();
    if (options.json)
        print_json(nlohmann::ordered_json{{"format", "hygroloom-textures"},
                                          {"version", 1},
                                          {"folder", folder},
                                          {"width_mm", size.width_mm},
                                          {"height_mm", size.height_mm},
                                          {"columns", size.columns},
                                          {"rows", size.rows},
                                          {"files", files}});
    else
        print_result("{}: {:.4f} x {:.4f} mm in {} x {} pixels; {} files in {}\n", fabric.name, size.width_mm, size.height_mm, size.columns,
                     size.rows, files.size(), folder);
    return exit_ok;
}

} // namespace hygroloom
