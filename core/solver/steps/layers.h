// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What passes between layers of cloth that lie on each other: pairs of crossings, each pair for itself.
#pragma once

#include "core/solver/steps/crossing_exchange.h"
#include "core/solver/steps/pair_flow.h"

namespace hygroloom {

/// The segments of two crossings that face each other: warp and warp, weft and weft.
struct FacingSegments {
    int a, b;

    HL_FN FacingSegments(const Segments& s, const LayerJoint& joint, bool is_warp)
        : a(is_warp ? joint.a : s.weft_of(joint.a / s.picks, joint.a % s.picks)),
          b(is_warp ? joint.b : s.weft_of(joint.b / s.picks, joint.b % s.picks))
    {
    }
};

/// Liquid where layers touch: from yarns into yarns, from the room between yarns of one layer into yarns of the other and back, and from
/// room into room. A full layer so hands on what its rooms hold, too.
struct WickBetweenLayers : PairFlow {
    const LayerJoint* joints;

    HL_FN void operator()(int index) const
    {
        const LayerJoint& joint = joints[index];
        if (is_dry(joint.a) && is_dry(joint.b)) return;
        flow(room_side(joint.a), room_side(joint.b), {joint.rooms, of_room, 0});
        for (bool is_warp : {true, false}) {
            const FacingSegments facing(s, joint, is_warp);
            const Side a = side(facing.a), b = side(facing.b);
            flow(a, b, {0.5 * joint.yarns * past_finish(a, b.suction()) * past_finish(b, a.suction()), of_yarn, 0});
            with_room(joint.a, facing.b, 0.5 * joint.a_room_to);
            with_room(joint.b, facing.a, 0.5 * joint.b_room_to);
        }
    }

private:
    static constexpr int of_yarn = 7, of_room = usual_quarters_of_room; ///< see Way::power
    static constexpr int of_face = 4;                                   ///< of a room's liquid the yarn touches as large a part as it fills

    HL_FN bool is_dry(int crossing) const
    {
        const int weft = s.weft_of(crossing / s.picks, crossing % s.picks);
        return s.liquid[crossing] <= 0 && s.liquid[weft] <= 0 && s.between[crossing] <= 0;
    }
    HL_FN void with_room(int crossing, int segment, double conductance) const
    {
        const Side room = room_side(crossing), yarn = side(segment);
        flow(room, yarn, {conductance * past_finish(yarn, room.suction()), yarn.suction() > room.suction() ? of_face : of_yarn, 0});
    }
    /// Share that the finish of the face that a yarn lies on leaves to liquid of a suction, Pa, whichever face the other layer touches.
    HL_FN double past_finish(const Side& yarn, double suction) const
    {
        const int crossing = s.crossing_of(yarn.segment);
        return s.yarn_of(yarn.segment).on_face[s.face_of(crossing, s.is_warp(yarn.segment))].finish.lets_through(-suction);
    }
};

/// What passes between two segments that face each other: now, and as the next step first takes it to go on. W, kg/s.
struct LayerFlow {
    double heat = 0, heat_now = 0;
    double vapour = 0, vapour_now = 0;
    double corrected = 0; ///< in the last step: kg of vapour, or J without
    double caution = 1;   ///< on the responses of both sides: more where corrections change their sign and grow, or fall by less than half

    HL_FN void take_care(double correction)
    {
        constexpr double most = 4, fades = 0.8;
        const bool swings =
            correction * corrected < 0 && (correction > 0 ? correction + 0.5 * corrected : -correction - 0.5 * corrected) > 0;
        caution = swings ? (caution < 0.5 * most ? 2 * caution : most) : (fades * caution > 1 ? fades * caution : 1);
        corrected = correction;
    }
};

/// A segment under or over another layer: what it has, and by how much vapour (kg) and heat (J) that come in a step change it.
struct LayerSide {
    double vapour = 0, warmth = 0;                   ///< kg/m3, K
    double vapour_by_vapour = 0, vapour_by_heat = 0; ///< 1/m3, kg/(m3 J)
    double warmth_by_vapour = 0, warmth_by_heat = 0; ///< K/kg, K/J
    double vapour_as_it_goes_on = 0;                 ///< 1/m3, by how much a flow that goes on changes what liquid brings vapour to
    double at_hand = 0;                              ///< kg of vapour that it can give

