// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The yarns' part of Solver: one step of the network, the frame and the ledger. Included by solver.h.
#pragma once

#include "core/sim/solver.h"

#include <numeric>

namespace hygroloom {

constexpr double exchange_steps = 4.0; // network steps of full length between exchanges with fibres and air, which are slower

/// The largest change of saturation since before[], as bits of a float; before[] is brought up to date.
struct TrackChange {
    Segments s;
    double density;
    double* before;
    int* largest;
    HL_FN void operator()(int i) const
    {
        const double change = s.liquid[i] - before[i];
        if (change == 0) return;
        const YarnParameters& yarn = s.yarn_of(i);
        union {
            float value;
            int bits;
        } moved;
        moved.value = static_cast<float>((change < 0 ? -change : change) / (density * yarn.pore_area * s.length[i]));
        if (moved.value > 0) atomic_max(largest, moved.bits);
        before[i] = s.liquid[i];
    }
};

template <typename Executor> void Solver<Executor>::load_segments()
{
    const auto n = static_cast<std::size_t>(scene_.segments());
    const auto shells = static_cast<std::size_t>(scene_.fibre_shells);
    length_.upload(scene_.length);
    warp_up_.upload(scene_.warp_up);
    shift_.upload(scene_.shift.empty() ? std::vector<float>(n, 0.0f) : scene_.shift);
    type_.upload(scene_.type);
    yarns_.upload(scene_.yarns);
    crossing_.upload(scene_.crossing);
    for (auto* b : {&liquid_, &warmth_, &evaporated_, &released_, &lost_, &work0_, &work1_, &work2_, &flux_, &before_}) {
        b->resize(n);
        b->fill(0.0);
    }
    if (!scene_.initial_liquid.empty()) liquid_.upload(scene_.initial_liquid);
    absorbed_.resize(n);
    absorbed_.fill(0);
    contact_.resize(n);
    contact_.fill(no_particle);
    sums_.resize(2);
    sums_.fill(0);
    maxima_.resize(2);
    maxima_.fill(0);

    std::vector<double> vapour(n), regain(n * shells);
    const double background = scene_.climate.humidity * saturation_concentration(scene_.climate.temperature);
    const Yarns yarns = yarns_on_host();
    for (std::size_t i = 0; i < n; ++i) {
        const YarnParameters& yarn = yarns.yarn_of(static_cast<int>(i));
        const double liquid = scene_.initial_liquid.empty() ? 0.0 : scene_.initial_liquid[i];
        vapour[i] = background * pore_air(yarn, scene_.length[i], liquid, scene_.climate.density);
        std::fill_n(regain.begin() + static_cast<std::ptrdiff_t>(i * shells), shells, yarn.initial_regain);
    }
    vapour_.upload(vapour);
    regain_.upload(regain);
}

template <typename Executor> void Solver<Executor>::step_network(double dt, bool frame_due)
{
    const ClimateParameters& climate = scene_.climate;
    each_segment("take absorbed", TakeAbsorbed{segments()});
    maxima_.write(1, 0);
    each_segment("remember", TrackChange{segments(), climate.density, before_.data(), maxima_.data() + 1});
    if (scene_.wicking || scene_.heat) {
        maxima_.write(1, 0);
        const int lines = yarns().lines();
        if (scene_.wicking) exec_.for_each("wick", lines, WickAlongYarn{segments(), dt, climate.density, scene_.fed_segments});
        if (scene_.heat) exec_.for_each("conduct", lines, ConductAlongYarn{segments(), dt, climate.density});
        exec_.for_each("cross", scene_.crossings(), ExchangeAtCrossing{segments(), climate, dt, scene_.wicking, scene_.heat, false});
        each_segment("change", TrackChange{segments(), climate.density, before_.data(), maxima_.data() + 1});
    }
    if (frame_due || time_ - exchange_time_ >= 0.999 * exchange_steps * scene_.network_step) exchange(time_ - exchange_time_);

    union {
        float value;
        int bits;
    } change;
    change.bits = maxima_.read(1);
    const double wanted = 0.8 * scene_.saturation_change / std::max(1e-9, static_cast<double>(change.value));
    network_dt_ = std::clamp(network_dt_ * std::clamp(wanted, 0.5, 1.3), std::min(1e-4, scene_.network_step), scene_.network_step);
}

template <typename Executor> void Solver<Executor>::exchange(double dt)
{
    exchange_time_ = time_;
    if (dt <= 0 || (!scene_.sorption && !scene_.vapour)) return;
    const ClimateParameters& climate = scene_.climate;
    if (scene_.vapour) {
        const double background = climate.humidity * saturation_concentration(climate.temperature);
        exec_.for_each("vapour", yarns().lines(), DiffuseVapourAlongYarn{segments(), climate, dt, background, scene_.heat});
        exec_.for_each("cross vapour", scene_.crossings(), ExchangeAtCrossing{segments(), climate, dt, false, false, true});
    }
    each_segment("exchange", ExchangeInSegment{segments(), climate, scene_.cell_area, dt, scene_.sorption, scene_.vapour, scene_.heat});
}

template <typename Executor> Yarns Solver<Executor>::yarns()
{
    return {scene_.ends, scene_.picks, scene_.warp_types, scene_.weft_types(), type_.data(), yarns_.data(), crossing_.data()};
}

template <typename Executor> Yarns Solver<Executor>::yarns_on_host() const
{
    return {scene_.ends,        scene_.picks,        scene_.warp_types,     scene_.weft_types(),
            scene_.type.data(), scene_.yarns.data(), scene_.crossing.data()};
}

template <typename Executor> Segments Solver<Executor>::segments()
{
    Segments s;
    static_cast<Yarns&>(s) = yarns();
    s.shells = scene_.fibre_shells;
    s.length = length_.data();
    s.warp_up = warp_up_.data();
    s.liquid = liquid_.data();
    s.vapour = vapour_.data();
    s.warmth = warmth_.data();
    s.regain = regain_.data();
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

/// Summed on the host in segment order: the same on every machine.
template <typename Executor> Ledger Solver<Executor>::ledger()
{
    const auto sum = [](const std::vector<double>& values) {
        long double total = 0;
        for (double v : values) total += v;
        return static_cast<double>(total);
    };
    const std::vector<double> liquid = liquid_.download(), warmth = warmth_.download();
    std::vector<double> regain = regain_.download();
    const Segments s = fibres_on_host(regain);
    Ledger l;
    l.time = time_;
    l.water_initial = initial_;
    l.water_delivered = delivered_;
    const std::vector<std::int64_t> content = content_.download();
    l.water_free = static_cast<double>(std::accumulate(content.begin(), content.begin() + count_, std::int64_t(0))) * water_quantum;
    long double bound = 0, stored = 0;
    for (std::size_t i = 0; i < liquid.size(); ++i) {
        const YarnParameters& yarn = s.yarn_of(static_cast<int>(i));
        const double here = bound_water(s, yarn, static_cast<int>(i));
        bound += here;
        stored += heat_capacity(yarn, s.length[i], liquid[i] + here) * warmth[i];
    }
    l.water_liquid = sum(liquid);
    l.water_bound = static_cast<double>(bound);
    l.water_vapour = sum(vapour_.download());
    l.water_evaporated = sum(evaporated_.download());
    l.water_dripped = static_cast<double>(sums_.read(1)) * water_quantum;
    l.energy_stored = static_cast<double>(stored);
    l.energy_released = sum(released_.download());
    l.energy_lost = sum(lost_.download());
    return l;
}

template <typename Executor> Frame Solver<Executor>::frame()
{
    if (count_ > 0) sort_particles(); // drops the particles that were drunk since the last step
    Frame f;
    f.time = time_;
    f.ledger = ledger();
    const std::vector<double> liquid = liquid_.download(), vapour = vapour_.download(), warmth = warmth_.download();
    std::vector<double> regain = regain_.download();
    const Segments s = fibres_on_host(regain);
    const auto n = liquid.size();
    for (auto* values : {&f.saturation, &f.liquid, &f.regain, &f.vapour, &f.temperature}) values->resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const bool is_warp = i < n / 2;
        const YarnParameters& yarn = s.yarn_of(static_cast<int>(i));
        const double fibres = scene_.length[i] * yarn.fibre_area * yarn.fibre_density;
        const double bound = bound_water(s, yarn, static_cast<int>(i));
        const double air = pore_air(yarn, scene_.length[i], liquid[i], scene_.climate.density);
        f.saturation[i] = static_cast<float>(liquid[i] / (scene_.climate.density * yarn.pore_area * scene_.length[i]));
        f.liquid[i] = static_cast<float>(liquid[i]);
        f.regain[i] = static_cast<float>(bound / fibres);
        f.vapour[i] = static_cast<float>(vapour[i] / air);
        f.temperature[i] = static_cast<float>(scene_.climate.temperature + warmth[i]);
        const bool on_top = (scene_.warp_up[static_cast<std::size_t>(s.crossing_of(static_cast<int>(i)))] != 0) == is_warp;
        (on_top ? f.water_top : f.water_bottom) += liquid[i] + bound - yarn.initial_regain * fibres;
    }
    const std::vector<Vec3> x = position_.download(), v = velocity_.download();
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        f.positions.push_back({static_cast<float>(x[i].x), static_cast<float>(x[i].y), static_cast<float>(x[i].z)});
        f.velocities.push_back({static_cast<float>(v[i].x), static_cast<float>(v[i].y), static_cast<float>(v[i].z)});
    }
    return f;
}

} // namespace hygroloom
