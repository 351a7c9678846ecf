// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment and its wearer as a backend sees them: one cloth of all panels, and the skin under it.
#pragma once

#include "core/base/free_memory.h"
#include "core/design/design.h"
#include "core/garment/sweat_table.h"
#include "core/wear/fabric_cells.h"
#include "core/wear/garment_grid.h"

#include <optional>

namespace hygroloom {

/// What a garment's scene is made from.
struct GarmentParts {
    const Design* design = nullptr;
    const Garment* garment = nullptr;
    const WearExperiment* wear = nullptr;
    GarmentPattern pattern;
    SweatTable sweat;
    std::optional<SweatCourse> course; ///< of zones over time, where the experiment names a file of them
};
/// Reads what a worn garment is made from: its source, its wearer's table, the experiment's rates over time. base: folder of the project.
/// The design and the experiment must outlive it. Throws FileError with a sentence.
GarmentParts garment_parts(const Design& design, const WearExperiment& wear, const std::filesystem::path& base,
                           const Asked& cancelled = {});

constexpr double skin_film = 35e-6;    ///< m of liquid that stay on skin, some 35 g/m2; what comes then drips; an assumption
constexpr double contact_gap = 0.3e-3; ///< m of still air that cloth on skin still has between, by hairs and waviness; an assumption

/// A cell of the garment.
struct GarmentCell {
    int panel = 0;
    int end = 0, pick = 0;   ///< in the panel's grid; of computed cells as that lies in the cloth
    int zone = 0;            ///< of body_zones(), then of the wearer's own zones
    int crossing = 0;        ///< in the scene's cloth
    FlatPlace flat{};        ///< m
    Vec3d place{};           ///< m
    double area = 0;         ///< m2
    double skin_contact = 0; ///< W/(m2 K), from the skin to the cloth
    double capacity = 0;     ///< kg of water that its fibres, pores and room can hold beyond what they hold at rest
};

/// How finely frames, recordings and maps show a garment.
struct ShownSize {
    double side = 0;                 ///< m, of a shown cell, about; 0: as computed, or larger so that there are about 500 000 at most
    std::vector<std::string> detail; ///< panels of which every computed cell is shown
};

/// The cells that frames show: those that are computed, or squares of them.
struct ShownCells {
    std::vector<int> computed_per_cell; ///< of each panel, along an end and along a pick
    std::vector<PanelGrid> grids;       ///< of each panel
    std::vector<GarmentCell> cells; ///< areas and capacities are sums, zones those of most of the area; in order of their first crossings
};

struct GarmentScene {
    Scene scene;
    std::vector<FabricCells> fabrics; ///< that panels are cut from, each once
    std::vector<int> fabric;          ///< of each panel, its place in fabrics
    std::vector<PanelGrid> grids;     ///< of each panel, with ends and picks exchanged where its fabric is turned
    std::vector<GarmentCell> cells;   ///< as computed, in the order of the scene's panels.crossings
    ShownCells shown;
    std::string memory_is_short; ///< a sentence where a run takes much of the memory that is free; else empty
};

/// How finely, and what of the wearer acts.
struct GarmentResolution {
    Knobs knobs;
    double side = 3e-3;   ///< m, of a cell, about
    bool hangs = true;    ///< water runs down
    bool has_skin = true; ///< the inner face lies over the skin; otherwise air passes along both
    ShownSize shown = {};
    MemoryRule memory = {}; ///< asked once the number of cells is known
};

/// Bytes that a run of so many crossings takes, of the rectangle that the panels lie in: arrays of the solver, of the scene, of a frame.
double bytes_of_garment(double crossings);

/// Precondition: validate() found no error. Throws Error with a sentence where a panel has no fabric or no cell, or is not there to be
/// shown in detail; NotEnoughMemory.
GarmentScene garment_scene(const GarmentParts& parts, const GarmentResolution& resolution);

/// Which cells frames show; tells the scene which crossings each sums up. Throws Error for a panel that the garment does not have.
ShownCells show_cells(GarmentScene& garment, const GarmentPattern& pattern, const ShownSize& size);

/// Which panels lie with their picks as the cloth's ends, so that as many yarns as can be meet others of their system at seams: as the weft
/// of a body meets the warp of its sleeves. pass: share of each seam. The first panel of those that are sewn together lies as it is woven.
std::vector<bool> turned_panels(const GarmentPattern& pattern, const Garment& garment, const std::vector<double>& pass);

/// The joints of the pattern's seams between cells; pass: share of each seam.
std::vector<SeamJoint> seam_joints(const GarmentPattern& pattern, const GarmentScene& garment, const std::vector<double>& pass);

/// Of which fabric a panel is, by its cut.
const std::string& fabric_of(const PatternPanel& panel, const PanelCut& cut);

/// Share of the crowns of two cloths on each other that touch as yarns do where they cross; an assumption, for a garment's light pressure.
constexpr double touching_crowns = 0.1;
/// Joins the cells of layers that lie on each other, by the area that they share: liquid where yarns touch, vapour and heat through
/// contact_gap of still air.
void lay_on_each_other(GarmentScene& garment, const GarmentPattern& pattern);

/// Joins pieces of one system end to end where seams let them, each end to one other at most, and never to a ring. What joints are left act
/// between the pieces as they are, in groups. Fills in the cloth's chains and its seams.
void sew(Cloth& cloth, std::vector<SeamJoint> joints);

} // namespace hygroloom
