// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/fabric_scene.h"

#include "core/base/units.h"

#include <QVector4D>

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double fade_seconds = 0.22;
constexpr std::size_t most_cut_crossings = 12000;
constexpr double belt_start = 1.15 * belt_pixels[0]; // up to this pitch hardly any tubes are seen in the belt

/// The half spaces that the picture shows, in the scene's coordinates.
std::array<QVector4D, 6> planes_of(const QMatrix4x4& clip)
{
    std::array<QVector4D, 6> planes;
    for (int axis = 0; axis < 3; ++axis) {
        planes[static_cast<std::size_t>(2 * axis)] = clip.row(3) + clip.row(axis);
        planes[static_cast<std::size_t>(2 * axis + 1)] = clip.row(3) - clip.row(axis);
    }
    return planes;
}

bool outside(const QVector4D& plane, const QVector3D& low, const QVector3D& high)
{
    const QVector3D farthest(plane.x() > 0 ? high.x() : low.x(), plane.y() > 0 ? high.y() : low.y(), plane.z() > 0 ? high.z() : low.z());
    return QVector3D::dotProduct(plane.toVector3D(), farthest) + plane.w() < 0;
}

} // namespace

QMatrix4x4 SceneView::clip() const
{
    QMatrix4x4 shifted;
    shifted.translate(static_cast<float>(2 * shift.x() / size.width()), static_cast<float>(2 * shift.y() / size.height()));
    return shifted * camera.projection(size) * camera.view();
}

double pitch_scale(const PreviewFabric& fabric, const SceneView& view)
{
    const QVector3D pitch = fabric.pitch();
    return view.detail * std::sqrt(pitch.x() * pitch.y());
}

void FabricScene::setFabric(std::shared_ptr<const PreviewFabric> fabric)
{
    fabric_ = std::move(fabric);
    states_.clear();
    visible_.clear();
    batches_.clear();
    wanted_.clear();
    fading_ = false;
    if (fabric_) { states_.resize(static_cast<std::size_t>(fabric_->columns()) * static_cast<std::size_t>(fabric_->rows())); }
}

void FabricScene::findVisible(const SceneView& view)
{
    visible_.clear();
    std::vector<QVector4D> planes;
    for (const QVector4D& plane : planes_of(view.camera.projection(view.size) * view.camera.view())) { planes.push_back(plane); }
    if (view.cut) {
        const Vec3d& n = view.cut->normal;
        planes.emplace_back(static_cast<float>(-n.x), static_cast<float>(-n.y), static_cast<float>(-n.z),
                            static_cast<float>(mm_from_metre(view.cut->offset)));
    }
    const auto seen = [&](const TextileRegion& crossings) {
        const QVector3D low = fabric_->low(crossings), high = fabric_->high(crossings);
        return std::none_of(planes.begin(), planes.end(), [&](const QVector4D& plane) { return outside(plane, low, high); });
    };
    const int columns = fabric_->columns(), rows = fabric_->rows();
    const auto mark_unseen = [&](int row, int from, int to) {
        for (int column = from; column < to; ++column) { state({column, row}) = {}; }
    };
    for (int row = 0; row < rows; ++row) {
        TextileRegion strip = fabric_->crossings({0, row});
        strip.ends = fabric_->textile.ends();
        if (!seen(strip)) {
            mark_unseen(row, 0, columns);
            continue;
        }
        for (int column = 0; column < columns; ++column) {
            if (seen(fabric_->crossings({column, row}))) {
                visible_.push_back({column, row});
            } else {
                mark_unseen(row, column, column + 1);
            }
        }
    }
}

std::pair<double, double> FabricScene::pitchPixels(Cell cell, const SceneView& view) const
{
    const TextileRegion part = fabric_->crossings(cell);
    const QVector3D low = fabric_->low(part), high = fabric_->high(part), towards = view.camera.direction();
    const auto corner = [&](bool nearest) {
        const auto pick = [&](int axis) { return (towards[axis] > 0) == nearest ? high[axis] : low[axis]; };
        return view.camera.pixelsPerMillimetre(view.camera.depth({pick(0), pick(1), pick(2)}), view.size) * pitch_scale(*fabric_, view);
    };
    return {corner(true), corner(false)};
}

void FabricScene::update(const SceneView& view, double seconds, const Available& available)
{
    wanted_.clear();
    missing_.clear();
    if (!fabric_ || view.size.width() < 1) {
        visible_.clear();
        batches_.clear();
        return;
    }
    findVisible(view);
    fading_ = false;
    // The flat picture cannot be cut level; it stays for pieces that would be too many tubes.
    const bool level_cut = view.cut && view.cut->normal.z != 0 &&
                           visible_.size() * static_cast<std::size_t>(fabric_->cell_ends * fabric_->cell_picks) < most_cut_crossings;
    for (const Cell cell : visible_) {
        State& s = state(cell);
        if (s.from >= 0) {
            s.fade = std::min(1.0F, s.fade + static_cast<float>(seconds / fade_seconds));
            s.from = s.fade < 1 ? s.from : std::int8_t{-1};
        }
        chooseLevel(cell, view, level_cut, available);
        fading_ = fading_ || s.from >= 0;
    }
    for (const auto& [key, wish] : missing_) { wanted_.push_back(wish); }
    std::sort(wanted_.begin(), wanted_.end(), [](const WantedMesh& a, const WantedMesh& b) { return a.distance < b.distance; });
    collect();
}

