// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/compare_view.h"

#include "core/analysis/comparison.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/atomic_file.h"
#include "core/run/recording.h"
#include "ui/basics/quantity.h"
#include "ui/results/results_panel.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSplitter>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>

namespace hygroloom {

namespace {

constexpr int legend_width = 92;
constexpr int moments = 200; // of the slider
constexpr int crossings_per_cell = 2;

/// Criteria give their units in plain letters, as files have them.
QString shownUnit(const std::string& unit)
{
    static const std::pair<const char*, QString> spelled[] = {
        {"mm2/s", "mm²/s"}, {"mm/s^0.5", "mm/√s"}, {"g/(m2 h)", "g/(m² h)"}, {"C", "°C"}};
    for (const auto& [plain, shown] : spelled) {
        if (unit == plain) { return shown; }
    }
    return QString::fromStdString(unit);
}

QString fabricOf(const KeptRun& run) { return QString::fromStdString(run.run->fabric); }

double durationOf(const KeptRun& run)
{
    const Experiment* experiment = find_experiment(run.run->design, run.run->experiment);
    return experiment ? experiment->duration_s : 0;
}

bool isSameRun(const RunRecord& one, const RunRecord& other)
{
    return one.fabric == other.fabric && one.experiment == other.experiment && one.date == other.date &&
           one.textile.ends() == other.textile.ends() && one.textile.picks() == other.textile.picks();
}

/// At the last recorded moment not after a time. Throws Error where the file at the run's path is of another run by now.
FaceMap mapOf(const KeptRun& run, double time, MapSide side)
{
    const Recording recording(run.path.toStdString());
    const RunRecord& recorded = recording.run();
    if (recording.frames() == 0 || !isSameRun(recorded, *run.run)) {
        throw Error(
            CompareView::tr("The recording %1 is of another run by now. Open it again to compare that one.").arg(run.path).toStdString());
    }
    const auto& ledgers = recording.ledgers();
    const auto after = std::find_if(ledgers.begin(), ledgers.end(), [time](const Ledger& l) { return l.time > time + 1e-9; });
    const int index = std::clamp(static_cast<int>(after - ledgers.begin()) - 1, 0, recording.frames() - 1);
    return faceMap(recorded, recording.frame(index), recording.frame(0), side, crossings_per_cell);
}

/// The best of the candidates by a criterion, where one is better than another.
std::optional<double> bestOf(const Comparison& comparison, const Criterion& criterion)
{
    std::vector<double> numbers;
    for (const Candidate& candidate : comparison.candidates) {
        if (const auto found = candidate.numbers.find(criterion.name); found != candidate.numbers.end()) {
            numbers.push_back(found->second);
        }
    }
    if (numbers.size() < 2) { return {}; }
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    return *least == *most ? std::optional<double>() : criterion.most_first ? *most : *least;
}

QTableWidgetItem* cellOf(const Candidate& candidate, const Criterion& criterion, const std::optional<double>& best)
{
    const auto found = candidate.numbers.find(criterion.name);
    auto* item = new QTableWidgetItem;
    if (found == candidate.numbers.end()) {
        item->setText(QStringLiteral("–"));
        item->setToolTip(CompareView::tr("This run does not tell."));
        return item;
    }
    const QString number = shownNumber(found->second, decimals_for(found->second, 3));
    const QString unit = shownUnit(criterion.unit);
    const QString text = unit.isEmpty() ? number : number + QChar(0x00a0) + unit;
    item->setText(text);
    if (best && found->second == *best) {
        item->setText(CompareView::tr("%1, best").arg(text));
        QFont font = item->font();
        font.setBold(true);
        item->setFont(font);
        item->setToolTip(criterion.most_first ? CompareView::tr("The most counts as best.") : CompareView::tr("The least counts as best."));
    }
    return item;
}

} // namespace

CompareView::CompareView(RunHistory& history, QWidget* parent)
    : QWidget(parent), history_(history), list_(new QTreeWidget), table_(new QTableWidget), empty_(new QLabel), origin_(new QLabel),
      save_(new QPushButton(tr("Save &Table…"))), side_by_side_(new QWidget), legend_(new QWidget), face_(new QComboBox),
      time_(new QSlider(Qt::Horizontal)), shown_time_(new QLabel), value_(new QLabel), problem_(new QLabel)
{
    auto* numbers = new QWidget;
    auto* column = new QVBoxLayout(numbers);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    table_->setAccessibleName(tr("Numbers of the compared runs"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setTabKeyNavigation(false); // Tab leaves it; arrow keys go through it
    table_->setMinimumSize(200, 120);
    column->addWidget(table_, 1);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 4);
    origin_->setWordWrap(true);
    origin_->setForegroundRole(QPalette::PlaceholderText);
    foot->addWidget(origin_, 1);
    save_->setToolTip(tr("Write the numbers as a CSV file for spreadsheets."));
    foot->addWidget(save_);
    column->addLayout(foot);
    connect(save_, &QPushButton::clicked, this, &CompareView::saveTable);

    auto* upper = new QSplitter(Qt::Horizontal);
    upper->setChildrenCollapsible(false);
    upper->addWidget(buildList());
    upper->addWidget(numbers);
    upper->setSizes({520, 640});
    auto* parts = new QSplitter(Qt::Vertical);
    parts->setChildrenCollapsible(false);
    parts->addWidget(upper);
    parts->addWidget(buildMaps());
    parts->setSizes({260, 440});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(parts);
    connect(&history_, &RunHistory::changed, this, &CompareView::refresh);
    refresh();
}

QWidget* CompareView::buildList()
{
    list_->setAccessibleName(tr("Runs to compare"));
    list_->setHeaderLabels({tr("Fabric"), tr("Experiment"), tr("Fidelity"), tr("Took"), tr("Saved")});
    list_->setRootIsDecorated(false);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setMinimumSize(240, 120);
    list_->header()->setStretchLastSection(false);
    list_->setToolTip(tr("Tick two to four runs of the same experiment. Double-click one to look at it alone."));
    connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        const QString path = item->data(0, Qt::UserRole).toString();
        const bool on = item->checkState(0) == Qt::Checked;
        // The list is built anew, which an item must not see that is just being changed.
        QMetaObject::invokeMethod(
            this, [this, path, on] { choose(path, on); }, Qt::QueuedConnection);
    });
    connect(list_, &QTreeWidget::itemActivated, this,
            [this](QTreeWidgetItem* item) { Q_EMIT runRequested(item->data(0, Qt::UserRole).toString()); });
    return list_;
}

