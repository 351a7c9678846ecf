// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// File, Technical Card: the chosen fabric's numbers as they become known, in the reader's units; saved as PDF or web page.
#pragma once

#include "ui/export/card_export.h"
#include "ui/export/card_numbers.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace hygroloom {

/// It is not modal: it follows the fabric that is chosen and edited beside it.
class CardDialog : public QDialog {
    Q_OBJECT
public:
    CardDialog(Document& document, WindowQueue& queue, QWidget* parent = nullptr);

    CardNumbers& numbers() { return numbers_; }
    CardExport& file() { return file_; }
    QTableWidget* table() { return table_; }
    QString message() const;
    void startOrCancel();
    /// Asks whether tests that are on may be stopped.
    bool agreesToStopTests(QWidget* window) const;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void arrange();
    void refresh();
    void fillRow(int row, const CardNumbers::Row& of);
    void fillConstruction(int row, const PageRow& of);
    QString notes() const;
    QString state() const;

    Document& document_;
    CardNumbers numbers_;
    CardExport file_;
    QLabel* fabric_;
    QTableWidget* table_;
    QLabel* notes_;
    QLabel* message_;
    QProgressBar* progress_;
    QPushButton* start_;
    QPushButton* save_;
};

} // namespace hygroloom
