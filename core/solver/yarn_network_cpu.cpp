// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The yarns on the CPU. They are the same whatever the precision of the particles, so they are compiled once, apart from them.
#include "core/solver/cpu_executor.h"
#include "core/solver/yarn_network_flow.h"
#include "core/solver/yarn_network_stock.h"
#include "core/solver/yarn_network_supply.h"
#include "core/solver/yarn_network_whole.h"

namespace hygroloom {

template class YarnNetwork<CpuExecutor>;

} // namespace hygroloom
