// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/wear_timeline.h"

#include "ui/basics/icon_button.h"
#include "ui/basics/quantity.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr double show_s = 12; // that playing the whole run takes

} // namespace

WearTimeline::WearTimeline(WearPlayback& playback, QWidget* parent)
    : QWidget(parent), playback_(playback), first_(iconButton("first", tr("To the start"))),
      play_(iconButton("run", tr("Play or pause (Space)"))), last_(iconButton("last", tr("To the end"))),
      slider_(new QSlider(Qt::Horizontal)), time_(new QLabel)
{
    slider_->setAccessibleName(tr("Time"));
    time_->setAccessibleName(tr("Time shown"));
    time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance("00000.0 s / 00000.0 s"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 0);
    layout->setSpacing(4);
    layout->addWidget(first_);
    layout->addWidget(play_);
    layout->addWidget(last_);
    layout->addWidget(slider_, 1);
    layout->addWidget(time_);
    ticker_.setInterval(33);
    connect(&ticker_, &QTimer::timeout, this, &WearTimeline::tick);
    connect(first_, &QToolButton::clicked, this, [this] {
        setPlaying(false);
        playback_.show(0);
    });
    connect(last_, &QToolButton::clicked, this, [this] {
        setPlaying(false);
        playback_.show(playback_.frames() - 1);
    });
    connect(play_, &QToolButton::clicked, this, &WearTimeline::togglePlaying);
    connect(slider_, &QSlider::valueChanged, this, [this](int frame) {
        setPlaying(false);
        playback_.show(std::min(frame, playback_.frames() - 1));
    });
    connect(&playback_, &WearPlayback::framesChanged, this, &WearTimeline::refresh);
    connect(&playback_, &WearPlayback::frameShown, this, &WearTimeline::refresh);
    connect(&playback_, &WearPlayback::runChanged, this, [this] {
        setPlaying(false);
        refresh();
    });
    refresh();
}

void WearTimeline::step(int frames)
{
    setPlaying(false);
    playback_.show(std::clamp(playback_.current() + frames, 0, std::max(0, playback_.frames() - 1)));
}

void WearTimeline::setPlaying(bool playing)
{
    playing = playing && playback_.frames() > 1;
    if (playing == this->playing()) { return; }
    if (playing) {
        from_ = playback_.current() >= playback_.frames() - 1 ? 0 : playback_.time();
        since_.start();
        ticker_.start();
    } else {
        ticker_.stop();
    }
    play_->setIcon(themedIcon(playing ? "pause" : "run"));
}

void WearTimeline::tick()
{
    const double end = playback_.run()->frames.back()->time;
    const double time = from_ + std::max(1.0, end / show_s) * 1e-3 * static_cast<double>(since_.elapsed());
    if (const int frame = playback_.run()->frameAt(std::min(time, end)); frame != playback_.current()) { playback_.show(frame); }
    if (time >= end) { setPlaying(false); }
}

void WearTimeline::refresh()
{
    const int frames = playback_.frames();
    for (QWidget* widget :
         {static_cast<QWidget*>(first_), static_cast<QWidget*>(play_), static_cast<QWidget*>(last_), static_cast<QWidget*>(slider_)}) {
        widget->setEnabled(frames > 1);
    }
    const QSignalBlocker quiet(slider_);
    int expected = frames;
    if (playback_.run() && playback_.run()->live) { // the handle moves on evenly while frames come
        if (const WearExperiment* wear = find_wear(playback_.run()->record->design, playback_.run()->layout().experiment)) {
            expected = std::max(frames, static_cast<int>(wear_times(*wear).size()));
        }
    }
    slider_->setRange(0, std::max(0, expected - 1));
    slider_->setPageStep(std::max(1, frames / 10));
    if (!slider_->isSliderDown()) { slider_->setValue(std::max(0, playback_.current())); }
    time_->setText(playback_.current() < 0 ? QStringLiteral("–")
                                           : tr("%1 / %2").arg(momentText(playback_.time(), playback_.duration()),
                                                               momentText(playback_.duration(), playback_.duration())));
}

} // namespace hygroloom
