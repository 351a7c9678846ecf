// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A recording as files that ParaView and others of VTK open: yarn segments as lines with what they hold, free liquid as points.
#pragma once

#include "core/run/recording.h"

#include <filesystem>
#include <functional>

namespace hygroloom {

/// Writes yarns_NNNNNN.vtp for every Nth frame and the last, and liquid_NNNNNN.vtp beside it where the run ever had free
/// liquid; then yarns.pvd and liquid.pvd, and .vtp.series files, which name the frames' times in s. Lengths are in mm. Each frame has the
/// same arrays: saturation (liquid over pores), water_content_kg_kg (liquid and bound over dry fibre), regain_kg_kg, vapour_g_m3,
/// temperature_c, top (1: on the top face), warp (1, or 0 of weft), end and pick (of the crossing), segment; of liquid velocity_m_s.
/// Makes the folder, or takes the files of another recording in it out of use by removing those that name them. Returns how many frames it
/// has written. progress gets the share that is done and returns whether to go on; otherwise throws Cancelled, and the files so far stay
/// without the ones that name them. Throws FileError.
int write_vtk(const Recording& recording, const std::filesystem::path& folder, int every, const std::function<bool(double)>& progress);

} // namespace hygroloom
