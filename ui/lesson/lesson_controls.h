// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a hand changes on the table: the size of drops, wind and dryer, and the tilt.
#pragma once

#include "core/lesson/lesson.h"

#include <QTimer>
#include <QWidget>

class QFormLayout;
class QLabel;
class QSlider;

namespace hygroloom {

class LessonControls : public QWidget {
    Q_OBJECT
public:
    explicit LessonControls(QWidget* parent = nullptr);

    /// Level, and without a signal.
    void setLesson(const Lesson& lesson);
    double dropVolume() const; ///< ul
    Climate air() const;
    double tilt() const; ///< degrees
    QSlider& windSlider() { return *wind_; }
    QSlider& temperatureSlider() { return *temperature_; }
    QSlider& dropSlider() { return *drop_; }
    QSlider& tiltSlider() { return *tilt_; }

Q_SIGNALS:
    void dropChanged(double volume_ul);
    /// A moment after the hand has stopped.
    void airChanged();
    void tiltChanged();

private:
    QSlider* addSlider(QFormLayout* form, const QString& name, int least, int most, QLabel** value);
    void showValues();

    QSlider *drop_, *wind_, *temperature_, *humidity_, *tilt_;
    QLabel *drop_text_ = nullptr, *wind_text_ = nullptr, *temperature_text_ = nullptr, *humidity_text_ = nullptr, *tilt_text_ = nullptr;
    QTimer air_pause_, tilt_pause_;
};

} // namespace hygroloom
