// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The zones of the wearer's own: how much each sweats; drawing, renaming and deleting them.
#pragma once

#include "ui/garment/garment_choice.h"

#include <QWidget>

class QTableWidget;
class QToolButton;

namespace hygroloom {

class QuantityEdit;

class ZonesForm : public QWidget {
    Q_OBJECT
public:
    explicit ZonesForm(GarmentChoice& choice, QWidget* parent = nullptr);

    QTableWidget& table() { return *table_; }
    QToolButton& drawButton() { return *draw_; }
    /// Asks for another name of the selected zone.
    void rename();
    void removeSelected();
    /// The view draws, or no longer.
    void setDrawing(bool drawing);

Q_SIGNALS:
    /// The user wants to draw a zone on a flat panel, or no longer.
    void drawingWanted(bool wanted);

private:
    void addRow();
    void refresh();

    GarmentChoice& choice_;
    QTableWidget* table_;
    QToolButton* draw_;
    QToolButton* rename_;
    QToolButton* remove_;
    std::vector<QuantityEdit*> rates_;
};

} // namespace hygroloom
