// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What pores between fibres and between yarns hold, and when they let liquid through, against closed forms and integrals.
#include "core/base/error.h"
#include "core/physics/scattered_gate.h"
#include "core/physics/water.h"
#include "core/verify/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace hygroloom {
namespace {

double degree_from_radian(double angle) { return angle * 180.0 / pi; }

const double tension = water_surface_tension(kelvin_from_celsius(20));

VerifyResult within(const char* name, double computed, double expected, double relative)
{
    return {name, computed, expected, relative * std::abs(expected)};
}

PoreClosure bundle(const VerifyValues& v)
{
    const double advancing = value(v, "contact_angle_deg"), receding = value(v, "receding_angle_deg");
    if (receding > advancing)
        throw Error(
            fmt::format("receding_angle_deg: A receding angle is at most the contact angle, {}; {} was given.", advancing, receding));
    return pores_of_bundle(value(v, "packing"), metre_from_um(value(v, "fibre_radius_um")), tension, radian_from_degree(advancing),
                           radian_from_degree(receding));
}

/// Gauss and Legendre's five places on each of many cells; u^shape for the saturation takes the root's steep end away.
double filling_energy(const PoreClosure& pores)
{
    constexpr int cells = 200;
    constexpr double place[] = {0.0, 0.5384693101056831, 0.9061798459386640},
                     weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    PoreClosure uncapped = pores;
    uncapped.front_suction = std::numeric_limits<double>::infinity();
    double sum = 0;
    for (int cell = 0; cell < cells; ++cell)
        for (int k = -2; k <= 2; ++k) {
            const double u = (cell + 0.5 + (k < 0 ? -0.5 : 0.5) * place[std::abs(k)]) / cells, s = std::pow(u, pores.shape);
            sum += 0.5 * weight[std::abs(k)] / cells * imbibition_suction(uncapped, s) * pores.shape * s / u;
        }
    return sum;
}

/// The suctions at which saturations are what the closure's numbers say, found by bisection of the curves themselves.
template <typename Curve> double suction_where(const Curve& saturation, double wanted)
{
    double low = 0, high = 1e12;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (saturation(middle) >= wanted ? low : high) = middle;
    }
    return low;
}

std::vector<VerifyResult> pore_closure(const VerifyValues& v, Backend&)
{
    const PoreClosure pores = bundle(v);
    const double packing = value(v, "packing"), angle = radian_from_degree(value(v, "contact_angle_deg"));
    const double radius = metre_from_um(value(v, "fibre_radius_um")), cosine = std::cos(angle);
    const double pore_radius = radius * (1.0 / packing - 1.0), energy = 2.0 * tension * cosine / pore_radius;
    const double shape = std::round(2 * std::clamp(4.25 - 1.8 * packing + (6.4 - 8 * packing) * (1 - cosine) / cosine, 3.0, 6.0)) / 2;
    const double entry = energy * (1 - 1 / shape), threshold = std::min(0.30, 0.137 + 0.040 / (1 / packing - 1));
    const double hysteresis =
        std::max(1.1, (1.85 - 0.75 * packing) * std::cos(radian_from_degree(value(v, "receding_angle_deg"))) / cosine);
    const double filled = suction_where([&](double p) { return saturation_filling(pores, p); }, 1.0);
    const double emptied = suction_where([&](double p) { return saturation_emptying(pores, p); }, 1.0);
    const double front = suction_where([&](double p) { return saturation_filling(pores, p); }, pores.threshold);
    return {within("shape", pores.shape, shape, 1e-12),
            within("pore_radius_um", um_from_metre(bundle_pore_radius(radius, packing)), um_from_metre(pore_radius), 1e-4),
            within("entry_suction_pa", filled, entry, 1e-4),
            within("hysteresis", emptied / filled, hysteresis, 1e-4),
            within("threshold_saturation", pores.threshold, threshold, 1e-4),
            within("front_suction_pa", front, entry / std::pow(threshold, 1 / shape), 1e-4),
            within("energy_pa", filling_energy(pores), energy, 1e-4)};
}

/// Newton's rounds on Princen's gap, whose slope is -(pi/2 - angle) sin(angle), from the side on which it is steep.
double angle_of_gap(double gap)
{
    double angle = 0.5;
    for (int i = 0; i < 100; ++i) {
        const double rest = 0.5 * pi - angle;
        angle = std::clamp(angle + (rest * std::cos(angle) + std::sin(angle) - 1 - gap) / (rest * std::sin(angle)), 1e-3, 0.5 * pi - 1e-9);
    }
    return angle;
}

