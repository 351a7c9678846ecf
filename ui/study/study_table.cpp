// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/study_table.h"

#include "ui/study/study_fields.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hygroloom {

namespace {

using Role = StudyColumnRole;

} // namespace

void StudyTableModel::setStudy(std::shared_ptr<const StudyData> data)
{
    beginResetModel();
    const std::size_t columns = data ? data->table.columns.size() : 0;
    if (titles_.size() != columns) { sorted_by_ = -1; }
    data_ = std::move(data);
    kept_.clear();
    titles_.clear();
    for (std::size_t k = 0; k < columns; ++k) { titles_.push_back(titleOf(k)); }
    arrange();
    endResetModel();
}

void StudyTableModel::setKept(const KeptPoints& kept)
{
    beginResetModel();
    kept_ = kept;
    arrange();
    endResetModel();
}

int StudyTableModel::shownAt(std::size_t row) const
{
    const auto found = std::find(order_.begin(), order_.end(), row);
    return found == order_.end() ? -1 : static_cast<int>(found - order_.begin());
}

int StudyTableModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(order_.size()); }

int StudyTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(titles_.size()); }

QString StudyTableModel::titleOf(std::size_t column) const
{
    for (const StudyAxis& axis : data_->axes) {
        if (axis.column == column) { return axis.title; }
    }
    switch (data_->table.columns[column].role) {
    case Role::point: return tr("point");
    case Role::replicate: return tr("replicate");
    case Role::status: return tr("status");
    case Role::wall: return tr("time taken (s)");
    case Role::device: return tr("device");
    case Role::commit: return tr("program");
    case Role::reason: return tr("why it failed");
    default: return QString::fromStdString(data_->table.columns[column].name);
    }
}

/// Those of its axis are in the user's unit.
const std::vector<double>& StudyTableModel::numbersOf(std::size_t column) const
{
    for (const StudyAxis& axis : data_->axes) {
        if (axis.column == column) { return axis.numbers; }
    }
    return data_->table.columns[column].numbers;
}

QVariant StudyTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) { return {}; }
    const StudyColumn& column = data_->table.columns[static_cast<std::size_t>(index.column())];
    const std::size_t row = rowAt(index.row());
    if (role == Qt::TextAlignmentRole && column.is_number) { return int(Qt::AlignRight | Qt::AlignVCenter); }
    if (role == Qt::ToolTipRole && !column.is_number) { return QString::fromStdString(column.word(row)).toHtmlEscaped(); }
    if (role != Qt::DisplayRole) { return {}; }
    if (!column.is_number) {
        const std::string& word = column.word(row);
        if (column.role == Role::status) { return word == row_done ? tr("done") : tr("failed"); }
        return QString::fromStdString(word);
    }
    const double number = numbersOf(static_cast<std::size_t>(index.column()))[row];
    return std::isnan(number) ? QString() : studyNumber(number);
}

QVariant StudyTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical) { return {}; }
    const auto column = static_cast<std::size_t>(section);
    if (role == Qt::DisplayRole) { return titles_[column]; }
    if (role == Qt::ToolTipRole) { return QString::fromStdString(data_->table.columns[column].name); }
    return {};
}

void StudyTableModel::sort(int column, Qt::SortOrder order)
{
    if (sorted_by_ == column && direction_ == order) { return; }
    beginResetModel();
    sorted_by_ = column;
    direction_ = order;
    arrange();
    endResetModel();
}

/// Empty cells stand last in either direction.
void StudyTableModel::arrange()
{
    order_.clear();
    if (!data_) { return; }
    for (std::size_t row = 0; row < data_->table.rows(); ++row) {
        if (kept_.empty() || kept_[row]) { order_.push_back(row); }
    }
    if (sorted_by_ < 0) { return; }
    const StudyColumn& column = data_->table.columns[static_cast<std::size_t>(sorted_by_)];
    const bool down = direction_ == Qt::DescendingOrder;
    if (column.is_number) {
        const std::vector<double>& numbers = numbersOf(static_cast<std::size_t>(sorted_by_));
        std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
            if (std::isnan(numbers[a]) || std::isnan(numbers[b])) { return !std::isnan(numbers[a]) && std::isnan(numbers[b]); }
            return down ? numbers[a] > numbers[b] : numbers[a] < numbers[b];
        });
        return;
    }
    std::vector<std::size_t> places(column.words.size()), rank(column.words.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) { return column.words[a] < column.words[b]; });
    for (std::size_t i = 0; i < places.size(); ++i) { rank[places[i]] = column.words[places[i]].empty() ? places.size() : i; }
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
        const std::size_t one = rank[column.word_of[a]], other = rank[column.word_of[b]];
        if (one == places.size() || other == places.size()) { return one < other; }
        return down ? one > other : one < other;
    });
}

} // namespace hygroloom
