// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the tests of the page of studies share: fields of drop_design() that studies vary.
#pragma once

namespace hygroloom {

inline constexpr const char* ends = "fabrics[0].ends_per_cm";
inline constexpr const char* angle = "fabrics[0].contact_angle_deg";
inline constexpr const char* volume = "experiments[0].droplets[0].volume_ul";

} // namespace hygroloom
