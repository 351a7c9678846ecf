// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/study_report.h"

#include "core/analysis/cell_map.h"
#include "core/analysis/comparison_report.h"
#include "core/analysis/map_picture.h"
#include "core/project/atomic_file.h"
#include "core/run/recording.h"
#include "core/wear/wear_report.h"
#include "ui/results/report_file.h"

#include <QCoreApplication>
#include <QSettings>

#include <deque>

namespace hygroloom {

namespace {

QString keyOf(const QString& project, const std::string& experiment)
{
    return "measured/" + (project + '\n' + QString::fromStdString(experiment)).toUtf8().toHex();
}

/// All panels at the end, on one scale.
std::vector<ReportPicture> picturesOfGarments(const Comparison& comparison, const std::map<std::string, QString>& recordings)
{
    WearMapOptions how;
    how.crossings = 1; // as computed
    how.units = unitsOfReader();
    std::deque<WearRecording> read; // whose layouts stay where they are
    std::vector<GarmentAtEnd> ends;
    for (const Candidate& candidate : comparison.candidates) {
        const auto found = recordings.find(candidate.fabric);
        if (found == recordings.end()) { continue; }
        const WearRecording& recording = read.emplace_back(found->second.toStdString());
        if (recording.frames() == 0) { continue; }
        ends.push_back(
            {candidate.fabric, &recording.record().layout, std::make_shared<const WearFrame>(recording.frame(recording.frames() - 1))});
    }
    return pictures_on_one_scale(ends, how);
}

} // namespace

ReportPage studyReport(const Comparison& comparison, const std::map<std::string, QString>& recordings)
{
    constexpr int crossings_per_cell = 2;
    std::vector<std::pair<std::string, MapPicture>> maps;
    for (const Candidate& candidate : comparison.candidates) {
        const auto found = recordings.find(candidate.fabric);
        if (found == recordings.end() || candidate.worn) { continue; }
        const Recording recording(found->second.toStdString());
        if (recording.frames() == 0) { continue; }
        const Frame start = start_of_maps(recording.run(), recording.frame(0)), last = recording.frame(recording.frames() - 1);
        for (const auto& [side, name] : {std::pair(MapSide::top, "top"), std::pair(MapSide::bottom, "bottom")}) {
            maps.emplace_back(map_caption(comparison, candidate.fabric, name),
                              map_picture(recording.run(), last, start, side, crossings_per_cell, unitsOfReader()));
        }
    }
    std::vector<ReportPicture> pictures = pictures_on_one_scale(std::move(maps));
    if (comparison.of_garments) { pictures = picturesOfGarments(comparison, recordings); }
    return comparison_report(comparison, pictures, unitsOfReader());
}

LaboratoryTable readMeasured(const std::vector<OutcomeInfo>& criteria, const std::vector<std::string>& fabrics, const QString& file)
{
    constexpr std::size_t most_bytes = std::size_t{16} << 20U;
    std::vector<std::pair<std::string, std::string>> metrics;
    metrics.reserve(criteria.size());
    for (const OutcomeInfo& criterion : criteria) { metrics.emplace_back(criterion.key, criterion.unit); }
    return read_laboratory_table(read_file(file.toStdString(), most_bytes), file.toStdString(), fabrics, metrics);
}

QString measuredFile(const QString& project, const std::string& experiment)
{
    return QSettings().value(keyOf(project, experiment)).toString();
}

void rememberMeasured(const QString& project, const std::string& experiment, const QString& file)
{
    QSettings().setValue(keyOf(project, experiment), file);
}

} // namespace hygroloom
