// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a yarn has beside its substance and its shape: how it is dyed, what it costs, under which name a library has it.
#pragma once

#include "core/design/yarn.h"

namespace hygroloom {

/// Without colour, price and the library's name.
Yarn without_labels(Yarn yarn);

} // namespace hygroloom
