// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/stock.h"

#include "core/solver/steps/yarn_lines.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace hygroloom::inline HL_PRECISION {
namespace {

double sum_of_all(std::span<const double> values)
{
    long double total = 0;
    for (double v : values) total += v;
    return static_cast<double>(total);
}

double sum_of_visited(const Yarns& yarns, std::span<const double> values)
{
    long double total = 0;
    for (int line = 0; line < yarns.visited_lines(); ++line) {
        const YarnLine l = yarns.visited_line(line);
        for (int i = l.first; i < l.last; ++i) total += values[static_cast<std::size_t>(i)];
    }
    return static_cast<double>(total);
}

void show_particles(const Stock& stock, const Scene& scene, Frame& f)
{
    const auto &x = stock.particles.position, &v = stock.particles.velocity;
    for (std::size_t i = 0; i < stock.particles.alive.size(); ++i) {
        if (!stock.particles.alive[i]) continue;
        f.positions.push_back({static_cast<float>(x[i].x), static_cast<float>(x[i].y), static_cast<float>(x[i].z)});
        f.velocities.push_back({static_cast<float>(v[i].x), static_cast<float>(v[i].y), static_cast<float>(v[i].z)});
        if (scene.rules.shows_pressure)
            f.pressures.push_back(stock.stressed > 0 ? static_cast<float>(static_cast<double>(stock.stress[i]) / stock.stressed) : 0.0F);
    }
}

/// One segment as formulas of frame fields see it. SI.
struct SegmentNow {
    const Scene& scene;
    double fibres; ///< kg, dry
    double liquid, bound, pores, vapour, temperature;
    double between; ///< kg of the liquid between the yarns of its crossing that clings to this one
};

/// kg; rounding leaves some 1e-17 of what a segment can hold below nothing where a whole yarn runs dry.
double in_pores(const SegmentNow& s) { return std::max(0.0, s.liquid); }
double saturation(const SegmentNow& s) { return in_pores(s) / (s.scene.climate.density * s.pores); }
double regain(const SegmentNow& s) { return s.bound / s.fibres; }
/// Where vapour is not modelled, none of it makes way for the liquid or condenses.
double vapour_concentration(const SegmentNow& s)
{
    const double vapour = s.vapour / pore_air(s.pores, s.liquid, s.scene.climate.density);
    return s.scene.rules.vapour ? vapour : std::min(vapour, saturation_concentration(s.temperature));
}
double temperature(const SegmentNow& s) { return s.temperature; }
double liquid(const SegmentNow& s) { return in_pores(s) + s.between; }
double between(const SegmentNow& s) { return s.between; }

/// Of a frame field that is no copy of a solver's field.
struct FrameFormula {
    std::vector<float> Frame::*values;
    double (*of)(const SegmentNow&);
};
constexpr FrameFormula frame_formulas[] = {
    {&Frame::saturation, saturation},   {&Frame::regain, regain}, {&Frame::vapour, vapour_concentration},
    {&Frame::temperature, temperature}, {&Frame::liquid, liquid}, {&Frame::between, between},
};

/// Whether frame_of() fills it: by one formula, or as a copy of a field that is shown, has one value a segment and has its unit.
constexpr bool is_filled(const FrameField& field)
{
    int sources = 0;
    for (const FrameFormula& formula : frame_formulas) sources += formula.values == field.values;
    if (field.shows == nullptr) return sources == 1;
    SegmentFields<Shown>::each([&](const Field<SegmentCount>& row) {
        using Count = SegmentCount;
        const bool of_all = row.count == Count::segments,
                   of_some = row.count == Count::fed_segments || row.count == Count::watched_segments;
        const bool fits = row.shown && (of_all || (of_some && field.absent)) && std::string_view(row.unit) == field.unit;
        sources += fits && std::string_view(row.name) == field.shows;
    });
    return sources == 1;
}
static_assert(std::all_of(std::begin(frame_fields), std::end(frame_fields), is_filled));

void copy_shown_fields(const SegmentFields<Shown>& segments, Frame& f)
{
    for (const FrameField& field : frame_fields) {
        if (field.shows == nullptr) continue;
        std::vector<float>& to = field.in(f);
        SegmentFields<Shown>::each(
            [&](const auto& row, const auto& from) {
                if (std::string_view(row.name) != field.shows) return;
                if (from.empty()) std::fill(to.begin(), to.end(), field.absent.value_or(0.0F));
                std::transform(from.begin(), from.end(), to.begin(), [](auto value) { return static_cast<float>(value); });
            },
            segments);
    }
}

/// Share of the liquid between a crossing's yarns that clings to one of them.
double clings(const Yarns& yarns, bool to_warp, std::size_t crossing, bool warp_up)
{
    const int at = static_cast<int>(crossing);
    const double on_warp = yarns.crossing_at(at / yarns.picks, at % yarns.picks).between.on_warp[warp_up];
    return to_warp ? on_warp : 1.0 - on_warp;
}

/// Segment i on a line: its formulas, and what it adds to its face.
void show_segment(const Stock& stock, const Scene& scene, const Yarns& yarns, const YarnLine& line, std::size_t i, std::size_t crossing,
                  Frame& f)
{
    const SegmentFields<Shown>& s = stock.segments;
    const bool warp_up = scene.cloth.warp_up[crossing] != 0, on_top = warp_up == line.is_warp;
    const double fibre_mass = line.yarn.fibre_area * line.yarn.fibre_density;
    const SegmentNow now{scene,
                         scene.cloth.fibre_length(i, line.yarn) * fibre_mass,
                         s.liquid[i],
                         s.bound[i],
                         s.pores[i],
                         s.vapour[i],
                         scene.climate.temperature + s.warmth[i],
                         s.between.empty() ? 0.0 : clings(yarns, line.is_warp, crossing, warp_up) * s.between[crossing]};
    [&]<std::size_t... k>(std::index_sequence<k...>)
    { // called by name, which a loop over pointers is not
        (((f.*frame_formulas[k].values)[i] = static_cast<float>(frame_formulas[k].of(now))), ...);
    }
    (std::make_index_sequence<std::size(frame_formulas)>());
    (on_top ? f.water_top : f.water_bottom) += now.liquid + now.between + now.bound - line.yarn.initial_regain * now.fibres;
}

/// Adds what a garment's cells hold.
void add_cells(const Stock& stock, Ledger& l)
{
    for (const CellSums& cell : stock.cells) {
        l.water_free += cell.on_skin;
        l.water_liquid += cell.liquid;
        l.water_bound += cell.bound;
        l.water_vapour += cell.vapour;
        l.water_evaporated += cell.evaporated;
        l.energy_stored += cell.stored;
        l.energy_released += cell.released;
        l.energy_lost += cell.lost;
    }
}

/// Adds what the cells hold that a large sample is shown in.
void add_shown(const Stock& stock, Ledger& l)
{
    ShownSums all;
    for (const ShownSums& line : stock.shown_lines) all.add(line);
    l.water_delivered += all.supplied;
    l.water_liquid = all.liquid;
    l.water_bound = all.bound;
    l.water_vapour = all.vapour;
    l.water_evaporated += all.evaporated;
    l.energy_stored = all.stored;
    l.energy_released = all.released;
    l.energy_lost = all.lost;
}

/// The fields and faces of a sample that is shown in cells.
void show_cells(const Stock& stock, Frame& f)
{
    static_assert(std::size(frame_fields) == shown_field_count, "a field of frames is not seen in cells: see SeeShown");
    const std::size_t n = stock.shown_fields.size() / shown_field_count;
    const auto take = [&](ShownField field, std::vector<float>& values) {
        const auto first = stock.shown_fields.begin() + static_cast<std::ptrdiff_t>(field * n);
        values.assign(first, first + static_cast<std::ptrdiff_t>(n));
    };
    take(shown_saturation, f.saturation);
    take(shown_liquid, f.liquid);
    take(shown_regain, f.regain);
    take(shown_vapour, f.vapour);
    take(shown_temperature, f.temperature);
    take(shown_between, f.between);
    ShownSums all;
    for (const ShownSums& line : stock.shown_lines) all.add(line);
    f.water_top = all.top;
    f.water_bottom = all.bottom;
    f.wet_sums = all.wet;
    f.wet.assign(stock.wet.begin(), stock.wet.end());
}

void add_segments(const Stock& stock, const Scene& scene, Ledger& l)
{
    Yarns yarns = yarns_of(scene);
    yarns.unvisited = stock.unvisited;
    const SegmentFields<Shown>& s = stock.segments;
    const auto sum_visited = [&yarns](std::span<const double> values) { return sum_of_visited(yarns, values); }; // the others are 0
    l.water_liquid = sum_visited(s.liquid);
    if (!s.between.empty()) l.water_liquid += sum_of_all(s.between);
    l.water_bound = sum_of_all(s.bound);
    l.water_vapour = sum_of_all(s.vapour);
    l.water_evaporated += sum_visited(s.evaporated);
    l.energy_stored = sum_visited(s.stored);
    l.energy_released = sum_visited(s.released);
    l.energy_lost = sum_visited(s.lost);
}

} // namespace

