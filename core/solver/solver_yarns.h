// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The yarns' part of Solver: one step of the network, the frame and the ledger. Included by solver.h.
#pragma once

#include "core/solver/solver.h"

#include <limits>
#include <numeric>

namespace hygroloom::inline HL_PRECISION {

/// The largest change of saturation since before[], as bits of a float; before[] is brought up to date.
struct TrackChange {
    Segments s;
    double density;
    double* before;
    int* largest; ///< null: nobody asks
    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        note(change_of(i, before[i]));
    }
    HL_FN void note(float change) const
    {
        union {
            float value;
            int bits;
        } moved;
        moved.value = change;
        if (largest != nullptr && change > 0) atomic_max_of_many(largest, moved.bits);
    }
    HL_FN float change_of(int i, double was) const
    {
        const double change = s.liquid[i] - was;
        if (change == 0) return 0;
        before[i] = s.liquid[i];
        return static_cast<float>((change < 0 ? -change : change) * plain_inverse(density * s.pores[i]));
    }
};

/// What moves at a crossing, and how much its segments have changed then.
struct ExchangeAndTrack {
    ExchangeAtCrossing exchange;
    TrackChange track;

    HL_FN void operator()(int index) const
    {
        const Segments& s = track.s;
        const auto [end, pick] = s.visited_place(index);
        const int a = s.warp_of(end, pick), b = s.weft_of(end, pick);
        const double was_a = track.before[a], was_b = track.before[b]; // under way while liquid and heat are exchanged
        exchange(index);
        const float warp = track.change_of(a, was_a), weft = track.change_of(b, was_b);
        track.note(warp > weft ? warp : weft);
    }
};

/// How far a yarn's regain is from what the air of any moment asks for.
template <typename Executor> double Solver<Executor>::largest_change(const YarnParameters& yarn) const
{
    double change = std::abs(yarn.initial_regain - yarn.resting_regain);
    for (const SceneClimate& moment : scene_.course)
        change = std::max(change, std::abs(yarn.initial_regain - equilibrium_regain(yarn.isotherm, moment.humidity,
                                                                                    scene_.climate.temperature + moment.air_warmth)));
    return change;
}

template <typename Executor> void Solver<Executor>::load_segments()
{
    const auto n = static_cast<std::size_t>(scene_.segments());
    const auto shells = static_cast<std::size_t>(scene_.fibre_shells);
    length_.upload(scene_.length);
    warp_up_.upload(scene_.warp_up);
    warp_up_share_.upload(scene_.warp_up_share);
    type_.upload(scene_.type);
    yarns_.upload(scene_.yarns);
    crossing_.upload(scene_.crossing);
    for (auto* b : {&liquid_, &evaporated_, &released_, &lost_, &work0_, &work1_, &work2_, &flux_, &before_, &uptake_}) {
        b->resize(n);
        b->fill(0.0);
    }
    fibre_water_.resize(n);
    may_have_absorbed_ = false;
    warmth_.resize(n);
    warmth_.fill(scene_.initial_warmth);
    fed_.upload(scene_.fed);
    supplied_.resize(scene_.fed.size());
    supplied_.fill(0.0);
    for (auto* b : {&liquid_rate_, &bound_, &bound_rate_, &heat_, &heat_rate_}) {
        b->resize(scene_.step_error > 0 ? n : 0);
        b->fill(0.0);
    }
    if (!scene_.initial_liquid.empty()) liquid_.upload(scene_.initial_liquid);
    absorbed_.resize(n);
    absorbed_.fill(0);
    contact_.resize(n);
    contact_.fill(no_particle);
    totals_.resize(1);

    std::vector<double> vapour(n), regain(n * shells), pores(n);
    const ClimateParameters& climate = scene_.climate;
    const double humidity = scene_.initial_humidity < 0 ? climate.humidity : scene_.initial_humidity;
    const double begins = scene_.vapour ? humidity : std::min(1.0, humidity); // more than saturated air condenses in the first exchange
    const double pore_vapour = begins * saturation_concentration(climate.temperature + scene_.initial_warmth);
    const Yarns yarns = yarns_on_host();
    water_scale_ = heat_scale_ = 0;
    constexpr double least_change = 1e-3; // of regain: where nothing is to change, nothing is to be followed more closely
    for (std::size_t i = 0; i < n; ++i) {
        const YarnParameters& yarn = yarns.yarn_of(static_cast<int>(i));
        const double liquid = scene_.initial_liquid.empty() ? 0.0 : scene_.initial_liquid[i];
        const double fibres = scene_.length[i] * yarn.fibre_area * yarn.fibre_density;
        const double dry = scene_.pores.empty() ? yarn.pore_area * scene_.length[i] : scene_.pores[i];
        pores[i] = std::max({0.05 * dry, liquid / climate.density, dry - scene_.swelling * yarn.initial_regain * fibres});
        vapour[i] = pore_vapour * pore_air(pores[i], liquid, climate.density);
        std::fill_n(regain.begin() + static_cast<std::ptrdiff_t>(i * shells), shells, yarn.initial_regain);
        if (scene_.sorption) water_scale_ += fibres * std::max(least_change, largest_change(yarn));
        heat_scale_ +=
            50.0 * heat_capacity(yarn, scene_.length[i], liquid); // K: temperatures settle at once, so errors of steps do not add up
    }
    // What is still to come counts too, or the first drops would have to be followed exactly.
    constexpr double filled = 0.2; // of the pores, by a bath
    if (!scene_.fed.empty()) water_scale_ += filled * climate.density * std::accumulate(pores.begin(), pores.end(), 0.0);
    for (const ScenePool& pool : scene_.pools) water_scale_ += pool.rate * (pool.end - pool.start) * climate.density;
    water_scale_ += sweat_rate() * scene_.calm_network_step;
    pores_.upload(pores);
    vapour_.upload(vapour);
    regain_.upload(regain);
    sum_shells();
    if (scene_.step_error > 0) note_start(regain);
    visit_from_start();
}