    HL_FN void take(double mass, double heat)
    {
        vapour += vapour_by_vapour * mass + vapour_by_heat * heat;
        warmth += warmth_by_vapour * mass + warmth_by_heat * heat;
    }
};

/// Finds it from the balances of ExchangeInSegment about where the last one ended: fibres and liquid take vapour and warm, and give some
/// as they warm. Vapour is that of the pores, or what liquid will have brought it to, the more the more of it liquid feeds: the little air
/// of full pores does not tell it.
struct SeeLayers {
    Segments s;
    ClimateParameters climate;
    double dt, dt_before; ///< of this exchange and the last, in which fibres' uptake was found
    bool heat;
    LayerSide* sides;

    /// On the responses: found too small, corrections overshoot and flows swing; too large, they only take more steps.
    static constexpr double cautious = 2;

    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        const YarnParameters& yarn = s.yarn_of(i);
        const ForeseeVapour foresee(s, climate, yarn, dt, 0.0, false);
        const Saturation saturated = saturation_at(climate.temperature + s.warmth[i]);
        const double air = foresee.air(i), fed = foresee.supply(i, saturated.concentration), still = air + foresee.to_air_at(i);
        const VapourAtHome home = foresee(i);
        const double squeezed = s.vapour[i] * plain_inverse(air);
        const double vapour = squeezed < saturated.concentration ? squeezed : saturated.concentration;
        const double by_mass = plain_inverse(home.pivot), by_kept = plain_inverse(air + s.uptake[i] + fed);
        LayerSide side;
        side.vapour = (s.vapour[i] + s.uptake[i] * vapour + fed * home.known * by_mass) * by_kept;
        side.warmth = s.warmth[i];
        side.vapour_by_vapour = by_mass;
        side.vapour_as_it_goes_on = fed * by_kept * by_mass;
        constexpr double share = 0.9; // of what it holds
        const double held = vapour * (air + s.uptake[i]) + s.liquid[i];
        side.at_hand = held > 0 ? share * held : 0.0;
        if (heat) {
            const double latent = heat_of_evaporation(climate.temperature + s.warmth[i]);
            const double humidity = vapour < saturated.concentration ? vapour * plain_inverse(saturated.concentration) : 1.0;
            const double capacity =
                heat_capacity(yarn, s.fibre_length(i, yarn), s.warm_water(i)) + dt * s.air_over(i).heat_transfer * s.cell_area(i);
            const double taken = uptake(i, humidity * saturated.slope * latent * plain_inverse(capacity));
            const double given = saturated.slope * (humidity * taken + fed); // kg/K
            const double mass_by_vapour = still + taken + fed, heat_by_warmth = capacity + latent * given;
            const double scale = plain_inverse(mass_by_vapour * heat_by_warmth - given * latent * (taken + fed));
            side.vapour_by_vapour = heat_by_warmth * scale;
            side.vapour_by_heat = given * scale;
            side.warmth_by_vapour = latent * (taken + fed) * scale;
            side.warmth_by_heat = mass_by_vapour * scale;
        }
        for (double* response : {&side.vapour_by_vapour, &side.vapour_by_heat, &side.warmth_by_vapour, &side.warmth_by_heat})
            *response *= cautious;
        sides[i] = side;
    }
    /// m3 at a steady temperature, from what it was with its own warming; of the shorter step, where that is.
    HL_FN double uptake(int i, double warming) const
    {
        constexpr double most = 0.95;
        const double slowed = s.uptake[i] * warming;
        const double steady = s.uptake[i] * plain_inverse(1.0 - (slowed < most ? slowed : most));
        return dt < dt_before ? steady * dt * plain_inverse(dt_before) : steady;
    }
};

/// Counts in what flows that go on leave of the vapour that liquid would bring each side to.
struct GoOnBetweenLayers {
    LayerSide* sides;
    Segments s;
    double dt;
    const LayerJoint* joints;
    const LayerFlow* flows;

