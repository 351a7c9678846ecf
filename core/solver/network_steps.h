// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How long the yarns' next step and their next exchange with fibres and air may be: from errors, and from changes of saturation.
#pragma once

#include "core/base/first_step.h"
#include "core/solver/steps/ordered_bits.h"
#include "core/solver/steps/supply.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

constexpr double exchange_steps = 4.0; ///< network steps of full length between exchanges with fibres and air, which are slower
constexpr double under_drops = 0.25;   ///< of the longest step, where a drop's liquid flows by suction: rooms under it fill within less
constexpr double most_sweat = 0.2;     ///< kg in a step, whose quanta are counted; see ManyQuanta

/// kg/s on all of the sample's face, at most.
inline double sweat_rate(const Scene& scene)
{
    const SkinSupply& skin = scene.supply.skin;
    double rate = scene.supply.sweat * scene.cloth.cell_area * scene.cloth.crossings(); // m3/s
    const std::vector<double> most = skin.most_rates();
    for (int crossing : scene.cloth.panels.crossings)
        if (!most.empty())
            rate += most[static_cast<std::size_t>(crossing)] *
                    scene.cloth.panels.cell_area[scene.cloth.panels.panel[static_cast<std::size_t>(crossing % scene.cloth.picks)]];
    return rate * scene.climate.density;
}
/// Whether fibres or air exchange anything with the pores.
inline bool exchanges(const Scene& scene) { return scene.rules.sorption || scene.rules.vapour; }

/// What an error of a step is compared with.
struct AtStake {
    double water = 0;   ///< kg, that the fibres of all the cloth may bind
    double heat = 0;    ///< J, of all the cloth
    double to_come = 0; ///< kg of water
    double fills = 0;   ///< kg of water that fills the yarns of cloth at rest, in which nothing happens but where water falls; else 0
};

/// What the length of the network's next step follows from.
struct StepSigns {
    bool error; ///< of the last one
    bool pools; ///< that stand: the change of saturation counts, too

    bool change() const { return !error || pools; }
};

/// One step of the network, on its way.
struct NetworkStep {
    double time = 0;        ///< s, at its end
    double dt = 0;          ///< s
    double exchange_dt = 0; ///< s since the last exchange
    bool exchange_is_due = false;
    StepSigns signs{};
};

/// How changes compare with those of the step before.
struct RateWatch {
    double dt = 0;      ///< s, of the step before
    bool known = false; ///< whether there was one
};

/// drops_about: whether free liquid may soon come to the yarns, which keeps steps short.
class NetworkSteps {
public:
    void load(const Scene& scene, const AtStake& at_stake)
    {
        scene_ = &scene;
        sweat_rate_ = sweat_rate(scene);
        at_stake_ = at_stake;
        standing_dt_ = std::numeric_limits<double>::infinity();
        time_ = 0;
        forget_rates();
    }
    double longest() const { return std::min(network_dt_, exchange_step()); }
    bool exchange_is_due(double since_last) const { return since_last >= 0.999 * exchange_step(); }
    const RateWatch& wicking() const { return wicking_; }
    const RateWatch& exchange() const { return exchange_; }
    /// Until further notice what stands on the cloth changes little in so long, s.
    void follow_standing(double lasts) { standing_dt_ = lasts; }
    void forget_rates() { wicking_ = exchange_ = {}; }

    /// Short steps again: something sudden has happened.
    void begin_anew(bool drops_about)
    {
        network_dt_ = std::min(first_step, step_limit(drops_about));
        exchange_dt_ = scene_->rules.step_error > 0 ? std::min(first_step, exchange_limit(drops_about)) : exchange_limit(drops_about);
    }

    /// After a step of length dt, in which the water delivered (kg) came to that of the start: from its error, and from the change of
    /// saturation while drops or pools are about.
    void choose_network_step(double dt, const StepSigns& signs, const YarnTotals& found, bool drops_about, double delivered)
    {
        time_ += dt;
        wicking_ = {dt, signs.error};
        constexpr double most = 1.5;
        double grow = most;
        const auto change = static_cast<double>(from_ordered_bits(found.largest_change));
        if (signs.error && scene_->rules.wicking)
            grow = growth(static_cast<double>(found.wicking_error) * water_quantum / water_at_stake(delivered), most);
        if (signs.change()) {
            const double wanted = 0.8 * scene_->rules.saturation_change / std::max(1e-9, change);
            grow = std::min(grow, std::clamp(wanted, 0.5, 1.3));
        }
        // The limit may be shorter than the shortest: in a run of a microsecond.
        network_dt_ =
            std::min(std::max(network_dt_ * grow, std::min(1e-4, scene_->rules.network_step)), step_limit(drops_about, change > 0));
    }