/// Nothing of a sample at rest, all of one that is not, or whose air changes.
template <typename Executor> void Solver<Executor>::visit_from_start()
{
    reach_.resize(4);
    reach_.fill(-1);
    unvisited_ = {};
    const bool stirred = !scene_.initial_liquid.empty() || scene_.initial_warmth != 0 || scene_.initial_humidity >= 0 ||
                         scene_.climate.humidity > 1 || !scene_.course.empty() || scene_.sweat > 0;
    if (scene_.rest_tolerance <= 0 || stirred) return;
    unvisited_ = {scene_.ends / 2, (scene_.ends - 1) / 2, scene_.picks / 2, (scene_.picks - 1) / 2};
    YarnTotals fed;
    for (int i = 0; i < static_cast<int>(scene_.fed.size()) / 2; ++i) {
        if (scene_.fed[static_cast<std::size_t>(i)] == 0) continue;
        const int end = i / scene_.picks, pick = i % scene_.picks;
        Reach{fed.reach}.include(yarns_on_host(), i);
        unvisited_.ends_before = std::min(unvisited_.ends_before, end);
        unvisited_.ends_after = std::min(unvisited_.ends_after, scene_.ends - 1 - end);
        unvisited_.picks_before = std::min(unvisited_.picks_before, pick);
        unvisited_.picks_after = std::min(unvisited_.picks_after, scene_.picks - 1 - pick);
    }
    visit_what_changed(fed.reach);
}

/// Takes in what lies within a radius (m) of the sample's middle.
template <typename Executor> void Solver<Executor>::visit_around(double radius)
{
    const auto least = [](int& out, int threads, double reach, double pitch) {
        out = std::min(out, std::max(0, static_cast<int>(0.5 * (threads - 1) - reach / pitch)));
    };
    least(unvisited_.ends_before, scene_.ends, radius, scene_.warp_pitch);
    least(unvisited_.ends_after, scene_.ends, radius, scene_.warp_pitch);
    least(unvisited_.picks_before, scene_.picks, radius, scene_.weft_pitch);
    least(unvisited_.picks_after, scene_.picks, radius, scene_.weft_pitch);
}

/// So many from the border of what is visited count as near to it.
template <typename Executor> int Solver<Executor>::threads_near()
{
    return 4 + std::max(yarns().visited_ends(), yarns().visited_picks()) / 16;
}

