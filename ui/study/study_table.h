// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The rows of a study as a table that sorts by any column and follows a brush; quick at any number of rows.
#pragma once

#include "ui/study/study_data.h"

#include <QAbstractTableModel>

namespace hygroloom {

class StudyTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    /// Sorted as before where the columns are the same.
    void setStudy(std::shared_ptr<const StudyData> data);
    void setKept(const KeptPoints& kept);
    /// The row of the study that a row of the table shows.
    std::size_t rowAt(int shown) const { return order_[static_cast<std::size_t>(shown)]; }
    bool isEmpty() const { return order_.empty(); }
    /// The reverse; -1: a brush hides it.
    int shownAt(std::size_t row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;

private:
    void arrange();
    QString titleOf(std::size_t column) const;
    const std::vector<double>& numbersOf(std::size_t column) const;

    std::shared_ptr<const StudyData> data_;
    KeptPoints kept_;
    std::vector<std::size_t> order_;
    std::vector<QString> titles_;
    int sorted_by_ = -1;
    Qt::SortOrder direction_ = Qt::AscendingOrder;
};

} // namespace hygroloom