Ledger ledger_of(const Stock& stock, const Scene& scene)
{
    Ledger l;
    l.time = stock.time;
    l.water_initial = stock.initial;
    l.water_delivered = stock.delivered + sum_of_all(stock.segments.supplied);
    std::int64_t free = stock.standing;
    const ParticleFields<Shown>& p = stock.particles;
    for (std::size_t i = 0; i < p.alive.size(); ++i) free += p.alive[i] ? p.content[i] : 0;
    l.water_free = static_cast<double>(free) * water_quantum;
    l.water_dripped = stock.dripped;
    l.free_until = stock.free_until;
    l.water_evaporated = stock.evaporated;
    l.energy_delivered = stock.initial_energy;
    if (scene.cloth.panels.count > 0)
        add_cells(stock, l);
    else if (scene.cloth.shown_ends > 0)
        add_shown(stock, l);
    else
        add_segments(stock, scene, l);
    return l;
}

Frame frame_of(const Stock& stock, const Scene& scene)
{
    Frame f;
    f.time = stock.time;
    f.unsolved_lines = stock.unsolved_lines;
    f.ledger = ledger_of(stock, scene);
    f.cells.assign(stock.cells.begin(), stock.cells.end());
    f.caps = stock.caps;
    show_particles(stock, scene, f);
    if (!stock.shown_fields.empty()) {
        show_cells(stock, f);
        f.wet_picks = scene.cloth.picks;
    }
    if (stock.segments.liquid.empty()) return f;
    f.shells.assign(stock.segments.regain.begin(), stock.segments.regain.end());
    f.resize_fields(stock.segments.liquid.size());
    copy_shown_fields(stock.segments, f);
    Segments s;
    static_cast<Yarns&>(s) = yarns_of(scene);
    for (int line = 0; line < s.visited_lines(); ++line) { // on the host all are visited
        const YarnLine l = s.visited_line(line);
        auto crossing = static_cast<std::size_t>(s.crossing_of(l.first));
        for (auto i = static_cast<std::size_t>(l.first); i < static_cast<std::size_t>(l.last); ++i) {
            show_segment(stock, scene, s, l, i, crossing, f);
            crossing += l.is_warp ? 1 : static_cast<std::size_t>(scene.cloth.picks);
        }
    }
    return f;
}

} // namespace hygroloom::inline HL_PRECISION
