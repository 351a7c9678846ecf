// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/chart_data.h"

#include "core/base/text.h"

#include "ui/basics/core_words.h"
#include "ui/basics/words.h"
#include "ui/results/report_file.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace hygroloom {

namespace {

/// The number whose error a curve has.
struct CurveError {
    std::vector<double> Series::*curve;
    const char* metric;
    const char* words;
};
constexpr CurveError curve_errors[] = {
    {&Series::radius_top, "maximum_wetted_radius_top_mm", "the wetted radius, top"},
    {&Series::radius_bottom, "maximum_wetted_radius_bottom_mm", "the wetted radius, bottom"},
    {&Series::wick_height, "wick_height_mm", "the height"},
};

const CurveError* errorOf(const Curve& curve)
{
    const auto found = std::find_if(std::begin(curve_errors), std::end(curve_errors),
                                    [&curve](const CurveError& error) { return error.curve == curve.values; });
    return found == std::end(curve_errors) ? nullptr : found;
}

/// From the worst of all candidates to the best; nothing where all are alike or one number is missing.
double shareOf(const Comparison& comparison, const Candidate& candidate, const OutcomeInfo& criterion)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Candidate& each : comparison.candidates) {
        const auto found = each.intervals.find(criterion.key);
        if (found == each.intervals.end()) { continue; }
        low = std::min(low, found->second.centre);
        high = std::max(high, found->second.centre);
    }
    const auto own = candidate.intervals.find(criterion.key);
    if (own == candidate.intervals.end()) { return -1; }
    if (!(high > low)) { return 1; }
    const double share = (own->second.centre - low) / (high - low);
    return criterion.better == Better::less ? 1 - share : share;
}

/// "grade 4 (75.3 %/s)"
QString gradeText(const Outcome& outcome)
{
    const QString grade = QCoreApplication::translate("hygroloom", "grade %1").arg(*outcome.grade);
    if (!outcome.value) { return grade; }
    const ShownValue value = shown(outcome, *outcome.value);
    const QString number = QString::fromStdString(rounded_text(value.value, 3)) + " " + QString::fromStdString(value.unit);
    return QString("%1 (%2)").arg(grade, number.trimmed());
}

/// "3.25 ± 0.04 mm"; empty: it has no such number.
QString numberText(const Candidate& candidate, const OutcomeInfo& criterion)
{
    const auto found = candidate.intervals.find(criterion.key);
    if (found == candidate.intervals.end()) { return {}; }
    const ReaderUnits units = unitsOfReader();
    const std::string text = with_interval(criterion, found->second, units) + " " + units(shown(criterion, found->second).unit).unit;
    return QString::fromStdString(text).trimmed();
}

std::vector<const Candidate*> named(const Comparison& comparison, const std::vector<std::string>& names)
{
    std::vector<const Candidate*> found;
    for (const std::string& name : names) {
        for (const Candidate& each : comparison.candidates) {
            if (each.fabric == name && ((each.run && each.metrics) || each.worn)) { found.push_back(&each); }
        }
    }
    return found;
}

} // namespace

std::vector<std::size_t> paretoFront(const std::vector<QPointF>& points, Better x, Better y)
{
    const double sign_x = x == Better::less ? -1 : 1, sign_y = y == Better::less ? -1 : 1;
    const auto dominates = [&](const QPointF& a, const QPointF& b) {
        const double dx = sign_x * (a.x() - b.x()), dy = sign_y * (a.y() - b.y());
        return dx >= 0 && dy >= 0 && (dx > 0 || dy > 0);
    };
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::none_of(points.begin(), points.end(), [&](const QPointF& other) { return dominates(other, points[i]); })) {
            front.push_back(i);
        }
    }
    std::stable_sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) { return points[a].x() < points[b].x(); });
    return front;
}

std::vector<CurveChoice> curvesOf(ExperimentType type, const std::vector<std::shared_ptr<const Metrics>>& runs)
{
    std::vector<const Plot*> plots{&subject_plot(type), &water_plot(type)};
    for (const Plot& plot : all_plots()) {
        if (std::find(plots.begin(), plots.end(), &plot) == plots.end()) { plots.push_back(&plot); }
    }
    if (plots[0] == plots[1]) { plots.erase(plots.begin() + 1); }
    std::vector<CurveChoice> choices;
    for (const Plot* plot : plots) {
        for (const Curve& curve : plot->curves) {
            const auto is_seen = [&](const std::shared_ptr<const Metrics>& run) {
                const auto& values = (*run).series.*curve.values;
                return std::any_of(values.begin(), values.end(), [](double value) { return value != 0; });
            };
            if (std::none_of(runs.begin(), runs.end(), is_seen)) { continue; }
            const QString name = plot->curves.size() == 1 ? coreWord(plot->title) : coreTitle(plot->title, curve.name);
            const UserUnit unit = userUnit(plot->unit);
            choices.push_back({plot, curve, {}, QString("%1 (%2)").arg(name, coreWord(unit.unit)), unit});
        }
    }
    return choices;
}