QWidget* CompareView::buildMaps()
{
    row_ = new QHBoxLayout(side_by_side_);
    row_->setContentsMargins(0, 4, 0, 0);
    row_->setSpacing(0);
    legend_->setFixedWidth(legend_width);
    row_->addWidget(legend_);
    face_->addItems({tr("Top face"), tr("Bottom face")});
    face_->setAccessibleName(tr("Face of the fabrics"));
    time_->setRange(0, moments);
    time_->setValue(moments);
    time_->setAccessibleName(tr("Moment of all maps"));
    value_->setAccessibleName(tr("Value under the pointer"));
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 4);
    foot->addWidget(face_);
    foot->addWidget(time_, 1);
    foot->addWidget(shown_time_);
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    auto* part = new QWidget;
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(side_by_side_, 1);
    layout->addWidget(empty_, 1);
    problem_->setWordWrap(true);
    problem_->setTextFormat(Qt::PlainText);
    problem_->setContentsMargins(8, 0, 8, 0);
    problem_->setVisible(false);
    layout->addWidget(problem_);
    layout->addWidget(value_);
    layout->addLayout(foot);
    value_->setContentsMargins(8, 0, 8, 0);
    connect(face_, &QComboBox::currentIndexChanged, this, [this] {
        maximum_ = 0;
        readMaps();
    });
    connect(time_, &QSlider::valueChanged, this, &CompareView::readMaps);
    return part;
}

const KeptRun* CompareView::find(const QString& path) const
{
    const auto& runs = history_.runs();
    const auto found = std::find_if(runs.begin(), runs.end(), [&path](const KeptRun& run) { return run.path == path; });
    return found == runs.end() ? nullptr : &*found;
}

QString CompareView::nameOf(const KeptRun& run) const
{
    const auto& runs = history_.runs();
    const auto same =
        std::count_if(runs.begin(), runs.end(), [&run](const KeptRun& other) { return other.run->fabric == run.run->fabric; });
    return same > 1 ? tr("%1: %2").arg(run.number).arg(fabricOf(run)) : fabricOf(run);
}

std::vector<KeptRun> CompareView::compared() const
{
    std::vector<KeptRun> runs;
    for (const KeptRun& run : history_.runs()) {
        if (chosen_.contains(run.path)) { runs.push_back(run); }
    }
    return runs;
}

double CompareView::duration() const
{
    const std::vector<KeptRun> runs = compared();
    return runs.empty() ? 0 : durationOf(runs.front());
}

double CompareView::moment() const { return duration() * time_->value() / moments; }

QString CompareView::whyNot(const KeptRun& run) const
{
    const std::vector<KeptRun> others = compared();
    const bool alone = others.empty() || (others.size() == 1 && others.front().path == run.path);
    const QString why = whyNotCompared(run, alone ? run : others.front());
    const bool full = others.size() >= most_runs && !chosen_.contains(run.path);
    return why.isEmpty() && full ? tr("Four runs stand side by side at most.") : why;
}

