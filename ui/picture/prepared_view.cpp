// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/prepared_view.h"

#include <chrono>

namespace hygroloom {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto first_picture_within = std::chrono::milliseconds(45);
constexpr auto delivery_every = std::chrono::milliseconds(30);

} // namespace

std::shared_ptr<const PreparedView> prepare_view(const PreviewRequest& request, SceneView view, Framing framing,
                                                 const std::function<bool()>& outdated)
{
    auto prepared = std::make_shared<PreparedView>();
    prepared->fabric = prepare_fabric(request);
    view.camera = framed(view.camera, *prepared->fabric, framing, view.size);
    FabricScene scene;
    scene.setFabric(prepared->fabric);
    scene.update(view, 0, [](const MeshKey&) { return false; });
    const auto start = Clock::now();
    bool complete = true;
    for (const WantedMesh& wish : scene.wanted()) {
        if (outdated()) { break; }
        if (wish.key.level == 0 || Clock::now() - start > first_picture_within) {
            complete = false;
            break;
        }
        prepared->meshes.push_back(mesh_cell(*prepared->fabric, wish.cell, wish.key.level));
    }
    if (!complete) { prepared->picture = picture_of_repeat(*prepared->fabric); }
    return prepared;
}

void make_wanted(const std::shared_ptr<const PreviewFabric>& fabric, const std::vector<WantedMesh>& wanted,
                 const std::function<bool()>& outdated, const std::function<void(std::shared_ptr<const PreparedView>)>& deliver)
{
    auto ready = std::make_shared<PreparedView>();
    ready->fabric = fabric;
    auto last = Clock::now();
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const WantedMesh& wish = wanted[i];
        if (wish.key.level == 0) {
            ready->picture = picture_of_repeat(*fabric);
        } else {
            ready->meshes.push_back(mesh_cell(*fabric, wish.cell, wish.key.level));
        }
        const bool stop = outdated() || i + 1 == wanted.size();
        if (stop || Clock::now() - last > delivery_every) {
            deliver(ready);
            ready = std::make_shared<PreparedView>();
            ready->fabric = fabric;
            last = Clock::now();
        }
        if (stop) { return; }
    }
}

} // namespace hygroloom
