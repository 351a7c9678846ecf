// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How readily dry fibres let liquid in whose contact angles scatter from pore to pore, as those of all fibres do. Angles in radian.
#pragma once

#include "core/physics/pores.h"

#include <algorithm>
#include <vector>

namespace hygroloom {

/// Standard deviation of contact angles from pore to pore. Measured hysteresis of 20 to 30 degrees means places that differ as much; an
/// assumption, between 8 and 15 degrees.
inline double scatter_of_angles() { return radian_from_degree(12); }

/// A share of all pores, and what they conduct, 0..1.
struct ConductingShare {
    double share, conducts;
};

/// What a net of pores in three dimensions conducts that differ at random (Bruggeman 1935; Kirkpatrick 1973). The shares sum up to 1. 0
/// where a third or less of them conduct.
inline double conductance_of_mixture(const std::vector<ConductingShare>& pores)
{
    double most = 0, open = 0;
    for (const ConductingShare& part : pores) {
        most = std::max(most, part.conducts);
        if (part.conducts > 0) open += part.share;
    }
    if (3.0 * open <= 1.0) return 0.0;
    double low = 0, high = most;
    for (int round = 0; round < 50; ++round) {
        const double middle = 0.5 * (low + high);
        double over = 0;
        for (const ConductingShare& part : pores) over += part.share * (part.conducts - middle) / (part.conducts + 2.0 * middle);
        (over > 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Calls add(share, value) with values of a normal distribution up to six standard deviations from its mean; the shares sum up to 1.
template <typename Add> void each_of_normal(double mean, double deviation, const Add& add)
{
    constexpr int side = 40;
    constexpr double reach = 6.0;
    double all = 0;
    for (int i = -side; i <= side; ++i) all += std::exp(-0.5 * reach * reach * i * i / (side * side));
    for (int i = -side; i <= side; ++i)
        add(std::exp(-0.5 * reach * reach * i * i / (side * side)) / all, mean + reach * deviation * i / side);
}

/// Of dry parallel fibres, how readily they take liquid in across, over how they do along: liquid at the air's pressure passes between them
/// by touching and merging menisci only where they lie so close that it wets them well enough; else only by the channels that come to the
/// surface as fibres migrate, along which it goes in. Exact for rods at random up to the first number: none passes at a packing of 0.7 or
/// less; derived here. section: of the yarn, m2; apart: between a channel's mouths, m; 0: fibres are crimped or hairy, and nothing holds it
/// up.
inline double entry_across_fibres(double packing, double contact_angle, double along_over_across, double section, double apart)
{
    if (!(apart > 0)) return 1.0;
    constexpr double over = 5.0; // degrees, over which it fades
    constexpr double packings[] = {0.70, 0.75, 0.80, 0.85}, angles[] = {-over, 19.0, 30.0, 36.0};
    double widest = packing < packings[0] ? -over : packing >= packings[3] ? angles[3] : 0.0;
    for (int i = 0; i < 3; ++i)
        if (packing >= packings[i] && packing < packings[i + 1])
            widest = angles[i] + (angles[i + 1] - angles[i]) * (packing - packings[i]) / (packings[i + 1] - packings[i]);
    const double touching = std::clamp(0.5 + 0.5 * (widest - contact_angle / radian_from_degree(1)) / over, 0.0, 1.0);
    return std::min(1.0, touching + 2.0 * along_over_across * section / (apart * apart));
}

/// How readily dry fibres take liquid in, 0..1, whose contact angles have this mean and scatter: mean of patches of thirty pores, each a
/// mixture. 0 from a mean of 90 degrees on, and where less than one part in a million would pass.
inline double gate_of_dry_fibres(double packing, double contact_angle, double scatter = scatter_of_angles())
{
    if (contact_angle >= 0.5 * pi) return 0.0;
    if (!(scatter > 0)) return gate_of_like_fibres(packing, contact_angle);
    constexpr double pores_of_patch = 30.0, next_to_none = 1e-6;
    double gate = 0;
    each_of_normal(contact_angle, scatter / std::sqrt(pores_of_patch), [&](double of_patches, double mean) {
        std::vector<ConductingShare> pores;
        each_of_normal(mean, scatter, [&](double share, double angle) {
            pores.push_back({share, gate_of_like_fibres(packing, std::abs(angle))});
        });
        gate += of_patches * conductance_of_mixture(pores);
    });
    return gate < next_to_none ? 0.0 : gate;
}

} // namespace hygroloom