void CompareView::choose(const QString& path, bool on)
{
    const KeptRun* run = find(path);
    proposing_ = false;
    if (on && run && !chosen_.contains(path) && whyNot(*run).isEmpty()) {
        chosen_ << path;
    } else if (!on) {
        chosen_.removeAll(path);
    }
    refresh();
}

void CompareView::setWaterColors(WaterColors colors)
{
    colors_ = colors;
    showRange();
}

/// The newest run of each fabric that goes with the newest of all.
void CompareView::propose()
{
    chosen_.clear();
    QStringList fabrics;
    const auto& runs = history_.runs();
    for (auto run = runs.rbegin(); run != runs.rend() && chosen_.size() < most_runs; ++run) {
        if (whyNotCompared(*run, chosen_.isEmpty() ? *run : *find(chosen_.front())).isEmpty() && !fabrics.contains(fabricOf(*run))) {
            chosen_ << run->path;
            fabrics << fabricOf(*run);
        }
    }
}

void CompareView::refresh()
{
    if (proposing_) { propose(); }
    chosen_.removeIf([this](const QString& path) { return !find(path); });
    refreshList();
    refreshTable();
    refreshMaps();
}

void CompareView::refreshList()
{
    const QSignalBlocker quiet(list_);
    const QTreeWidgetItem* current = list_->currentItem();
    const QString at = current ? current->data(0, Qt::UserRole).toString() : QString();
    list_->clear();
    for (const KeptRun& run : history_.runs()) {
        auto* item = new QTreeWidgetItem(list_);
        item->setData(0, Qt::UserRole, run.path);
        const QString fidelity = QString::fromLatin1(name_of(run.run->plan.fidelity));
        item->setText(0, nameOf(run));
        item->setText(1, QString::fromStdString(run.run->experiment));
        item->setText(2, fidelity.left(1).toUpper() + fidelity.mid(1));
        item->setText(3, run.complete() ? tr("%1 s").arg(shownNumber(run.run->wall, decimals_for(run.run->wall, 2))) : tr("cut short"));
        item->setText(4, run.saved ? tr("yes") : tr("no"));
        const QString why = whyNot(run);
        const QString tip = why.isEmpty() ? originOf(*run.run, false) : why;
        item->setCheckState(0, chosen_.contains(run.path) ? Qt::Checked : Qt::Unchecked);
        if (!why.isEmpty()) { item->setFlags(item->flags() & ~Qt::ItemIsUserCheckable); }
        for (int column = 0; column < list_->columnCount(); ++column) {
            item->setToolTip(column, "<p>" + tip.toHtmlEscaped() + "</p>");
            if (!why.isEmpty()) { item->setForeground(column, palette().color(QPalette::Disabled, QPalette::Text)); }
        }
        if (run.path == at) { list_->setCurrentItem(item); }
    }
    for (int column = 0; column < list_->columnCount(); ++column) { list_->resizeColumnToContents(column); }
    list_->setColumnWidth(0, std::min(list_->columnWidth(0), 220));
    list_->setColumnWidth(1, std::min(list_->columnWidth(1), 160));
}

Comparison CompareView::comparison() const
{
    const std::vector<KeptRun> runs = compared();
    Comparison made;
    if (runs.empty()) { return made; }
    const Experiment* experiment = find_experiment(runs.front().run->design, runs.front().run->experiment);
    made.experiment = runs.front().run->experiment;
    made.criteria = criteria_of(experiment ? experiment->type : ExperimentType::droplet);
    made.ranked_by = made.criteria.front();
    for (const KeptRun& run : runs) {
        made.candidates.push_back(candidate_of(*run.run, *run.metrics, made.criteria));
        made.candidates.back().fabric = nameOf(run).toStdString();
    }
    made.complete = true;
    return made;
}

