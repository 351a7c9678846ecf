// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The closure `pores`: its numbers from geometry and two contact angles.
// Liquid between parallel fibres: how much they hold at a suction while they fill and while they drain, and which bundles wet at all.
// Angles in radian, everything else SI; suction is positive below the air's pressure, saturation 0..1 of the pore volume.
#pragma once

#include "core/physics/wicking.h"

namespace hygroloom {

/// What a class of pores holds. Imbibition follows entry suction x s^(-1/shape), drainage the same times hysteresis.
struct PoreClosure {
    double entry_suction = 0; ///< Pa, at which the last pore fills
    double shape = 4;         ///< Brooks and Corey's; larger: pores more alike
    double hysteresis = 1;    ///< drainage suction over imbibition suction, at least 1
    double threshold = 0;     ///< saturation below which the liquid is not connected
    double front_suction = 0; ///< Pa, at the threshold: no front advances into dry pores at a larger one
};

/// Suction of imbibition at a saturation in (0, 1], Pa; never above that of a front.
HL_FN double imbibition_suction(const PoreClosure& pores, double saturation)
{
    const double suction = pores.entry_suction * std::pow(saturation, -1.0 / pores.shape);
    return suction < pores.front_suction ? suction : pores.front_suction;
}

constexpr double front_ramp = 0.05; // of the front's suction, over which what is below the threshold comes to nothing; an assumption

/// Saturation to which dry pores fill at a suction.
HL_FN double saturation_filling(const PoreClosure& pores, double suction)
{
    if (suction <= pores.entry_suction) return 1.0;
    if (suction <= pores.front_suction) return std::pow(suction / pores.entry_suction, -pores.shape);
    const double beyond = (suction - pores.front_suction) / (front_ramp * pores.front_suction);
    return beyond < 1.0 ? pores.threshold * (1.0 - beyond) : 0.0;
}

/// Saturation to which full pores empty at a suction.
HL_FN double saturation_emptying(const PoreClosure& pores, double suction)
{
    const double entry = pores.hysteresis * pores.entry_suction;
    return suction <= entry ? 1.0 : std::pow(suction / entry, -pores.shape);
}

/// Pores between the fibres of a yarn: sizes of the triangles between random parallel rods, their filling as a fit to invasion computed on
/// them; derived here. Packing 0.05..0.95, advancing angle below 90 degrees and not below the receding one.
HL_FN PoreClosure pores_of_bundle(double packing, double fibre_radius, double surface_tension, double advancing, double receding)
{
    const double cosine = std::cos(advancing);
    const double fitted = 4.25 - 1.8 * packing + (1.0 / cosine - 1.0) * (6.4 - 8.0 * packing);
    PoreClosure pores;
    pores.shape = 0.5 * std::round(2.0 * (fitted < 3.0 ? 3.0 : fitted > 6.0 ? 6.0 : fitted));
    const double whole = capillary_pressure(surface_tension, advancing, bundle_pore_radius(fibre_radius, packing));
    pores.entry_suction = (pores.shape - 1.0) / pores.shape * whole; // all fibre surface is wetted once
    const double drainage = (1.85 - 0.75 * packing) * std::cos(receding) / cosine;
    pores.hysteresis = drainage < 1.1 ? 1.1 : drainage;
    const double smallest = 0.137 + 0.040 * packing / (1.0 - packing); // volume of the 37 % smallest pores, at which they connect
    pores.threshold = smallest < 0.30 ? smallest : 0.30;
    pores.front_suction = pores.entry_suction * std::pow(pores.threshold, -1.0 / pores.shape);
    return pores;
}

/// Half gap over radius up to which liquid at no suction runs between two rods (Princen 1969). Angle 0 to 90 degrees.
HL_FN double widest_gap(double contact_angle)
{
    return (0.5 * pi - contact_angle) * std::cos(contact_angle) + std::sin(contact_angle) - 1.0;
}

/// Half gap over fibre radius that is not exceeded along a connected way through a bundle: quantile 2 sin(pi/18) of the gaps between random
/// rods, bonds that percolate on a triangular net; a fit, derived here. Fibres gather in a core where the packing leaves room.
HL_FN double connected_gap(double packing)
{
    const double loose = 0.9 / packing - 1.0, core = loose < 0.0 ? 0.0 : loose > 0.5 ? 0.5 : loose;
    const double dense = packing * (1.0 + 0.5 * core), in_core = dense < 0.9 ? dense : 0.9;
    return (0.86 - 0.54 * in_core) * (0.9523 / std::sqrt(in_core) - 1.0);
}

/// How readily dry fibres let liquid in whose contact angle is the same everywhere, 0..1: 0 from the angle on at which the gaps that liquid
/// runs through no longer connect.
HL_FN double gate_of_like_fibres(double packing, double contact_angle)
{
    if (contact_angle >= 0.5 * pi) return 0.0;
    const double share = 1.0 - connected_gap(packing) / widest_gap(contact_angle);
    return share > 0.0 ? share : 0.0;
}

/// Curvature of a meniscus between two parallel cylinders over -cos(contact angle + contact line), 1/m. The contact line is an angle from
/// the plane through the axes.
HL_FN double meniscus_curvature(double radius, double half_gap, double contact_line)
{
    return 1.0 / (radius + half_gap - radius * std::cos(contact_line));
}

/// Pressure over the air's, Pa, that liquid on a hole between two ends and two picks must exceed to pass; half heights and half gaps of
/// both pairs, m. An infinite half gap of one pair: a slot. Contact angle 0 to 180 degrees. Derived here for cylinders.
HL_FN double breakthrough_pressure(double surface_tension, double contact_angle, double half_height_warp, double half_gap_warp,
                                   double half_height_weft, double half_gap_weft)
{
    const auto pressure = [&](double line) {
        return -surface_tension * std::cos(contact_angle + line) *
               (meniscus_curvature(half_height_warp, half_gap_warp, line) + meniscus_curvature(half_height_weft, half_gap_weft, line));
    };
    constexpr int places = 1800; // the pressure may have a maximum for each pair
    int best = 0;
    for (int i = 1; i <= places; ++i)
        if (pressure(0.5 * pi * i / places) > pressure(0.5 * pi * best / places)) best = i;
    double low = 0.5 * pi * (best > 0 ? best - 1 : 0) / places, high = 0.5 * pi * (best < places ? best + 1 : places) / places;
    for (int i = 0; i < 60; ++i) {
        const double third = (high - low) / 3.0;
        if (pressure(low + third) < pressure(high - third))
            low += third;
        else
            high -= third;
    }
    const double most = pressure(0.5 * (low + high));
    return most > 0.0 ? most : 0.0;
}

/// Liquid between two parallel rods: where its contact lines stand, and its cross-section.
struct RodColumn {
    double contact_line = 0; ///< radian, of each contact line from the plane through the rods' axes
    double area = 0;         ///< m2
};

/// At a suction above 0, by bisection. No area: the gap is too wide for a meniscus at that suction, or so wide for thin rods that both
/// menisci would meet in the middle.
HL_FN RodColumn rod_column(double radius, double half_gap, double contact_angle, double surface_tension, double suction)
{
    const double meniscus = surface_tension / suction;
    if (meniscus * std::cos(contact_angle) <= half_gap) return {};
    double low = 0, high = pi - contact_angle;
    for (int i = 0; i < 60; ++i) {
        const double line = 0.5 * (low + high);
        const double room = meniscus * std::cos(line + contact_angle) - (radius + half_gap - radius * std::cos(line));
        (room > 0 ? low : high) = line;
    }
    const double line = 0.5 * (low + high), turned = line + contact_angle;
    const double width = radius + half_gap - radius * std::cos(line), middle = radius * std::sin(line) + meniscus * std::sin(turned);
    if (middle <= meniscus) return {};
    const double under_meniscus = width * middle - 0.5 * meniscus * (width * std::sin(turned) + meniscus * (0.5 * pi - turned));
    const double in_rod = 0.5 * radius * radius * (line - std::sin(line) * std::cos(line));
    return {line, 4.0 * (under_meniscus - in_rod)};
}

} // namespace hygroloom
