// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The shown time of a worn garment: a slider over its frames, and playback.
#pragma once

#include "ui/garment/wear_playback.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QSlider;
class QToolButton;

namespace hygroloom {

class WearTimeline : public QWidget {
    Q_OBJECT
public:
    explicit WearTimeline(WearPlayback& playback, QWidget* parent = nullptr);

    bool playing() const { return ticker_.isActive(); }
    void togglePlaying() { setPlaying(!playing()); }
    /// By so many frames.
    void step(int frames);

private:
    void setPlaying(bool playing);
    void tick();
    void refresh();

    WearPlayback& playback_;
    QToolButton* first_;
    QToolButton* play_;
    QToolButton* last_;
    QSlider* slider_;
    QLabel* time_;
    QTimer ticker_;
    QElapsedTimer since_;
    double from_ = 0;
};

} // namespace hygroloom