/// Grows by a quarter, or more, on the sides whose border liquid, vapour or heat has come near to: see Reach.
template <typename Executor> void Solver<Executor>::visit_what_changed(std::span<const int> reach)
{
    if (!unvisited_.any()) return;
    constexpr int least_growth = 8;
    const int near = threads_near(), growth = std::max(least_growth, std::max(yarns().visited_ends(), yarns().visited_picks()) / 4);
    const auto grow = [&](int& out, int threads, int farthest) { // farthest from the other side
        if (farthest >= threads - out - near) out = std::max(0, threads - 1 - farthest - growth);
    };
    grow(unvisited_.ends_after, scene_.ends, reach[0]);
    grow(unvisited_.picks_after, scene_.picks, reach[1]);
    grow(unvisited_.ends_before, scene_.ends, reach[2]);
    grow(unvisited_.picks_before, scene_.picks, reach[3]);
}

/// Takes in the segments that particles have given liquid to.
template <typename Executor> void Solver<Executor>::visit_what_drank()
{
    if (!may_have_absorbed_ || !unvisited_.any()) return;
    visit_what_changed(reach_.download());
    reach_.fill(-1);
}

/// What the fibres hold, from the regain of their shells.
template <typename Executor> void Solver<Executor>::sum_shells()
{
    Segments s = segments();
    s.unvisited = {};
    exec_.for_each("sum shells", s.visited_segments(), SumShells{s});
}

/// Water and heat of the fibres, from which the first changes count.
template <typename Executor> void Solver<Executor>::note_start(std::vector<double>& regain)
{
    const Segments s = fibres_on_host(regain);
    const std::vector<double> liquid = liquid_.download();
    std::vector<double> bound(liquid.size()), heat(liquid.size());
    for (std::size_t i = 0; i < liquid.size(); ++i) {
        const YarnParameters& yarn = s.yarn_of(static_cast<int>(i));
        bound[i] = bound_water(s, yarn, static_cast<int>(i));
        heat[i] = heat_capacity(yarn, s.length[i], liquid[i] + bound[i]) * scene_.initial_warmth;
    }
    bound_.upload(bound);
    heat_.upload(heat);
}

/// The air of this moment, and the regain it leaves fibres alone with.
template <typename Executor> void Solver<Executor>::set_climate()
{
    if (scene_.course.empty()) return;
    const SceneClimate now = air_at(scene_, time_);
    ClimateParameters& climate = scene_.climate;
    climate.air_warmth = now.air_warmth;
    climate.humidity = now.humidity;
    climate.vapour = now.humidity * saturation_concentration(climate.temperature + now.air_warmth);
    climate.heat_transfer = now.heat_transfer;
    climate.mass_transfer = now.mass_transfer;
    for (YarnParameters& yarn : scene_.yarns)
        yarn.resting_regain = equilibrium_regain(yarn.isotherm, climate.humidity, climate.temperature + climate.air_warmth);
    yarns_.upload(scene_.yarns);
}

/// The next moment at which something begins or ends; steps end there.
template <typename Executor> double Solver<Executor>::next_event() const
{
    double next = std::numeric_limits<double>::infinity();
    const auto consider = [&](double time) {
        if (time > time_) next = std::min(next, time);
    };
    if (next_droplet_ < scene_.droplets.size()) consider(scene_.droplets[next_droplet_].time);
    for (const ScenePool& pool : scene_.pools) {
        consider(pool.start);
        consider(pool.end);
    }
    for (const SceneClimate& moment : scene_.course) consider(moment.time);
    return next;
}

/// Liquid that came without drops in the last dt.
template <typename Executor> void Solver<Executor>::supply(double dt)
{
    if (!scene_.fed.empty()) each_segment("keep fed", KeepFed{segments(), scene_.climate.density});
    drink(dt);
    if (scene_.sweat > 0) sweat(dt);
    may_have_absorbed_ = may_have_absorbed_ || !pool_.empty() || scene_.sweat > 0;
}

/// Pools fill, and the yarns under them drink: a pool lies within the circle of a half ball of its volume.
template <typename Executor> void Solver<Executor>::drink(double dt)
{
    const double density = scene_.climate.density;
    for (std::size_t k = 0; k < pool_.size(); ++k) {
        const ScenePool& pool = scene_.pools[k];
        const double running = std::clamp(time_, pool.start, pool.end) - std::clamp(time_ - dt, pool.start, pool.end);
        const std::int64_t came = std::llround(pool.rate * running * density / water_quantum);
        pool_[k] += came;
        pumped_.add(came);
        if (pool_[k] <= 0) continue;
        const double volume = static_cast<double>(pool_[k]) * water_quantum / density;
        const int threads = scene_.threads_per_cell;
        const double cell = std::max(scene_.warp_pitch, scene_.weft_pitch);
        const double radius = std::max(std::cbrt(1.5 * volume / pi), cell / threads);
        visit_around(threads > 1 ? radius + cell : radius); // a cell may be covered in part
        totals_.write(0, {});
        const FedFace face{pool.top, radius, scene_.warp_pitch, scene_.weft_pitch, threads};
        const AskPool ask{segments(), face, density, dt, -1.0, &totals_.data()->asked};
        each_segment("ask pool", ask);
        each_segment("take from pool", TakeFromPool{ask, pool_[k], &totals_.data()->given});
        pool_[k] -= totals_.read(0).given;
    }
}

