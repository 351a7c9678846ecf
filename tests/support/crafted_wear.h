// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings of worn garments as a stranger would make them: a valid one, and which of its objects can be changed.
#pragma once

#include "core/wear/wear_recording.h"
#include "tests/support/crafted_recording.h"

namespace hygroloom {

/// Of two panels that are sewn to each other, made up.
WearRecord small_wear();
WearFrame small_wear_frame(const WearLayout& layout, int number);

/// A valid one of three frames.
void write_small_wear_recording(const std::string& path);

const CraftTargets& targets_of_a_garment();

/// Does all that the program does with a recorded garment: reads its frames, sums them up, draws its map. The map's files come to a folder
/// that is there; with an empty name only its tables are made, which is quicker. Throws FileError.
void use_wear_recording(const std::string& path, const std::string& folder);

} // namespace hygroloom