void CompareView::refreshTable()
{
    const Comparison numbers = comparison();
    table_->clear();
    table_->setRowCount(static_cast<int>(numbers.criteria.size()));
    table_->setColumnCount(static_cast<int>(numbers.candidates.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const Criterion& criterion = numbers.criteria[static_cast<std::size_t>(row)];
        const QString title = QString::fromStdString(criterion.title);
        table_->setVerticalHeaderItem(row, new QTableWidgetItem(title.left(1).toUpper() + title.mid(1)));
        const std::optional<double> best = bestOf(numbers, criterion);
        for (int column = 0; column < table_->columnCount(); ++column) {
            table_->setItem(row, column, cellOf(numbers.candidates[static_cast<std::size_t>(column)], criterion, best));
        }
    }
    bool one_fidelity = true;
    const std::vector<KeptRun> runs = compared();
    for (int column = 0; column < table_->columnCount(); ++column) {
        const KeptRun& run = runs[static_cast<std::size_t>(column)];
        auto* head = new QTableWidgetItem(nameOf(run));
        head->setToolTip("<p>" + (nameOf(run) + ". " + originOf(*run.run, false)).toHtmlEscaped() + "</p>");
        table_->setHorizontalHeaderItem(column, head);
        one_fidelity = one_fidelity && run.run->plan.fidelity == runs.front().run->plan.fidelity;
    }
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    save_->setEnabled(runs.size() > 1);
    origin_->setText(one_fidelity ? QString() : tr("These runs differ in fidelity; part of their difference is that."));
}

void CompareView::refreshMaps()
{
    const std::vector<KeptRun> runs = compared();
    side_by_side_->setVisible(!runs.empty());
    empty_->setVisible(runs.empty());
    empty_->setText(history_.runs().empty()
                        ? tr("Nothing has been run yet. Run an experiment on one fabric and then on another, or open recordings; "
                             "they are listed above.")
                        : tr("Tick the runs above that are to stand side by side."));
    QStringList paths, titles, drawn;
    for (const KeptRun& run : runs) {
        paths << run.path;
        titles << nameOf(run);
        drawn << titles.back() + "\n" + QString::fromStdString(run.run->date);
    }
    face_->setEnabled(!runs.empty());
    time_->setEnabled(!runs.empty());
    if (paths == mapped_ && drawn == drawn_) { return; }
    mapped_ = paths;
    drawn_ = drawn;
    qDeleteAll(maps_);
    maps_.clear();
    maximum_ = 0;
    value_->clear();
    for (const QString& title : titles) {
        auto* map = new WaterMap(title);
        map->setAccessibleName(tr("Water on %1").arg(title));
        connect(map, &WaterMap::pointed, value_, &QLabel::setText);
        row_->insertWidget(static_cast<int>(maps_.size()), map, 1);
        maps_.push_back(map);
    }
    readMaps();
}

void CompareView::readMaps()
{
    shown_time_->setText(mapped_.isEmpty() ? QString() : momentText(moment(), duration()));
    if (mapped_.isEmpty()) {
        ++asked_;
        reader_.drop();
        showProblem({});
        update();
        return;
    }
    const MapSide side = face_->currentIndex() == 0 ? MapSide::top : MapSide::bottom;
    reader_.run([this, runs = compared(), asked = ++asked_, side, time = moment()](const NewestJob::Turn& turn) {
        std::vector<FaceMap> maps;
        QString problem;
        try {
            for (const KeptRun& run : runs) {
                if (turn.outdated()) { return; }
                maps.push_back(mapOf(run, time, side));
            }
        } catch (const std::exception& error) {
            problem = QString::fromStdString(error.what());
        }
        turn.deliver([this, maps, asked, problem] {
            if (asked != asked_) { return; }
            showProblem(problem);
            if (problem.isEmpty()) { showMaps(maps); }
        });
    });
}

void CompareView::showMaps(const std::vector<FaceMap>& maps)
{
    for (std::size_t i = 0; i < maps.size(); ++i) {
        maximum_ = std::max(maximum_, maps[i].cells.maximum());
        maps_[i]->setMap(maps[i].cells, maps[i].stain, maps[i].size);
    }
    showRange();
    Q_EMIT mapsChanged();
}

/// In the view, as the same may come at each step of the slider.
void CompareView::showProblem(const QString& sentence)
{
    problem_->setText(sentence);
    problem_->setVisible(!sentence.isEmpty());
    if (sentence.isEmpty()) { return; }
    for (WaterMap* map : maps_) { map->clear(); }
}

void CompareView::showRange()
{
    for (WaterMap* map : maps_) { map->setRange(roundedUp(maximum_), colors_); }
    update();
}

void CompareView::paintEvent(QPaintEvent*)
{
    if (maps_.empty() || !(maximum_ > 0)) { return; }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF room(legend_->mapTo(this, QPoint(0, 0)), legend_->size());
    drawLegend(painter, room.adjusted(4, 0, -4, -std::max(0.0, room.height() - 240)), tr("Water"), 1000 * roundedUp(maximum_), tr("g/m²"),
               colors_);
}

std::string CompareView::tableCsv() const
{
    Comparison ranked = comparison();
    rank(ranked);
    return comparison_csv(ranked);
}

void CompareView::saveTable()
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString chosen =
        QFileDialog::getSaveFileName(this, tr("Save Table"), QDir(folder).filePath("comparison.csv"), tr("Tables (*.csv)"));
    if (chosen.isEmpty()) { return; }
    try {
        write_file((chosen.endsWith(".csv", Qt::CaseInsensitive) ? chosen : chosen + ".csv").toStdString(), tableCsv());
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
}

} // namespace hygroloom
