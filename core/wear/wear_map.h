// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The water map of a garment at one moment, and its files: pictures of flat panels, textures, tables, shapes with textures.
#pragma once

#include "core/analysis/map_image.h"
#include "core/wear/wear_recording.h"

#include <array>
#include <optional>

namespace hygroloom {

enum class WearScale {
    same,    ///< g/m2, the same for all fabrics
    capacity ///< share of what each fabric can hold
};

/// Where the eight colours end, g/m2 or a share: each above the one before, the first above 0. A value at an end lies in the next step; the
/// last one holds what lies above it, too.
using WearSteps = std::array<double, 8>;
WearSteps even_steps(double most);
/// Throws Error with a sentence where they do not ascend.
void require_ascending(const WearSteps& steps);
/// Which step a value lies in, from 0 to 7.
std::size_t step_of(const WearSteps& steps, double value);

struct WearMapOptions {
    int crossings = 2; ///< over which water is summed up each way; at least a cell
    WearScale scale = WearScale::same;
    double most = 0;                ///< at the scale's end, g/m2 or a share; 0: see rounded_up()
    std::optional<WearSteps> steps; ///< instead of even ones up to most
    ReaderUnits units{};            ///< of the scale bar
};

/// Value of every cell: the mean over its group of cells. g/m2, or a share.
struct WearMap {
    std::vector<double> values;
    WearSteps steps = even_steps(1);
    WearScale scale = WearScale::same;
    std::string cells; ///< "by 8 x 8 or 14 x 14 crossings"
    ReaderUnits units{};
    /// At the scale's end.
    double most() const { return steps.back(); }
};
/// Throws Error where the steps do not ascend.
WearMap wear_map(const WearLayout& layout, const WearFrame& frame, const WearMapOptions& options);

/// The eight colours, white to dark blue; red, green, blue.
std::array<std::uint8_t, 3> step_colour(std::size_t step);

/// A panel, flat, with its scale bar, grain line and legend.
Image panel_picture(const WearLayout& layout, const WearMap& map, std::size_t panel, double time);
/// A panel's colours alone, from the least to the largest flat x and y of its outline, at the pattern's scale.
Image panel_texture(const WearLayout& layout, const WearMap& map, std::size_t panel);

/// What tables of cells and files for ParaView have of each.
struct CellNumber {
    const char* name; ///< ends in its unit
    double (*of)(const GarmentCell& cell, const WearFrame& frame, std::size_t number);
    std::optional<int> decimals = {}; ///< in tables; none: six digits
};
const std::vector<CellNumber>& cell_numbers();

/// A row for each cell.
std::string wear_csv(const WearLayout& layout, const WearFrame& frame);

/// Cells as quadrilaterals in space (mm) with what they hold, each array named as the table's column; panels and zones by number, with
/// their names beside. Of each point flat_mm, its place on the flat panel. Throws FileError.
void write_cells_vtk(const WearLayout& layout, const WearFrame& frame, const std::filesystem::path& path);

/// Writes NAME.png, NAME_texture.png of each panel, cells.csv, cells.vtp, garment.obj with garment.mtl, and garment.glb to a folder that is
/// there.
/// Returns the files' names. Throws FileError.
std::vector<std::string> write_wear_map(const WearLayout& layout, const WearFrame& frame, const WearMap& map,
                                        const std::filesystem::path& folder);

} // namespace hygroloom
