// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Why one fabric is better than another, as part of a comparison's JSON.
#pragma once

#include "core/analysis/why.h"

#include <nlohmann/json.hpp>

namespace hygroloom {

nlohmann::ordered_json why_value(const Why& why);

} // namespace hygroloom
