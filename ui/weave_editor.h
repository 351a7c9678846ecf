// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The weave of the chosen fabric: a pattern from the list, or crossings turned over by hand.
#pragma once

#include "ui/document.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QSpinBox;

namespace hygroloom {

class PointPaper;

class WeaveEditor : public QWidget {
    Q_OBJECT
public:
    explicit WeaveEditor(Document& document, QWidget* parent = nullptr);

    PointPaper* paper() { return paper_; }

private:
    void refresh();
    void choosePattern();
    void resizeRepeat();
    void setWeave(const QString& undo, const std::string& field, const Weave& weave);

    Document& document_;
    QComboBox* pattern_;
    QSpinBox* ends_;
    QSpinBox* picks_;
    PointPaper* paper_;
    QLabel* summary_;
};

} // namespace hygroloom
