// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a case of verify gave, as JSON.
#pragma once

#include "core/verify/verify.h"

#include <nlohmann/json_fwd.hpp>

namespace hygroloom {

nlohmann::ordered_json parameters_value(const std::vector<VerifyParameter>& parameters);
/// As `verify --json` prints it.
nlohmann::ordered_json report_value(const VerifyReport& report);

} // namespace hygroloom
