// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_sweep.h"
namespace hygroloom {
int submit_to_slurm(const SweepOptions&) { return 1; }
int slurm_status(const SweepOptions&) { return 1; }
int slurm_cancel(const SweepOptions&) { return 1; }
} // namespace hygroloom
