// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/results_panel.h"

#include "core/base/text.h"
#include "core/base/units.h"
#include "ui/basics/quantity.h"
#include "ui/results/plan_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDateTime>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

QString tr(const char* text) { return ResultsPanel::tr(text); }

/// Three digits that count.
QString number(double value)
{
    const int decimals = value == 0 ? 0 : std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 6);
    return shownNumber(value, decimals);
}

QString with(double value, const char* unit) { return number(value) + (*unit ? QChar(0x00a0) + QString::fromUtf8(unit) : QString()); }

QString orWhy(const std::optional<double>& value, double scale, const char* unit, const QString& why)
{
    return value ? with(scale * *value, unit) : why;
}

QString graded(const QString& value, int grade) { return QStringLiteral("%1 (%2)").arg(value).arg(grade); }

void addStain(std::vector<Result>& results, const Metrics& m)
{
    results.push_back(
        {tr("Wetted radius"), with(1e3 * m.maximum_wetted_radius_top, "mm"), with(1e3 * m.maximum_wetted_radius_bottom, "mm")});
    results.push_back(
        {tr("Stain, warp × weft"),
         ResultsPanel::tr("%1 × %2 mm").arg(number(2e3 * m.wetted_area_ellipse_warp), number(2e3 * m.wetted_area_ellipse_weft))});
}

void addAbsorbency(std::vector<Result>& results, const Metrics& m)
{
    if (m.ledger.water_delivered > 0) {
        results.push_back({tr("Absorbency time"), orWhy(m.absorbency_time, 1, "s", tr("not soaked in yet"))});
    }
}

void addManagement(std::vector<Result>& results, const ManagementIndices& m)
{
    const ManagementGrades grades = management_grades(m);
    const QString dry = tr("stayed dry");
    results.push_back({tr("Wetting time"), graded(orWhy(m.top.wetting_time, 1, "s", dry), grades.wetting_time_top),
                       graded(orWhy(m.bottom.wetting_time, 1, "s", dry), grades.wetting_time_bottom)});
    results.push_back({tr("Absorption rate"), graded(with(m.top.absorption_rate, "%/s"), grades.absorption_rate_top),
                       graded(with(m.bottom.absorption_rate, "%/s"), grades.absorption_rate_bottom)});
    results.push_back({tr("Wetted radius"), graded(with(m.top.maximum_wetted_radius, "mm"), grades.maximum_wetted_radius_top),
                       graded(with(m.bottom.maximum_wetted_radius, "mm"), grades.maximum_wetted_radius_bottom)});
    results.push_back({tr("Spreading speed"), graded(with(m.top.spreading_speed, "mm/s"), grades.spreading_speed_top),
                       graded(with(m.bottom.spreading_speed, "mm/s"), grades.spreading_speed_bottom)});
    results.push_back({tr("One-way transport"), graded(with(m.one_way_transport, "%"), grades.one_way_transport)});
    results.push_back({tr("Overall (OMMC)"), graded(with(m.ommc, ""), grades.ommc)});
    results.push_back({tr("Class"), QString::fromUtf8(fabric_class(m))});
}

void addDrying(std::vector<Result>& results, const DryingResult& m)
{
    const QString early = tr("dried too little yet");
    results.push_back({tr("Steady drying rate"), orWhy(m.rate, 3.6e6, "g/(m² h)", early)});
    results.push_back({tr("Steady temperature"), m.steady_temperature ? with(celsius_from_kelvin(*m.steady_temperature), "°C") : early});
    results.push_back({tr("Time to dry"), orWhy(m.time_to_dry, 1, "s", tr("more than 4 % of the water are left"))});
}

void addConditioning(std::vector<Result>& results, const ConditioningResult& m)
{
    results.push_back({tr("Regain at the start"), with(100 * m.regain_start, "%")});
    results.push_back({tr("Regain at the end"), m.settled ? with(100 * m.regain_end, "%")
                                                          : ResultsPanel::tr("%1, still changing").arg(with(100 * m.regain_end, "%"))});
    results.push_back({tr("Half of the change after"), orWhy(m.half_time, 1, "s", tr("the regain did not change"))});
    results.push_back({tr("Warmest over the air"), with(m.peak_rise, "K")});
}

/// Empty for a recording of an older version.
QString begunAt(const RunRecord& run)
{
    const QDateTime begun = QDateTime::fromString(QString::fromStdString(run.date), Qt::ISODate);
    return begun.isValid() ? QLocale().toString(begun.toLocalTime(), QLocale::ShortFormat) : QString();
}

/// With a capital.
QString sentence(const QString& words) { return words.left(1).toUpper() + words.mid(1); }

