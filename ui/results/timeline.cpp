// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/timeline.h"

#include "ui/basics/icon_button.h"
#include "ui/basics/quantity.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr double longest_show = 20; // s; longer runs play faster than real time

} // namespace

Timeline::Timeline(ShownRun& shown, QWidget* parent)
    : QWidget(parent), shown_(shown), first_(iconButton("first", tr("To the start"))),
      play_(iconButton("run", tr("Play or pause (Space)"))), last_(iconButton("last", tr("To the end"))),
      slider_(new QSlider(Qt::Horizontal)), time_(new QLabel), event_(new QLabel)
{
    slider_->setAccessibleName(tr("Time"));
    time_->setAccessibleName(tr("Time shown"));
    time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance("00000.0 s / 00000.0 s"));
    event_->setForegroundRole(QPalette::PlaceholderText);
    event_->setAccessibleName(tr("What has happened"));
    event_->setMinimumWidth(24 * event_->fontMetrics().averageCharWidth()); // the slider keeps its length
    if (!shown_.happened()) { event_->hide(); }
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 0);
    layout->setSpacing(4);
    layout->addWidget(first_);
    layout->addWidget(play_);
    layout->addWidget(last_);
    layout->addWidget(slider_, 1);
    layout->addWidget(time_);
    layout->addWidget(event_);
    ticker_.setInterval(33);
    connect(&ticker_, &QTimer::timeout, this, &Timeline::tick);
    connect(first_, &QToolButton::clicked, this, [this] {
        setPlaying(false);
        shown_.show(0);
    });
    connect(last_, &QToolButton::clicked, this, [this] {
        setPlaying(false);
        shown_.show(shown_.frames() - 1);
    });
    connect(play_, &QToolButton::clicked, this, &Timeline::togglePlaying);
    connect(slider_, &QSlider::valueChanged, this, [this](int value) {
        setPlaying(false);
        shown_.show(std::min(value, shown_.frames() - 1));
    });
    for (const auto signal : {&ShownRun::framesChanged, &ShownRun::frameShown, &ShownRun::metricsChanged}) {
        connect(&shown_, signal, this, &Timeline::refresh);
    }
    connect(&shown_, &ShownRun::runChanged, this, [this] {
        setPlaying(false);
        refresh();
    });
    refresh();
}

void Timeline::togglePlaying() { setPlaying(!playing()); }

void Timeline::step(int frames)
{
    setPlaying(false);
    shown_.show(std::clamp(shown_.current() + frames, 0, std::max(0, shown_.frames() - 1)));
}

void Timeline::setPlaying(bool playing)
{
    playing = playing && shown_.frames() > 1;
    if (playing == this->playing()) { return; }
    if (playing) {
        const bool atEnd = shown_.current() >= shown_.frames() - 1;
        from_ = atEnd ? 0 : shown_.time();
        since_.start();
        ticker_.start();
    } else {
        ticker_.stop();
    }
    play_->setIcon(themedIcon(playing ? "pause" : "run"));
    Q_EMIT playingChanged(playing);
}

void Timeline::tick()
{
    const double end = shown_.timeOf(shown_.frames() - 1);
    const double speed = std::max(1.0, end / longest_show);
    const double time = from_ + speed * 1e-3 * static_cast<double>(since_.elapsed());
    const int index = shown_.frameAt(std::min(time, end));
    if (index != shown_.current()) { shown_.show(index); }
    if (time >= end) { setPlaying(false); }
}

void Timeline::refresh()
{
    const int frames = shown_.frames();
    for (QWidget* widget :
         {static_cast<QWidget*>(first_), static_cast<QWidget*>(play_), static_cast<QWidget*>(last_), static_cast<QWidget*>(slider_)}) {
        widget->setEnabled(frames > 1);
    }
    const QSignalBlocker quiet(slider_);
    slider_->setRange(0, std::max(0, shown_.expectedFrames() - 1));
    slider_->setPageStep(std::max(1, frames / 10));
    if (!slider_->isSliderDown()) { slider_->setValue(std::max(0, shown_.current())); }
    if (frames == 0 || shown_.current() < 0) {
        time_->setText(QStringLiteral("–"));
        event_->clear();
        return;
    }
    time_->setText(tr("%1 / %2").arg(momentText(shown_.time(), shown_.duration()), momentText(shown_.duration(), shown_.duration())));
    event_->setText(shown_.happened().value_or(QString()));
}

} // namespace hygroloom
