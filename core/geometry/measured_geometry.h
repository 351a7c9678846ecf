// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A fabric's quantities measured on its geometry, fibre by fibre: the check on the formulas of FabricQuantities. Trade units, as there.
#pragma once

#include "core/geometry/textile.h"

namespace hygroloom {

/// Radii below which a tenth, half and nine tenths of the pore space (inside yarns) or of the holes (between them) lie.
struct PoreRadii {
    double tenth_um = 0;
    double median_um = 0;
    double nine_tenths_um = 0;
    double mean_um = 0;
};

/// Of water or air through the dry fabric, m2.
struct Permeability {
    double through = 0;    ///< from face to face: holes between yarns (Poiseuille) beside yarns (Gebart, across)
    double along_warp = 0; ///< in the fabric's plane, in the yarns: Gebart, along
    double along_weft = 0;
};

struct MeasuredYarn {
    double crimp_percent = 0; ///< out of the fabric's plane
    double cover = 0;
    double braiding_angle_deg = 0; ///< between the chords that meet over a crossed yarn; 0 when it never changes sides
    PoreRadii pores;               ///< between the fibres
};

struct MeasuredGeometry {
    MeasuredYarn warp;
    MeasuredYarn weft;
    double cover_factor = 0;
    double areal_density_g_m2 = 0;
    double yarn_layer_thickness_mm = 0;
    double thickness_mm = 0;          ///< with the highest loops of the piece that was measured
    double porosity = 0;              ///< of the thickness that the formulas use, so that both compare
    double fibre_volume_fraction = 0; ///< of the yarn layer
    double smoothness = 1;
    PoreRadii holes; ///< between yarns
    Permeability permeability;
    int ends = 0, picks = 0;  ///< that were measured
    double flyaways_seen = 1; ///< share of their loops and hairs that stands for all
    double points = 0;        ///< that were looked at, of fibres and of the raster for cover: what it took
};

/// Makes the fibres of some repeats of weave and yarn order, of 240 ends and picks at most, and measures them; pores in yarns are those of
/// the first yarn of each system. Laboratory values are left out; a fabric without them is not fitted again. Precondition: validate() found
/// no error.
MeasuredGeometry measure_geometry(const Design& design, const Fabric& fabric, const FittedFabric* fitted = nullptr);

/// By formula, beside MeasuredGeometry::permeability.
Permeability permeability_of(const FabricQuantities& quantities);

/// Eq. 2 of the paper, tan(angle/2) = l / (2 (d + h)) with l two pitches and d + h the centreline's rise from side to side.
double braiding_angle_deg(double pitch, double rise);

} // namespace hygroloom
