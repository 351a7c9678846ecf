// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What Cairo has drawn, as a picture of this program.
#pragma once

#include "core/analysis/image.h"

#include <cairo.h>

namespace hygroloom {

/// Of the image surface (RGB24) that a context draws into. Throws Error where something could not be drawn: Cairo keeps its first failure
/// to the end.
Image image_from(cairo_t* cairo);

} // namespace hygroloom
