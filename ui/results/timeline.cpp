// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/timeline.h"

#include "core/analysis/outcomes.h"
#include "ui/basics/appearance.h"
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

QToolButton* button(const QString& icon, const QString& name)
{
    auto* made = new QToolButton;
    made->setIcon(themedIcon(icon));
    made->setAutoRaise(true);
    made->setToolTip(name);
    made->setAccessibleName(name);
    return made;
}

/// When the last free liquid was absorbed, where the type of experiment reports it.
QString absorbedAt(const RunRecord& run, const Metrics& metrics)
{
    for (const Outcome& outcome : outcomes_of(run, metrics)) {
        if (outcome.key == "absorbency_time_s" && outcome.value) {
            return Timeline::tr("absorbed at %1 s").arg(shownNumber(*outcome.value, 2));
        }
    }
    return {};
}

} // namespace

Timeline::Timeline(Playback& playback, QWidget* parent)
    : QWidget(parent), playback_(playback), first_(button("first", tr("To the start"))), play_(button("run", tr("Play or pause (Space)"))),
      last_(button("last", tr("To the end"))), slider_(new QSlider(Qt::Horizontal)), time_(new QLabel), event_(new QLabel)
{
    slider_->setAccessibleName(tr("Time"));
    time_->setAccessibleName(tr("Time shown"));
    time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance("0000.00 s / 0000 s"));
    event_->setForegroundRole(QPalette::PlaceholderText);
    event_->setAccessibleName(tr("What has happened"));
    event_->setMinimumWidth(event_->fontMetrics().horizontalAdvance(tr("absorbed at %1 s").arg("0000.00"))); // the slider keeps its length
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
        playback_.show(0);
    });
    connect(last_, &QToolButton::clicked, this, [this] {
        setPlaying(false);
        playback_.show(playback_.frames() - 1);
    });
    connect(play_, &QToolButton::clicked, this, &Timeline::togglePlaying);
    connect(slider_, &QSlider::valueChanged, this, [this](int value) {
        setPlaying(false);
        playback_.show(std::min(value, playback_.frames() - 1));
    });
    for (const auto signal : {&Playback::framesChanged, &Playback::frameShown, &Playback::metricsChanged}) {
        connect(&playback_, signal, this, &Timeline::refresh);
    }
    connect(&playback_, &Playback::runChanged, this, [this] {
        setPlaying(false);
        refresh();
    });
    refresh();
}

void Timeline::togglePlaying() { setPlaying(!playing()); }

void Timeline::setPlaying(bool playing)
{
    playing = playing && playback_.frames() > 1;
    if (playing == this->playing()) { return; }
    if (playing) {
        const bool atEnd = playback_.current() >= playback_.frames() - 1;
        from_ = atEnd || playback_.current() < 0 ? 0 : playback_.timeOf(playback_.current());
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
    const double end = playback_.timeOf(playback_.frames() - 1);
    const double speed = std::max(1.0, end / longest_show);
    const double time = from_ + speed * 1e-3 * static_cast<double>(since_.elapsed());
    const int index = playback_.frameAt(std::min(time, end));
    if (index != playback_.current()) { playback_.show(index); }
    if (time >= end) { setPlaying(false); }
}

void Timeline::refresh()
{
    const int frames = playback_.frames();
    for (QWidget* widget :
         {static_cast<QWidget*>(first_), static_cast<QWidget*>(play_), static_cast<QWidget*>(last_), static_cast<QWidget*>(slider_)}) {
        widget->setEnabled(frames > 1);
    }
    const QSignalBlocker quiet(slider_);
    slider_->setRange(0, std::max(0, playback_.expectedFrames() - 1));
    slider_->setPageStep(std::max(1, frames / 10));
    if (!slider_->isSliderDown()) { slider_->setValue(std::max(0, playback_.current())); }
    if (frames == 0 || playback_.current() < 0) {
        time_->setText(QStringLiteral("–"));
        event_->clear();
        return;
    }
    time_->setText(tr("%1 / %2").arg(momentText(playback_.timeOf(playback_.current()), playback_.duration()),
                                     momentText(playback_.duration(), playback_.duration())));
    event_->setText(playback_.run() && playback_.metrics() ? absorbedAt(*playback_.run(), *playback_.metrics()) : QString());
}

} // namespace hygroloom
