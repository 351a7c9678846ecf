// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/export/mesh_export.h"

#include "core/base/error.h"

#include <QCoreApplication>
#include <QSettings>

#include <algorithm>
#include <limits>

namespace hygroloom {

namespace {

MeshExport simulatedPiece(const ExportSource& source)
{
    const RunRecord& run = *source.run;
    const Fabric* fabric = find_fabric(run.design, run.fabric);
    if (!fabric) { throw Error(QCoreApplication::translate("hygroloom", "The recording does not contain its fabric.").toStdString()); }
    return {*fabric, run.textile, {{}, source.frame->saturation}, 0};
}

MeshExport dryPiece(const ExportSource& source, const ExportChoice& choice)
{
    const Fabric& fabric = source.design->fabrics[static_cast<std::size_t>(source.fabric)];
    const double* size = choice.piece == ExportPiece::sample ? source.sample_mm : choice.size_mm;
    const TextileRegion region = choice.piece == ExportPiece::repeats ? region_of_repeats(fabric, choice.repeats[0], choice.repeats[1])
                                                                      : region_of_sample(fabric, size[0], size[1]);
    return {fabric, build_textile(fabric, *source.fitted, region), {}, 0};
}

} // namespace

MeshExport meshExport(const ExportSource& source, const ExportChoice& choice)
{
    MeshExport made = choice.piece == ExportPiece::simulated ? simulatedPiece(source) : dryPiece(source, choice);
    MeshRequest& mesh = made.options.mesh;
    mesh = smooth_request(made.textile, choice.detail);
    mesh.samples_per_crossing = choice.samples.value_or(mesh.samples_per_crossing);
    mesh.sides = choice.sides.value_or(mesh.sides);
    mesh.capped = choice.capped;
    mesh.flyaways = choice.flyaways;
    mesh.seed = static_cast<std::uint64_t>(choice.seed);
    made.smooth_samples = choice.detail == MeshDetail::fibre ? smooth_samples(made.textile) : 0;
    return made;
}

ExportChoice savedExportChoice(const QSettings& settings)
{
    ExportChoice choice;
    const auto whole = [&](const char* key, int value, int least, int most) {
        return std::clamp(settings.value(QString("export/") + key, value).toInt(), least, most);
    };
    const auto yes = [&](const char* key, bool value) { return settings.value(QString("export/") + key, value).toBool(); };
    const auto millimetres = [&](const char* key, double value) { return settings.value(QString("export/") + key, value).toDouble(); };
    choice.ending = settings.value("export/ending", choice.ending).toString();
    choice.detail = static_cast<MeshDetail>(whole("detail", static_cast<int>(choice.detail), 0, 2));
    choice.piece = static_cast<ExportPiece>(whole("piece", static_cast<int>(choice.piece), 0, 3));
    choice.repeats[0] = whole("repeats_across", choice.repeats[0], 1, largest_yarn_order);
    choice.repeats[1] = whole("repeats_along", choice.repeats[1], 1, largest_yarn_order);
    choice.size_mm[0] = millimetres("width_mm", choice.size_mm[0]);
    choice.size_mm[1] = millimetres("height_mm", choice.size_mm[1]);
    if (const int samples = whole("samples", 0, 0, most_samples)) { choice.samples = samples; }
    if (const int sides = whole("sides", 0, 0, most_sides)) { choice.sides = sides; }
    choice.capped = yes("capped", choice.capped);
    choice.flyaways = yes("flyaways", choice.flyaways);
    choice.seed = whole("seed", choice.seed, 0, std::numeric_limits<int>::max());
    return choice;
}

void saveExportChoice(QSettings& settings, const ExportChoice& choice)
{
    settings.setValue("export/ending", choice.ending);
    settings.setValue("export/detail", static_cast<int>(choice.detail));
    settings.setValue("export/piece", static_cast<int>(choice.piece));
    settings.setValue("export/repeats_across", choice.repeats[0]);
    settings.setValue("export/repeats_along", choice.repeats[1]);
    settings.setValue("export/width_mm", choice.size_mm[0]);
    settings.setValue("export/height_mm", choice.size_mm[1]);
    settings.setValue("export/samples", choice.samples.value_or(0));
    settings.setValue("export/sides", choice.sides.value_or(0));
    settings.setValue("export/capped", choice.capped);
    settings.setValue("export/flyaways", choice.flyaways);
    settings.setValue("export/seed", choice.seed);
}

} // namespace hygroloom