/// Each segment of the face gets its share; what finds no room runs off.
template <typename Executor> void Solver<Executor>::sweat(double dt)
{
    const double each = scene_.sweat * scene_.cell_area * scene_.climate.density * dt;
    const std::int64_t offered = static_cast<std::int64_t>(each / water_quantum) * scene_.crossings();
    totals_.write(0, {});
    const AskPool ask{segments(), {scene_.sweat_on_top, -1.0, 0, 0}, scene_.climate.density, dt, each, &totals_.data()->asked};
    each_segment("sweat", TakeFromPool{ask, offered, &totals_.data()->given});
    pumped_.add(offered);
    ran_off_.add(offered - totals_.read(0).given);
}

/// The host waits for the yarns once, at the end of their step, unless particles or pools are about.
template <typename Executor> void Solver<Executor>::step_network(double dt, bool frame_due)
{
    set_climate();
    visit_what_drank();
    supply(dt);
    totals_.write(0, {});
    const Signs signs{scene_.step_error > 0 && !drops_about(), pools_stand()};
    move_liquid_and_heat(dt, signs);
    const double exchange_dt = time_ - exchange_time_;
    const bool exchange_due = frame_due || exchange_dt >= 0.999 * exchange_dt_;
    const bool wakes = exchange_due && exchange(exchange_dt);
    if (unvisited_.any())
        each_segment("find reach", FindReach{segments(), scene_.climate, scene_.rest_tolerance, threads_near(), {totals_.data()->reach}});
    const YarnTotals found = totals_.read(0);
    choose_network_step(dt, signs, found);
    if (wakes) begin_anew();
    if (exchange_due) choose_exchange_step(exchange_dt, found);
    visit_what_changed(found.reach);
    const auto changes_now = [this](const ScenePool& pool) { return pool.start == time_ || pool.end == time_; };
    if (std::any_of(scene_.pools.begin(), scene_.pools.end(), changes_now)) begin_anew(); // courses of climate have no jumps
}

/// Along yarns and where they cross, with what has come since the last step.
template <typename Executor> void Solver<Executor>::move_liquid_and_heat(double dt, const Signs& signs)
{
    const ClimateParameters& climate = scene_.climate;
    const bool moves = scene_.wicking || scene_.heat;
    const TrackChange track{segments(), climate.density, before_.data(), &totals_.data()->largest_change};
    if (!scene_.wicking) {
        const TrackChange remember{segments(), climate.density, before_.data(), moves ? nullptr : track.largest};
        each_segment("take absorbed", InTurn<TakeAbsorbed, TrackChange>{{segments()}, remember});
    } else if (may_have_absorbed_)
        each_segment("take absorbed", TakeAbsorbed{segments()});
    may_have_absorbed_ = false;
    if (!moves) return;
    if (scene_.wicking)
        each_line("wick", WickAlongYarn{segments(), climate, dt, scene_.gravity_along_warp, scene_.gravity_along_weft, before_.data()});
    if (scene_.heat) each_line("conduct", ConductAlongYarn{segments(), climate, dt, scene_.face_only});
    const ExchangeAtCrossing cross{segments(), climate, dt, scene_.wicking, scene_.heat};
    if (!signs.error) { // then the change of saturation counts alone
        each_crossing("cross", ExchangeAndTrack{cross, track});
        return;
    }
    each_crossing("cross", cross);
    if (scene_.wicking)
        each_line("wicking error", EstimateWicking{segments(),
                                                   {liquid_rate_.data(), dt, wicking_watch_.dt, wicking_watch_.known},
                                                   before_.data(),
                                                   &totals_.data()->wicking_error});
    if (signs.pools) each_segment("change", track);
}

template <typename Executor> double Solver<Executor>::water_at_stake() const { return std::max(1e-30, water_scale_ + delivered_); }

