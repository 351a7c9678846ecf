// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Outlines of flat panels: curves as straight pieces, lengths, areas.
#pragma once

#include "core/garment/pattern.h"

#include <functional>

namespace hygroloom {

constexpr double flattening_m = 2e-5; ///< how far straight pieces may lie from their curve

/// A curve of a parameter from 0 to 1 as straight pieces.
std::vector<FlatPlace> flattened(const std::function<FlatPlace(double)>& curve);

/// A Bezier curve of one or two control points.
std::vector<FlatPlace> flattened_bezier(const FlatPlace& from, const std::vector<FlatPlace>& controls, const FlatPlace& to);

/// A part of a circle from one place to another, bulging to the right of that way or to its left.
std::vector<FlatPlace> flattened_arc(const FlatPlace& from, const FlatPlace& to, double radius, bool large, bool to_the_right);

/// All places round a panel, without the last edge's end, which is the first edge's begin.
std::vector<FlatPlace> outline_of(const PatternPanel& panel);

double length_of(const PanelEdge& edge);
/// Positive where the outline goes round counter-clockwise.
double signed_area(const std::vector<FlatPlace>& outline);
/// Whether pieces of a closed outline cross. Beyond a number of comparisons it is not known, and false. done counts them.
bool crosses_itself(const std::vector<FlatPlace>& outline, std::size_t& done);

inline Vec3d in_space(const PatternPanel& panel, const FlatPlace& flat)
{
    return panel.placed[0] + flat[0] * panel.placed[1] + flat[1] * panel.placed[2];
}

} // namespace hygroloom