    /// After an exchange over dt, from its error.
    void choose_exchange_step(double dt, const YarnTotals& found, bool drops_about, double delivered)
    {
        const bool any = exchanges(*scene_);
        if (!any) exchange_dt_ = exchange_limit(drops_about); // nothing is exchanged that steps would have to follow
        if (dt <= 0 || !any || scene_->rules.step_error <= 0) return;
        const double water = static_cast<double>(found.bound_error) * water_quantum / water_at_stake(delivered);
        const double heat = static_cast<double>(found.heat_error) * EstimateExchange::heat_quantum / heat_at_stake(delivered);
        exchange_ = {dt, true};
        // The steady temperature depends a little on the step. Where steps grow faster, that shift counts as an error and they shorten
        // again, without end.
        constexpr double most = 1.1;
        const double wanted = std::min(exchange_dt_, 2.0 * dt) * growth(std::max(water, heat), most);
        exchange_dt_ = std::min(std::max(wanted, std::min(1e-4, scene_->rules.network_step)), exchange_limit(drops_about));
    }

    template <typename Archive> void pass_state(Archive& archive)
    {
        archive.value(network_dt_);
        archive.value(exchange_dt_);
        archive.value(standing_dt_);
        archive.value(time_);
        archive.value(wicking_);
        archive.value(exchange_);
    }

private:
    double exchange_step() const { return std::min(exchange_dt_, standing_dt_); }
    /// s, however calm the cloth is.
    double calm_limit() const
    {
        const StepRules& rules = scene_->rules;
        return rules.step_share > 0
                   ? std::clamp(rules.step_share * time_, std::min(first_step, rules.calm_network_step), rules.calm_network_step)
                   : rules.calm_network_step;
    }
    bool takes_short_steps(bool drops_about) const { return drops_about || scene_->rules.calm_network_step <= 0; }
    /// flows: whether the cloth's liquid moved; a drop may lie on cloth that takes nothing in.
    double step_limit(bool drops_about, bool flows = true) const
    {
        const double shortened = drops_about && flows && scene_->cloth.by_suction ? under_drops : 1.0;
        const double longest = takes_short_steps(drops_about) ? shortened * scene_->rules.network_step : calm_limit();
        return sweat_rate_ > 0 ? std::min(longest, most_sweat / sweat_rate_) : longest;
    }
    double exchange_limit(bool drops_about) const
    {
        return takes_short_steps(drops_about) ? exchange_steps * scene_->rules.network_step : calm_limit();
    }
    double growth(double error, double most) const
    {
        return std::clamp(0.9 / std::sqrt(std::max(1e-12, error / scene_->rules.step_error)), 0.3, most);
    }
    /// Of the cloth, where anything happens: as much of cloth at rest as the water fills that came or is to come, so that steps do not
    /// depend on how much cloth lies about a drop.
    double share_at_stake(double delivered) const
    {
        constexpr double a_little = 1e-6; // kg
        return at_stake_.fills > 0 ? std::min(1.0, std::max(a_little, at_stake_.to_come + delivered) / at_stake_.fills) : 1.0;
    }
    double water_at_stake(double delivered) const
    {
        return std::max(1e-30, share_at_stake(delivered) * at_stake_.water + at_stake_.to_come + delivered);
    }
    double heat_at_stake(double delivered) const { return std::max(1e-30, share_at_stake(delivered) * at_stake_.heat); }

    const Scene* scene_ = nullptr;
    double sweat_rate_ = 0; ///< kg/s
    AtStake at_stake_;
    double time_ = 0;                                              ///< s, that steps have come to
    double network_dt_ = 0, exchange_dt_ = 0;                      ///< s
    double standing_dt_ = std::numeric_limits<double>::infinity(); ///< s, see follow_standing()
    RateWatch wicking_, exchange_;
};

} // namespace hygroloom