template <typename Executor> bool Solver<Executor>::pools_stand() const
{
    return std::any_of(pool_.begin(), pool_.end(), [](std::int64_t quanta) { return quanta > 0; });
}

/// From the error of the last step, and from the change of saturation while drops or pools are about.
template <typename Executor> void Solver<Executor>::choose_network_step(double dt, const Signs& signs, const YarnTotals& found)
{
    wicking_watch_ = {dt, signs.error};
    double grow = 1.5;
    if (signs.error && scene_.wicking) grow = growth(static_cast<double>(found.wicking_error) * water_quantum / water_at_stake());
    if (signs.change()) {
        union {
            float value;
            int bits;
        } change;
        change.bits = found.largest_change;
        const double wanted = 0.8 * scene_.saturation_change / std::max(1e-9, static_cast<double>(change.value));
        grow = std::min(grow, std::clamp(wanted, 0.5, 1.3));
    }
    network_dt_ = std::clamp(network_dt_ * grow, std::min(1e-4, scene_.network_step), step_limit());
}

/// From the error of the last exchange.
template <typename Executor> void Solver<Executor>::choose_exchange_step(double dt, const YarnTotals& found)
{
    if (!exchanges()) exchange_dt_ = exchange_limit(); // nothing is exchanged that steps would have to follow
    if (dt <= 0 || !exchanges() || scene_.step_error <= 0) return;
    const double water = static_cast<double>(found.bound_error) * water_quantum / water_at_stake();
    const double heat = static_cast<double>(found.heat_error) * EstimateExchange::heat_quantum / std::max(1e-30, heat_scale_);
    exchange_watch_ = {dt, true};
    exchange_dt_ =
        std::clamp(std::min(exchange_dt_, 2.0 * dt) * growth(std::max(water, heat)), std::min(1e-4, scene_.network_step), exchange_limit());
}

/// Returns whether it wakes free liquid.
template <typename Executor> bool Solver<Executor>::exchange(double dt)
{
    exchange_time_ = time_;
    if (dt <= 0 || !exchanges()) return false;
    const ClimateParameters& climate = scene_.climate;
    const bool wakes = scene_.swelling > 0 && swell();
    if (scene_.vapour) {
        each_line("vapour", DiffuseVapourAlongYarn{segments(), climate, dt, scene_.cell_area, scene_.heat, scene_.face_only});
        each_crossing("cross vapour", DiffuseAtCrossing{segments(), dt});
    }
    each_segment("exchange", ExchangeInSegment{segments(), climate, scene_.cell_area, dt, scene_.sorption, scene_.vapour, scene_.heat});
    if (scene_.step_error > 0)
        each_line("exchange error", EstimateExchange{segments(),
                                                     {bound_rate_.data(), dt, exchange_watch_.dt, exchange_watch_.known},
                                                     {heat_rate_.data(), dt, exchange_watch_.dt, exchange_watch_.known},
                                                     bound_.data(),
                                                     heat_.data(),
                                                     totals_.data()});
    return wakes;
}

/// Where there is free liquid, swollen yarns give back to it what they have no room for. Returns whether that wakes it.
template <typename Executor> bool Solver<Executor>::swell()
{
    constexpr double least_part = 0.25; // of a particle
    const double least = least_part * static_cast<double>(particle_mass_);
    each_segment("swell", Swell{segments(), scene_.climate.density, scene_.swelling, least, &totals_.data()->swollen});
    if (room_ == 0 || totals_.read(0).swollen == 0) return false;
    std::size_t kept = 0; // for drops to come
    for (std::size_t k = next_droplet_; k < scene_.droplets.size(); ++k) kept += particles_of(scene_.droplets[k].volume);
    const std::size_t room = static_cast<std::size_t>(room_ - flow_.count) - kept;
    const std::vector<double> surplus = work0_.download();
    std::vector<int> from;
    for (int k = 0; k < yarns().visited_segments() && from.size() < room; ++k)
        if (const int i = yarns().visited_segment(k); surplus[static_cast<std::size_t>(i)] >= least) from.push_back(i);
    if (from.empty()) return false;
    from_.upload(from);
    exec_.for_each("give back", static_cast<int>(from.size()),
                   GiveBack{particle_views(), shape(), segments(), scene_.climate.density, from_.data(), flow_.count,
                            Real(1.1) * touching_in_spacings * spacing_});
    const bool wakes = flow_.count == 0 || flow_.asleep;
    flow_.count += static_cast<int>(from.size());
    flow_.listed_for = 0;
    flow_.asleep = 0;
    flow_.roused = time_;
    const double settling = rules_.capillary_time(static_cast<double>(from.size()) * std::pow(static_cast<double>(spacing_), 3));
    flow_.settling = wakes ? settling : std::max(flow_.settling, settling);
    flow_.longest_dt = std::min(flow_.longest_dt, rules_.longest_step());
    return wakes;
}

