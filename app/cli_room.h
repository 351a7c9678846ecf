// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The room between a fabric's yarns as it is drawn, for check.
#pragma once

#include "core/design/fitted_fabric.h"

#include <nlohmann/json_fwd.hpp>

namespace hygroloom {

/// Key "room": of its first types of yarn, with water of 20 degrees Celsius.
void add_room_json(nlohmann::ordered_json& json, const Fabric& fabric, const FittedFabric& fitted);
void print_room(const Fabric& fabric, const FittedFabric& fitted);

} // namespace hygroloom
