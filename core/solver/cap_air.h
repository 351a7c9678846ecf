// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How a drop's contact angle changes what diffuses from it to the air.
#pragma once

namespace hygroloom {

/// Of diffusion_from_cap(): 4 / pi of a flat drop, 2 of a half ball. Contact angle in rad, 0 to 179 degrees (more count as 179). Popov's
/// integral, tabled once; within 1e-4.
double evaporation_factor(double contact_angle);

} // namespace hygroloom
