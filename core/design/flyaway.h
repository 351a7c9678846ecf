// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The shape of flyaway fibres and the numbers that follow from it. Any one unit of length.
#pragma once

namespace hygroloom {

constexpr double loop_width = 1.5;  ///< half the base of a loop / its height; its profile is a squared cosine
constexpr double lowest_loop = 0.5; ///< heights lie evenly between this share of the given height and the given height
constexpr double shortest_hair =
    0.5; ///< lengths lie evenly between this share of the given length and 1.5 times it; the mean is the given one

/// Length of a loop from where it leaves the skin of a yarn of this radius to where it comes back, its fibre turning round the yarn by
/// a number of turns per length. Numerical integral of the profile, within 1e-4.
double loop_length(double height, double turns_per_length, double radius);

/// Mean over the heights.
double mean_loop_length(double greatest_height, double turns_per_length, double radius);

} // namespace hygroloom
