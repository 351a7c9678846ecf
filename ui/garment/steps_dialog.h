// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where each of the eight colours ends, to be typed; what is typed shows at once where all ends ascend.
#pragma once

#include "ui/garment/wear_playback.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QStackedWidget;

namespace hygroloom {

class QuantityEdit;

class StepsDialog : public QDialog {
    Q_OBJECT
public:
    explicit StepsDialog(WearPlayback& playback, QWidget* parent);

    /// Of the value that is shown, from the lowest step to the highest.
    QuantityEdit& end(std::size_t step) const { return *ends_[static_cast<std::size_t>(playback_.value())][step]; }
    /// Why the ends are not in use; empty: they are.
    QString complaint() const;
    void reset();

private:
    QWidget* makePage(WearValue value);
    void apply();
    void refresh();

    WearPlayback& playback_;
    std::array<std::array<QuantityEdit*, std::tuple_size_v<WearSteps>>, 2> ends_{};
    QStackedWidget* pages_;
    QLabel* complaint_;
    QPushButton* reset_;
};

} // namespace hygroloom
