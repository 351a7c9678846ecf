// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/parts.h"

#include "core/plan/cap_room.h"
#include "core/plan/supply.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

PlannedPart decide(const char* name, bool on, std::string reason, const ForcedParts& forced)
{
    PlannedPart part{name, on, false, std::move(reason)};
    const auto found = forced.find(name);
    if (found != forced.end()) {
        part.reason = fmt::format("Forced {} by the user; left to itself it would be {}: {}", found->second ? "on" : "off",
                                  on ? "on" : "off", part.reason);
        part.on = found->second;
        part.forced = true;
    }
    return part;
}

/// A part that is left out where it changes less than the neglected share; then, if it can matter at all, the run watches it.
struct Estimate {
    double share;     ///< at most, by an estimate before the run
    bool can_matter;  ///< not when what it is about is not there
    std::string what; ///< the run watches
};
PlannedPart decide_by(const char* name, const Estimate& estimate, std::string reason, const Knobs& knobs, const ForcedParts& forced)
{
    PlannedPart part = decide(name, estimate.can_matter && estimate.share > knobs.neglected_share, std::move(reason), forced);
    part.share = estimate.share;
    part.watched = !part.on && !part.forced && estimate.can_matter;
    if (part.watched)
        part.reason +=
            fmt::format(" Watched while running: {}; over {:.3g} % the part is switched on.", estimate.what, 100 * knobs.neglected_share);
    return part;
}

/// What is left out where the share is that of the knob, in a clause.
std::string left_out_below(double share)
{
    return share > 0 ? fmt::format("parts below {:.3g} % are left out at this fidelity", 100 * share)
                     : "nothing that has an effect is left out at this fidelity";
}

/// Goes through the parts in their order; each depends on those before.
class Decisions {
public:
    Decisions(ModelPlan& plan, const Bounds& bounds, const Experiment& experiment, const ForcedParts& forced)
        : plan_(plan), b_(bounds), experiment_(experiment), from_air_(info_of(experiment.type).source == WaterSource::air),
          knobs_(plan.knobs), forced_(forced), left_out_(left_out_below(plan.knobs.neglected_share))
    {
        plan_.water_at_stake = std::max(b_.at_stake, 1e-30);
    }

