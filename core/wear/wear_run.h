// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment that is worn, from its project to frames of cells.
#pragma once

#include "core/run/learned_times.h"
#include "core/run/run_options.h"
#include "core/wear/garment_scene.h"

#include <memory>

namespace hygroloom {

class Backend;

/// One moment. Of each shown cell, in the order of ShownCells::cells.
struct WearFrame {
    double time = 0; ///< s
    Ledger ledger;
    std::vector<double> inside, outside; ///< kg of liquid and bound water over the start, on the face towards the skin and on the other
    std::vector<double> evaporated;      ///< kg since the start
    std::vector<float> temperature;      ///< K, of its yarns
    std::vector<double> on_skin;         ///< kg under it

    double water(std::size_t cell) const { return inside[cell] + outside[cell]; }
};

WearFrame wear_frame(const GarmentScene& garment, const Frame& frame);

/// m, of a garment's computed cells.
double cell_side(const RunOptions& options);
GarmentResolution resolution_of(const RunOptions& options);

/// What is expected before anything runs.
struct WearPlan {
    int cells = 0;
    std::vector<int> panel_cells;
    std::vector<int> crossings_per_cell; ///< of each panel
    double bytes = 0;
    GarmentTime time; ///< rough, on two cores of some machine, unless it was learned on this one
};
WearPlan plan_wear(const GarmentScene& garment, const WearExperiment& wear, Fidelity fidelity);
/// With what garments took here on the backend, see expect_as_learned().
WearPlan plan_wear(const GarmentScene& garment, const WearExperiment& wear, Fidelity fidelity, const std::string& backend);

/// s, of frames: 60 evenly, and one at each change of activity.
std::vector<double> wear_times(const WearExperiment& wear);

struct WearCallbacks {
    std::function<void(std::shared_ptr<const WearFrame>)> frame;
    std::function<void(const RunProgress&)> progress;
    std::function<void(const std::string&)> device_failed = {};  ///< the run is about to go on on the CPU; a sentence
    std::function<void(const std::string&)> device_changed = {}; ///< what it has gone on on since when, to be added to the device's name
};

/// To the end, in the calling thread. Of the options those count that say how it may go on on the CPU. Throws Cancelled within 0.2 s when
/// asked to stop, DeviceError, Error.
void run_wear(const GarmentScene& garment, const WearExperiment& wear, Backend& backend, RunControl& control,
              const WearCallbacks& callbacks, const RunOptions& options = {});

} // namespace hygroloom
