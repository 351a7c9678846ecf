// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/part_watch.h"

#include "core/physics/heat_moisture.h"
#include "core/scene/thirst.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// visit(segment, type of yarn)
template <typename Visit> void each_segment(const Scene& scene, const Visit& visit)
{
    std::size_t segment = 0;
    for (std::size_t line = 0; line < scene.cloth.type.size(); ++line) {
        const int crossed = line < static_cast<std::size_t>(scene.cloth.ends) ? scene.cloth.picks : scene.cloth.ends;
        for (int i = 0; i < crossed; ++i) visit(segment++, std::size_t(scene.cloth.type[line]));
    }
}

double dry_mass(const YarnParameters& yarn, double length) { return yarn.fibre_area * yarn.fibre_density * length; }

/// Rate at which a wet face gives vapour to the air at a time (s), or takes it from air that is more than saturated, kg/(m2 s).
double drying_rate(const Scene& scene, double time)
{
    const AirMoment air = air_at(scene.climate, time);
    return air.mass_transfer * std::abs(1.0 - air.humidity) * saturation_concentration(scene.climate.temperature + air.air_warmth);
}

} // namespace

PartWatch::PartWatch(const Scene& scene, const ModelPlan& plan)
    : scene_(scene), duration_(plan.counts.duration), water_at_stake_(plan.water_at_stake)
{
    bool sorption = false;
    for (const PlannedPart& part : plan.parts) {
        sorption = sorption || (part.name == "sorption" && part.watched);
        const bool may_follow = part.name == "vapour" && sorption && !scene.climate.course.empty() && !part.on && !part.forced;
        if (part.watched || may_follow) watched_.push_back({{part.name, 0, 0, plan.knobs.neglected_share, part.share.value_or(0)}, false});
    }
    for (const YarnParameters& yarn : scene.cloth.yarns) thirst_.push_back(thirst_of(yarn, scene.climate.temperature));
}

bool PartWatch::is_watching() const
{
    return std::any_of(watched_.begin(), watched_.end(), [](const Watched& watched) { return !watched.reported; });
}

std::vector<SwitchedPart> PartWatch::see(const Frame& frame)
{
    std::vector<SwitchedPart> over;
    if (!is_watching()) return over;
    const WetCloth wet = wet_cloth(frame);
    const double rate = wet.area * drying_rate(scene_, frame.time);
    evaporated_ += 0.5 * (rate_ + rate) * (frame.time - time_);
    rate_ = rate;
    time_ = frame.time;
    if (time_ <= 0) return over;

    bool sorption = scene_.rules.sorption, vapour = scene_.rules.vapour; // with those that come on now: others follow them
    for (Watched& watched : watched_) {
        SwitchedPart& part = watched.part;
        if (watched.reported) continue;
        part.share = share_of(part.name, frame, wet, sorption, vapour);
        bool follows = part.name == "heat" && std::any_of(watched_.begin(), watched_.end(), [](const Watched& w) { return w.reported; });
        if (part.share <= part.limit) { // as in the plan, fibres that come on exchange vapour with air that changes
            follows = part.name == "vapour" && sorption && !scene_.rules.sorption && !scene_.climate.course.empty();
            if (!follows) continue;
            part.share = wet.thirst / water_at_stake_;
        }
        if (follows) part.estimate.reset();
        part.time = frame.time;
        watched.reported = true;
        over.push_back(part);
        sorption = sorption || part.name == "sorption";
        vapour = vapour || part.name == "vapour";
    }
    return over;
}

PartWatch::WetCloth PartWatch::wet_cloth(const Frame& frame) const
{
    if (in_cells()) return {scene_.cloth.cell_area * frame.wet_sums.faces, frame.wet_sums.thirst};
    WetCloth wet;
    each_segment(scene_, [&](std::size_t i, std::size_t type) {
        if (frame.saturation[i] <= 0) return;
        const double share = wet_share(static_cast<double>(frame.saturation[i]));
        wet.area += share * scene_.cloth.cell_area; // each of the two segments of a crossing has a face
        wet.thirst += share * thirst_[type] * dry_mass(scene_.cloth.yarns[type], scene_.cloth.fibre_length(i, scene_.cloth.yarns[type]));
    });
    return wet;
}

/// What a wet face gives to the air from a time to the end, kg/m2; between the times of the climate by their mean.
double PartWatch::dries_until_end(double from) const
{
    double dried = 0, rate = drying_rate(scene_, from);
    const auto on_to = [&](double time) {
        const double then = drying_rate(scene_, time);
        dried += 0.5 * (rate + then) * (time - from);
        rate = then;
        from = time;
    };
    for (const AirMoment& moment : scene_.climate.course)
        if (moment.time > from && moment.time < duration_) on_to(moment.time);
    on_to(duration_);
    return dried;
}

/// The most of any segment, K.
double PartWatch::warming(const Frame& frame) const
{
    const bool from_vapour = frame.ledger.water_delivered <= 0; // without liquid it all was vapour
    if (in_cells()) return from_vapour ? frame.wet_sums.warming_from_vapour : frame.wet_sums.warming;
    const double latent = from_vapour ? heat_of_evaporation(scene_.climate.temperature) : 0.0;
    double most = 0;
    each_segment(scene_, [&](std::size_t i, std::size_t type) {
        const YarnParameters& yarn = scene_.cloth.yarns[type];
        const double liquid = static_cast<double>(frame.liquid[i]) / dry_mass(yarn, scene_.cloth.fibre_length(i, yarn));
        const WaterOnFibre water{static_cast<double>(frame.regain[i]), liquid, wet_share(static_cast<double>(frame.saturation[i])),
                                 thirst_[type]};
        most = std::max(most, warming_of(water, yarn, scene_.climate.humidity, latent));
    });
    return most;
}

double PartWatch::share_of(const std::string& part, const Frame& frame, const WetCloth& wet, bool sorption, bool vapour) const
{
    if (part == "sorption") return wet.thirst / water_at_stake_;
    if (part == "vapour") return (evaporated_ + wet.area * dries_until_end(frame.time)) / water_at_stake_;
    double effect = sorption ? change_per_kelvin * warming(frame) : 0.0;
    if (vapour && wet.area > 0) {
        const AirMoment air = air_at(scene_.climate, frame.time);
        const double temperature = scene_.climate.temperature + air.air_warmth;
        const double dried = std::max(0.0, frame.ledger.water_evaporated) + wet.area * dries_until_end(frame.time);
        effect = std::max(
            {effect, change_per_kelvin * std::abs(wet_bulb_depression(air.heat_transfer, air.mass_transfer, temperature, air.humidity)),
             cooling_slows_evaporation(air.heat_transfer, air.mass_transfer, temperature) * std::min(1.0, dried / water_at_stake_)});
    }
    return effect;
}

} // namespace hygroloom
