// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The shown time: a slider over the frames, and playback.
#pragma once

#include "ui/results/shown_run.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QSlider;
class QToolButton;

namespace hygroloom {

class Timeline : public QWidget {
    Q_OBJECT
public:
    explicit Timeline(ShownRun& shown, QWidget* parent = nullptr);

    bool playing() const { return ticker_.isActive(); }
    /// By so many frames.
    void step(int frames);

public Q_SLOTS:
    void togglePlaying();

Q_SIGNALS:
    void playingChanged(bool playing);

private:
    void setPlaying(bool playing);
    void tick();
    void refresh();

    ShownRun& shown_;
    QToolButton* first_;
    QToolButton* play_;
    QToolButton* last_;
    QSlider* slider_;
    QLabel* time_;
    QLabel* event_;
    QTimer ticker_;
    QElapsedTimer since_;
    double from_ = 0;
};

} // namespace hygroloom
