// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The panels of the chosen garment: fabric, grain and face of each.
#pragma once

#include "ui/garment/garment_choice.h"

#include <QTableWidget>

class QComboBox;

namespace hygroloom {

class QuantityEdit;

class PanelTable : public QTableWidget {
    Q_OBJECT
public:
    explicit PanelTable(GarmentChoice& choice, QWidget* parent = nullptr);

    void choosePanel(int panel);

Q_SIGNALS:
    void panelChosen(int panel);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Row {
        std::string panel;
        QComboBox* fabric;
        QuantityEdit* grain;
        QComboBox* face;
    };
    void rebuild();
    void addRow(const std::string& panel);
    void refresh();
    void shareWidth();

    GarmentChoice& choice_;
    std::vector<Row> rows_;
};

} // namespace hygroloom