    HL_FN void operator()(int index) const
    {
        for (bool is_warp : {true, false}) {
            const auto [a, b] = FacingSegments(s, joints[index], is_warp);
            const double passes = dt * flows[2 * index + (is_warp ? 1 : 0)].vapour_now;
            sides[a].vapour -= sides[a].vapour_as_it_goes_on * passes;
            sides[b].vapour += sides[b].vapour_as_it_goes_on * passes;
        }
    }
};

/// How much heat and vapour flow through the air between. What the exchange with fibres and air leaves must not depend on the step's length
/// where nothing changes any more: a flow goes on as in the step before, corrected by what the layers' end state of that step asks for
/// (rebalanced splitting: Speth et al. 2013, doi 10.1137/120878641). Half of a correction stays for the next step, so that none comes
/// twice.
struct FlowBetweenLayers {
    LayerSide* sides;
    Segments s;
    double dt;
    bool vapour, heat;
    const LayerJoint* joints;
    LayerFlow* flows; ///< two per joint

    HL_FN void operator()(int index) const
    {
        for (bool is_warp : {true, false}) {
            const auto [of_a, of_b] = FacingSegments(s, joints[index], is_warp);
            LayerSide &a = sides[of_a], &b = sides[of_b];
            LayerFlow& flow = flows[2 * index + (is_warp ? 1 : 0)];
            const double mass = vapour ? 0.5 * dt * joints[index].vapour : 0.0, joules = heat ? 0.5 * dt * joints[index].heat : 0.0;
            const double missing_mass = mass * (a.vapour - b.vapour) - dt * flow.vapour;
            const double missing_heat = joules * (a.warmth - b.warmth) - dt * flow.heat;
            const double c = flow.caution, mm = 1.0 + c * mass * (a.vapour_by_vapour + b.vapour_by_vapour),
                         mh = c * mass * (a.vapour_by_heat + b.vapour_by_heat), hm = c * joules * (a.warmth_by_vapour + b.warmth_by_vapour),
                         hh = 1.0 + c * joules * (a.warmth_by_heat + b.warmth_by_heat);
            const double scale = plain_inverse(mm * hh - mh * hm);
            const double more_mass = (hh * missing_mass - mh * missing_heat) * scale,
                         more_heat = (mm * missing_heat - hm * missing_mass) * scale;
            a.take(-more_mass, -more_heat);
            b.take(more_mass, more_heat);
            flow.take_care(vapour ? more_mass : more_heat);
            correct(more_mass, flow.vapour, flow.vapour_now);
            correct(more_heat, flow.heat, flow.heat_now);
        }
    }
    HL_FN void correct(double more, double& flow, double& now) const
    {
        const double rate = more * plain_inverse(dt);
        now = flow + rate;
        flow += 0.5 * rate;
    }
};

/// Hands the flows to the exchange, of vapour never more than the giving side has at hand.
struct PassBetweenLayers {
    LayerSide* sides;
    Segments s;
    double dt;
    bool vapour, heat;
    const LayerJoint* joints;
    LayerFlow* flows;

    HL_FN void operator()(int index) const
    {
        for (bool is_warp : {true, false}) {
            const auto [a, b] = FacingSegments(s, joints[index], is_warp);
            LayerFlow& flow = flows[2 * index + (is_warp ? 1 : 0)];
            if (vapour) {
                const double wanted = dt * flow.vapour_now, passed = wanted > 0 ? taken(sides[a], wanted) : -taken(sides[b], -wanted);
                if (passed != wanted) flow.vapour = flow.vapour_now = passed * plain_inverse(dt);
                s.vapour[a] -= passed; // less than nothing is what liquid and fibres will give
                s.vapour[b] += passed;
            }
            if (!heat) continue;
            s.came[a] -= dt * flow.heat_now;
            s.came[b] += dt * flow.heat_now;
        }
    }
    HL_FN double taken(LayerSide& from, double wanted) const // kg
    {
        const double taken = wanted < from.at_hand ? wanted : from.at_hand;
        from.at_hand -= taken;
        return taken;
    }
};

} // namespace hygroloom
