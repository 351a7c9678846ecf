// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is drawn and told of a sample's run over time.
#include "core/analysis/outcomes.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity.h"
#include "ui/results/playback.h"

#include <algorithm>

namespace hygroloom {

namespace {

TimePlot plotOf(const Plot& plot, const Metrics& metrics)
{
    const UserUnit user = userUnit(plot.unit);
    TimePlot made;
    made.title = coreTitle(plot.title, user.unit.toStdString());
    made.unit = coreWord(user.unit);
    made.from_zero = plot.from_zero;
    made.low = user.of(15);
    made.high = user.of(30);
    for (const Curve& curve : plot.curves) {
        if (curve.in_reports_only) { continue; }
        const QString name = coreWord(curve.name);
        made.lines.push_back({name, coreWord(plot.title), {}});
        const std::vector<double> values = plotted(plot, curve, metrics);
        for (std::size_t k = 0; k < std::min(metrics.series.time.size(), values.size()); ++k) {
            made.lines.back().points << QPointF(metrics.series.time[k], user.of(plot.from_zero ? std::max(0.0, values[k]) : values[k]));
        }
    }
    for (TimePlot::Line& line : made.lines) {
        if (made.lines.size() > 1) { line.told += ", " + line.name; }
    }
    return made;
}

} // namespace

std::vector<TimePlot> Playback::plots() const
{
    static const Metrics nothing;
    const Experiment* experiment = run_ ? find_experiment(run_->design, run_->experiment) : nullptr;
    const ExperimentType type = experiment ? experiment->type : ExperimentType::droplet;
    const Metrics& metrics = metrics_ ? *metrics_ : nothing;
    TimePlot water = plotOf(water_plot(type), metrics);
    water.tip = tr("In fibres: water absorbed since the start.\nClick to show that time.");
    return {std::move(water), plotOf(subject_plot(type), metrics)};
}

std::optional<QString> Playback::happened() const
{
    if (!run_ || !metrics_ || current_ < 0) { return QString(); }
    for (const Outcome& outcome : outcomes_of(*run_, *metrics_)) {
        if (outcome.key == "absorbency_time_s" && outcome.value) { return tr("absorbed at %1 s").arg(shownNumber(*outcome.value, 2)); }
    }
    return QString();
}

} // namespace hygroloom
