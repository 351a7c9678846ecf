// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/session.h"

#include "core/scene/coarse_scene.h"

namespace hygroloom {

Session::Session(Backend& backend, Scene scene, int crossings_per_cell) : backend_(&backend), scene_(std::move(scene))
{
    if (crossings_per_cell <= 1) return;
    single_ = std::move(scene_);
    scene_ = coarsened(*single_, crossings_per_cell);
}

void Session::move_to(std::unique_ptr<Backend> backend)
{
    backend_ = backend.get();
    moved_to_ = std::move(backend);
}

Frame Session::of_single_yarns(Frame frame) const
{
    if (!single_) return frame; // a conditional expression would copy it
    return refined(std::move(frame), scene_, *single_);
}

void Session::go_on_from(const std::vector<std::byte>& state)
{
    load();
    backend_->go_on_from(state);
}

void Session::go_on_from(const std::vector<std::byte>& state, const ModelPlan& plan)
{
    set_parts(scene_, plan);
    go_on_from(state);
}

} // namespace hygroloom