std::vector<CurveChoice> curvesOf(const WearPartName& part)
{
    std::vector<CurveChoice> choices;
    for (const OutcomeInfo& number : worn_curves(part)) {
        const UserUnit unit = userUnit(QString::fromStdString(number.unit));
        const QString title = QString("%1 (%2)").arg(capital(coreTitle(number.title, number.part)), coreWord(unit.unit));
        choices.push_back({nullptr, {}, number, title, unit});
    }
    return choices;
}

namespace {

/// seen: a value as people read it.
CurvePoints pointsOf(const CurveRange& range, const std::function<double(double)>& seen)
{
    CurvePoints points;
    points.replicates = range.runs;
    for (std::size_t i = 0; i < range.time.size(); ++i) {
        points.values.emplace_back(range.time[i], seen(range.middle[i]));
        points.low.push_back(seen(range.low[i]));
        points.high.push_back(seen(range.high[i]));
    }
    return points;
}

} // namespace

CurvePoints pointsOf(const Candidate& garment, const CurveChoice& choice)
{
    const auto seen = [&](double value) { return choice.unit.of(value); };
    if (const auto range = curve_range(garment, choice.worn.key)) { return pointsOf(*range, seen); }
    CurvePoints points;
    const auto& first = garment.replicates.front();
    if (!first || !first->trace || !first->trace->worn.contains(choice.worn.key)) { return points; }
    const std::vector<double>& values = first->trace->worn.at(choice.worn.key);
    for (std::size_t i = 0; i < values.size(); ++i) { points.values.emplace_back(first->trace->series.time[i], seen(values[i])); }
    return points;
}

CurvePoints pointsOf(const RunRecord& run, const Metrics& metrics, const CurveChoice& choice, const Candidate* candidate)
{
    CurvePoints points;
    const auto cut = [&choice](double value) { return choice.plot->from_zero ? std::max(0.0, value) : value; };
    const auto seen = [&](double value) { return choice.unit.of(cut(value)); };
    if (const auto range = candidate ? curve_range(*candidate, *choice.plot, choice.curve) : std::nullopt) {
        return pointsOf(*range, seen);
    }
    const std::vector<double> values = plotted(*choice.plot, choice.curve, metrics);
    const CurveError* error = errorOf(choice.curve);
    const bool known = error && numerical_error(run, error->metric, 1).has_value();
    for (std::size_t i = 0; i < std::min(values.size(), metrics.series.time.size()); ++i) {
        const double value = cut(values[i]);
        points.values.emplace_back(metrics.series.time[i], choice.unit.of(value));
        if (!known) { continue; }
        const double half = *numerical_error(run, error->metric, value);
        points.low.push_back(choice.unit.of(value - half));
        points.high.push_back(choice.unit.of(value + half));
    }
    return points;
}

QString bandText(const CurveChoice& choice)
{
    const CurveError* error = errorOf(choice.curve);
    return error ? coreWord(error->words) : QString();
}

Fingerprint fingerprintOf(const Comparison& comparison, const std::vector<std::string>& names)
{
    Fingerprint made;
    const std::vector<const Candidate*> all = named(comparison, names);
    made.runs.resize(all.size());
    made.numbers.resize(all.size());
    if (all.empty()) { return made; }
    made.grades = all.front()->metrics && all.front()->metrics->management.has_value();
    if (made.grades) {
        made.most = 5;
        for (const Outcome& outcome : outcomes_of(*all.front()->run, *all.front()->metrics)) {
            if (!outcome.grade) { continue; }
            made.spokes << capital(coreTitle(outcome.title, outcome.part));
            for (std::size_t i = 0; i < all.size(); ++i) {
                double grade = -1;
                QString number;
                for (const Outcome& each : outcomes_of(*all[i]->run, *all[i]->metrics)) {
                    if (each.key != outcome.key || !each.grade) { continue; }
                    grade = *each.grade;
                    number = gradeText(each);
                }
                made.runs[i].push_back(grade);
                made.numbers[i] << number;
            }
        }
        return made;
    }
    for (const OutcomeInfo& criterion : comparison.criteria) {
        made.spokes << capital(coreTitle(criterion.title, criterion.part));
        for (std::size_t i = 0; i < all.size(); ++i) {
            made.runs[i].push_back(shareOf(comparison, *all[i], criterion));
            made.numbers[i] << numberText(*all[i], criterion);
        }
    }
    return made;
}

std::vector<int> laterOn(const Fingerprint& fingerprint, double near)
{
    const auto& runs = fingerprint.runs;
    const auto meet = [&](const std::vector<double>& a, const std::vector<double>& b, std::size_t spoke) {
        return a[spoke] >= 0 && b[spoke] >= 0 && std::abs(a[spoke] - b[spoke]) <= near * fingerprint.most;
    };
    std::vector<int> later(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (std::size_t k = i + 1; k < runs.size(); ++k) {
            bool lies = false;
            const std::size_t spokes = runs[i].size();
            for (std::size_t s = 0; s < spokes; ++s) {
                lies = lies || (meet(runs[i], runs[k], s) && meet(runs[i], runs[k], (s + 1) % spokes));
            }
            later[i] += lies ? 1 : 0;
        }
    }
    return later;
}

} // namespace hygroloom
