// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/garment_maps.h"

#include "core/base/error.h"
#include "core/base/round_up.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity.h"
#include "ui/compare/recorded_frame.h"
#include "ui/garment/flat_view.h"
#include "ui/garment/garment_pane.h"
#include "ui/garment/shape_view.h"
#include "ui/garment/step_legend.h"

#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hygroloom {

namespace {

constexpr int time_steps = 200;

QString identityOf(const KeptRun& run) { return run.path + '\n' + QString::fromStdString(run.run->date); }

double mostOf(const std::vector<double>& values)
{
    double most = 0;
    for (const double value : values) { most = std::isnan(value) ? most : std::max(most, std::abs(value)); }
    return most;
}

} // namespace

GarmentMaps::GarmentMaps(QWidget* parent)
    : QWidget(parent), side_by_side_(new QWidget), row_(new QHBoxLayout(side_by_side_)), legend_(new StepLegend), empty_(new QLabel),
      probe_(new QLabel), problem_(new QLabel), sides_(new QComboBox), shown_(new QComboBox), time_(new QSlider(Qt::Horizontal)),
      shown_time_(new QLabel)
{
    row_->setContentsMargins(0, 4, 0, 0);
    row_->setSpacing(2);
    row_->addWidget(legend_);
    sides_->addItems({tr("3D and flat"), tr("3D"), tr("Flat")});
    sides_->setCurrentIndex(static_cast<int>(GarmentPane::Sides::flat));
    sides_->setAccessibleName(tr("What is drawn of the garments"));
    shown_->addItems({tr("Water, g/m²"), tr("Share of capacity"), tr("Difference of water"), tr("Difference of shares")});
    shown_->setAccessibleName(tr("What the colours show"));
    time_->setRange(0, time_steps);
    time_->setValue(time_steps);
    time_->setAccessibleName(tr("Time of all garments"));
    shown_time_->setMinimumWidth(shown_time_->fontMetrics().horizontalAdvance("00000.0 s")); // the slider keeps its length
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    for (QLabel* label : {problem_, probe_}) {
        label->setTextFormat(Qt::PlainText);
        label->setContentsMargins(8, 0, 8, 0);
    }
    problem_->setWordWrap(true);
    problem_->hide();
    probe_->setAccessibleName(tr("Place under the pointer"));
    probe_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 4);
    foot->addWidget(sides_);
    foot->addWidget(shown_);
    foot->addWidget(time_, 1);
    foot->addWidget(shown_time_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(side_by_side_, 1);
    layout->addWidget(empty_, 1);
    layout->addWidget(problem_);
    layout->addWidget(probe_);
    layout->addLayout(foot);
    connect(sides_, &QComboBox::currentIndexChanged, this, [this](int index) {
        for (GarmentPane* pane : panes_) { pane->setSides(static_cast<GarmentPane::Sides>(index)); }
    });
    connect(shown_, &QComboBox::currentIndexChanged, this, &GarmentMaps::read);
    connect(time_, &QSlider::valueChanged, this, &GarmentMaps::read);
    setRuns({}, {}, {}, {});
}

GarmentMaps::Shown GarmentMaps::shown() const { return static_cast<Shown>(shown_->currentIndex()); }

void GarmentMaps::show(Shown shown) { shown_->setCurrentIndex(static_cast<int>(shown)); }

WearValue GarmentMaps::value() const
{
    return shown() == Shown::water || shown() == Shown::water_difference ? WearValue::water : WearValue::share;
}

bool GarmentMaps::differs() const { return shown() == Shown::water_difference || shown() == Shown::share_difference; }

double GarmentMaps::duration() const { return runs_.empty() ? 0 : durationOf(runs_.front()); }

void GarmentMaps::setTime(double share) { time_->setValue(static_cast<int>(std::lround(share * time_steps))); }

QString GarmentMaps::probeText() const { return probe_->text(); }

