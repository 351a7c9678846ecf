// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/garment_scene.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/design/wear.h"
#include "core/physics/air.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace hygroloom {
namespace {

constexpr std::size_t most_kinds = 255; ///< of yarns, airs and panels

/// Whether no other layer lies between a panel and the skin.
bool is_innermost(const GarmentPattern& pattern, std::size_t panel)
{
    return std::none_of(pattern.panels.begin(), pattern.panels.end(),
                        [&](const PatternPanel& other) { return other.over == static_cast<int>(panel); });
}

struct Builder {
    const GarmentParts& parts;
    const GarmentResolution& resolution;
    GarmentScene made;
    std::vector<std::size_t> first_warp, first_weft; ///< of each fabric's types in the cloth's
    std::size_t weft_types = 0;
    std::map<std::pair<std::string, bool>, int> known; ///< by fabric and whether it is turned, its place in made.fabrics
    /// By fabric, gap, zone where the skin's warmth changes, and whether it lies outermost and innermost.
    std::map<std::tuple<int, double, int, bool, bool>, std::uint8_t> air;

    Cloth& cloth() { return made.scene.cloth; }
    std::size_t warp(int end, int pick) const
    {
        return static_cast<std::size_t>(made.scene.cloth.picks) * static_cast<std::size_t>(end) + static_cast<std::size_t>(pick);
    }
    std::size_t weft(int end, int pick) const
    {
        const Cloth& c = made.scene.cloth;
        return static_cast<std::size_t>(c.crossings()) + static_cast<std::size_t>(c.ends) * static_cast<std::size_t>(pick) +
               static_cast<std::size_t>(end);
    }
    const FabricCells& fabric_of(std::size_t panel) const { return made.fabrics[static_cast<std::size_t>(made.fabric[panel])]; }
};

/// Which seam passes how much.
std::vector<double> passes(const GarmentParts& parts)
{
    std::vector<double> pass;
    for (const PatternSeam& seam : parts.pattern.seams)
        pass.push_back(parts.garment->seam_between(parts.pattern.panels[static_cast<std::size_t>(seam.panel_a)].cut(),
                                                   parts.pattern.panels[static_cast<std::size_t>(seam.panel_b)].cut()));
    return pass;
}

/// The place of a fabric's cells in the scene, which are made where they are not there yet.
int cells_of(Builder& b, const std::string& name, bool is_turned)
{
    const auto [at, is_new] = b.known.try_emplace({name, is_turned}, 0);
    if (!is_new) return at->second;
    const Fabric* fabric = find_fabric(*b.parts.design, name);
    FabricCells cells = is_turned ? turned(b.made.fabrics[static_cast<std::size_t>(cells_of(b, name, false))])
                                  : fabric_cells(*b.parts.design, *fabric, *b.parts.wear, b.resolution.knobs, b.resolution.side);
    b.made.fabrics.push_back(std::move(cells));
    return at->second = static_cast<int>(b.made.fabrics.size()) - 1;
}

void cut_panels(Builder& b, const std::vector<bool>& is_turned)
{
    const std::vector<PatternPanel>& panels = b.parts.pattern.panels;
    if (panels.size() > most_kinds) throw Error("A garment of more than 255 panels cannot be computed.");
    for (const PatternPanel& panel : panels) {
        const PanelCut* cut = b.parts.garment->cut_of(panel.cut());
        if (cut == nullptr || find_fabric(*b.parts.design, fabric_of(panel, *cut)) == nullptr)
            throw Error("The panel \"" + panel.name + "\" of the garment \"" + b.parts.garment->name +
                        "\" has no fabric; name it or \"*\" in its panels.");
        const bool turn = is_turned[b.made.grids.size()];
        b.made.fabric.push_back(cells_of(b, fabric_of(panel, *cut), turn));
        const FabricCells& cells = b.made.fabrics[static_cast<std::size_t>(b.made.fabric.back())];
        const double end_pitch = turn ? cells.pick_pitch : cells.end_pitch, pick_pitch = turn ? cells.end_pitch : cells.pick_pitch;
        PanelGrid grid = panel_grid(panel, radian_from_degree(cut->grain_deg), end_pitch, pick_pitch);
        if (turn) grid = turned(grid);
        if (std::count(grid.there.begin(), grid.there.end(), 1) == 0)
            throw Error("The panel \"" + panel.name + "\" is smaller than a cell; take smaller cells.");
        grid.first_pick = b.cloth().picks;
        b.cloth().picks += grid.picks;
        b.cloth().ends = std::max(b.cloth().ends, grid.ends);
        b.made.grids.push_back(std::move(grid));
    }
}

/// All fabrics' types of yarn, and how they cross; those of two fabrics never do.
void add_types(Builder& b)
{
    Cloth& cloth = b.cloth();
    cloth.warp_types = 0;
    for (bool is_warp : {true, false})
        for (const FabricCells& fabric : b.made.fabrics) {
            const Cloth& tile = fabric.tile.cloth;
            const auto begin = tile.yarns.begin(), middle = begin + tile.warp_types;
            (is_warp ? b.first_warp : b.first_weft).push_back(cloth.yarns.size());
            cloth.yarns.insert(cloth.yarns.end(), is_warp ? begin : middle, is_warp ? middle : tile.yarns.end());
            if (is_warp) cloth.warp_types += tile.warp_types;
        }
    if (cloth.yarns.size() > most_kinds) throw Error("A garment of more than 255 types of yarn cannot be computed.");
    b.weft_types = cloth.yarns.size() - static_cast<std::size_t>(cloth.warp_types);
    cloth.crossing.resize(static_cast<std::size_t>(cloth.warp_types) * b.weft_types);
    for (std::size_t f = 0; f < b.made.fabrics.size(); ++f) {
        const Cloth& tile = b.made.fabrics[f].tile.cloth;
        const auto wefts = static_cast<std::size_t>(tile.weft_types());
        for (std::size_t i = 0; i < tile.crossing.size(); ++i)
            cloth.crossing[(b.first_warp[f] + i / wefts) * b.weft_types + b.first_weft[f] - static_cast<std::size_t>(cloth.warp_types) +
                           i % wefts] = tile.crossing[i];
    }
}

std::uint8_t type_in_cloth(const Builder& b, std::size_t fabric, bool is_warp, int line)
{
    const Cloth& tile = b.made.fabrics[fabric].tile.cloth;
    const std::size_t own = tile.type[static_cast<std::size_t>(is_warp ? line : tile.ends + line)];
    return static_cast<std::uint8_t>(is_warp ? b.first_warp[fabric] + own
                                             : b.first_weft[fabric] + own - static_cast<std::size_t>(tile.warp_types));
}

/// What every crossing of a panel's rectangle is like, whether it is there or not.
void fill_panel(Builder& b, std::size_t panel)
{
    const PanelGrid& grid = b.made.grids[panel];
    const FabricCells& fabric = b.fabric_of(panel);
    const auto number = static_cast<std::size_t>(b.made.fabric[panel]);
    Cloth& cloth = b.cloth();
    const Cloth& tile = fabric.tile.cloth;
    for (int end = 0; end < cloth.ends; ++end) {
        cloth.type[panel * static_cast<std::size_t>(cloth.ends) + static_cast<std::size_t>(end)] =
            type_in_cloth(b, number, true, end % fabric.ends);
        for (int pick = 0; pick < grid.picks; ++pick) {
            const std::size_t warp = b.warp(end, grid.first_pick + pick), weft = b.weft(end, grid.first_pick + pick);
            const std::size_t from = fabric.crossing(end, pick), from_weft = fabric.weft(end, pick);
            cloth.length[warp] = tile.length[from];
            cloth.length[weft] = tile.length[from_weft];
            cloth.warp_up[warp] = tile.warp_up[from];
            if (!cloth.warp_up_share.empty())
                cloth.warp_up_share[warp] = tile.warp_up_share.empty() ? static_cast<float>(tile.warp_up[from]) : tile.warp_up_share[from];
            if (tile.touching.empty()) continue;
            if (grid.has(end, pick) && grid.has(end + 1, pick)) cloth.touching[warp] = tile.touching[from];
            if (grid.has(end, pick) && grid.has(end, pick + 1)) cloth.touching[weft] = tile.touching[from_weft];
        }
    }
    const std::size_t picks_from = b.made.grids.size() * static_cast<std::size_t>(cloth.ends);
    auto row = static_cast<std::size_t>(grid.first_pick);
    for (int pick = 0; pick < grid.picks; ++pick, ++row) {
        cloth.type[picks_from + row] = type_in_cloth(b, number, false, pick % fabric.picks);
        cloth.panels.panel[row] = static_cast<std::uint8_t>(panel);
    }
}

/// Pieces of yarns: where the outline begins and ends along each.
void add_pieces(Builder& b)
{
    ClothPanels& panels = b.cloth().panels;
    const auto add = [&](std::size_t first, int count, const auto& there) {
        for (int i = 0; i < count; ++i) {
            if (!there(i)) continue;
            panels.first.push_back(static_cast<int>(first) + i);
            while (i < count && there(i)) ++i;
            panels.last.push_back(static_cast<int>(first) + i);
        }
    };
    for (int end = 0; end < b.cloth().ends; ++end)
        for (const PanelGrid& grid : b.made.grids)
            add(b.warp(end, grid.first_pick), grid.picks, [&](int pick) { return grid.has(end, pick); });
    panels.warp_pieces = static_cast<int>(panels.first.size());
    for (const PanelGrid& grid : b.made.grids)
        for (int pick = 0; pick < grid.picks; ++pick)
            add(b.weft(0, grid.first_pick + pick), grid.ends, [&](int end) { return grid.has(end, pick); });
}

/// W/(m2 K), through a gap of still air, mm.
double skin_contact(double gap) { return air_conductivity / (metre_from_mm(gap) + contact_gap); }

/// Whether zones have a warmth of their own over time.
bool warmth_changes(const Builder& b) { return b.resolution.has_skin && b.parts.course && b.parts.course->has_temperature; }

/// Air over the outer face, and the skin beyond the gap, or the layers there (layer_joints()). The skin's face lets no vapour through: it
/// sweats liquid, and what it holds lies wet under the cloth. Each of a crossing's two segments answers for half of both faces.
std::uint8_t air_over(Builder& b, std::size_t panel, double gap, int zone)
{
    const int fabric = b.made.fabric[panel];
    const bool outermost = b.parts.pattern.panels[panel].over < 0, innermost = is_innermost(b.parts.pattern, panel);
    const auto [at, is_new] = b.air.try_emplace({fabric, gap, warmth_changes(b) ? zone : 0, outermost, innermost},
                                                static_cast<std::uint8_t>(b.cloth().panels.airs.size()));
    if (!is_new) return at->second;
    std::vector<FaceAir>& airs = b.cloth().panels.airs;
    if (airs.size() >= most_kinds) throw Error("A garment with more than 255 kinds of air at its cloth cannot be computed.");
    const SceneClimate& outside = b.fabric_of(panel).tile.climate;
    const double open = outermost ? 1 : 0; // of the outer face
    if (!b.resolution.has_skin) {
        const double faces = 0.5 * (open + (innermost ? 1 : 0));
        airs.push_back({outside.air_warmth, outside.vapour, faces * outside.heat_transfer, faces * outside.mass_transfer});
        return at->second;
    }
    if (!innermost) {
        airs.push_back({outside.air_warmth, outside.vapour, 0.5 * open * outside.heat_transfer, 0.5 * open * outside.mass_transfer});
        return at->second;
    }
    const double to_skin = skin_contact(gap);
    const double skin_warmth = kelvin_from_celsius(b.parts.garment->wearer.skin_temperature_c) - outside.temperature;
    const SkinAir mixed{static_cast<std::size_t>(zone), open * outside.heat_transfer, outside.air_warmth, to_skin};
    airs.push_back(
        {mixed.warmth(skin_warmth), outside.vapour, 0.5 * (open * outside.heat_transfer + to_skin), 0.5 * open * outside.mass_transfer});
    if (warmth_changes(b)) b.made.scene.supply.skin.airs.push_back(mixed);
    return at->second;
}

double capacity_of(const Builder& b, std::size_t panel, int end, int pick)
{
    const FabricCells& fabric = b.fabric_of(panel);
    const Cloth& tile = fabric.tile.cloth;
    const SceneClimate& climate = fabric.tile.climate;
    const auto type = [&](bool is_warp) {
        const int line = is_warp ? end % fabric.ends : tile.ends + pick % fabric.picks;
        return static_cast<std::size_t>(tile.type[static_cast<std::size_t>(line)]);
    };
    const auto of_yarn = [&](const YarnParameters& yarn, double length) {
        const double bound = std::max(0.0, yarn.isotherm.saturation_regain - yarn.initial_regain);
        return length * (climate.density * yarn.pore_area + bound * yarn.fibre_area * yarn.fibre_density);
    };
    const std::size_t warp = type(true), weft = type(false);
    const CrossingParameters& crossing =
        tile.crossing[warp * static_cast<std::size_t>(tile.weft_types()) + weft - static_cast<std::size_t>(tile.warp_types)];
    return of_yarn(tile.yarns[warp], tile.length[fabric.warp(end, pick)]) + of_yarn(tile.yarns[weft], tile.length[fabric.weft(end, pick)]) +
           climate.density * crossing.between.volume;
}

/// m/s of liquid.
double skin_rate(const Builder& b, double g_m2_h) { return 1e-3 * g_m2_h / 3600.0 / b.made.scene.climate.density; }

/// g/m2h of a zone at the factor 1: of the body by its table, of the wearer's own as it says.
double usual_rate(const Builder& b, std::size_t zone)
{
    const std::size_t of_body = body_zones().size();
    return zone < of_body ? b.parts.sweat.g_m2_h[zone] : b.parts.garment->wearer.own_zones[zone - of_body].sweat_g_m2_h;
}

/// How each zone sweats over time; those that the file does not name as their table, or they themselves, say.
void add_course(Builder& b)
{
    const GarmentParts& parts = b.parts;
    if (!parts.wear->activity_file.empty() && !parts.course)
        throw Error("The rates over time of \"" + parts.wear->name + "\" (" + parts.wear->activity_file + ") were not read.");
    if (!parts.course) return;
    SkinSupply& skin = b.made.scene.supply.skin;
    const double usual = kelvin_from_celsius(parts.garment->wearer.skin_temperature_c), from = b.made.scene.climate.temperature;
    for (std::size_t zone = 0; zone < body_zones().size() + parts.garment->wearer.own_zones.size(); ++zone) {
        std::vector<SkinMoment>& moments = skin.zones.emplace_back();
        const bool is_known = zone < parts.course->zones.size();
        for (const SweatMomentOfZone& moment : is_known ? parts.course->zones[zone] : std::vector<SweatMomentOfZone>{})
            moments.push_back({moment.time_s, skin_rate(b, moment.g_m2_h),
                               (parts.course->has_temperature ? kelvin_from_celsius(moment.skin_temperature_c) : usual) - from});
        if (moments.empty()) moments.push_back({0, skin_rate(b, usual_rate(b, zone)), usual - from});
    }
    skin.zone.assign(static_cast<std::size_t>(b.cloth().crossings()), static_cast<std::uint8_t>(skin.zones.size()));
    for (const GarmentCell& cell : b.made.cells)
        if (is_innermost(b.parts.pattern, static_cast<std::size_t>(cell.panel)))
            skin.zone[static_cast<std::size_t>(cell.crossing)] = static_cast<std::uint8_t>(cell.zone);
    skin.rate = skin.rates_at(0);
    if (!skin.airs.empty()) b.cloth().panels.airs = skin.airs_at(std::move(b.cloth().panels.airs), 0);
}

/// The cells that are there, with what the body under each does.
void add_cells(Builder& b, const std::vector<std::vector<Vec3d>>& places)
{
    Scene& scene = b.made.scene;
    for (std::size_t panel = 0; panel < b.made.grids.size(); ++panel) {
        const PanelGrid& grid = b.made.grids[panel];
        for (int end = 0; end < grid.ends; ++end)
            for (int pick = 0; pick < grid.picks; ++pick) {
                if (!grid.has(end, pick)) continue;
                GarmentCell cell{static_cast<int>(panel), end, pick};
                cell.place = places[panel][grid.cell(end, pick)];
                cell.crossing = static_cast<int>(b.warp(end, grid.first_pick + pick));
                cell.flat = grid.middle(end, pick);
                cell.zone = zone_at(*b.parts.garment, b.parts.pattern, cell.panel, cell.place, cell.flat);
                cell.area = b.fabric_of(panel).cell_area();
                cell.capacity = capacity_of(b, panel, end, pick);
                b.made.cells.push_back(cell);
            }
    }
    std::sort(b.made.cells.begin(), b.made.cells.end(), [](const GarmentCell& a, const GarmentCell& c) { return a.crossing < c.crossing; });
    scene.cloth.panels.air.assign(static_cast<std::size_t>(scene.cloth.crossings()), 0);
    scene.supply.skin.rate.assign(static_cast<std::size_t>(scene.cloth.crossings()), 0);
    for (GarmentCell& cell : b.made.cells) {
        const auto crossing = static_cast<std::size_t>(cell.crossing), zone = static_cast<std::size_t>(cell.zone);
        scene.cloth.panels.crossings.push_back(cell.crossing);
        const double gap = gap_at(*b.parts.garment, b.parts.pattern, cell.panel, cell.place);
        const bool on_skin = is_innermost(b.parts.pattern, static_cast<std::size_t>(cell.panel));
        if (b.resolution.has_skin && on_skin) cell.skin_contact = skin_contact(gap);
        scene.cloth.panels.air[crossing] = air_over(b, static_cast<std::size_t>(cell.panel), gap, cell.zone);
        if (on_skin) scene.supply.skin.rate[crossing] = skin_rate(b, usual_rate(b, zone));
    }
    for (const Activity& activity : b.parts.wear->activity) scene.supply.skin.course.push_back({activity.time_s, activity.factor});
    scene.supply.skin.holds = skin_film;
    add_course(b);
}

/// What is drawn too small for computed cells would sweat as the body, for shown ones it would be missing, without a word.
void require_own_zones(const Builder& b, const std::vector<GarmentCell>& cells, const char* remedy)
{
    const std::vector<OwnZone>& own = b.parts.garment->wearer.own_zones;
    std::vector<bool> is_covered(own.size());
    for (const GarmentCell& cell : cells)
        if (static_cast<std::size_t>(cell.zone) >= body_zones().size())
            is_covered[static_cast<std::size_t>(cell.zone) - body_zones().size()] = true;
    for (std::size_t k = 0; k < own.size(); ++k) {
        const auto& panels = b.parts.pattern.panels;
        if (std::none_of(panels.begin(), panels.end(), [&](const PatternPanel& panel) { return panel.name == own[k].panel; }))
            throw Error("The garment \"" + b.parts.garment->name + "\" has no panel \"" + own[k].panel + "\", on which the zone \"" +
                        own[k].name + "\" lies.");
        if (!is_covered[k])
            throw Error("The zone \"" + own[k].name + "\" of the garment \"" + b.parts.garment->name +
                        "\" holds the middle of no cell of the panel \"" + own[k].panel + "\", or lies under a later zone; " + remedy +
                        ", or change its outline.");
    }
}

/// By how much the next cell along each yarn lies higher.
void add_rises(Builder& b, const std::vector<std::vector<Vec3d>>& places)
{
    b.cloth().panels.rise.assign(static_cast<std::size_t>(b.cloth().segments()), 0);
    if (!b.resolution.hangs) return;
    for (std::size_t panel = 0; panel < b.made.grids.size(); ++panel) {
        const PanelGrid& grid = b.made.grids[panel];
        for (int end = 0; end < grid.ends; ++end)
            for (int pick = 0; pick < grid.picks; ++pick) {
                const auto height = [&](int e, int p) { return places[panel][grid.cell(e, p)].y; };
                const auto rise = [&](int e, int p) {
                    return grid.has(end, pick) && grid.has(e, p) ? static_cast<float>(height(e, p) - height(end, pick)) : 0.0F;
                };
                b.cloth().panels.rise[b.warp(end, grid.first_pick + pick)] = rise(end, pick + 1);
                b.cloth().panels.rise[b.weft(end, grid.first_pick + pick)] = rise(end + 1, pick);
            }
    }
}

/// Water that pores hold at the start, all of a cell alike.
void wet(Builder& b)
{
    const double per_area = 1e-3 * b.parts.wear->initial_water_g_m2;
    if (per_area <= 0) return;
    Cloth& cloth = b.cloth();
    cloth.start.liquid.assign(static_cast<std::size_t>(cloth.segments()), 0);
    for (const GarmentCell& cell : b.made.cells) {
        const PanelGrid& grid = b.made.grids[static_cast<std::size_t>(cell.panel)];
        const std::size_t warp = b.warp(cell.end, grid.first_pick + cell.pick), weft = b.weft(cell.end, grid.first_pick + cell.pick);
        const std::size_t panel = static_cast<std::size_t>(cell.panel) * static_cast<std::size_t>(cloth.ends);
        const auto pores = [&](std::size_t segment, std::size_t line) {
            return cloth.yarns[cloth.type[line]].pore_area * cloth.length[segment];
        };
        const double own = pores(warp, panel + static_cast<std::size_t>(cell.end)),
                     crossed = pores(weft, b.made.grids.size() * static_cast<std::size_t>(cloth.ends) +
                                               static_cast<std::size_t>(grid.first_pick + cell.pick));
        const double share = std::min(1.0, per_area * cell.area / (b.made.scene.climate.density * (own + crossed)));
        cloth.start.liquid[warp] = share * own * b.made.scene.climate.density;
        cloth.start.liquid[weft] = share * crossed * b.made.scene.climate.density;
    }
}

} // namespace