QString timeTaken(const RunRecord& run, bool live)
{
    if (run.wall > 0) { return ResultsPanel::tr("took %1 s").arg(shownNumber(run.wall, decimals_for(run.wall, 2))); }
    return live ? tr("running") : tr("cut short");
}

} // namespace

std::vector<Result> resultsOf(const RunRecord& run, const Metrics& m)
{
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    std::vector<Result> results;
    switch (experiment ? experiment->type : ExperimentType::droplet) {
    case ExperimentType::droplet:
        addAbsorbency(results, m);
        addStain(results, m);
        break;
    case ExperimentType::horizontal_wicking:
        results.push_back({tr("Wicking rate"), orWhy(m.horizontal_rate, 1e6, "mm²/s", tr("nothing is wet"))});
        addAbsorbency(results, m);
        addStain(results, m);
        break;
    case ExperimentType::moisture_management:
        if (m.management) { addManagement(results, *m.management); }
        break;
    case ExperimentType::vertical_wicking:
        if (m.wicking) {
            results.push_back({tr("Height"), with(1e3 * m.wicking->height, "mm")});
            results.push_back({tr("Wicking rate"), orWhy(m.wicking->rate, 1e3, "mm/√s", tr("the liquid did not rise"))});
        }
        break;
    case ExperimentType::drying:
        if (m.drying) { addDrying(results, *m.drying); }
        break;
    case ExperimentType::conditioning:
        if (m.conditioning) { addConditioning(results, *m.conditioning); }
        break;
    case ExperimentType::sweat: addStain(results, m); break;
    }
    const Ledger& l = m.ledger;
    if (l.water_delivered > 0) { results.push_back({tr("Water delivered"), with(1e6 * l.water_delivered, "mg")}); }
    results.push_back({tr("In the pores"), with(1e6 * l.water_liquid, "mg")});
    results.push_back({tr("Taken up by fibres"), with(1e6 * (l.water_bound + l.water_vapour - l.water_initial), "mg")});
    results.push_back(l.water_evaporated < 0 ? Result{tr("Taken from the air"), with(-1e6 * l.water_evaporated, "mg")}
                                             : Result{tr("Evaporated"), with(1e6 * l.water_evaporated, "mg")});
    if (l.water_dripped > 0) { results.push_back({tr("Dripped off"), with(1e6 * l.water_dripped, "mg")}); }
    return results;
}

QString originOf(const RunRecord& run, bool live)
{
    QStringList parts{fidelityName(run.plan.fidelity)};
    const std::size_t set = changed_knobs(knobs_of(run.plan.fidelity), run.plan.knobs).size();
    if (set > 0) { parts << (set == 1 ? tr("1 knob set") : ResultsPanel::tr("%1 knobs set").arg(set)); }
    parts << expectedError(run.plan) << (run.backend == "cpu" ? tr("on the CPU") : tr("on a GPU"));
    if (const QString begun = begunAt(run); !begun.isEmpty()) { parts << begun; }
    return (parts << timeTaken(run, live)).join(", ");
}

QStringList originInFull(const RunRecord& run, bool live)
{
    const Knobs usual = knobs_of(run.plan.fidelity);
    QStringList lines{ResultsPanel::tr("Fidelity: %1").arg(fidelityName(run.plan.fidelity))};
    for (const KnobInfo* knob : changed_knobs(usual, run.plan.knobs)) {
        lines << ResultsPanel::tr("%1 set to %2 (%3 has %4)")
                     .arg(knob->name, QLocale().toString(run.plan.knobs.*knob->value), fidelityName(run.plan.fidelity).toLower(),
                          QLocale().toString(usual.*knob->value));
    }
    const QString source = QString::fromStdString(run.plan.expectation_source);
    lines << sentence(expectedError(run.plan)) + (source.isEmpty() ? "" : ". " + source);
    for (const PlannedPart& part : run.plan.parts) {
        if (part.forced) {
            lines << (part.on ? ResultsPanel::tr("%1 modelled, as was asked") : ResultsPanel::tr("%1 left out, as was asked"))
                         .arg(QString::fromStdString(part.name));
        }
    }
    lines << ResultsPanel::tr("Device: %1").arg(QString::fromStdString(run.device));
    if (const QString begun = begunAt(run); !begun.isEmpty()) { lines << ResultsPanel::tr("Begun: %1").arg(begun); }
    lines << sentence(timeTaken(run, live));
    for (const std::string& note : notes_of(run.plan)) { lines << QString::fromStdString(note); }
    return lines;
}