void GarmentMaps::setRuns(const std::vector<KeptRun>& runs, const QStringList& titles, const QString& hint,
                          const std::optional<KeptRun>& baseline)
{
    side_by_side_->setVisible(!runs.empty());
    empty_->setVisible(runs.empty());
    empty_->setText(hint);
    for (QWidget* each : {static_cast<QWidget*>(sides_), static_cast<QWidget*>(shown_), static_cast<QWidget*>(time_)}) {
        each->setEnabled(!runs.empty());
    }
    QStringList identities = titles;
    for (const KeptRun& run : runs) { identities << identityOf(run); }
    if (baseline) { identities << identityOf(*baseline); }
    if (std::exchange(identities_, identities) == identities) { return; }
    runs_ = runs;
    titles_ = titles;
    baseline_ = baseline;
    most_ = {};
    makePanes();
    read();
}

void GarmentMaps::makePanes()
{
    qDeleteAll(panes_);
    panes_.clear();
    drawn_.clear();
    probe_->clear();
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        auto* pane = new GarmentPane;
        pane->setAccessibleName(tr("Water on %1").arg(titles_[static_cast<qsizetype>(i)]));
        pane->setCaption(titles_[static_cast<qsizetype>(i)]);
        pane->setSides(static_cast<GarmentPane::Sides>(sides_->currentIndex()));
        row_->insertWidget(static_cast<int>(i), pane, 1);
        panes_.push_back(pane);
        connectPane(i);
    }
}

/// One camera for all.
void GarmentMaps::connectPane(std::size_t at)
{
    connect(panes_[at], &GarmentPane::hovered, this, [this, at](const GarmentSpot& spot) { showProbe(at, spot); });
    const ShapeView* shape = panes_[at]->shape();
    if (!shape) { return; }
    connect(shape, &ShapeView::cameraMoved, this, [this, shape](const Camera& camera) {
        for (GarmentPane* other : panes_) {
            if (other->shape() != shape) { other->shape()->setCamera(camera); }
        }
    });
}

/// What stays the same through a run is read once. Throws Error.
GarmentMaps::Drawn GarmentMaps::readOne(const KeptRun& run, double share, const std::vector<Drawn>& known)
{
    Drawn drawn{identityOf(run), nullptr, nullptr, nullptr};
    const auto found = std::find_if(known.begin(), known.end(), [&](const Drawn& each) { return each.identity == drawn.identity; });
    if (found != known.end()) {
        drawn = *found;
    } else {
        drawn.recording = std::make_shared<const WearRecording>(run.path.toStdString());
        if (drawn.recording->frames() == 0 || drawn.recording->record().date != run.run->date) {
            throw Error(
                RunHistory::tr("The recording %1 holds another run now. Open it again to compare that run.").arg(run.path).toStdString());
        }
        drawn.run = newWornRun(std::make_shared<const WearRecord>(drawn.recording->record()));
    }
    const WearRecording& recording = *drawn.recording;
    int frame = 0;
    while (frame + 1 < recording.frames() && recording.time_of(frame + 1) <= share * durationOf(run) + 1e-9) { ++frame; }
    drawn.frame = std::make_shared<const WearFrame>(recording.frame(frame));
    return drawn;
}

void GarmentMaps::read()
{
    const double share = static_cast<double>(time_->value()) / time_steps;
    shown_time_->setText(runs_.empty() ? QString() : momentText(share * duration(), duration()));
    if (runs_.empty()) {
        reader_.drop();
        known_.clear();
        problem_->hide();
        return;
    }
    std::vector<KeptRun> wanted = runs_;
    if (differs() && baseline_) { wanted.push_back(*baseline_); }
    reader_.run([this, wanted, share, known = known_](const NewestJob::Turn& turn) {
        std::vector<Drawn> drawn;
        QString problem;
        try {
            for (const KeptRun& run : wanted) {
                if (turn.outdated()) { return; }
                drawn.push_back(readOne(run, share, known));
            }
        } catch (const std::exception& error) {
            problem = QString::fromStdString(error.what());
        }
        turn.deliver([this, turn, drawn, problem] {
            if (turn.outdated()) { return; }
            problem_->setText(problem);
            problem_->setVisible(!problem.isEmpty());
            if (!problem.isEmpty()) { return; }
            known_ = drawn_ = drawn;
            draw();
        });
    });
}

