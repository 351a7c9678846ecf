// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which cells of the fabric are in sight, and how fine each is drawn. Levels change by fading, never at once.
#pragma once

#include "ui/picture/camera.h"
#include "ui/picture/cell_mesh.h"
#include "ui/picture/yarn_field.h"

#include <array>
#include <functional>
#include <map>
#include <optional>

namespace hygroloom {

/// A cell to draw, as the graphics card takes it.
struct CellInstance {
    float corner[2];   ///< mm
    float crossing[2]; ///< first end and pick
    float size[2];     ///< mm, for the flat picture
    float fade;        ///< 1 all; 0..1 that share of the pixels; below 0 the pixels that -fade leaves out
};

/// How a cell is drawn.
enum class CellRole {
    whole, ///< on all pixels
    fading,
    over,   ///< the flat picture, laid over tubes
    skins,  ///< in the belt where skins blend into fibres
    fibres, ///< the same cells
};

struct CellBatch {
    MeshKey key;
    std::array<std::vector<CellInstance>, 5> cells; ///< by role
    std::vector<CellInstance>& of(CellRole role) { return cells[static_cast<std::size_t>(role)]; }
    const std::vector<CellInstance>& of(CellRole role) const { return cells[static_cast<std::size_t>(role)]; }
};

/// A mesh that would be drawn if it were there.
struct WantedMesh {
    MeshKey key;
    Cell cell; ///< one that needs it, the nearest
    double distance = 0;
};

struct SceneView {
    Camera camera;
    QSizeF size;                 ///< of the picture
    double detail = 1;           ///< how much finer than usual; device pixels per pixel among it
    int finest = fibre_level;    ///< level that is drawn at most
    std::optional<CutPlane> cut; ///< metres
    QPointF shift;               ///< pixels, by which the picture is drawn beside its place

    /// From the scene to the card's clip space.
    QMatrix4x4 clip() const;
};

class FabricScene {
public:
    void setFabric(std::shared_ptr<const PreviewFabric> fabric);
    const std::shared_ptr<const PreviewFabric>& fabric() const { return fabric_; }

    /// Whether a mesh has been made.
    using Available = std::function<bool(const MeshKey&)>;

    /// Chooses levels; those that change begin to fade over. seconds: since the last update, for those that fade.
    void update(const SceneView& view, double seconds, const Available& available);
    /// Ends all fading.
    void settle();

    const std::vector<CellBatch>& batches() const { return batches_; }
    /// Nearest first.
    const std::vector<WantedMesh>& wanted() const { return wanted_; }
    bool fading() const { return fading_; }
    std::size_t visibleCells() const { return visible_.size(); }
    const std::vector<Cell>& visible() const { return visible_; }

private:
    struct State {
        std::int8_t level = -1;
        std::int8_t from = -1;
        float fade = 1;
        bool belt = false; ///< the level below shows through
    };
    State& state(Cell cell)
    {
        return states_[static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(fabric_->columns()) +
                       static_cast<std::size_t>(cell.column)];
    }
    void findVisible(const SceneView& view);
    /// Of a pitch at the nearest and at the farthest point of a cell. The nearest decides, so that no part is too coarse.
    std::pair<double, double> pitchPixels(Cell cell, const SceneView& view) const;
    void want(Cell cell, const MeshKey& key, const SceneView& view);
    void chooseLevel(Cell cell, const SceneView& view, bool level_cut, const Available& available);
    int substitute(Cell cell, int wished, const Available& available);
    static void changeLevel(State& s, int level, double pixels);
    void collect();

    std::shared_ptr<const PreviewFabric> fabric_;
    std::vector<State> states_;
    std::vector<Cell> visible_;
    std::vector<CellBatch> batches_;
    std::vector<WantedMesh> wanted_;
    std::map<MeshKey, WantedMesh> missing_; ///< of the update in progress
    bool fading_ = false;
};

/// What a millimetre's pixels are to be multiplied by for the width of a pitch that levels go by.
double pitch_scale(const PreviewFabric& fabric, const SceneView& view);

} // namespace hygroloom
