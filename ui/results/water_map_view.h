// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Both faces side by side with one range of colours.
#pragma once

#include "ui/results/playback.h"
#include "ui/results/water_map.h"

class QBoxLayout;
class QLabel;
class QSpinBox;

namespace hygroloom {

class WaterMapView : public QWidget {
    Q_OBJECT
public:
    explicit WaterMapView(Playback& playback, QWidget* parent = nullptr);

    const WaterMap& top() const { return *top_; }
    const WaterMap& bottom() const { return *bottom_; }
    /// The end of the colour scale, kg/m2: of the shown frames while the run is live, of all frames afterwards.
    double range() const;
    void setCrossingsPerCell(int crossings);
    void setWaterColors(WaterColors colors);

Q_SIGNALS:
    void mapChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    /// Widens the range to all frames of a recording.
    void scan();
    void widen(double maximum);

    Playback& playback_;
    WaterMap* top_;
    WaterMap* bottom_;
    QLabel* value_;
    QLabel* empty_;
    QSpinBox* cells_;
    QWidget* legend_;
    QBoxLayout* maps_;
    double maximum_ = 0; ///< kg/m2, of all maps of this run that are known
    WaterColors colors_ = WaterColors::blue;
    NewestJob mapper_;
    NewestJob scanner_;
};

} // namespace hygroloom
