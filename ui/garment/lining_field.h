// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What lies under the chosen panel of a garment, or under all of them where none is chosen.
#pragma once

#include "ui/garment/garment_choice.h"

#include <QWidget>

class QLabel;

namespace hygroloom {

class ElidedCombo;

class LiningField : public QWidget {
    Q_OBJECT
public:
    explicit LiningField(GarmentChoice& choice, QWidget* parent = nullptr);

    /// Less than 0: all.
    void setPanel(int panel);

private:
    std::vector<std::string> panels() const;
    void refresh();
    void line(int index);

    GarmentChoice& choice_;
    int panel_ = -1;
    QLabel* label_;
    ElidedCombo* lining_;
};

} // namespace hygroloom
