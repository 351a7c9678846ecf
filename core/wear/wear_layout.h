// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What of a garment stays the same through a run: its panels, cells and shape, for those who show what came of it.
#pragma once

#include "core/wear/garment_scene.h"

#include <optional>

namespace hygroloom {

/// m, of flat places.
struct FlatBox {
    double left = 1e300, low = 1e300, right = -1e300, high = -1e300;
    double width() const { return right - left; }
    double height() const { return high - low; }
};

struct WearPanel {
    std::string name, fabric;
    double grain = 0;               ///< radian
    int crossings_per_cell = 1;     ///< ends, and picks
    std::vector<FlatPlace> outline; ///< m, counter-clockwise
    PanelGrid grid;

    FlatBox box() const; ///< about its outline
};

struct WearLayout {
    std::string garment, experiment;
    std::string cells_in_words;  ///< "cells of 2.3 x 2.3 mm, 8 x 8 crossings"
    double skin_temperature = 0; ///< K
    /// How warm each zone of the body is, where that changes: as SkinMoment, but K; empty: skin_temperature everywhere.
    struct SkinTemperature {
        double time = 0;        ///< s
        double temperature = 0; ///< K
    };
    std::vector<std::vector<SkinTemperature>> skin_course;
    /// s, when the wearer's activity last falls: from then on cloth may dry; where it never falls, the start of what is wet from the start;
    /// none: neither.
    std::optional<double> stops;
    std::vector<std::string> own_zones; ///< names of the wearer's own zones, which follow the body's
    std::vector<WearPanel> panels;
    std::vector<GarmentCell> cells;
    GarmentShape shape;

    double skin_temperature_at(int zone, double time) const; ///< K
    /// Of the body, then its own, by their numbers in cells.
    std::vector<std::string> zone_names() const;
};

WearLayout wear_layout(const GarmentParts& parts, const GarmentScene& garment);

} // namespace hygroloom
