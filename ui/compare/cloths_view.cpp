// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/cloths_view.h"

#include "ui/basics/quantity.h"
#include "ui/compare/chart_style.h"
#include "ui/compare/recorded_frame.h"
#include "ui/picture/view_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>

namespace hygroloom {

namespace {

constexpr int slider_steps = 200;

} // namespace

ClothsView::ClothsView(QWidget* parent)
    : QWidget(parent), row_(new QHBoxLayout), empty_(new QLabel), clock_(new QSlider(Qt::Horizontal)), shown_time_(new QLabel),
      problem_(makeNote(tr("Problem")))
{
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    problem_->setVisible(false);
    row_->setSpacing(2);
    clock_->setRange(0, slider_steps);
    clock_->setValue(slider_steps);
    clock_->setAccessibleName(tr("Time of all cloths"));
    shown_time_->setMinimumWidth(shown_time_->fontMetrics().horizontalAdvance("0000.00 s")); // the slider keeps its length
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 4);
    foot->addWidget(clock_, 1);
    foot->addWidget(shown_time_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(row_, 1);
    layout->addWidget(empty_, 1);
    layout->addWidget(problem_);
    layout->addLayout(foot);
    connect(clock_, &QSlider::valueChanged, this, [this](int value) { Q_EMIT timeChosen(static_cast<double>(value) / slider_steps); });
}

void ClothsView::setRuns(const std::vector<KeptRun>& runs, const QStringList& titles, const QString& hint)
{
    runs_ = runs;
    titles_ = titles;
    empty_->setText(hint);
    empty_->setVisible(runs.empty());
    clock_->setEnabled(!runs.empty());
    if (isVisible() || runs.empty()) { build(); }
}

void ClothsView::setTime(double share)
{
    time_ = share;
    const QSignalBlocker quiet(clock_);
    clock_->setValue(static_cast<int>(std::lround(share * slider_steps)));
    if (isVisible()) { readFrames(); }
}

void ClothsView::setWaterColors(WaterColors colors)
{
    colors_ = colors;
    for (Viewport* cloth : cloths_) { cloth->setWaterColors(colors); }
}

void ClothsView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    build();
}

void ClothsView::build()
{
    QStringList wanted;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        wanted << titles_[static_cast<qsizetype>(i)] + "\n" + runs_[i].path + "\n" + QString::fromStdString(runs_[i].run->date);
    }
    if (wanted != built_) {
        built_ = wanted;
        while (QLayoutItem* item = row_->takeAt(0)) {
            delete item->widget();
            delete item;
        }
        cloths_.clear();
        for (std::size_t i = 0; i < runs_.size(); ++i) { addCloth(runs_[i], titles_[static_cast<qsizetype>(i)]); }
    }
    readFrames();
}

/// Its title stands above: two runs may be of one fabric.
void ClothsView::addCloth(const KeptRun& run, const QString& title)
{
    auto* cloth = new Viewport;
    cloth->bar().hide();
    cloth->setMinimumSize(120, 100);
    cloth->setAccessibleName(tr("%1 in 3D").arg(title));
    cloth->setWaterColors(colors_);
    if (cloth->canvas()) {
        connect(cloth->canvas(), &TextileCanvas::cameraMoved, this, [this, cloth] { follow(cloth); });
    }
    auto* both = new QWidget;
    auto* column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    auto* name = new QLabel(title);
    name->setTextFormat(Qt::PlainText);
    name->setContentsMargins(8, 2, 8, 0);
    QFont bold = name->font();
    bold.setBold(true);
    name->setFont(bold);
    name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    column->addWidget(name);
    column->addWidget(cloth, 1);
    row_->addWidget(both, 1);
    cloths_.push_back(cloth);
    cloth->showRun(run.run);
}

/// All look from where one does.
void ClothsView::follow(const Viewport* moved)
{
    if (following_) { return; }
    const QScopedValueRollback following(following_, true);
    for (const Viewport* cloth : cloths_) {
        if (cloth != moved) { cloth->canvas()->setCamera(moved->canvas()->camera()); }
    }
}

void ClothsView::readFrames()
{
    shown_time_->setText(runs_.empty() ? QString() : momentText(time_ * durationOf(runs_.front()), durationOf(runs_.front())));
    if (runs_.empty()) {
        reader_.drop();
        problem_->setVisible(false);
        return;
    }
    reader_.run([this, runs = runs_, share = time_, built = built_](const NewestJob::Turn& turn) {
        std::vector<std::shared_ptr<const Frame>> frames;
        QString problem;
        try {
            for (const KeptRun& run : runs) {
                if (turn.outdated()) { return; }
                const Recording recording = recordingOf(run);
                frames.push_back(std::make_shared<const Frame>(recording.frame(frameIndexAt(recording, share * durationOf(run)))));
            }
        } catch (const std::exception& error) {
            problem = QString::fromStdString(error.what());
        }
        turn.deliver([this, frames, problem, built] {
            problem_->setText(problem);
            problem_->setVisible(!problem.isEmpty());
            if (!problem.isEmpty() || built != built_) { return; }
            for (std::size_t i = 0; i < frames.size(); ++i) { cloths_[i]->showFrame(frames[i], 1); }
        });
    });
}

} // namespace hygroloom
