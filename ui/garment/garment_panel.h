// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The dock of the chosen garment: which one, its panels, its wearer.
#pragma once

#include "core/design/fields.h"
#include "ui/garment/garment_choice.h"

#include <QScrollArea>

class QComboBox;
class QGridLayout;
class QLabel;
class QListWidget;
class QToolButton;

namespace hygroloom {

class PanelTable;
class QuantityEdit;

class GarmentPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit GarmentPanel(GarmentChoice& choice, QWidget* parent = nullptr);

    PanelTable& panels() { return *panels_; }
    /// Asks for a pattern or a mesh, and adds it once it has been read.
    void addFile();
    void removeChosen();
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void problemFound(const QString& sentence);

private:
    QWidget* makeHead();
    QWidget* makeSize();
    QWidget* makeWearer();
    void addSize(QGridLayout* grid, const Field<BuiltInGarment>& size);
    void chooseSweat(int index);
    void refresh();

    GarmentChoice& choice_;
    QComboBox* garments_;
    QToolButton* rename_;
    QToolButton* remove_;
    QWidget* size_;
    PanelTable* panels_;
    QListWidget* fabrics_;
    struct SizeField {
        QLabel* label;
        QuantityEdit* edit;
        const Field<BuiltInGarment>& row;
    };
    std::vector<SizeField> sizes_;
    QuantityEdit* skin_;
    QuantityEdit* gap_;
    QComboBox* sweat_;
    NewestJob reader_; // last: joined before the rest goes
};

/// The project's fabrics, to be dragged onto panels.
constexpr const char* fabric_mime = "application/x-hygroloom-fabric";

} // namespace hygroloom
