// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What colours on cloth can show of a frame besides its water: how warm the yarns are, how damp the air in them is.
#pragma once

#include "core/plan/model_plan.h"
#include "core/scene/frame.h"

namespace hygroloom {

/// humidity: relative, of the air in a yarn's pores.
enum class ShownQuantity { water, temperature, humidity };

/// Throws Error naming the words.
ShownQuantity shown_quantity_from_name(const std::string& name);
const char* name_of(ShownQuantity quantity);

/// The part of the physics without which a frame has only the start's value of it; empty: each run has it.
std::string part_behind(ShownQuantity quantity);
/// Why a run has none, in a sentence; empty when it has.
std::string why_not_shown(const ModelPlan& plan, ShownQuantity quantity);

/// Of each segment: share of the pores that is filled; K; share of the vapour that air of that temperature can hold.
std::vector<float> segment_values(const Frame& frame, ShownQuantity quantity);

/// The ends of a scale.
struct ValueRange {
    double low = 0, high = 1;
    bool operator==(const ValueRange&) const = default;
};
/// From the lowest temperature to the highest, K, but at least half a kelvin wide; of shares, from 0 to 1.
ValueRange range_of_values(const Frame& frame, ShownQuantity quantity);
ValueRange united(const ValueRange& one, const ValueRange& other);

} // namespace hygroloom