GarmentParts garment_parts(const Design& design, const WearExperiment& wear, const std::filesystem::path& base, const Asked& cancelled)
{
    GarmentParts parts;
    parts.design = &design;
    parts.garment = find_garment(design, wear.garment);
    parts.wear = &wear;
    if (parts.garment == nullptr) throw Error("There is no garment named \"" + wear.garment + "\" in the project.");
    parts.pattern = read_pattern(*parts.garment, base, cancelled);
    add_layers(parts.pattern, *parts.garment);
    parts.sweat = sweat_table(parts.garment->wearer.zones, base);
    if (!wear.activity_file.empty()) parts.course = sweat_course(wear.activity_file, base, parts.garment->wearer.own_zones);
    return parts;
}

double bytes_of_garment(double crossings)
{
    constexpr double bytes_per_crossing = 1800; // with what is kept aside for frames
    return bytes_per_crossing * crossings;
}

GarmentScene garment_scene(const GarmentParts& parts, const GarmentResolution& resolution)
{
    Builder b{parts, resolution, {}, {}, {}, 0, {}, {}};
    const std::vector<double> pass = passes(parts);
    cut_panels(b, turned_panels(parts.pattern, *parts.garment, pass));
    Cloth& cloth = b.cloth();
    b.made.memory_is_short = ask_for_memory("This run", bytes_of_garment(cloth.crossings()), resolution.memory);
    const Scene& first = b.made.fabrics.front().tile;
    b.made.scene.climate = first.climate;
    b.made.scene.rules = first.rules;
    b.made.scene.rules.rest_tolerance = 0;
    cloth.by_suction = true;
    cloth.face_only = true;
    cloth.warp_pitch = b.made.fabrics.front().end_pitch;
    cloth.weft_pitch = b.made.fabrics.front().pick_pitch;
    const auto segments = static_cast<std::size_t>(cloth.segments()), crossings = static_cast<std::size_t>(cloth.crossings());
    cloth.length.resize(segments);
    cloth.warp_up.resize(crossings);
    const auto has = [&](auto&& what) { return std::any_of(b.made.fabrics.begin(), b.made.fabrics.end(), what); };
    if (has([](const FabricCells& f) { return !f.tile.cloth.warp_up_share.empty(); })) cloth.warp_up_share.resize(crossings);
    if (has([](const FabricCells& f) { return !f.tile.cloth.touching.empty(); })) cloth.touching.resize(segments);
    cloth.panels.count = static_cast<int>(b.made.grids.size());
    cloth.type.resize(b.made.grids.size() * static_cast<std::size_t>(cloth.ends) + static_cast<std::size_t>(cloth.picks));
    cloth.panels.panel.resize(static_cast<std::size_t>(cloth.picks));
    add_types(b);
    std::vector<std::vector<Vec3d>> places;
    for (std::size_t panel = 0; panel < b.made.grids.size(); ++panel) {
        fill_panel(b, panel);
        cloth.panels.cell_area.push_back(b.fabric_of(panel).cell_area());
        cloth.panels.skin_on_top.push_back(parts.garment->cut_of(parts.pattern.panels[panel].cut())->top_inside);
        places.push_back(places_of(b.made.grids[panel], parts.pattern.shape, static_cast<int>(panel)));
    }
    for (double& length : cloth.length)
        if (length == 0) length = cloth.warp_pitch; // outside all panels
    add_pieces(b);
    add_cells(b, places);
    require_own_zones(b, b.made.cells, "take smaller cells");
    add_rises(b, places);
    wet(b);
    sew(cloth, seam_joints(parts.pattern, b.made, pass));
    lay_on_each_other(b.made, parts.pattern);
    b.made.scene.rules.shows_segments = false;
    b.made.shown = show_cells(b.made, parts.pattern, resolution.shown);
    if (!b.made.shown.cells.empty()) require_own_zones(b, b.made.shown.cells, "show smaller cells");
    return std::move(b.made);
}

} // namespace hygroloom
