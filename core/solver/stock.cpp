// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/stock.h"

#include "core/solver/steps/yarn_lines.h"

#include <algorithm>

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

/// Of segment i on a line.
void show_segment(const Stock& stock, const Scene& scene, const YarnLine& line, std::size_t i, bool on_top, Frame& f)
{
    const SegmentFields<Shown>& s = stock.segments;
    const double fibre_mass = line.yarn.fibre_area * line.yarn.fibre_density;
    const double fibres = scene.cloth.length[i] * fibre_mass, liquid = s.liquid[i], bound = s.bound[i], pores = s.pores[i];
    f.saturation[i] = static_cast<float>(liquid / (scene.climate.density * pores));
    f.liquid[i] = static_cast<float>(liquid);
    f.regain[i] = static_cast<float>(bound / fibres);
    const double temperature = scene.climate.temperature + s.warmth[i];
    const double vapour = s.vapour[i] / pore_air(pores, liquid, scene.climate.density);
    // Where vapour is not modelled, none of it makes way for the liquid or condenses.
    f.vapour[i] = static_cast<float>(scene.rules.vapour ? vapour : std::min(vapour, saturation_concentration(temperature)));
    f.temperature[i] = static_cast<float>(temperature);
    (on_top ? f.water_top : f.water_bottom) += liquid + bound - line.yarn.initial_regain * fibres;
}

} // namespace

Ledger ledger_of(const Stock& stock, const Scene& scene)
{
    Yarns yarns = yarns_of(scene);
    yarns.unvisited = stock.unvisited;
    const SegmentFields<Shown>& s = stock.segments;
    const auto sum_visited = [&yarns](std::span<const double> values) { return sum_of_visited(yarns, values); }; // the others are 0
    Ledger l;
    l.time = stock.time;
    l.water_initial = stock.initial;
    l.water_delivered = stock.delivered + sum_of_all(s.supplied);
    std::int64_t free = stock.standing;
    const ParticleFields<Shown>& p = stock.particles;
    for (std::size_t i = 0; i < p.alive.size(); ++i) free += p.alive[i] ? p.content[i] : 0;
    l.water_free = static_cast<double>(free) * water_quantum;
    l.water_liquid = sum_visited(s.liquid);
    l.water_bound = sum_of_all(s.bound);
    l.water_vapour = sum_of_all(s.vapour);
    l.water_evaporated = sum_visited(s.evaporated);
    l.water_dripped = stock.dripped;
    l.energy_stored = sum_visited(stock.stored);
    l.energy_delivered = stock.initial_energy;
    l.energy_released = sum_visited(s.released);
    l.energy_lost = sum_visited(s.lost);
    return l;
}

Frame frame_of(const Stock& stock, const Scene& scene)
{
    Frame f;
    f.time = stock.time;
    f.ledger = ledger_of(stock, scene);
    f.shells.assign(stock.segments.regain.begin(), stock.segments.regain.end());
    f.resize_fields(stock.segments.liquid.size());
    Segments s;
    static_cast<Yarns&>(s) = yarns_of(scene);
    for (int line = 0; line < s.visited_lines(); ++line) { // on the host all are visited
        const YarnLine l = s.visited_line(line);
        auto crossing = static_cast<std::size_t>(s.crossing_of(l.first));
        for (auto i = static_cast<std::size_t>(l.first); i < static_cast<std::size_t>(l.last); ++i) {
            show_segment(stock, scene, l, i, (scene.cloth.warp_up[crossing] != 0) == l.is_warp, f);
            crossing += l.is_warp ? 1 : static_cast<std::size_t>(scene.cloth.picks);
        }
    }
    show_particles(stock, scene, f);
    return f;
}

} // namespace hygroloom::inline HL_PRECISION
