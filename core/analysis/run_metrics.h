// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The numbers and the time series of one run, in SI units.
#pragma once

#include "core/analysis/laboratory.h"
#include "core/analysis/moisture_tester.h"
#include "core/analysis/stain_shape.h"
#include "core/scene/frame.h"

#include <optional>
#include <string>
#include <vector>

namespace hygroloom {

/// One value per frame for each series of the metrics file. The water of a face is what it has beyond what its fibres held before any came;
/// less than nothing only where they have given some of that to the air.
struct Series {
    std::vector<double> time, radius_top, radius_bottom, water_top, water_bottom, free_water, yarn_water, bound_water, evaporated, dripped,
        temperature_mean, temperature_min, temperature_max, regain_mean; ///< SI
    std::vector<double> air_temperature;                                 ///< K
    std::vector<double> delivered;                                       ///< kg
    std::vector<double> wick_height;                                     ///< m, of vertical_wicking only
    std::vector<double> content_top, content_bottom; ///< % of the dry mass, of moisture_management only: see face_content()
    std::vector<TesterReading> tester;               ///< what they follow from
};

struct Metrics {
    double maximum_wetted_radius_top = 0;    ///< m
    double maximum_wetted_radius_bottom = 0; ///< m
    double equal_area_radius_top = 0;        ///< m, of a circle as large as the largest stain on top
    double equal_area_radius_bottom = 0;     ///< m
    std::optional<double> absorbency_time;   ///< s
    double wetted_area_ellipse_warp = 0;     ///< m, semi-axis along the warp, of the final stain on top
    double wetted_area_ellipse_weft = 0;     ///< m
    std::optional<StainShape> shape;         ///< of the final stain on top; none of little, and where frames show cells
    std::optional<double> time_of_arrest;    ///< s: when the last segment got wet that had been dry, at least 10 s before the end
    double water_between_yarns = 0;          ///< kg, at the end
    std::optional<ManagementIndices> management;
    std::optional<WickingResult> wicking;
    std::optional<double> horizontal_rate; ///< m2/s: area of the stain over the time in which it grew to 95 % of it (AATCC 198)
    std::optional<DryingResult> drying;
    std::optional<double> water_at_start; ///< kg/m2, of a cloth that begins wet
    std::optional<ConditioningResult> conditioning;
    Series series;
    Ledger ledger;                    ///< at the end
    std::optional<double> edge_time;  ///< s, when water was first seen where the sample ends
    double unsettled = 0;             ///< how often the suctions along a yarn were not found
    std::vector<std::string> notes;   ///< what else limits a metric, in sentences
    std::vector<std::string> assumed; ///< of the cloth, and of the instrument that a metric imitates, in sentences
};

/// Its notes, then in a sentence what was not found.
std::vector<std::string> notes_of(const Metrics& metrics);

} // namespace hygroloom
