// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cloth's yarns: their arrays, and one step of the network that they form. How liquid comes to it stands in yarn_network_supply.h, how
// it flows by suctions in yarn_network_flow.h and yarn_network_whole.h.
#pragma once

#include "core/physics/caps.h"
#include "core/solver/caps.h"
#include "core/solver/state_archive.h"
#include "core/solver/steps/cap_supply.h"
#include "core/solver/steps/layers.h"
#include "core/solver/steps/segment_exchange.h"
#include "core/solver/steps/segment_sums.h"
#include "core/solver/steps/swelling.h"
#include "core/solver/steps/touching.h"
#include "core/solver/steps/track_change.h"
#include "core/solver/steps/whole_flow.h"
#include "core/solver/steps/whole_solution.h"
#include "core/solver/visited_region.h"
#include "core/solver/water_passed.h"
#include "core/solver/yarn_start.h"
#include "core/solver/yarn_stock.h"

#include <limits>
#include <numeric>
#include <type_traits>

namespace hygroloom {

/// The scene must outlive it. Whether drops are about: see FreeLiquid::is_about().
template <typename Executor> class YarnNetwork {
public:
    template <typename T> using Buffer = typename Executor::template Buffer<std::remove_const_t<T>>;

    explicit YarnNetwork(Executor& executor) : exec_(executor) {}

    void load(const Scene& scene);
    Segments segments();
    int visited_segments() { return yarns().visited_segments(); }
    /// kg that stand on the cloth as pools, caps or a film, less what of all that came is too little to be seen.
    double seen_standing() const
    {
        const std::int64_t stands = std::accumulate(pools_.standing.begin(), pools_.standing.end(), caps_.water() + film_);
        return static_cast<double>(stands) * water_quantum - unseen_share * (pools_.pumped.mass() + scene_->cloth.start.film);
    }
    bool pool_was_fed() const { return pools_.came; }
    double longest_step() const { return steps_.longest(); }
    /// The next time after this at which something begins or ends; steps end there.
    double next_event(double time) const;
    /// Whether the air changes at once at this time, or a drop begins that will stand as a cap: steps are short then.
    bool jumps_at(double time) const;
    void begin_anew(bool drops_about) { steps_.begin_anew(drops_about); }

    /// From now on, until the next step, free liquid may come to the yarns.
    void expect_liquid() { may_have_absorbed_ = true; }
    void draw_from_particles(bool offered) { particles_offer_ = offered; } ///< what they offer, in the next step
    /// Drops of particles that stand on the cloth, until the next step is over.
    void stand(std::vector<CapOnFace> drops) { drops_on_face_ = std::move(drops); }
    std::int64_t evaporated_from_drops() const { return evaporated_from_drops_; } ///< quanta, in the last step
    WaterAbsorbed absorbed() { return {segments(), reach_.data()}; }

    // A step, in this order; between the first two swell() may give water back.
    NetworkStep begin_step(double time, double dt, bool frame_due, bool drops_about);
    void exchange(const NetworkStep& step);
    void end_step(const NetworkStep& step, bool drops_about, bool wakes, double delivered);

    bool swells(const NetworkStep& step) const { return step.exchange_is_due && exchanges_in(step) && scene_->cloth.swelling > 0; }
    /// From at most this many segments, each with the least surplus (kg) or more.
    WaterGivenBack swell(double least, std::size_t most);
    /// Presses liquid out of the pores, see PressOut; what stands on the cloth runs off. Precondition: at most 0.25 kg do.
    void squeeze(double share);

    /// Segments that are not visited neither hold liquid nor are warmer or cooler than the air.
    void take_stock(YarnStock& stock);
    template <typename LookAt> void show(const LookAt& look_at, YarnStock& stock);

    template <typename Archive> void pass_state(Archive& archive);
    /// Goes on with other parts of the physics than before.
    void change_parts(bool drops_about)
    {
        steps_.forget_rates();
        steps_.begin_anew(drops_about);
    }

private:
    template <typename Stage> void each_segment(const char* name, const Stage& stage)
    {
        exec_.for_each(name, yarns().visited_segments(), stage);
    }
    template <typename Stage> void each_crossing(const char* name, const Stage& stage)
    {
        exec_.for_each(name, yarns().visited_crossings(), stage);
    }
    template <typename Stage> void each_line(const char* name, const Stage& stage)
    {
        exec_.for_each_line(name, yarns().visited_lines(), std::max(yarns().visited_ends(), yarns().visited_picks()),
                            stage); // of which no line is longer
    }
    Yarns yarns()
    {
        return {scene_->cloth.ends, scene_->cloth.picks, scene_->cloth.warp_types, scene_->cloth.weft_types(), type_.data(),
                yarns_.data(),      crossing_.data(),    region_.unvisited(),      panels_.view(panels_now_)};
    }
    bool by_suction() const { return scene_->cloth.by_suction; }
    void load_start();
    void set_climate(double time);
    void include_absorbed();
    void supply(double time, double dt);
    void feed_from_pools(double time, double dt);
    FedFace face_under(std::size_t pool)
    {
        const FedFace face = pools_.face_under(*scene_, pool, climate_.density);
        region_.include_disc(0, 0, pools_.reach(*scene_, face));
        return face;
    }
    void take_drops(double time, double dt);
    void offer_caps(double dt);
    double widest_cell() const { return std::max(scene_->cloth.warp_pitch, scene_->cloth.weft_pitch); } ///< m
    void cover_a_cell(std::vector<CapOnFace>& caps) const;
    FindCap find_cap(int count);
    void visit_standing();
    StandingOnFace standing(double time);
    StandingLiquid find_standing(const StandingOnFace& standing);
    void take_evaporated(const StandingOnFace& standing);
    double standing_lasts(double time);
    StandingPool standing_pool();
    double lift(bool along_warp) const;
    void flow_by_suction(double dt, bool of_warp);
    void flow_in_turn(double dt);
    bool flow_whole(double dt);
    template <typename Whole> bool find_suctions(const Whole& w, double open);
    template <typename Whole> WholeSums balance_of(const Whole& w, bool changed);
    template <typename Whole> WholeSums go_downhill(const Whole& w, double downhill, bool& stiff);
    template <typename Whole> double solve_round(const Whole& w);
    template <typename Whole> void carry_heat(const Whole& w, double dt);
    void flow_between_touching(double dt, bool odd_first);
    void flow_through_seams(double dt);
    template <typename Stage> void each_layer_joint(const char* name, const Stage& stage_from);
    void wick_between_layers(double dt);
    void flow_between_layers(double dt);
    void pass_between_layers(double dt);
    void move_by_suction(double dt);
    void sweat(double dt);
    void sweat_from_skin(double time, double dt);
    void move_liquid_and_heat(double dt, const StepSigns& signs);
    bool exchanges_in(const NetworkStep& step) const { return step.exchange_dt > 0 && exchanges(*scene_); }
    template <typename Archive> void pass_regain(Archive& archive);
    bool shows_cells() const { return scene_->cloth.shown_ends > 0; }
    void see_shown();

    Executor& exec_;
    const Scene* scene_ = nullptr;
    ClimateParameters climate_; ///< of now
    NetworkSteps steps_;
    VisitedRegion region_;
    Pools pools_;
    Caps caps_;
    std::vector<CapOnFace> caps_on_face_;    ///< in this step
    bool cap_landed_ = false;                ///< in this step
    std::vector<CapOnFace> drops_on_face_;   ///< of particles, in this step
    std::int64_t evaporated_from_drops_ = 0; ///< in this step
    std::int64_t film_ = 0;                  ///< quanta that stand on both faces
    ManyQuanta evaporated_from_standing_;
    double exchange_time_ = 0;       ///< s, of the last one
    bool warp_first_ = true;         ///< in the next step by suction
    double unsolved_lines_ = 0;      ///< since the start
    bool may_have_absorbed_ = false; ///< some segment, from particles or a pool, since the last step
    bool particles_offer_ = false;   ///< in the next step, or in this one

    SegmentFields<Buffer> fields_;
    Buffer<std::uint8_t> type_;
    Buffer<YarnParameters> yarns_;
    Buffer<CrossingParameters> crossing_;
    PanelArrays<Buffer> panels_;
    Panels panels_now_; ///< of the scene, on the host
    Buffer<SeamJoint> seams_;
    Buffer<LayerJoint> layers_;
    Buffer<LayerFlow> layer_flows_; ///< two per joint
    Buffer<LayerSide> layer_sides_; ///< one per segment, where there are layers
    Buffer<CapOnFace> cap_views_;
    Buffer<CapSums> cap_sums_;
    Buffer<int> reach_;         ///< see Reach: where particles gave liquid since the last step
    Buffer<YarnTotals> totals_; ///< one, of this step
    Buffer<CellSums> cells_;    ///< of a garment's frames
    Buffer<double> whole_numbers_, whole_line_sums_;
    Buffer<int> whole_reach_;
    Buffer<WholeSums> whole_sums_; ///< one, of this step
    Buffer<float> shown_fields_;   ///< of a cloth that is shown in cells
    Buffer<ShownSums> shown_sums_, shown_lines_;
    Buffer<WetEnd> wet_;
    bool cells_were_seen_ = false; ///< all of them, since the scene or a state was loaded
    Unvisited unseen_;             ///< what was not visited when cells were seen last
};

template <typename Executor> Segments YarnNetwork<Executor>::segments()
{
    Segments s;
    static_cast<Yarns&>(s) = yarns();
    s.shells = scene_->rules.fibre_shells;
    s.swelling = scene_->cloth.swelling;
    s.narrows = scene_->cloth.swelling > 0;
    Segments::each([](const auto&, auto& buffer, auto& pointer) { pointer = buffer.size() > 0 ? buffer.data() : nullptr; }, fields_, s);
    return s;
}

template <typename Executor> void YarnNetwork<Executor>::load(const Scene& scene)
{
    scene_ = &scene;
    cells_were_seen_ = false;
    climate_ = scene.climate;
    exchange_time_ = 0;
    may_have_absorbed_ = false;
    warp_first_ = true;
    unsolved_lines_ = 0;
    pools_ = {std::vector<std::int64_t>(scene.supply.pools.size(), 0), {}, {}};
    caps_.load(scene);
    caps_on_face_.clear();
    cap_landed_ = false;
    drops_on_face_.clear();
    evaporated_from_drops_ = 0;
    film_ = std::llround(scene.cloth.start.film / water_quantum);
    evaporated_from_standing_ = {};
    region_.load(scene);
    Segments::each(
        [&](const auto& field, auto& buffer) {
            buffer.resize(count_of(field.count, scene));
            buffer.fill({});
        },
        fields_);
    fields_.length.upload(scene.cloth.length);
    fields_.warp_up.upload(scene.cloth.warp_up);
    fields_.warp_up_share.upload(scene.cloth.warp_up_share);
    fields_.fed.upload(scene.supply.fed);
    fields_.dry_pores.upload(scene.cloth.pores);
    fields_.touching.upload(scene.cloth.touching);
    fields_.room_along.upload(scene.cloth.room_along);
    fields_.contact.fill(no_particle);
    fields_.sweat.upload(scene.supply.skin.rate);
    panels_.upload(scene.cloth.panels);
    panels_now_ = panels_of(scene.cloth.panels);
    seams_.upload(scene.cloth.seams.joints);
    layers_.upload(scene.cloth.layers.joints);
    layer_flows_.resize(2 * scene.cloth.layers.joints.size());
    layer_flows_.fill({});
    layer_sides_.resize(layer_flows_.size() > 0 ? static_cast<std::size_t>(scene.cloth.segments()) : 0);
    type_.upload(scene.cloth.type);
    yarns_.upload(scene.cloth.yarns);
    crossing_.upload(scene.cloth.crossing);
    totals_.resize(1);
    reach_.resize(4);
    reach_.fill(-1);
    load_start();
}

template <typename Executor> void YarnNetwork<Executor>::load_start()
{
    YarnStart start = yarn_start(*scene_);
    fields_.pores.upload(start.pores);
    fields_.vapour.upload(start.vapour);
    fields_.regain.upload(start.regain);
    fields_.warmth.fill(scene_->cloth.start.warmth);
    if (!scene_->cloth.start.liquid.empty()) fields_.liquid.upload(scene_->cloth.start.liquid);
    if (by_suction()) upload_suctions(start, *scene_, fields_);
    Segments all = segments();
    all.unvisited = {};
    exec_.for_each("sum shells", all.visited_segments(), SumShells{all});
    steps_.load(*scene_, start.at_stake);
    if (scene_->rules.step_error <= 0) return;
    const FibreStart fibres = fibre_start(*scene_, start.regain, fields_.liquid.download());
    fields_.bound_before.upload(fibres.bound);
    fields_.heat_before.upload(fibres.heat);
}

template <typename Executor> void YarnNetwork<Executor>::set_climate(double time)
{
    if (scene_->climate.course.empty()) return;
    climate_ = climate_at(*scene_, time);
    yarns_.upload(yarns_in(*scene_, climate_));
}

/// Takes in the segments that particles have given liquid to.
template <typename Executor> void YarnNetwork<Executor>::include_absorbed()
{
    if (!may_have_absorbed_ || !region_.unvisited().any()) return;
    region_.include_reached(reach_.download());
    reach_.fill(-1);
}

template <typename Executor> NetworkStep YarnNetwork<Executor>::begin_step(double time, double dt, bool frame_due, bool drops_about)
{
    set_climate(time);
    include_absorbed();
    supply(time, dt);
    visit_standing();
    totals_.write(0, {});
    const double exchange_dt = time - exchange_time_;
    const bool is_due = frame_due || steps_.exchange_is_due(exchange_dt);
    const StepSigns signs{scene_->rules.step_error > 0 && !drops_about && !by_suction(), pools_.any_stands() || !caps_on_face_.empty()};
    const NetworkStep step{time, dt, exchange_dt, is_due, signs};
    move_liquid_and_heat(dt, step.signs);
    return step;
}

/// Along yarns and where they cross, with what has come since the last step.
template <typename Executor> void YarnNetwork<Executor>::move_liquid_and_heat(double dt, const StepSigns& signs)
{
    const bool wicking = scene_->rules.wicking, heat = scene_->rules.heat, moves = wicking || heat;
    double* const before = fields_.liquid_before.data();
    const TrackChange track{segments(), climate_.density, before, &totals_.data()->largest_change};
    if (!wicking) {
        const TrackChange remember{segments(), climate_.density, before, moves ? nullptr : track.largest};
        each_segment("take absorbed", InTurn<TakeAbsorbed, TrackChange>{{segments()}, remember});
    } else if (may_have_absorbed_)
        each_segment("take absorbed", TakeAbsorbed{segments()});
    may_have_absorbed_ = false;
    if (!moves) return;
    if (wicking && by_suction()) {
        each_segment("remember", TrackChange{segments(), climate_.density, before, nullptr});
        move_by_suction(dt);
        each_segment("change", track);
        if (heat) each_crossing("cross", ExchangeAtCrossing{segments(), climate_, dt, false, true});
        return;
    }
    if (wicking)
        each_line("wick",
                  WickAlongYarn{segments(), climate_, dt, scene_->cloth.gravity_along_warp, scene_->cloth.gravity_along_weft, before});
    if (heat) each_line("conduct", ConductAlongYarn{segments(), climate_, dt, scene_->cloth.face_only});
    const ExchangeAtCrossing cross{segments(), climate_, dt, wicking, heat};
    if (!signs.error) { // then the change of saturation counts alone
        each_crossing("cross", ExchangeAndTrack{cross, track});
        return;
    }
    each_crossing("cross", cross);
    if (wicking)
        each_line("wicking error", EstimateWicking{segments(),
                                                   {fields_.liquid_rate.data(), dt, steps_.wicking().dt, steps_.wicking().known},
                                                   before,
                                                   &totals_.data()->wicking_error});
    if (signs.pools) each_segment("change", track);
}

template <typename Executor> WaterGivenBack YarnNetwork<Executor>::swell(double least, std::size_t most)
{
    WaterGivenBack given;
    each_segment("swell", Swell{segments(), climate_.density, least, &totals_.data()->swollen});
    if (by_suction()) each_crossing("narrow room", NarrowRoom{segments(), climate_.density});
    if (most == 0 || totals_.read(0).swollen == 0) return given;
    const std::vector<double> surplus = fields_.work0.download();
    const Yarns all = yarns();
    for (int k = 0; k < all.visited_segments() && given.segments.size() < most; ++k)
        if (const int i = all.visited_segment(k); surplus[static_cast<std::size_t>(i)] >= least) given.segments.push_back(i);
    return given;
}

/// With fibres and air.
template <typename Executor> void YarnNetwork<Executor>::exchange(const NetworkStep& step)
{
    evaporated_from_drops_ = 0;
    if (!step.exchange_is_due) return;
    exchange_time_ = step.time;
    if (!exchanges_in(step)) return;
    const double dt = step.exchange_dt;
    flow_between_layers(dt);
    if (scene_->rules.vapour) {
        each_line("vapour",
                  DiffuseVapourAlongYarn{segments(), climate_, dt, scene_->cloth.cell_area, scene_->rules.heat, scene_->cloth.face_only});
        each_crossing("cross vapour", DiffuseAtCrossing{segments(), dt});
    }
    pass_between_layers(dt);
    const StandingOnFace stands = scene_->rules.vapour ? standing(step.time) : StandingOnFace();
    each_segment("exchange", ExchangeInSegment{{segments(), climate_, scene_->cloth.cell_area, dt, scene_->rules.sorption,
                                                scene_->rules.vapour, scene_->rules.heat},
                                               find_standing(stands)});
    take_evaporated(stands);
    if (scene_->rules.step_error <= 0) return;
    const RateWatch& watch = steps_.exchange();
    each_line("exchange error", EstimateExchange{segments(),
                                                 {fields_.bound_rate.data(), dt, watch.dt, watch.known},
                                                 {fields_.heat_rate.data(), dt, watch.dt, watch.known},
                                                 fields_.bound_before.data(),
                                                 fields_.heat_before.data(),
                                                 totals_.data()});
}

/// The host waits for the yarns here alone, unless particles or pools are about.
template <typename Executor> void YarnNetwork<Executor>::end_step(const NetworkStep& step, bool drops_about, bool wakes, double delivered)
{
    if (region_.unvisited().any())
        each_segment("find reach",
                     FindReach{segments(), climate_, scene_->rules.rest_tolerance, region_.threads_at_border(), {totals_.data()->reach}});
    const YarnTotals found = totals_.read(0);
    unsolved_lines_ += static_cast<double>(found.unsolved);
    steps_.choose_network_step(step.dt, step.signs, found, drops_about, delivered);
    if (wakes) steps_.begin_anew(drops_about);
    if (step.exchange_is_due) steps_.choose_exchange_step(step.exchange_dt, found, drops_about, delivered);
    steps_.follow_standing(standing_lasts(step.time));
    region_.include_reached(found.reach);
    const auto changes_now = [&](const ScenePool& pool) { return pool.next_change(step.time - step.dt) == step.time; };
    const bool changes = cap_landed_ || std::any_of(scene_->supply.pools.begin(), scene_->supply.pools.end(), changes_now) ||
                         scene_->supply.skin.jumps_at(step.time); // courses of climate have no jumps
    if (changes) steps_.begin_anew(drops_about);
}

template <typename Executor> template <typename Archive> void YarnNetwork<Executor>::pass_state(Archive& archive)
{
    steps_.pass_state(archive);
    archive.value(exchange_time_);
    archive.value(warp_first_);
    archive.value(unsolved_lines_);
    archive.value(pools_.pumped);
    archive.value(pools_.ran_off);
    archive.values(pools_.standing, "standing in pools");
    caps_.pass_state(archive);
    archive.value(film_);
    archive.value(evaporated_from_standing_);
    archive.value(region_.unvisited());
    if (Archive::reads && !Archive::stays) cells_were_seen_ = false;
    if (Archive::reads && !Archive::stays && !scene_->climate.course.empty())
        region_.unvisited() = {}; // the air may have been constant so far
    archive.buffer(reach_, "reach");
    if (layer_flows_.size() > 0) archive.buffer(layer_flows_, "flows between layers");
    pass_regain(archive);
    Segments::each(
        [&](const auto& field, auto& buffer) {
            if (field.saved && field.count != SegmentCount::shells) archive.buffer(buffer, field.name);
        },
        fields_);
}

/// Fibres that took part in nothing have one shell. Where they go on with more, all of a segment's begin with what the one holds.
template <typename Executor> template <typename Archive> void YarnNetwork<Executor>::pass_regain(Archive& archive)
{
    const auto own = static_cast<std::size_t>(scene_->rules.fibre_shells);
    auto shells = own;
    archive.value(shells);
    if (shells == own || shells != 1) {
        archive.buffer(fields_.regain, "regain");
        return;
    }
    std::vector<double> one(fields_.regain.size() / own), all(fields_.regain.size());
    archive.values(one, "regain");
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = one[i / own];
    fields_.regain.upload(all);
}

} // namespace hygroloom
