// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The one function of the module.
#pragma once

/// A request as JSON, {"do": "indices" | "fit" | "predict", …}; the answer as JSON, or {"error": sentence}, to be given to free(). Any
/// thread may call it, one at a time.
extern "C" char* hygroloom_openturns(const char* request);
