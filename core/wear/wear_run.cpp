// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/wear_run.h"

#include "core/base/error.h"
#include "core/design/wear.h"
#include "core/run/course.h"
#include "core/scene/ledger_closes.h"
#include "core/solver/backend.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

namespace hygroloom {
namespace {

constexpr double side_of_cells[] = {12e-3, 6e-3, 3e-3, 1.5e-3}; // m: live, draft, standard, reference

} // namespace

double cell_side(const RunOptions& options)
{
    return options.cell_side > 0 ? options.cell_side : side_of_cells[static_cast<std::size_t>(options.fidelity)];
}

GarmentResolution resolution_of(const RunOptions& options)
{
    GarmentResolution resolution{with_settings(knobs_of(options.fidelity), options.knobs), cell_side(options)};
    resolution.shown = {options.shown_side, options.detail};
    resolution.memory = options.memory;
    return resolution;
}

WearFrame wear_frame(const GarmentScene& garment, const Frame& frame)
{
    WearFrame seen;
    seen.time = frame.time;
    seen.ledger = frame.ledger;
    for (std::size_t i = 0; i < frame.cells.size(); ++i) {
        const CellSums& cell = frame.cells[i];
        const bool skin_on_top = garment.scene.cloth.panels.skin_on_top[static_cast<std::size_t>(garment.shown.cells[i].panel)] != 0;
        seen.inside.push_back(skin_on_top ? cell.top : cell.bottom);
        seen.outside.push_back(skin_on_top ? cell.bottom : cell.top);
        seen.evaporated.push_back(cell.evaporated);
        seen.temperature.push_back(static_cast<float>(garment.scene.climate.temperature + cell.warmth));
        seen.on_skin.push_back(cell.on_skin);
    }
    return seen;
}

std::vector<double> wear_times(const WearExperiment& wear)
{
    constexpr int frames = 60;
    std::set<double> times{0, wear.duration_s};
    for (int k = 1; k < frames; ++k) times.insert(wear.duration_s * k / frames);
    for (const Activity& activity : wear.activity)
        if (activity.time_s < wear.duration_s) times.insert(activity.time_s);
    return {times.begin(), times.end()};
}

namespace {

/// How wet the cloth over sweating skin gets, on average: 1 from 0.1 mm of liquid on, which flows everywhere then; 0 where no yarn absorbs.
double wetness(const GarmentScene& garment, const WearExperiment& wear)
{
    constexpr double wet_through = 0.1e-3; // m of liquid
    const std::vector<YarnParameters>& yarns = garment.scene.cloth.yarns;
    if (std::none_of(yarns.begin(), yarns.end(), [](const YarnParameters& yarn) { return yarn.absorbs; })) return 0;
    const SkinSupply& skin = garment.scene.supply.skin;
    double depth = wear.initial_water_g_m2 * 1e-6;
    constexpr int times = 6;
    for (int k = 0; k < times && !skin.rate.empty(); ++k) {
        const double time = (k + 0.5) / times * wear.duration_s;
        const std::vector<double> of_zones = skin.has_zones() ? skin.rates_at(time) : std::vector<double>();
        const std::vector<double>& rates = skin.has_zones() ? of_zones : skin.rate;
        double sweat = 0, area = 0; // where the skin sweats
        for (const GarmentCell& cell : garment.cells) {
            const double rate = rates[static_cast<std::size_t>(cell.crossing)];
            sweat += rate * cell.area;
            area += rate > 0 ? cell.area : 0.0;
        }
        if (area > 0) depth += skin.factor_at(time) * sweat / area * wear.duration_s / times;
    }
    return std::min(1.0, depth / wet_through);
}

/// How often zones change on their own: each time ends a step.
double changes_of(const SkinSupply& skin, double duration)
{
    double changes = 0;
    if (skin.has_zones())
        for (double time = skin.next_change(0); time < duration; time = skin.next_change(time)) ++changes;
    return changes;
}

/// Roughly, on two cores of an Intel Xeon, as if all cloth got as wet as that over sweating skin. Steps end at frames, are small at first,
/// and go on as things change; liquid in wet cloth takes more of its own. Set on 120 random garments, nearly all at live, and six of
/// textile F and poplin; the form was chosen with 48 others in sight. resources/help/limits.md has 48 more.
double seconds_of(const GarmentScene& garment, const WearExperiment& wear)
{
    constexpr double dry = 1.6e-6, wet = 1.4e-6, flow = 1.7e-6;                          // s, for a cell and step
    constexpr double first_steps = 20, steps_per_second = 0.02, flows_per_second = 0.06; // more than at frames, with the usual error
    constexpr double usual_error = 0.002;
    const double error = garment.scene.rules.step_error > 0 ? garment.scene.rules.step_error : usual_error;
    const double at_change = usual_error / error * wear.duration_s, wets = wetness(garment, wear);
    const double frames = static_cast<double>(wear_times(wear).size()) + changes_of(garment.scene.supply.skin, wear.duration_s);
    const double steps = frames + first_steps + steps_per_second * at_change;
    return static_cast<double>(garment.cells.size()) * (steps * (dry + wet * wets) + flows_per_second * at_change * flow * wets);
}

} // namespace

WearPlan plan_wear(const GarmentScene& garment, const WearExperiment& wear, Fidelity fidelity)
{
    WearPlan plan;
    plan.cells = static_cast<int>(garment.cells.size());
    plan.panel_cells.assign(garment.grids.size(), 0);
    for (const GarmentCell& cell : garment.cells) ++plan.panel_cells[static_cast<std::size_t>(cell.panel)];
    for (int fabric : garment.fabric)
        plan.crossings_per_cell.push_back(garment.fabrics[static_cast<std::size_t>(fabric)].crossings_per_cell);
    plan.bytes = bytes_of_garment(garment.scene.cloth.crossings());
    plan.time = {fidelity, seconds_of(garment, wear), {}};
    return plan;
}

WearPlan plan_wear(const GarmentScene& garment, const WearExperiment& wear, Fidelity fidelity, const std::string& backend)
{
    WearPlan plan = plan_wear(garment, wear, fidelity);
    expect_as_learned(plan.time, backend);
    return plan;
}

namespace {

/// With those at which zones change on their own, where they are few.
std::vector<double> times_of_frames(const GarmentScene& garment, const WearExperiment& wear)
{
    constexpr std::size_t few = 60;
    std::vector<double> times = wear_times(wear), changes;
    const SkinSupply& skin = garment.scene.supply.skin;
    if (!skin.has_zones()) return times;
    for (double time = skin.next_change(0); time < wear.duration_s && changes.size() <= few; time = skin.next_change(time))
        changes.push_back(time);
    if (changes.size() > few) return times;
    std::set<double> all(times.begin(), times.end());
    all.insert(changes.begin(), changes.end());
    return {all.begin(), all.end()};
}

using Clock = std::chrono::steady_clock;

class Onlooker : public Audience {
public:
    Onlooker(const GarmentScene& garment, double duration, const WearCallbacks& callbacks)
        : garment_(garment), duration_(duration), callbacks_(callbacks)
    {
    }
    void publish(Frame frame, double time, bool /*beside*/) override
    {
        frame.time = time;
        if (!ledger_closes(frame.ledger, garment_.scene))
            throw Error(fmt::format("At {:.4g} s {:.3g} kg of water are not accounted for.", time, frame.ledger.water_imbalance()));
        if (callbacks_.frame) callbacks_.frame(std::make_shared<const WearFrame>(wear_frame(garment_, frame)));
    }
    void progress(double reached, bool /*ends*/) override
    {
        const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
        if (callbacks_.progress) callbacks_.progress({reached, duration_, wall, 0, 0});
    }
    bool takes_at_once() const override { return true; } // callers are called from one thread
    void device_failed(const std::string& sentence) override
    {
        if (callbacks_.device_failed) callbacks_.device_failed(sentence);
    }
    void device_changed(const std::string& added) override
    {
        if (callbacks_.device_changed) callbacks_.device_changed(added);
    }

private:
    const GarmentScene& garment_;
    const double duration_; // s
    const WearCallbacks& callbacks_;
    const Clock::time_point start_ = Clock::now();
};

} // namespace

void run_wear(const GarmentScene& garment, const WearExperiment& wear, Backend& backend, RunControl& control,
              const WearCallbacks& callbacks, const RunOptions& options)
{
    Session session(backend, &garment.scene);
    Onlooker onlooker(garment, wear.duration_s, callbacks);
    go_through(times_of_frames(garment, wear), session, onlooker, options, control);
}

} // namespace hygroloom
