// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The wet map beside the picture while a fabric is edited: what the chosen experiment comes to, its leading numbers, how sure they are.
#pragma once

#include "ui/results/color_ranges.h"
#include "ui/results/live_answer.h"

#include <QTimer>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace hygroloom {

class Document;

/// Whether this machine runs on a battery that is being used up, as the kernel says it.
bool runsOnBattery(const QString& folder = QStringLiteral("/sys/class/power_supply"));

/// Works only while it is seen, on one core.
class LivePanel : public QWidget {
    Q_OBJECT
public:
    explicit LivePanel(Document& document, QWidget* parent = nullptr);

    /// To the design as it is; nullptr where there is none.
    const std::shared_ptr<const Answer>& answer() const { return shown_; }
    /// Whether what is seen is the cloth before the edit, marked as such.
    bool outdated() const { return map_->outdated(); }
    QString status() const;
    /// Where the colours end, kg/m2; 0: there is no scale.
    double range() const { return scaled_ ? ranges_->mostWater() : 0; }
    /// Takes the place of a range of its own. Precondition: it lives as long as this.
    void shareRanges(ColorRanges& ranges);
    void setWaterColors(WaterColors colors);

Q_SIGNALS:
    void changed();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    QSize sizeHint() const override { return {310, 300}; }

private:
    void build();
    void say(const QString& sentence);
    void keepStatusWhole();
    void ask();
    void askFiner();
    void take(const std::shared_ptr<const Answer>& answer);
    void showNumbers(const std::vector<Result>& numbers);
    void refuse(const QString& sentence);
    void setOutdated(bool outdated);
    void showRange();

    Document& document_;
    LiveAnswer live_;
    QTimer pause_;
    WaterMap* map_;
    QWidget* legend_;
    QLabel* status_;
    QCheckBox* refine_;
    QGridLayout* numbers_;
    std::shared_ptr<const Answer> shown_;
    bool scaled_ = false; ///< there is water on the map
    ColorRanges own_ranges_;
    ColorRanges* ranges_ = &own_ranges_;
    WaterColors colors_ = WaterColors::blue;
};

} // namespace hygroloom
