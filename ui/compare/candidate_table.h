// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The table of candidates: each number with its interval as a bar on its column's scale.
#pragma once

#include "ui/compare/candidate_grid.h"

#include <QSet>
#include <QTableWidget>

namespace hygroloom {

class CandidateTable : public QTableWidget {
    Q_OBJECT
public:
    explicit CandidateTable(QWidget* parent = nullptr);

    enum Column { rank_column, pin_column, name_column, first_number };

    /// What is shown. While a button of the mouse is pressed nothing moves: it waits. ticked: paths of runs; a row without a path cannot be
    /// ticked.
    void setGrid(const Grid& grid, const QSet<QString>& ticked, bool overview);
    void setFilter(const QString& text);
    /// The column of a number by which the rows are ranked; -1: by the first.
    int rankedBy() const { return sorted_ >= first_number ? sorted_ - first_number : -1; }
    const Grid& grid() const { return shown_; }
    /// The cell's words: "not run", or the number and its verdict.
    QString cellText(int row, int number) const { return item(row, first_number + number)->text(); }

Q_SIGNALS:
    void openRequested(const QString& path);
    void runRequested(const std::vector<StudyJob>& jobs);
    void baselineRequested(const std::string& name);
    void tickRequested(const QString& path, bool on);
    void rankingChanged();

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fill();
    void fillRow(int row);
    void shareWidth();
    QTableWidgetItem* itemOf(const GridCell& cell, int number) const;
    void sortBy(int column);
    void use(int row, int column);
    const GridCell* cellAt(int row, int column) const;

    Grid grid_, shown_;
    QSet<QString> ticked_;
    QString filter_;
    bool overview_ = false;
    bool waiting_ = false; ///< for the mouse's button
    bool filling_ = false;
    int sorted_ = rank_column;
    bool ascending_ = true;
};

} // namespace hygroloom
