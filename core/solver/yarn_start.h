// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The yarns' water and heat at the start of a scene, computed on the host.
#pragma once

#include "core/solver/network_steps.h"

#include <vector>

namespace hygroloom {

/// How many elements an array of a scene's segments has.
std::size_t count_of(SegmentCount count, const Scene& scene);

/// Whether yarns draw from a drop's particles in the step in which their liquid flows. Elsewhere segments absorb from particles as the
/// liquid goes on: where no liquid flows by suctions, or a pool makes the offers.
bool particles_offer(const Scene& scene);

/// One value per segment; regain per shell.
struct YarnStart {
    std::vector<double> pores{};  ///< m3
    std::vector<double> vapour{}; ///< kg
    std::vector<double> regain{};
    // Where liquid flows by suction, else empty:
    std::vector<double> suction{}, settled{};                         ///< see SegmentFields
    std::vector<double> room{}, between_suction{}, between_settled{}; ///< one value per crossing
    AtStake at_stake{};
};
YarnStart yarn_start(const Scene& scene);
/// Into a scene's fields of segments; of one in which liquid flows by suction.
template <typename Fields> void upload_suctions(const YarnStart& start, const Scene& scene, Fields& fields)
{
    fields.suction.upload(start.suction);
    fields.settled.upload(start.settled);
    fields.room.upload(start.room);
    fields.between_suction.upload(start.between_suction);
    fields.between_settled.upload(start.between_settled);
    if (!scene.cloth.start.between.empty()) fields.between.upload(scene.cloth.start.between);
}

/// Water (kg) and heat (J over the climate's temperature) of each segment's fibres and liquid, from which the first changes count.
struct FibreStart {
    std::vector<double> bound, heat;
};
FibreStart fibre_start(const Scene& scene, std::vector<double>& regain, const std::vector<double>& liquid);

/// The air at a time (s), and the regain that it leaves fibres alone with; the liquid's numbers stay those of the start.
ClimateParameters climate_at(const Scene& scene, double time);
std::vector<YarnParameters> yarns_in(const Scene& scene, const ClimateParameters& climate);

} // namespace hygroloom
