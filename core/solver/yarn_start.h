// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The yarns' water and heat at the start of a scene, computed on the host.
#pragma once

#include "core/solver/network_steps.h"

#include <vector>

namespace hygroloom::inline HL_PRECISION {

/// One value per segment; regain per shell.
struct YarnStart {
    std::vector<double> pores;  ///< m3
    std::vector<double> vapour; ///< kg
    std::vector<double> regain;
    AtStake at_stake;
};
YarnStart yarn_start(const Scene& scene);

/// Water (kg) and heat (J over the climate's temperature) of each segment's fibres and liquid, from which the first changes count.
struct FibreStart {
    std::vector<double> bound, heat;
};
FibreStart fibre_start(const Scene& scene, std::vector<double>& regain, const std::vector<double>& liquid);

/// The air at a time (s), and the regain that it leaves fibres alone with; the liquid's numbers stay those of the start.
ClimateParameters climate_at(const Scene& scene, double time);
std::vector<YarnParameters> yarns_in(const Scene& scene, const ClimateParameters& climate);

} // namespace hygroloom::inline HL_PRECISION