std::vector<VerifyResult> critical_angle(const VerifyValues& v, Backend&)
{
    const double packing = value(v, "packing"), angle = radian_from_degree(value(v, "contact_angle_deg"));
    double wets = 0, repels = 0.5 * pi;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (wets + repels);
        (gate_of_like_fibres(packing, middle) > 0 ? wets : repels) = middle;
    }
    const double expected = connected_gap(packing) < 0.5 * pi - 1 ? angle_of_gap(connected_gap(packing)) : 0.0; // or not at 0 degrees
    const double rest = 0.5 * pi - angle, gap = rest * std::cos(angle) + std::sin(angle) - 1;
    const double gate = angle < expected ? 1 - connected_gap(packing) / gap : 0.0;
    return {{"angle_deg", degree_from_radian(0.5 * (wets + repels)), degree_from_radian(expected),
             1e-3 * std::max(1.0, degree_from_radian(expected))},
            {"gate", gate_of_like_fibres(packing, angle), gate, 1e-3}};
}

std::vector<VerifyResult> gate(const VerifyValues& v, Backend&)
{
    const double packing = value(v, "packing"), mean = radian_from_degree(value(v, "contact_angle_deg")),
                 scatter = radian_from_degree(value(v, "angle_scatter_deg"));
    // By another quadrature, and simple rounds.
    constexpr int points = 300;
    const auto deviates = [](int i) { return (i + 0.5) * 16.0 / points - 8.0; };
    double sum = 0, expected = 0;
    for (int i = 0; i < points; ++i) sum += std::exp(-0.5 * deviates(i) * deviates(i));
    const auto local = [&](double angle) {
        const double off = std::abs(angle), rest = 0.5 * pi - off, gap = rest * std::cos(off) + std::sin(off) - 1;
        return off < 0.5 * pi && gap > connected_gap(packing) ? 1 - connected_gap(packing) / gap : 0.0;
    };
    for (int i = 0; i < points; ++i) {
        double open = 0, conducts = 1, shares[points], gates[points];
        for (int k = 0; k < points; ++k) {
            shares[k] = std::exp(-0.5 * deviates(k) * deviates(k)) / sum;
            gates[k] = local(mean + scatter / std::sqrt(30.0) * deviates(i) + scatter * deviates(k));
            if (gates[k] > 0) open += shares[k];
        }
        if (open <= 1 / 3.0) continue;
        for (int round = 0; round < 400; ++round) {
            double over = 0;
            for (int k = 0; k < points; ++k) over += 3 * shares[k] * gates[k] / (gates[k] + 2 * conducts);
            conducts *= over; // 1 where they balance
        }
        expected += conducts * shares[i];
    }
    const double computed = gate_of_dry_fibres(packing, mean, scatter);
    return {{"gate", computed, mean >= 0.5 * pi ? 0.0 : expected, 2e-3}};
}

/// Flow along hard discs at random, 108 in four samples: over the discs' radius^2.
std::vector<VerifyResult> random_rods(const VerifyValues& v, Backend&)
{
    const double packing = value(v, "packing");
    constexpr double packings[] = {0.35, 0.45, 0.5, 0.6, 0.7}, found[] = {0.349, 0.138, 0.0889, 0.0324, 0.0096};
    std::size_t i = 0;
    while (i < 3 && packing > packings[i + 1]) ++i;
    const double part = (packing - packings[i]) / (packings[i + 1] - packings[i]);
    const double expected = found[i] * std::pow(found[i + 1] / found[i], part);
    return {{"permeability", permeability_along_random(1, packing), expected, 0.06 * expected}};
}

std::vector<VerifyResult> effective_medium(const VerifyValues& v, Backend&)
{
    const double open = value(v, "open_share");
    return {{"conductance", conductance_of_mixture({{open, 1.0}, {1 - open, 0.0}}), std::max(0.0, 1.5 * open - 0.5), 1e-9}};
}

/// m, the half gap at which both menisci meet in the middle: radius sin(line) + meniscus sin(line + angle) = meniscus, of the line that the
/// balance gives for that gap.
double widest_column(double radius, double angle, double meniscus)
{
    double low = 0, high = 0.5 * pi - angle; // the higher the line, the farther apart they are
    for (int i = 0; i < 100; ++i) {
        const double line = 0.5 * (low + high);
        (radius * std::sin(line) + meniscus * std::sin(line + angle) > meniscus ? high : low) = line;
    }
    return std::max(0.0, meniscus * std::cos(high + angle) + radius * std::cos(high) - radius);
}

