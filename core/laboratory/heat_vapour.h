// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a cloth resists to heat and to vapour (ISO 11092), from its drawn repeat, and what follows for vapour cups. SI.
#pragma once

#include "core/geometry/textile.h"
#include "core/laboratory/estimate.h"

namespace hygroloom {

/// Of the dry cloth on a plate of 35 degrees Celsius: what the standard leaves when the plate's boundary layer is subtracted.
struct PlateResistances {
    Estimate thermal;     ///< Rct, m2 K/W
    Estimate evaporative; ///< Ret, m2 Pa/W
    /// imt of the standard, between 0 and 1.
    Estimate permeability_index() const;
};
/// Heat crosses yarns (fibres with air between them) and the air beside; vapour the air alone, as fibres at rest take none. On both faces
/// stand the fibres that thickness under 1 kPa is told with: under the cloth's own weight they stand higher (van Wyk). thickness_given:
/// then the fibres stand as high as it says. The interval: fibres half and twice as high, conductivity of fibres 30 % either way, half as
/// many voxels. A plate's cloth has waves and air below that are not in it.
PlateResistances plate_resistances(const Textile& textile, bool thickness_given);

/// W/m2 that the upper face takes from a plate 10 K warmer which is pressed on it with 1 kPa, 0.2 s after they touched: about when
/// instruments read their peak (JIS L1927). Under each place of the plate stand the fibres of half the cloth's loose layer and air down to
/// the yarn, which conducts across its fibres and is deep enough. The interval: 0.1 and 0.4 s, fibres half and twice as high, conductivity
/// of fibres 30 % either way, half as many voxels.
Estimate warm_cool_feeling(const Textile& textile, bool thickness_given);
constexpr double touch_kelvin = 10, touch_seconds = 0.2;

/// A cup or a plate with air layers of its own on both sides of the cloth.
struct VapourSetUp {
    const char *key, *title, *standard;
    double celsius = 23;
    double humid = 1, dry = 0.5; ///< relative humidities on both sides, at that temperature
    double inner = 0;            ///< m of still air between the water, or what takes it up, and the cloth
    double air_speed = -1;       ///< m/s over the cup, 7 cm wide; less than 0: no boundary layer counts
    bool water_on_cloth = false; ///< which has to hold it
};
const std::vector<VapourSetUp>& vapour_set_ups();

/// kg/(m2 s) through a cloth of this Ret, the cup's own layers in series with it.
double vapour_transmission(const VapourSetUp& set_up, double evaporative_resistance_of_cloth);
/// The interval: that of Ret, half and twice the air's speed, 20 % of the air layer inside.
Estimate vapour_transmission(const VapourSetUp& set_up, const Estimate& evaporative_resistance_of_cloth);

} // namespace hygroloom
