// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Both faces side by side with one range of colours: their water, or how warm or damp they are.
#pragma once

#include "ui/results/color_ranges.h"
#include "ui/results/playback.h"
#include "ui/results/water_map.h"

class QAction;
class QBoxLayout;
class QComboBox;
class QLabel;
class QSpinBox;

namespace hygroloom {

class WaterMapView : public QWidget {
    Q_OBJECT
public:
    explicit WaterMapView(Playback& playback, QWidget* parent = nullptr);

    const WaterMap& top() const { return *top_; }
    const WaterMap& bottom() const { return *bottom_; }
    /// Takes the place of a range of its own. Precondition: it lives as long as this.
    void shareRanges(ColorRanges& ranges);
    /// The end of the colours of water, kg/m2.
    double range() const { return ranges_->mostWater(); }
    void setCrossingsPerCell(int crossings);
    ShownQuantity quantity() const;
    /// Of temperatures and humidities, K and shares: where their colours end.
    ValueRange values() const { return ranges_->of(quantity()).value_or(ValueRange{}); }
    QComboBox& quantityChoice() { return *quantity_; }
    void setWaterColors(WaterColors colors);
    /// In the menus of the right button.
    void offerSaving(QAction* top, QAction* bottom);
    /// A face at the time shown: the numbers of its cells where the file ends in .csv, else a PNG picture in the colours'
    /// range of the window. Throws Error.
    void save(MapSide side, const QString& file) const;

Q_SIGNALS:
    void mapChanged();
    /// What is shown, or the ends of its colours.
    void quantityChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();
    void connectParts();
    void startOver();
    void refresh();
    /// Widens the range to all frames of a recording.
    void scan();
    void showRange();
    /// What the run does not model cannot be chosen.
    void offerQuantities();

    Playback& playback_;
    WaterMap* top_;
    WaterMap* bottom_;
    QLabel* value_;
    QLabel* empty_;
    QComboBox* quantity_;
    QSpinBox* cells_;
    QWidget* legend_;
    QBoxLayout* maps_;
    bool any_water_ = false; ///< on a map of this run that is known
    ColorRanges own_ranges_;
    ColorRanges* ranges_ = &own_ranges_;
    WaterColors colors_ = WaterColors::blue;
    NewestJob mapper_;
    NewestJob scanner_;
};

} // namespace hygroloom