template <typename Executor> Yarns Solver<Executor>::yarns()
{
    return {scene_.ends, scene_.picks, scene_.warp_types, scene_.weft_types(), type_.data(), yarns_.data(), crossing_.data(), unvisited_};
}

template <typename Executor> Yarns Solver<Executor>::yarns_on_host() const
{
    return {scene_.ends,        scene_.picks,        scene_.warp_types,      scene_.weft_types(),
            scene_.type.data(), scene_.yarns.data(), scene_.crossing.data(), {}};
}

template <typename Executor> Segments Solver<Executor>::segments()
{
    Segments s;
    static_cast<Yarns&>(s) = yarns();
    s.shells = scene_.fibre_shells;
    s.length = length_.data();
    s.warp_up = warp_up_.data();
    s.warp_up_share = scene_.warp_up_share.empty() ? nullptr : warp_up_share_.data();
    s.fed = scene_.fed.empty() ? nullptr : fed_.data();
    s.pores = pores_.data();
    s.supplied = supplied_.data();
    s.uptake = uptake_.data();
    s.liquid = liquid_.data();
    s.vapour = vapour_.data();
    s.warmth = warmth_.data();
    s.regain = regain_.data();
    s.bound = fibre_water_.data();
    s.absorbed = absorbed_.data();
    s.contact = contact_.data();
    s.evaporated = evaporated_.data();
    s.released = released_.data();
    s.lost = lost_.data();
    s.work0 = work0_.data();
    s.work1 = work1_.data();
    s.work2 = work2_.data();
    s.flux = flux_.data();
    return s;
}

/// Views for bound_water() on the host; of the segments' arrays only these are there.
template <typename Executor> Segments Solver<Executor>::fibres_on_host(std::vector<double>& regain) const
{
    Segments s;
    static_cast<Yarns&>(s) = yarns_on_host();
    s.shells = scene_.fibre_shells;
    s.length = scene_.length.data();
    s.regain = regain.data();
    return s;
}

/// Segments that are not visited neither hold liquid nor are warmer or cooler than the air.
template <typename Executor> Stock Solver<Executor>::take_stock()
{
    each_segment("take stock", TakeStock{segments(), work1_.data()});
    Stock stock;
    stock.time = time_;
    stock.delivered = delivered_ + pumped_.mass();
    stock.standing = std::accumulate(pool_.begin(), pool_.end(), std::int64_t(0));
    stock.dripped = static_cast<double>(flow_.dripped) * water_quantum + ran_off_.mass();
    stock.unvisited = unvisited_;
    snapshot_.take([&](const auto& look_at) {
        const auto particles = static_cast<std::size_t>(flow_.count);
        stock.liquid = look_at(liquid_, liquid_.size());
        stock.vapour = look_at(vapour_, vapour_.size());
        stock.warmth = look_at(warmth_, warmth_.size());
        stock.bound = look_at(fibre_water_, fibre_water_.size());
        stock.stored = look_at(work1_, work1_.size());
        stock.pores = look_at(pores_, pores_.size());
        stock.supplied = look_at(supplied_, supplied_.size());
        stock.evaporated = look_at(evaporated_, evaporated_.size());
        stock.released = look_at(released_, released_.size());
        stock.lost = look_at(lost_, lost_.size());
        stock.regain = look_at(regain_, scene_.shows_shells ? regain_.size() : 0);
        stock.position = look_at(position_, particles);
        stock.velocity = look_at(velocity_, particles);
        stock.content = look_at(content_, particles);
        stock.alive = look_at(alive_, particles);
    });
    if (scene_.shows_pressure) {
        stock.stress = stress_.download();
        stock.stressed = time_ - stress_since_;
        stress_.fill(0);
        stress_since_ = time_;
    }
    return stock;
}

inline double sum_of(std::span<const double> values)
{
    long double total = 0;
    for (double v : values) total += v;
    return static_cast<double>(total);
}

