// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/compare_maps.h"

#include "core/base/error.h"
#include "core/run/recording.h"
#include "ui/basics/quantity.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int legend_width = 92;
constexpr int slider_steps = 200;
constexpr int crossings_per_cell = 2;

bool isSameRun(const RunRecord& one, const RunRecord& other)
{
    return one.fabric == other.fabric && one.experiment == other.experiment && one.date == other.date &&
           one.textile.ends() == other.textile.ends() && one.textile.picks() == other.textile.picks();
}

/// At the last recorded time not after a time. Throws Error where the file at the run's path holds another run now.
FaceMap mapOf(const KeptRun& run, double time, MapSide side)
{
    const Recording recording(run.path.toStdString());
    const RunRecord& recorded = recording.run();
    if (recording.frames() == 0 || !isSameRun(recorded, *run.run)) {
        throw Error(
            CompareMaps::tr("The recording %1 holds another run now. Open it again to compare that run.").arg(run.path).toStdString());
    }
    const auto& ledgers = recording.ledgers();
    const auto after = std::find_if(ledgers.begin(), ledgers.end(), [time](const Ledger& l) { return l.time > time + 1e-9; });
    const int index = std::clamp(static_cast<int>(after - ledgers.begin()) - 1, 0, recording.frames() - 1);
    return faceMap(recorded, recording.frame(index), recording.frame(0), side, crossings_per_cell);
}

} // namespace

CompareMaps::CompareMaps(QWidget* parent)
    : QWidget(parent), side_by_side_(new QWidget), row_(new QHBoxLayout(side_by_side_)), legend_(new QWidget), empty_(new QLabel),
      face_(new QComboBox), time_(new QSlider(Qt::Horizontal)), shown_time_(new QLabel), value_(new QLabel), problem_(new QLabel)
{
    row_->setContentsMargins(0, 4, 0, 0);
    row_->setSpacing(0);
    legend_->setFixedWidth(legend_width);
    row_->addWidget(legend_);
    face_->addItems({tr("Top face"), tr("Bottom face")});
    face_->setAccessibleName(tr("Face of the fabrics"));
    time_->setRange(0, slider_steps);
    time_->setValue(slider_steps);
    time_->setAccessibleName(tr("Time of all maps"));
    value_->setAccessibleName(tr("Value under the pointer"));
    value_->setContentsMargins(8, 0, 8, 0);
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    problem_->setWordWrap(true);
    problem_->setTextFormat(Qt::PlainText);
    problem_->setContentsMargins(8, 0, 8, 0);
    problem_->setVisible(false);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 4);
    foot->addWidget(face_);
    foot->addWidget(time_, 1);
    foot->addWidget(shown_time_);
    shown_time_->setMinimumWidth(shown_time_->fontMetrics().horizontalAdvance("0000.00 s")); // the slider keeps its length
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(side_by_side_, 1);
    layout->addWidget(empty_, 1);
    layout->addWidget(problem_);
    layout->addWidget(value_);
    layout->addLayout(foot);
    connect(face_, &QComboBox::currentIndexChanged, this, [this] {
        maximum_ = 0;
        readMaps();
    });
    connect(time_, &QSlider::valueChanged, this, &CompareMaps::readMaps);
}

double CompareMaps::duration() const
{
    if (runs_.empty()) { return 0; }
    const RunRecord& run = *runs_.front().run;
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    return experiment ? experiment->duration_s : 0;
}

double CompareMaps::shownTime() const { return duration() * time_->value() / slider_steps; }

void CompareMaps::setWaterColors(WaterColors colors)
{
    colors_ = colors;
    showRange();
}

void CompareMaps::setRuns(const std::vector<KeptRun>& runs, const QStringList& titles, const QString& hint)
{
    side_by_side_->setVisible(!runs.empty());
    empty_->setVisible(runs.empty());
    empty_->setText(hint);
    face_->setEnabled(!runs.empty());
    time_->setEnabled(!runs.empty());
    QStringList identities;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        identities << titles[static_cast<qsizetype>(i)] + "\n" + runs[i].path + "\n" + QString::fromStdString(runs[i].run->date);
    }
    runs_ = runs;
    if (identities == identities_) { return; }
    identities_ = identities;
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

void CompareMaps::readMaps()
{
    shown_time_->setText(runs_.empty() ? QString() : momentText(shownTime(), duration()));
    if (runs_.empty()) {
        ++requests_;
        reader_.drop();
        showProblem({});
        update();
        return;
    }
    const MapSide side = face_->currentIndex() == 0 ? MapSide::top : MapSide::bottom;
    reader_.run([this, runs = runs_, request = ++requests_, side, time = shownTime()](const NewestJob::Turn& turn) {
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
        turn.deliver([this, maps, request, problem] {
            if (request != requests_) { return; }
            showProblem(problem);
            if (problem.isEmpty()) { showMaps(maps); }
        });
    });
}

void CompareMaps::showMaps(const std::vector<FaceMap>& maps)
{
    for (std::size_t i = 0; i < maps.size(); ++i) {
        maximum_ = std::max(maximum_, maps[i].cells.maximum());
        maps_[i]->setMap(maps[i].cells, maps[i].stain, maps[i].size);
    }
    showRange();
    Q_EMIT mapsChanged();
}

/// In the view rather than a dialog, as each step of the slider may repeat it.
void CompareMaps::showProblem(const QString& sentence)
{
    problem_->setText(sentence);
    problem_->setVisible(!sentence.isEmpty());
    if (sentence.isEmpty()) { return; }
    for (WaterMap* map : maps_) { map->clear(); }
}

void CompareMaps::showRange()
{
    for (WaterMap* map : maps_) { map->setRange(roundedUp(maximum_), colors_); }
    update();
}

void CompareMaps::paintEvent(QPaintEvent*)
{
    if (maps_.empty() || !(maximum_ > 0)) { return; }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF room(legend_->mapTo(this, QPoint(0, 0)), legend_->size());
    drawLegend(painter, room.adjusted(4, 0, -4, -std::max(0.0, room.height() - 240)), tr("Water"), 1000 * roundedUp(maximum_), tr("g/m²"),
               colors_);
}

} // namespace hygroloom
