// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How a fabric stands in the picture: framed, looked at from its sides, and the scale that holds there.
#pragma once

#include "ui/picture/camera.h"
#include "ui/picture/preview_fabric.h"
#include "ui/picture/yarn_field.h"

#include <optional>

namespace hygroloom {

enum class Framing { as_it_is, few_repeats, whole };

/// Shows the whole fabric, or a few repeats in its middle. Looked at from the edge both show a few yarns of the edge.
Camera framed(Camera camera, const PreviewFabric& fabric, Framing framing, const QSizeF& size);
/// The same picture from another side: what is in its middle stays there as large, and the eye stays outside the fabric.
Camera looking_from(Camera camera, const PreviewFabric& fabric, double turn, double lift, const QSizeF& size);

/// Comes nearer to the crossing that is nearest to a point of the picture. That one is in the picture afterwards, so that zooming ends in
/// no empty view, wherever the pointer is.
Camera zoomed_to_cloth(Camera camera, const PreviewFabric& fabric, const std::optional<CutPlane>& cut, double factor, const QPointF& at,
                       const QSizeF& size);

/// Millimetres that a pixel covers, across the line of sight, where the fabric is in the middle of the picture. Nothing where there is no
/// fabric, where the eye is within it, and where some of what is seen is more than scale_holds_within times larger or smaller.
constexpr double scale_holds_within = 1.6;
std::optional<double> millimetre_per_pixel(const Camera& camera, const PreviewFabric& fabric, const std::optional<CutPlane>& cut,
                                           const QSizeF& size);

} // namespace hygroloom
