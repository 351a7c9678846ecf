// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a worn garment comes to: numbers of the whole, of each panel and of each zone of the body.
#pragma once

#include "core/wear/wear_layout.h"
#include "core/wear/wear_run.h"

#include <optional>

namespace hygroloom {

/// Of a cell with more of its capacity than this the cloth is wet; as much over a panel's mean and it is full; a garment with less than
/// the last, of the most that it held, is dry again.
constexpr double share_of_wet = 0.1, share_of_full = 0.9, share_of_dry = 0.05;

/// Part of a garment at one moment.
struct WearNow {
    double time = 0;        ///< s
    double water = 0;       ///< kg in the cloth over the start
    double inside = 0;      ///< kg of that on the face towards the skin
    double wet_area = 0;    ///< m2
    double evaporated = 0;  ///< kg since the start
    double on_skin = 0;     ///< kg under it
    double temperature = 0; ///< K, mean over the area
};

/// A panel, a zone, or all.
struct WearPart {
    std::string name;
    double area = 0;     ///< m2, of the pattern
    double in_cells = 0; ///< m2, of its cells, whose water and capacity these are
    double capacity = 0; ///< kg
    std::vector<WearNow> course;

    double largest_wet_area() const; ///< m2
    double most_water() const;       ///< kg
    // Between two frames water is taken to change evenly.
    /// s: when it first holds share_of_full of its capacity; none: never.
    std::optional<double> time_to_full() const;
    /// s from a time on: until it holds less than share_of_dry of the most that it held, for good; none: not by the end.
    std::optional<double> time_to_dry(double from) const;
};

/// Collects frames.
class WearMetrics {
public:
    /// The layout must outlive it.
    explicit WearMetrics(const WearLayout& layout);
    void add(const WearFrame& frame);

    const WearPart& all() const { return all_; }
    const std::vector<WearPart>& panels() const { return panels_; }
    const std::vector<WearPart>& zones() const { return zones_; } ///< those that the garment covers
    const Ledger& ledger() const { return ledger_; }
    /// kg of liquid that the cloth held at the start, and that the skin gave since.
    double at_start() const { return at_start_; }
    double sweat() const { return ledger_.water_delivered - at_start_; }
    /// Share of all water, of the fibres' too, that is not accounted for.
    double imbalance() const;
    /// J that the skin has given to the cloth, by the trapezoidal rule over frames; and J that evaporating takes at the skin's temperature.
    double heat_from_skin() const { return from_skin_; }
    double heat_of_evaporation() const;
    /// s: see WearLayout::stops.
    std::optional<double> stops() const { return layout_.stops; }

private:
    const WearLayout& layout_;
    std::vector<double> areas_; ///< m2, of each cell
    WearPart all_;
    std::vector<WearPart> panels_, zones_;
    std::vector<int> zone_of_; ///< of each cell, its place in zones_
    Ledger ledger_;
    double at_start_ = 0;                    ///< kg
    double skin_temperature_ = 0;            ///< K
    double from_skin_ = 0, flow_before_ = 0; ///< J, W
};

} // namespace hygroloom