void GarmentMaps::draw()
{
    if (differs() && baseline_) {
        drawDifferences();
    } else {
        std::vector<std::vector<double>> values;
        double& most = most_[static_cast<std::size_t>(shown())];
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            values.push_back(cellValues(drawn_[i].run->layout(), *drawn_[i].frame, value()));
            most = std::max(most, mostOf(values.back()));
        }
        const WearSteps steps = even_steps(most > 0 ? rounded_up(most) : 1);
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            panes_[i]->show(drawn_[i].run->drawing, waterPaint(*drawn_[i].run, values[i], steps));
            panes_[i]->setVisible(true);
        }
        const bool share = value() == WearValue::share;
        legend_->setSteps(share ? tr("Share of capacity, %") : tr("Water, g/m²"), steps, share, false);
    }
    Q_EMIT mapsChanged();
}

/// The baseline's own is nothing to look at.
void GarmentMaps::drawDifferences()
{
    const Drawn& base = drawn_.back();
    const std::vector<double> others = cellValues(base.run->layout(), *base.frame, value());
    std::vector<std::vector<double>> values;
    double& most = most_[static_cast<std::size_t>(shown())];
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        values.push_back(
            differences(cellValues(drawn_[i].run->layout(), *drawn_[i].frame, value()), others, samePlaces(*drawn_[i].run, *base.run)));
        most = std::max(most, mostOf(values.back()));
    }
    const double end = most > 0 ? rounded_up(most) : 1;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        panes_[i]->show(drawn_[i].run->drawing, differencePaint(*drawn_[i].run, values[i], end));
        panes_[i]->setVisible(runs_[i].path != baseline_->path);
    }
    if (runs_.size() == 1 && runs_.front().path == baseline_->path) {
        problem_->setText(tr("Tick a second fabric to see how it differs."));
        problem_->show();
    }
    const bool share = value() == WearValue::share;
    legend_->setDifference(share ? tr("Difference, %") : tr("Difference, g/m²"), end, share, false);
}

/// Of the place under the pointer what each garment holds there.
void GarmentMaps::showProbe(std::size_t pane, const GarmentSpot& spot)
{
    if (pane >= drawn_.size() || drawn_.size() < runs_.size()) { return; }
    const WearLayout& own = drawn_[pane].run->layout();
    if (spot.panel < 0 || spot.panel >= static_cast<int>(own.panels.size())) {
        probe_->clear();
        return;
    }
    QStringList words;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const WearLayout& layout = drawn_[i].run->layout();
        const int cell = drawn_[i].run->lookup->at(sameSpot(own, layout, spot));
        if (cell < 0) { continue; }
        const GarmentCell& at = layout.cells[static_cast<std::size_t>(cell)];
        const double water = drawn_[i].frame->water(static_cast<std::size_t>(cell));
        words << tr("%1: %2 g/m², %3 % of capacity")
                     .arg(titles_[static_cast<qsizetype>(i)], shownNumber(1e3 * water / at.area, 1),
                          shownNumber(100 * water / at.capacity, 1));
    }
    const int cell = drawn_[pane].run->lookup->at(spot);
    const QString zone =
        cell < 0 ? QString() : coreWord(own.zone_names()[static_cast<std::size_t>(own.cells[static_cast<std::size_t>(cell)].zone)]);
    const QString panel = QString::fromStdString(own.panels[static_cast<std::size_t>(spot.panel)].name);
    probe_->setText(tr("%1, zone %2: %3").arg(panel, zone, words.join("; ")));
}

QImage GarmentMaps::picture()
{
    const double ratio = devicePixelRatioF();
    QImage image(size() * ratio, QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    render(&image);
    QPainter painter(&image);
    for (GarmentPane* pane : panes_) {
        if (pane->isVisible()) { painter.drawImage(QRect(pane->mapTo(this, QPoint(0, 0)), pane->size()), pane->picture()); }
    }
    return image;
}

} // namespace hygroloom
