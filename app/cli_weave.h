// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What check tells of a fabric's weave and sett.
#pragma once

#include "core/design/fabric_quantities.h"

#include <nlohmann/json_fwd.hpp>

namespace hygroloom {

/// Keys "weave" and "jam".
void add_weave_json(nlohmann::ordered_json& json, const Fabric& fabric, const FabricQuantities& quantities);
void print_weave(const Fabric& fabric, const FabricQuantities& quantities);

} // namespace hygroloom