    void liquid()
    {
        const bool on = add(decide("liquid", b_.drops > 0, supply_in_words(experiment_, b_.drops, b_.delivered), forced_));
        drops_ = info_of(experiment_.type).source == WaterSource::drops;
        wet_ = drops_ ? on : b_.delivered > 0;
    }
    /// How a drop is modelled.
    void cap()
    {
        if (!drops_ || !plan_.on("liquid")) return;
        const auto model = static_cast<DropModel>(knobs_.free_liquid);
        const std::string why_not = why_no_cap(experiment_, b_);
        const bool may = why_not.empty();
        std::string reason =
            !may ? why_not + " A drop is particles."
            : model == DropModel::particles
                ? std::string("fidelity.free_liquid is particles; with cap or auto a drop would stand as a cap.")
                : fmt::format(
                      "A drop stands as a cap with a contact line: it lands without splashing and has room on the sample. It spreads "
                      "while it shows more than {:.3g} degrees.",
                      b_.advancing_deg);
        add({"cap", may && model != DropModel::particles, false, std::move(reason)});
    }
    void wicking()
    {
        const std::string angle = fmt::format("The smallest contact angle of a yarn is {:g} degrees", b_.smallest_angle);
        const bool stay_dry = experiment_.closure == Closure::pores && b_.uptake <= 0;
        const bool on = add(decide("wicking", wet_ && b_.wicks,
                                   !wet_       ? std::string("No liquid comes to the yarns.")
                                   : !b_.wicks ? angle + ", 90 or more: no pores draw liquid."
                                   : stay_dry  ? angle + ", at which liquid does not run between dry fibres: dry yarns take none in."
                                               : angle + ", under 90: its pores draw liquid.",
                                   forced_));
        moist_ = on || from_air_ || (wet_ && !drops_) || b_.condenses;
    }
    void sorption()
    {
        const double sorbed = b_.sorbable / plan_.water_at_stake;
        sorption_ = add(
            decide_by("sorption", {sorbed, moist_ && b_.sorbable > 0, "what the fibres can take up wherever the cloth has really got wet"},
                      from_air_ ? fmt::format("The fibres exchange {}.", b_.sorbable > 0 ? "all the water there is" : "no water")
                                : share_reason("The fibres of the area that can get wet take up", sorbed),
                      knobs_, forced_));
    }
    void vapour()
    {
        // A sample in a new climate exchanges what its fibres do; without liquid that is all.
        const bool new_climate = from_air_ || !experiment_.climates.empty();
        evaporated_ = b_.evaporated / plan_.water_at_stake;
        vapour_ = add(
            b_.condenses ? decide("vapour", true, "The air has more vapour than it can hold, which condenses on the cloth.", forced_)
            : new_climate && (sorption_ || b_.delivered <= 0)
                ? decide("vapour", moist_ && sorption_, "What fibres exchange comes and goes as vapour.", forced_)
                : decide_by("vapour",
                            {evaporated_, (moist_ || wet_) && evaporated_ > 0,
                             "what would evaporate until the end wherever the cloth has really got wet"},
                            share_reason("Evaporation from both faces of the area that can get wet takes", evaporated_), knobs_, forced_));
    }
    void heat()
    {
        const bool changes_phase = vapour_ && (b_.delivered > 0 || b_.condenses);
        const double warming = sorption_ ? b_.temperature_rise : 0.0, cooling = changes_phase ? b_.wet_bulb_depression : 0.0;
        const double change = climate_change();
        const double slowed = changes_phase ? b_.slowed * std::min(1.0, evaporated_) : 0.0;
        const double rates = change_per_kelvin * std::max({warming, cooling, change}), effect = std::max(rates, slowed);
        const bool may_follow = std::any_of(plan_.parts.begin(), plan_.parts.end(), [](const PlannedPart& part) { return part.watched; });
        add(decide_by(
            "heat",
            {effect, (moist_ || wet_) && (effect > 0 || may_follow),
             "how far what fibres have really taken up and what evaporates change the temperature"},
            fmt::format("Sorption warms the wet area by at most {:.3g} K, {} it by at most {:.3g} K and the climate "
                        "changes by {:.3g} K. This changes the rates by {} (2 % per kelvin). Cooling prevents at most {:.3g} % of the "
                        "water from evaporating; {}.",
                        warming, b_.condenses ? "condensation warms" : "evaporation cools", cooling, change,
                        rates < 1 ? fmt::format("up to {:.3g} %", 100 * rates) : "more than 100 %", 100 * slowed, left_out_),
            knobs_, forced_));
    }
    /// Whether only cloth near the water is computed, an area that grows.
    void growth()
    {
        const auto [width, height] = sample_extent_mm(experiment_);
        const bool everywhere = changes_everywhere(experiment_.type) || !experiment_.climates.empty() || b_.condenses;
        const double wet = 1e6 * b_.wet_area / (width * height);
        const bool on = add(decide(
            "growth", !everywhere,
            everywhere ? std::string("All of the sample changes from the start.")
                       : fmt::format("Only cloth near the water is computed; the area grows with the stain, before the air's humidity "
                                     "changes by {1:.3g} % at its border. The liquid can wet {0} of the sample.",
                                     wet < 1 ? fmt::format("at most {:.3g} %", 100 * wet) : "all", 100 * knobs_.rest_tolerance),
            forced_));
        plan_.rest_tolerance = on ? knobs_.rest_tolerance : 0;
    }

private:
    /// Whether the part is on.
    bool add(PlannedPart part)
    {
        plan_.parts.push_back(std::move(part));
        return plan_.parts.back().on;
    }
    std::string share_reason(const char* what, double share) const
    {
        return share < 1 ? fmt::format("{} at most {:.3g} % of the water delivered; {}.", what, 100 * share, left_out_)
                         : fmt::format("{} at most all of the water delivered; {}.", what, left_out_);
    }
    /// K, of the air from the sample's state at the start.
    double climate_change() const
    {
        double change = from_air_ ? std::abs(experiment_.initial.temperature_c - experiment_.climate.temperature_c) : 0.0;
        for (const ClimateMoment& moment : experiment_.climates)
            change = std::max(change, std::abs(moment.climate.temperature_c - experiment_.climate.temperature_c));
        return change;
    }

    ModelPlan& plan_;
    const Bounds& b_;
    const Experiment& experiment_;
    const bool from_air_; // the sample starts in equilibrium with another climate and meets no liquid
    const Knobs& knobs_;
    const ForcedParts& forced_;
    const std::string left_out_;
    bool drops_ = false, wet_ = false;
    bool moist_ = false; // water can get to the fibres
    bool sorption_ = false, vapour_ = false;
    double evaporated_ = 0; // share of the water at stake
};

} // namespace

void decide_parts(ModelPlan& plan, const Bounds& bounds, const Experiment& experiment, const ForcedParts& forced)
{
    Decisions decisions(plan, bounds, experiment, forced);
    decisions.liquid();
    decisions.cap();
    decisions.wicking();
    decisions.sorption();
    decisions.vapour();
    decisions.heat();
    decisions.growth();
}

} // namespace hygroloom
