// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Scenes of one yarn in which liquid flows by suctions, and what the cases of the closure `pores` share. Water at 20 C.
#pragma once

#include "core/physics/pores.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

namespace hygroloom {

const double pore_temperature = kelvin_from_celsius(20);

/// A bundle of parallel fibres as packing, fibre_radius_um and contact_angle_deg say, with receding_angle_deg and hysteresis where a case
/// has them; hysteresis 0: the closure's own. Throws Error where they do not fit together.
struct FibreBundle {
    PoreClosure pores;
    double packing = 0, fibre_radius = 0; ///< m
    double permeability = 0;              ///< m2, along
    double gate = 0;                      ///< of dry fibres

    /// m2/(Pa s) over the share of pores: times a suction it is the diffusivity of a front.
    double mobility() const;
};
FibreBundle fibre_bundle(const VerifyValues& values);

/// The room beside a yarn.
struct RoomBeside {
    PoreClosure pores;
    double permeability = 0, porosity = 0.3;
    double mobility() const;
};

/// A level yarn of cells along pick after pick, with a room beside each that takes nothing and gives nothing. Its picks are full and pass
/// nothing on, so that rooms lie beside wet yarns.
Scene lone_yarn(const FibreBundle& bundle, int cells, double cell);
/// Lets liquid run from room to room.
void open_rooms(Scene& scene, const RoomBeside& room);
/// kg that its pores hold, and those of a room.
double cell_capacity(const Scene& scene);
double room_capacity(const Scene& scene);

/// Saturation of the warp's segments, and of the room at each.
std::vector<double> saturations(const Frame& frame, const Scene& scene);
std::vector<double> room_saturations(const Frame& frame, const Scene& scene);

/// Where a front ends that liquid is connected behind, m from the start of the first cell. What lies beyond it counts by its share.
double wet_length(const std::vector<double>& saturation, double threshold, double cell);

/// A front from a supply at no suction into level dry pores, x^2 = rate t, by its own integration: with x = y sqrt(t) the saturation
/// follows dy/ds = -2 D / I, dI/ds = y from the front, where I = y s; pores that are full carry what those beyond take.
struct SuppliedFront {
    double rate = 0;    ///< m2/s
    double full_to = 0; ///< share of the distance up to which pores are full
};
SuppliedFront supplied_front(const PoreClosure& pores, double mobility, double power);

} // namespace hygroloom
