// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/supply.h"

#include "core/base/units.h"

#include <fmt/format.h>

#include <iterator>

namespace hygroloom {
namespace {

double drops_deliver(const Experiment& experiment, const DryCloth& cloth)
{
    double volume = 0;
    for (const Droplet& d : falling_drops(experiment)) volume += cubic_metre_from_ul(d.volume_ul);
    return volume * cloth.density;
}
double volume_delivers(const Experiment& experiment, const DryCloth& cloth)
{
    return cubic_metre_from_ul(experiment.volume_ul) * cloth.density;
}
double bath_delivers(const Experiment&, const DryCloth& cloth) { return cloth.capacity * cloth.sample; }
double wet_cloth_holds(const Experiment& experiment, const DryCloth& cloth) { return 1e-3 * experiment.initial_water_g_m2 * cloth.sample; }
double sweat_delivers(const Experiment& experiment, const DryCloth& cloth)
{
    return 1e-3 * experiment.rate_g_m2_h / 3600.0 * experiment.duration_s * cloth.sample;
}
double nothing_delivers(const Experiment&, const DryCloth&) { return 0; }

std::string drops_in_words(const Experiment&, std::size_t drops, double delivered)
{
    if (drops == 0) return "No drop falls in this experiment.";
    return fmt::format("{} {:.4g} mg.", drops == 1 ? "One drop brings" : fmt::format("{} drops bring", drops), 1e6 * delivered);
}
std::string pool_in_words(const Experiment&, std::size_t, double delivered)
{
    return fmt::format("{:.4g} mg are fed as a pool that the cloth absorbs; no drop falls.", 1e6 * delivered);
}
std::string pump_in_words(const Experiment& experiment, std::size_t, double delivered)
{
    const int drops = drops_of_feed(experiment);
    if (drops == 0) return pool_in_words(experiment, 0, delivered);
    return fmt::format("{} of {:.4g} ul, {:.4g} mg in {:.4g} s, join a pool that the cloth absorbs; none is followed as it falls.",
                       drops == 1 ? "One drop" : fmt::format("{} drops", drops), experiment.volume_ul / drops, 1e6 * delivered,
                       experiment.feed_s);
}
std::string bath_in_words(const Experiment&, std::size_t, double) { return "The strip hangs in the liquid; no drop falls."; }
std::string wet_cloth_in_words(const Experiment&, std::size_t, double delivered)
{
    return fmt::format("{:.4g} mg are in the cloth at the start; no drop falls.", 1e6 * delivered);
}
std::string sweat_in_words(const Experiment&, std::size_t, double delivered)
{
    return fmt::format("{:.4g} mg are fed straight into one face; no drop falls.", 1e6 * delivered);
}
std::string nothing_in_words(const Experiment&, std::size_t, double) { return "The cloth meets no liquid in this experiment."; }

/// In the order of WaterSource.
struct SuppliedBy {
    WaterSource source;
    double (*delivered)(const Experiment&, const DryCloth&);
    std::string (*in_words)(const Experiment&, std::size_t drops, double delivered);
};
constexpr SuppliedBy supplies[] = {
    {WaterSource::drops, drops_deliver, drops_in_words},    {WaterSource::pool, volume_delivers, pump_in_words},
    {WaterSource::bath, bath_delivers, bath_in_words},      {WaterSource::cloth, wet_cloth_holds, wet_cloth_in_words},
    {WaterSource::air, nothing_delivers, nothing_in_words}, {WaterSource::face, sweat_delivers, sweat_in_words},
};

constexpr bool in_order()
{
    for (std::size_t i = 0; i < std::size(supplies); ++i)
        if (supplies[i].source != static_cast<WaterSource>(i)) return false;
    return true;
}
static_assert(in_order());

const SuppliedBy& supply_of(const Experiment& experiment) { return supplies[static_cast<std::size_t>(info_of(experiment.type).source)]; }

} // namespace

double delivered_water(const Experiment& experiment, const DryCloth& cloth) { return supply_of(experiment).delivered(experiment, cloth); }

std::string supply_in_words(const Experiment& experiment, std::size_t drops, double delivered)
{
    return supply_of(experiment).in_words(experiment, drops, delivered);
}

} // namespace hygroloom
