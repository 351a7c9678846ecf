// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How readily a cloth lets air through (ISO 9237, ASTM D737), from its drawn repeat. SI; air of 20 degrees Celsius.
#pragma once

#include "core/geometry/textile.h"
#include "core/laboratory/estimate.h"
#include "core/room/stokes.h"

namespace hygroloom {

/// The two ways through a cloth, side by side: holes between yarns, and the pores in yarns.
struct AirWays {
    FlowThrough holes;
    double yarns = 0; ///< 1/m, speed times viscosity over pressure

    double speed(double pressure) const; ///< m/s over the cloth's whole area, at a pressure difference in Pa
    double pressure(double speed) const; ///< Pa
    /// Of so many such cloths, one on the other: air that has left one spreads before the next.
    AirWays in_series(int cloths) const;
};

/// What of a cloth its description leaves open and air feels most.
struct AirInputs {
    Widening wider;         ///< than the drawn yarns
    Widening wider_off;     ///< either way
    double hair_share = 0;  ///< of the room between the yarns, of fibres that stand out into it
    double hair_radius = 0; ///< m
};
/// Sections are those of Peirce's compressed yarn. In finished cloth a spun yarn lies wider and frays: it fills `spread_of_spun` of the gap
/// to its neighbour, a calibration (core/verify/README.md), 0.2 more or less. Filament lies as it is drawn, 15 % of the width more or less,
/// half of that where a thickness is given: calendering decides. Hairs are as the fabric says, else of spun yarns 1.1 x root of tex times
/// as long as the yarn (tex; an assumption of usual hairiness); half of them stand in the room.
AirInputs air_inputs(const Textile& textile, bool thickness_given);
constexpr double spread_of_spun = 0.55, spread_off = 0.2;

/// voxels: in the mean pitch.
AirWays air_ways(const Textile& textile, const AirInputs& inputs, int voxels);

class AirPermeability {
public:
    static constexpr int voxels = 24, coarse_voxels = 16; ///< in the mean pitch: of the value, and of what is compared with it

    /// Takes 0.2 to 4 s of a core.
    AirPermeability(const Textile& textile, bool thickness_given);
    const AirWays& as_given() const { return as_given_; }
    /// m/s at a pressure difference in Pa.
    Estimate speed(double pressure) const;
    /// Pa at a speed in m/s.
    Estimate pressure(double speed) const;

private:
    template <typename Of> Estimate estimate(const Of& of) const;

    AirWays as_given_;
    AirWays coarse_, narrow_, wide_, hairy_, bare_; ///< on coarser voxels: the same; yarns as wide and as narrow, hairs twice and half
};

} // namespace hygroloom
