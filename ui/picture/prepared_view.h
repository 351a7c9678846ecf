// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Work for the background: a fabric with the meshes that its first picture needs.
#pragma once

#include "ui/picture/fabric_scene.h"
#include "ui/picture/framing.h"
#include "ui/picture/repeat_picture.h"

namespace hygroloom {

struct PreparedView {
    std::shared_ptr<const PreviewFabric> fabric;
    std::vector<CellMesh> meshes;
    std::optional<RepeatPicture> picture;
};

/// Meshes nearest first, for as long as an eye hardly notices; where they do not suffice, the flat picture stands in.
std::shared_ptr<const PreparedView> prepare_view(const PreviewRequest& request, SceneView view, Framing framing,
                                                 const std::function<bool()>& outdated);

/// Makes what is wanted, nearest first, and delivers it a few at a time; a newer wish stops it.
void make_wanted(const std::shared_ptr<const PreviewFabric>& fabric, const std::vector<WantedMesh>& wanted,
                 const std::function<bool()>& outdated, const std::function<void(std::shared_ptr<const PreparedView>)>& deliver);

} // namespace hygroloom
