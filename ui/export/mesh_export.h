// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is to be exported and how, as chosen in the export dialog, and the core's answers to it. Knows no widget.
#pragma once

#include "core/project/mesh_file.h"
#include "core/run/runner.h"

#include <QString>

#include <memory>
#include <optional>

class QSettings;

namespace hygroloom {

/// Which crossings.
enum class ExportPiece { repeats, size, sample, simulated };

struct ExportChoice {
    QString ending = QStringLiteral(".obj"); ///< says the format
    MeshDetail detail = MeshDetail::yarn;
    ExportPiece piece = ExportPiece::repeats;
    int repeats[2] = {2, 2}; ///< along the weft, along the warp
    double size_mm[2] = {5, 5};
    std::optional<int> samples; ///< per crossing; without a value as many as draw it smoothly
    std::optional<int> sides;
    bool capped = true;
    bool flyaways = true;
    int seed = 1;
};
ExportChoice savedExportChoice(const QSettings& settings);
void saveExportChoice(QSettings& settings, const ExportChoice& choice);

/// Copies of what can be exported now; none of them changes.
struct ExportSource {
    std::shared_ptr<const Design> design;
    int fabric = 0;
    std::shared_ptr<const FittedFabric> fitted; ///< the fabric's
    double sample_mm[2] = {0, 0};               ///< of the experiment
    std::shared_ptr<const RunRecord> run;       ///< with the frame, of a simulated piece
    std::shared_ptr<const Frame> frame;
};

struct MeshExport {
    Fabric fabric;
    Textile textile;
    ExportOptions options;
    int smooth_samples = 0; ///< what the twist needs; 0 where it does not matter
};
/// Throws Error with a sentence about the piece. Precondition: the fabric has no error.
MeshExport meshExport(const ExportSource& source, const ExportChoice& choice);

} // namespace hygroloom
