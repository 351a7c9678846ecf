// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The part of a yarn network's step in which liquid flows by suctions.
#pragma once

#include "core/solver/yarn_network.h"

namespace hygroloom {

/// Along one system's yarns, and half of what passes across them.
template <typename Executor> void YarnNetwork<Executor>::flow_by_suction(double dt, bool of_warp)
{
    Segments s = segments();
    s.room_with_warp = of_warp;
    const Cloth& cloth = scene_->cloth;
    const StandingPool pool = standing_pool();
    const Yarns all = yarns();
    const int first = of_warp ? 0 : all.visited_warps(), lines = of_warp ? all.visited_warps() : all.visited_wefts();
    const int chains = of_warp ? all.panels.warp_chains : all.panels.weft_chains;
    const int longest = of_warp ? all.visited_picks() : all.visited_ends();
    exec_.for_each_line("flow", all.whole() ? lines : chains, all.whole() ? longest : all.panels.longest_chain,
                        FlowAlongLines{s, climate_, dt, 0.5 * dt, of_warp, lift(of_warp), pool, &totals_.data()->given,
                                       scene_->rules.suction_rounds, &totals_.data()->shed, &totals_.data()->unsolved,
                                       of_warp != warp_first_});
    if (scene_->rules.heat)
        exec_.for_each_line("conduct", lines, longest, FromLine<ConductAlongYarn>{{s, climate_, dt, cloth.face_only}, first});
}

/// Pa, by which suction rises from a crossing to the next along ends, or along picks, in liquid at rest.
template <typename Executor> double YarnNetwork<Executor>::lift(bool along_warp) const
{
    const Cloth& cloth = scene_->cloth;
    if (cloth.panels.count > 0) return climate_.density * gravity_acceleration; // for each m of rise
    return climate_.density * (along_warp ? cloth.gravity_along_warp * cloth.weft_pitch : cloth.gravity_along_weft * cloth.warp_pitch);
}

template <typename Executor> void YarnNetwork<Executor>::flow_between_touching(double dt, bool odd_first)
{
    for (bool of_odd : {odd_first, !odd_first}) // in turn, or water would run farther to one side
        each_segment("touching", FlowBetweenTouching{{segments(), climate_, dt}, of_odd, lift(false), lift(true)});
}

/// Joints of a group act at once, groups one after the other.
template <typename Executor> void YarnNetwork<Executor>::flow_through_seams(double dt)
{
    int first = 0;
    for (int end : scene_->cloth.seams.group_ends) {
        exec_.for_each("seams", end - first, FlowThroughSeam{{segments(), climate_, dt}, seams_.data() + first});
        first = end;
    }
}

/// The same of layers.
template <typename Executor>
template <typename Stage>
void YarnNetwork<Executor>::each_layer_joint(const char* name, const Stage& stage_from)
{
    int first = 0;
    for (int end : scene_->cloth.layers.group_ends) {
        exec_.for_each(name, end - first, stage_from(first));
        first = end;
    }
}

template <typename Executor> void YarnNetwork<Executor>::wick_between_layers(double dt)
{
    each_layer_joint("layers", [&](int first) { return WickBetweenLayers{{segments(), climate_, dt}, layers_.data() + first}; });
}

template <typename Executor> void YarnNetwork<Executor>::flow_between_layers(double dt)
{
    if (layer_flows_.size() == 0) return;
    const StepRules& rules = scene_->rules;
    const RateWatch& watch = steps_.exchange();
    LayerSide* const sides = layer_sides_.data();
    each_segment("see layers", SeeLayers{segments(), climate_, dt, watch.known ? watch.dt : dt, rules.heat, sides});
    if (rules.vapour)
        each_layer_joint("layers, go on", [&](int first) {
            return GoOnBetweenLayers{sides, segments(), dt, layers_.data() + first, layer_flows_.data() + 2 * first};
        });
    each_layer_joint("layers, flow", [&](int first) {
        return FlowBetweenLayers{sides, segments(), dt, rules.vapour, rules.heat, layers_.data() + first, layer_flows_.data() + 2 * first};
    });
}

template <typename Executor> void YarnNetwork<Executor>::pass_between_layers(double dt)
{
    const StepRules& rules = scene_->rules;
    LayerSide* const sides = layer_sides_.data();
    each_layer_joint("layers, pass", [&](int first) {
        return PassBetweenLayers{sides, segments(), dt, rules.vapour, rules.heat, layers_.data() + first, layer_flows_.data() + 2 * first};
    });
}

/// With what stands on the cloth.
template <typename Executor> void YarnNetwork<Executor>::move_by_suction(double dt)
{
    const bool pools = pools_.feeds();
    if (pools) {
        totals_.write(0, {});
        const WeighPool weigh{segments(),
                              face_under(0),
                              climate_.density,
                              pools_.standing_pool(*scene_, climate_).pressure,
                              pools_.weight_unit(*scene_),
                              &totals_.data()->asked};
        each_segment("weigh pool", weigh);
        each_segment("offer pool", OfferPool{weigh, pools_.standing[0]});
    }
    if (!caps_on_face_.empty()) offer_caps(dt);
    if (!scene_->rules.whole_flow || !flow_whole(dt)) flow_in_turn(dt);
    warp_first_ = !warp_first_;
    if (!caps_on_face_.empty()) caps_.take(cap_sums_.download());
    if (!pools && caps_on_face_.empty()) return;
    const YarnTotals found = totals_.read(0);
    if (pools) pools_.standing[0] -= found.given;
    pools_.ran_off.add(found.shed);
}

/// Along warp and weft, one after the other; the other way round in the next step. Touching yarns, seams and layers pass half before each,
/// which fills up what they have given.
template <typename Executor> void YarnNetwork<Executor>::flow_in_turn(double dt)
{
    const bool hands_over = scene_->rules.heat; // the liquid between yarns
    for (bool of_warp : {warp_first_, !warp_first_}) {
        if (fields_.touching.size() > 0) flow_between_touching(0.5 * dt, of_warp);
        if (hands_over && !of_warp) each_crossing("to weft", HandRoomOver{segments(), true});
        flow_through_seams(0.5 * dt);
        wick_between_layers(0.5 * dt);
        flow_by_suction(dt, of_warp);
        if (hands_over && !of_warp) each_crossing("to warp", HandRoomOver{segments(), false});
    }
}

} // namespace hygroloom
