// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The wet map beside the picture while a fabric is edited: what the chosen experiment comes to, its leading numbers, how sure they are.
#pragma once

#include "ui/results/live_answer.h"

#include <QTimer>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace hygroloom {

class Document;

/// Whether this machine runs on a battery that is being used up, as the kernel says it.
bool runsOnBattery(const QString& folder = QStringLiteral("/sys/class/power_supply"));

/// Where the colours end after an answer with that much water at most, kg/m2: as before while it fits. may_shrink: also where it fills
/// little of the colours.
double keptRange(double range, double most, bool may_shrink);

/// Works only while it is seen, on one core.
class LivePanel : public QWidget {
    Q_OBJECT
public:
    explicit LivePanel(Document& document, QWidget* parent = nullptr);

    /// To the design as it is; nullptr where there is none.
    const std::shared_ptr<const Answer>& answer() const { return shown_; }
    QString status() const;
    /// Where the colours end, kg/m2.
    double range() const { return range_; }
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

    Document& document_;
    LiveAnswer live_;
    QTimer pause_;
    WaterMap* map_;
    QWidget* legend_;
    QLabel* status_;
    QCheckBox* refine_;
    QGridLayout* numbers_;
    std::shared_ptr<const Answer> shown_;
    double range_ = 0;      ///< kg/m2, of the colours; 0: there is no scale
    double last_range_ = 0; ///< the last that was not 0
    std::string range_of_;  ///< the experiment that it belongs to
    WaterColors colors_ = WaterColors::blue;
};

} // namespace hygroloom
