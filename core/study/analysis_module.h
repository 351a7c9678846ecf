// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The module with the mathematics, loaded when it is first asked.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace hygroloom {

/// Why there is none, in a sentence; empty: there is.
std::string why_no_module();

/// See core/study/openturns/module.h. Throws Error with what the module says, or that it is missing and what to install.
nlohmann::json ask_module(const nlohmann::json& request);

} // namespace hygroloom