ResultsPanel::ResultsPanel(Playback& playback, QWidget* parent)
    : QScrollArea(parent), playback_(playback), table_(new QWidget), grid_(new QGridLayout(table_)), notes_(new QLabel), origin_(new QLabel)
{
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(8);
    grid_->setVerticalSpacing(2);
    grid_->setColumnStretch(2, 1);
    notes_->setWordWrap(true);
    notes_->setTextFormat(Qt::PlainText);
    notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    notes_->setAccessibleName(tr("About the results"));
    origin_->setWordWrap(true);
    origin_->setForegroundRole(QPalette::PlaceholderText);
    origin_->setTextFormat(Qt::RichText);
    origin_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(origin_, &QLabel::linkActivated, this, &ResultsPanel::showPlan);
    origin_->setAccessibleName(tr("How the results were computed"));
    setMinimumWidth(220); // names and numbers of both faces, mostly
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(8, 4, 8, 8);
    layout->addWidget(origin_);
    layout->addWidget(notes_);
    layout->addWidget(table_);
    layout->addStretch();
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Results"));
    auto* copy = new QAction(tr("Copy the Results"), this);
    connect(copy, &QAction::triggered, this, [this] { QApplication::clipboard()->setText(text()); });
    addAction(copy);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(&playback_, &Playback::metricsChanged, this, &ResultsPanel::refresh);
    connect(&playback_, &Playback::runChanged, this, &ResultsPanel::refresh);
    refresh();
}

void ResultsPanel::refresh()
{
    std::vector<Result> results;
    QStringList notes;
    if (playback_.run() && playback_.metrics()) {
        results = resultsOf(*playback_.run(), *playback_.metrics());
        for (const std::string& note : playback_.metrics()->notes) { notes << QString::fromStdString(note); }
        const bool faces = std::any_of(results.begin(), results.end(), [](const Result& r) { return !r.bottom.isEmpty(); });
        if (faces) {
            const bool grades = playback_.metrics()->management.has_value();
            results.insert(results.begin(),
                           {QString(), grades ? tr("top (grade)") : tr("top"), grades ? tr("bottom (grade)") : tr("bottom")});
        }
    } else {
        notes << (playback_.run() ? tr("No results yet.") : tr("Run the experiment to see its results here."));
    }
    while (rows_.size() < results.size()) {
        const int row = static_cast<int>(rows_.size());
        std::array<QLabel*, 3> labels{new QLabel, new QLabel, new QLabel};
        for (int column = 0; column < 3; ++column) {
            labels[static_cast<std::size_t>(column)]->setTextInteractionFlags(Qt::TextSelectableByMouse);
            labels[static_cast<std::size_t>(column)]->setAlignment(Qt::AlignLeft | Qt::AlignTop);
            grid_->addWidget(labels[static_cast<std::size_t>(column)], row, column);
        }
        labels[0]->setForegroundRole(QPalette::PlaceholderText);
        rows_.push_back(labels);
    }
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        const Result result = row < results.size() ? results[row] : Result{};
        const QString texts[] = {result.name, result.value, result.bottom};
        for (std::size_t column = 0; column < 3; ++column) {
            rows_[row][column]->setText(texts[column]);
            rows_[row][column]->setAccessibleName(column == 0 ? QString() : result.name);
            rows_[row][column]->setVisible(row < results.size() && !(column == 2 && texts[2].isEmpty()));
        }
        // What is said of both faces has the room of both, and of words as many lines as it needs.
        grid_->removeWidget(rows_[row][1]);
        grid_->addWidget(rows_[row][1], static_cast<int>(row), 1, 1, result.bottom.isEmpty() ? 2 : 1);
        rows_[row][1]->setWordWrap(result.bottom.isEmpty());
    }
    const RunRecord* run = playback_.run().get();
    origin_->setVisible(run != nullptr);
    origin_->setText(run ? tr("%1. <a href='plan'>What was modelled…</a>").arg(originOf(*run, playback_.live()).toHtmlEscaped())
                         : QString());
    origin_->setToolTip(run ? "<p style='white-space:pre-wrap'>" + originInFull(*run, playback_.live()).join('\n').toHtmlEscaped() + "</p>"
                            : QString());
    table_->setVisible(!results.empty());
    notes_->setText(notes.join('\n'));
    notes_->setVisible(!notes.isEmpty());
}

void ResultsPanel::showPlan()
{
    if (playback_.run()) {
        auto* dialog = new PlanDialog(*playback_.run(), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    }
}

QString ResultsPanel::text() const
{
    QStringList lines;
    for (const auto& row : rows_) {
        if (!row[1]->text().isEmpty()) {
            QStringList cells;
            for (const QLabel* label : row) { cells << label->text(); }
            lines << cells.join('\t').trimmed();
        }
    }
    if (playback_.run()) { lines << originInFull(*playback_.run(), playback_.live()); }
    return (lines << notes_->text()).join('\n').trimmed();
}

} // namespace hygroloom