/// Expected: the angle from Princen's balance by the rule of false position, the area by slices across the column.
std::vector<VerifyResult> rod_column_case(const VerifyValues& v, Backend&)
{
    const double radius = metre_from_um(value(v, "rod_radius_um")), half_gap = metre_from_um(value(v, "half_gap_um"));
    const double angle = radian_from_degree(value(v, "contact_angle_deg")), meniscus = tension / value(v, "suction_pa");
    const double widest = widest_column(radius, angle, meniscus);
    if (half_gap >= widest)
        throw Error(fmt::format("half_gap_um: At this suction water stands in half gaps below {:.4g} um; {:g} was given.",
                                um_from_metre(widest), value(v, "half_gap_um")));
    const RodColumn column = rod_column(radius, half_gap, angle, tension, value(v, "suction_pa"));
    const auto room = [&](double line) { return meniscus * std::cos(line + angle) + radius * std::cos(line) - radius - half_gap; };
    double low = 0, high = pi - angle, line = 0;
    for (int i = 0; i < 2000; ++i) {
        const double at_low = room(low), at_high = room(high);
        line = i % 3 == 0 ? 0.5 * (low + high) : low + (high - low) * at_low / (at_low - at_high);
        (room(line) > 0 ? low : high) = line;
    }
    const double middle = radius * std::sin(line) + meniscus * std::sin(line + angle);
    const double width = radius + half_gap - radius * std::cos(line);
    constexpr int slices = 200000;
    double area = 0;
    for (int i = 0; i < slices; ++i) {
        const double x = width * (i + 0.5) / slices, in_rod = radius + half_gap - x;
        const double rod = x > half_gap ? std::sqrt(std::max(0.0, radius * radius - in_rod * in_rod)) : 0.0;
        area += 4 * width / slices * (middle - std::sqrt(std::max(0.0, meniscus * meniscus - x * x)) - rod);
    }
    return {within("angle_deg", degree_from_radian(column.contact_line), degree_from_radian(line), 1e-3),
            within("area_um2", 1e12 * column.area, 1e12 * area, 1e-3)};
}

/// Expected: where the slope of the pressure with the contact line changes its sign.
std::vector<VerifyResult> hole_breakthrough(const VerifyValues& v, Backend&)
{
    const double half = metre_from_um(value(v, "half_width_um")), gap = metre_from_um(value(v, "half_gap_um"));
    const double angle = radian_from_degree(value(v, "contact_angle_deg"));
    const bool square = value(v, "square") != 0;
    const double computed = breakthrough_pressure(tension, angle, half, gap, half, square ? gap : std::numeric_limits<double>::infinity());
    // d/dx of -cos(angle + x) / (b + d - b cos x) has the sign of sin(angle + x) (b + d - b cos x) + cos(angle + x) b sin x.
    const auto rises = [&](double x) {
        return std::sin(angle + x) * (half + gap - half * std::cos(x)) + half * std::cos(angle + x) * std::sin(x) > 0;
    };
    double low = 0, high = 0.5 * pi;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (rises(middle) ? low : high) = middle;
    }
    const double expected = std::max(0.0, -(square ? 2 : 1) * tension * std::cos(angle + low) / (half + gap - half * std::cos(low)));
    return {{"pressure_pa", computed, expected, 1e-3 * std::max(1.0, expected)}};
}

} // namespace

std::vector<VerifyCase> pore_cases()
{
    const VerifyParameter packing{"packing", 0.5, 0.05, 0.95, ""}, angle{"contact_angle_deg", 35, 0, 89, ""};
    return {
        {"pore_closure",
         "What the pores between parallel fibres hold at which suction: the numbers of the closure, and the work of filling them.",
         {packing, {"fibre_radius_um", 8, 0.1, 1e3, ""}, angle, {"receding_angle_deg", 0, 0, 89, ""}},
         pore_closure},
        {"critical_angle",
         "The contact angle up to which water enters a dry bundle by itself, and how readily it does at an angle.",
         {packing, angle},
         critical_angle},
        {"gate",
         "How readily dry fibres let water in where contact angles scatter from pore to pore.",
         {packing, angle, {"angle_scatter_deg", 12, 0.1, 40, ""}},
         gate},
        {"random_rods", "Permeability along rods at random, over their radius^2.", {{"packing", 0.5, 0.35, 0.7, ""}}, random_rods},
        {"effective_medium", "What a random net of open and closed pores conducts.", {{"open_share", 0.7, 0, 1, ""}}, effective_medium},
        {"rod_column",
         "Water between two parallel rods at a suction: where its edges stand, and its cross-section.",
         {{"rod_radius_um", 100, 0.1, 1e4, ""}, {"half_gap_um", 30, 0, 1e4, ""}, angle, {"suction_pa", 1e3, 1, 1e7, ""}},
         rod_column_case},
        {"hole_breakthrough",
         "The pressure at which water passes a hole between four yarns, or a slot between two.",
         {{"half_width_um", 100, 1, 1e4, ""},
          {"half_gap_um", 43, 0.1, 1e4, ""},
          {"contact_angle_deg", 89, 0, 180, ""},
          on_or_off("square", true)},
         hole_breakthrough},
    };
}

} // namespace hygroloom
