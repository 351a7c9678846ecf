// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The weave and sett of a fabric, for check.
#pragma once

#include "core/design/yarn_sections.h"

#include <nlohmann/json_fwd.hpp>

namespace hygroloom {

/// Keys "weave" and "jam".
void add_weave_json(nlohmann::ordered_json& json, const Fabric& fabric, const FittedYarns& yarns);
void print_weave(const Fabric& fabric, const FittedYarns& yarns);

} // namespace hygroloom
