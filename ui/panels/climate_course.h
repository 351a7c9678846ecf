// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The climate over time in the selected experiment: a table of times, the start first.
#pragma once

#include "ui/basics/quantity.h"
#include "ui/document/document.h"

#include <QWidget>

class QLabel;
class QTableWidget;
class QToolButton;

namespace hygroloom {

class ClimateCourse : public QWidget {
    Q_OBJECT
public:
    explicit ClimateCourse(Document& document, QWidget* parent = nullptr);

    /// Half-way to the time after the selected one, or at the experiment's end.
    void addMoment();
    void removeMoment();
    /// Chooses the cell of the value at this path and gives it the focus. False where the path leads elsewhere.
    bool showField(const std::string& where);
    /// From the cell's editor.
    void setCell(int row, int column, double value);
    static Quantity quantity(int column);

private:
    void refresh();
    void edit(const QString& undo, const std::string& field, const std::function<void(Experiment&)>& change);
    std::string path(int row, int column) const;

    Document& document_;
    QTableWidget* table_;
    QToolButton* add_;
    QToolButton* remove_;
    QLabel* note_;
};

} // namespace hygroloom