inline double sum_of_visited(const Yarns& yarns, std::span<const double> values)
{
    long double total = 0;
    for (int line = 0; line < yarns.visited_lines(); ++line) {
        const YarnLine l = yarns.visited_line(line);
        for (int i = l.first; i < l.last; ++i) total += values[static_cast<std::size_t>(i)];
    }
    return static_cast<double>(total);
}

/// Summed on the host in segment order: the same on every machine.
template <typename Executor> Ledger Solver<Executor>::ledger(const Stock& stock) const
{
    Yarns yarns = yarns_on_host();
    yarns.unvisited = stock.unvisited;
    // Where the others are 0.
    const auto sum_visited = [&yarns](std::span<const double> values) { return sum_of_visited(yarns, values); };
    Ledger l;
    l.time = stock.time;
    l.water_initial = initial_;
    l.water_delivered = stock.delivered + sum_of(stock.supplied);
    std::int64_t free = stock.standing;
    for (std::size_t i = 0; i < stock.alive.size(); ++i) free += stock.alive[i] ? stock.content[i] : 0;
    l.water_free = static_cast<double>(free) * water_quantum;
    l.water_liquid = sum_visited(stock.liquid);
    l.water_bound = sum_of(stock.bound);
    l.water_vapour = sum_of(stock.vapour);
    l.water_evaporated = sum_visited(stock.evaporated);
    l.water_dripped = stock.dripped;
    l.energy_stored = sum_visited(stock.stored);
    l.energy_delivered = initial_energy_;
    l.energy_released = sum_visited(stock.released);
    l.energy_lost = sum_visited(stock.lost);
    return l;
}

template <typename Executor> void Solver<Executor>::show_particles(const Stock& stock, Frame& f) const
{
    const auto &x = stock.position, &v = stock.velocity;
    for (std::size_t i = 0; i < stock.alive.size(); ++i) {
        if (!stock.alive[i]) continue;
        f.positions.push_back({static_cast<float>(x[i].x), static_cast<float>(x[i].y), static_cast<float>(x[i].z)});
        f.velocities.push_back({static_cast<float>(v[i].x), static_cast<float>(v[i].y), static_cast<float>(v[i].z)});
        if (scene_.shows_pressure)
            f.pressures.push_back(stock.stressed > 0 ? static_cast<float>(static_cast<double>(stock.stress[i]) / stock.stressed) : 0.0F);
    }
}

template <typename Executor> Frame Solver<Executor>::frame_of(const Stock& stock)
{
    snapshot_.fetch();
    Frame f;
    f.time = stock.time;
    f.ledger = ledger(stock);
    f.shells.assign(stock.regain.begin(), stock.regain.end());
    Segments s;
    static_cast<Yarns&>(s) = yarns_on_host();
    f.resize_fields(stock.liquid.size());
    for (int line = 0; line < s.visited_lines(); ++line) { // on the host all are visited
        const YarnLine l = s.visited_line(line);
        const double fibre_mass = l.yarn.fibre_area * l.yarn.fibre_density;
        std::size_t crossing = static_cast<std::size_t>(s.crossing_of(l.first));
        for (auto i = static_cast<std::size_t>(l.first); i < static_cast<std::size_t>(l.last); ++i) {
            const double fibres = scene_.length[i] * fibre_mass, liquid = stock.liquid[i], bound = stock.bound[i], pores = stock.pores[i];
            f.saturation[i] = static_cast<float>(liquid / (scene_.climate.density * pores));
            f.liquid[i] = static_cast<float>(liquid);
            f.regain[i] = static_cast<float>(bound / fibres);
            const double temperature = scene_.climate.temperature + stock.warmth[i];
            const double vapour = stock.vapour[i] / pore_air(pores, liquid, scene_.climate.density);
            // Where vapour is not modelled, none of it makes way for the liquid or condenses.
            f.vapour[i] = static_cast<float>(scene_.vapour ? vapour : std::min(vapour, saturation_concentration(temperature)));
            f.temperature[i] = static_cast<float>(temperature);
            const bool on_top = (scene_.warp_up[crossing] != 0) == l.is_warp;
            (on_top ? f.water_top : f.water_bottom) += liquid + bound - l.yarn.initial_regain * fibres;
            crossing += l.is_warp ? 1 : static_cast<std::size_t>(scene_.picks);
        }
    }
    show_particles(stock, f);
    return f;
}

} // namespace hygroloom::inline HL_PRECISION
