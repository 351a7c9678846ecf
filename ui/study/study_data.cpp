// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/study_data.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"
#include "ui/basics/quantity.h"
#include "ui/study/study_fields.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace hygroloom {

namespace {

using Role = StudyColumnRole;

/// Whether a file is there and none of the folder's rows came since.
bool isFresh(const std::filesystem::path& file)
{
    std::error_code failure;
    const auto written = std::filesystem::last_write_time(file, failure);
    if (failure) { return false; }
    for (const auto& part : std::filesystem::directory_iterator(file.parent_path() / "parts", failure)) {
        if (std::filesystem::last_write_time(part.path(), failure) > written) { return false; }
    }
    return true;
}

StudyAxis axisOf(const StudyTable& table, std::size_t column, const QString& title, const UserUnit& unit)
{
    const StudyColumn& of = table.columns[column];
    StudyAxis axis;
    axis.title = title;
    axis.column = column;
    axis.is_factor = of.role != Role::metric;
    if (of.is_number) {
        axis.numbers = of.numbers;
        for (double& number : axis.numbers) { number = unit.of(number); }
    } else {
        axis.numbers.assign(of.word_of.begin(), of.word_of.end());
        for (const std::string& word : of.words) { axis.words.push_back(QString::fromStdString(word)); }
    }
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double number : axis.numbers) {
        if (!std::isfinite(number)) { continue; }
        low = std::min(low, number);
        high = std::max(high, number);
    }
    axis.empty = !(low <= high);
    if (axis.empty) { return axis; }
    const double room = high > low ? 0 : std::max(0.05 * std::abs(low), 1e-9);
    axis.low = low - room;
    axis.high = high + room;
    return axis;
}

void addAxes(StudyData& data, const Design& design)
{
    std::set<QString> groups;
    for (const StudyColumn* column : data.table.all(Role::factor)) { groups.insert(fieldAt(design, column->name).group); }
    for (const bool factors : {true, false}) {
        for (std::size_t k = 0; k < data.table.columns.size(); ++k) {
            const StudyColumn& column = data.table.columns[k];
            QString title;
            UserUnit unit;
            if (column.role == Role::fabric) { title = QCoreApplication::translate("StudyData", "fabric"); }
            if (column.role == Role::experiment) { title = QCoreApplication::translate("StudyData", "experiment"); }
            if (column.role == Role::factor) {
                StudyField field = fieldAt(design, column.name);
                unit = userUnit(field.unit);
                field.unit = unit.unit;
                title = fieldTitle(field, groups.size() > 1);
            }
            if (column.role == Role::metric) {
                const MetricName name = metricName(column.name);
                unit = userUnit(name.unit);
                title = titleWithUnit(name.title, unit.unit);
            }
            if (!title.isEmpty() && (column.role != Role::metric) == factors) { data.axes.push_back(axisOf(data.table, k, title, unit)); }
        }
    }
}

/// What sensitivity.json says.
void readIndices(StudyData& data, const std::filesystem::path& file)
{
    const ProjectJson all = parse_json(read_file(file, std::size_t{64} << 20U), file.string());
    for (const auto& [metric, factors] : all.items()) {
        StudyIndices indices;
        const std::size_t name = metric.find(' '); // "metric of fabric in experiment"
        indices.title = metricTitle(metric.substr(0, name)) + QString::fromStdString(name < metric.size() ? metric.substr(name) : "");
        for (const auto& [path, of] : factors.items()) {
            indices.method = QString::fromStdString(of.value("method", ""));
            indices.points = of.value("points", std::size_t{0});
            SobolIndex index;
            const std::pair<const char*, double*> numbers[] = {{"first", &index.first},           {"first_low", &index.first_low},
                                                               {"first_high", &index.first_high}, {"total", &index.total},
                                                               {"total_low", &index.total_low},   {"total_high", &index.total_high}};
            for (const auto& [key, number] : numbers) { *number = of.at(key).get<double>(); }
            const QString title = data.of ? fieldTitle(fieldAt(data.of->design, path), false) : QString::fromStdString(path);
            indices.factors.emplace_back(title, index);
        }
        data.indices.push_back(std::move(indices));
    }
    data.has_indices = true;
}

void readFolder(StudyData& data, const std::filesystem::path& folder)
{
    data.of = read_study_folder(folder);
    const std::filesystem::path table = folder / "results.csv";
    data.table = isFresh(table) ? read_results(table) : collect_rows(*data.of, folder);
    data.rows = StudyFrame(data.of->study, data.of->design).rows();
    if (!isFresh(folder / "sensitivity.json")) { return; }
    try {
        readIndices(data, folder / "sensitivity.json");
    } catch (const std::exception&) { // it can be computed anew
        data.indices.clear();
        data.has_indices = false;
    }
}

double roundStep(double width, int most)
{
    const double rough = width / most, unit = std::pow(10, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * unit >= 0.999 * rough) { return factor * unit; }
    }
    return 10 * unit;
}

} // namespace

QString StudyAxis::text(double number) const
{
    if (words.empty()) { return studyNumber(number); }
    const auto place = static_cast<std::size_t>(std::lround(number));
    return place < words.size() ? words[place] : QString();
}

std::vector<double> StudyAxis::ticks(int most) const
{
    std::vector<double> made;
    if (empty || most < 1) { return made; }
    if (!words.empty()) {
        const std::size_t each = 1 + words.size() / (static_cast<std::size_t>(most) + 1);
        for (std::size_t i = 0; i < words.size(); i += each) { made.push_back(static_cast<double>(i)); }
        return made;
    }
    const double step = roundStep(high - low, most);
    for (double at = std::ceil(low / step - 1e-6) * step; at <= high + 1e-6 * step; at += step) {
        made.push_back(std::abs(at) < 1e-6 * step ? 0 : at);
    }
    return made;
}

std::shared_ptr<const StudyData> readStudyData(const QString& path)
{
    auto data = std::make_shared<StudyData>();
    data->path = path;
    const std::filesystem::path file = path.toStdString();
    if (QFileInfo(path).isDir()) {
        readFolder(*data, file);
    } else {
        data->table = path.endsWith(".sqlite") ? read_results_database(file) : read_results(file);
        data->rows = data->table.rows();
    }
    if (const StudyColumn* status = data->table.find(Role::status)) {
        const auto found = std::find(status->words.begin(), status->words.end(), row_failed);
        const auto failed = static_cast<std::uint32_t>(found - status->words.begin());
        data->failed = static_cast<std::size_t>(std::count(status->word_of.begin(), status->word_of.end(), failed));
    }
    addAxes(*data, data->of ? data->of->design : Design{});
    return data;
}

QString rowInWords(const StudyData& data, std::size_t row)
{
    QStringList parts;
    for (const StudyAxis& axis : data.axes) {
        const double number = axis.numbers[row];
        if (std::isfinite(number)) { parts << QString("%1 %2").arg(axis.title, axis.text(number)); }
    }
    return parts.join(", ");
}

KeptPoints keptBy(const StudyData& data, const std::vector<AxisBrush>& brushes)
{
    if (brushes.empty()) { return {}; }
    KeptPoints kept(data.table.rows(), 1);
    for (const AxisBrush& brush : brushes) {
        const std::vector<double>& numbers = data.axes[brush.axis].numbers;
        for (std::size_t row = 0; row < kept.size(); ++row) {
            kept[row] = static_cast<char>(kept[row] && numbers[row] >= brush.low && numbers[row] <= brush.high); // NaN lies nowhere
        }
    }
    return kept;
}

} // namespace hygroloom