void FabricScene::want(Cell cell, const MeshKey& key, const SceneView& view)
{
    const TextileRegion part = fabric_->crossings(cell);
    const double distance = (0.5F * (fabric_->low(part) + fabric_->high(part)) - view.camera.target()).length();
    auto [found, added] = missing_.try_emplace(key, WantedMesh{key, cell, distance});
    if (!added && distance < found->second.distance) { found->second = {key, cell, distance}; }
}

void FabricScene::chooseLevel(Cell cell, const SceneView& view, bool level_cut, const Available& available)
{
    State& s = state(cell);
    const auto [pixels, least_pixels] = pitchPixels(cell, view);
    int level = std::min(level_for(pixels, s.level), view.finest);
    s.belt = level == fibre_level ? least_pixels < fibre_belt_pixels[1] : level > 0 && least_pixels < belt_pixels[1];
    if (level_cut && level < fibre_level) {
        level = std::max(level, 1);
        s.belt = false;
    }
    if (level != s.level && s.from < 0) {
        if (const MeshKey key = fabric_->key(cell, level); !available(key)) {
            want(cell, key, view);
            level = substitute(cell, level, available);
        }
        changeLevel(s, level, pixels);
    }
    if (s.level >= 0 && !available(fabric_->key(cell, s.level))) { s = {}; }
    if (s.level > 0 && s.belt) {
        const MeshKey below = fabric_->key(cell, s.level == fibre_level ? fibre_level - 1 : 0);
        if (!available(below)) {
            want(cell, below, view);
            s.belt = false;
        }
    }
}

/// Until a level's mesh is there the level that is shown stays; a cell that shows none takes the nearest available one.
int FabricScene::substitute(Cell cell, int wished, const Available& available)
{
    int level = state(cell).level;
    for (int away = 1; level < 0 && away <= fibre_level; ++away) {
        for (const int other : {wished - away, wished + away}) {
            if (level < 0 && other >= 0 && other <= fibre_level && available(fabric_->key(cell, other))) { level = other; }
        }
    }
    return level;
}

/// At once where a belt hides the change, else by fading. pixels: of a pitch.
void FabricScene::changeLevel(State& s, int level, double pixels)
{
    const bool behind_belt = pixels < belt_start && ((level > 0 && s.level == 0) || (level == 0 && s.level > 0));
    const bool behind_fibres = pixels < 1.15 * fibre_belt_pixels[0] && std::max<int>(level, s.level) == fibre_level &&
                               std::min<int>(level, s.level) == fibre_level - 1;
    if (behind_belt || behind_fibres) {
        s.level = static_cast<std::int8_t>(level);
    } else if (level != s.level) {
        s = s.level < 0 ? State{static_cast<std::int8_t>(level), -1, 1, s.belt}
                        : State{static_cast<std::int8_t>(level), s.level, 0, s.belt};
    }
}

void FabricScene::settle()
{
    for (State& s : states_) {
        s.from = -1;
        s.fade = 1;
    }
    fading_ = false;
    if (fabric_) { collect(); }
}

void FabricScene::collect()
{
    batches_.clear();
    std::map<MeshKey, std::size_t> number;
    const auto batch = [&](const MeshKey& key) -> CellBatch& {
        const auto [found, added] = number.try_emplace(key, batches_.size());
        if (added) { batches_.push_back({key, {}}); }
        return batches_[found->second];
    };
    for (const Cell cell : visible_) {
        const State& s = state(cell);
        if (s.level < 0) { continue; }
        const TextileRegion part = fabric_->crossings(cell);
        const QVector3D low = fabric_->low(part), size = fabric_->high(part) - low;
        CellInstance instance{
            {low.x(), low.y()}, {static_cast<float>(part.first_end), static_cast<float>(part.first_pick)}, {size.x(), size.y()}, 1};
        if (s.level > 0 && s.level < fibre_level && s.belt) { batch({}).of(CellRole::over).push_back(instance); }
        if (s.level == fibre_level && s.belt && s.from < 0) {
            batch(fabric_->key(cell, fibre_level)).of(CellRole::fibres).push_back(instance);
            batch(fabric_->key(cell, fibre_level - 1)).of(CellRole::skins).push_back(instance);
        } else if (s.from < 0) {
            batch(fabric_->key(cell, s.level)).of(CellRole::whole).push_back(instance);
        } else {
            instance.fade = s.fade;
            batch(fabric_->key(cell, s.level)).of(CellRole::fading).push_back(instance);
            instance.fade = -std::max(s.fade, 1e-6F);
            batch(fabric_->key(cell, s.from)).of(CellRole::fading).push_back(instance);
        }
    }
}

} // namespace hygroloom
