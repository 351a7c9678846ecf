// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/candidate_table.h"

#include "ui/basics/appearance.h"
#include "ui/compare/number_delegate.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QTimer>

#include <algorithm>

namespace hygroloom {

namespace {

QString paragraph(const QString& text) { return "<p>" + text.toHtmlEscaped().replace('\n', "<br>") + "</p>"; }

} // namespace

CandidateTable::CandidateTable(QWidget* parent) : QTableWidget(parent)
{
    setAccessibleName(tr("Numbers of the candidates"));
    setEditTriggers(NoEditTriggers);
    setSelectionMode(SingleSelection);
    setFrameShape(NoFrame);
    setTabKeyNavigation(false); // Tab leaves it; arrow keys go through it
    setMinimumSize(240, 120);
    setMouseTracking(true);
    setHorizontalScrollMode(ScrollPerPixel);
    setVerticalScrollMode(ScrollPerPixel);
    verticalHeader()->hide();
    horizontalHeader()->setSortIndicatorShown(true);
    horizontalHeader()->setSortIndicator(rank_column, Qt::AscendingOrder);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    auto* delegate = new NumberDelegate(this);
    setItemDelegate(delegate);
    for (const int column : {rank_column, pin_column, name_column}) { setItemDelegateForColumn(column, new QStyledItemDelegate(this)); }
    connect(delegate, &NumberDelegate::pressed, this, &CandidateTable::use);
    connect(this, &QTableWidget::cellActivated, this, &CandidateTable::use); // by the Enter key; a double click opens by its first click
    connect(this, &QTableWidget::cellClicked, this, [this](int row, int column) {
        const GridCell* cell = cellAt(row, column);
        if (column == pin_column || (cell && cell->state == GridCell::State::number)) { use(row, column); }
    });
    connect(this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
        if (filling_ || item->column() != name_column) { return; }
        const QString path = item->data(Qt::UserRole).toString();
        const bool on = item->checkState() == Qt::Checked;
        // The table is filled anew, but not while one of its items is being changed.
        QMetaObject::invokeMethod(
            this, [this, path, on] { Q_EMIT tickRequested(path, on); }, Qt::QueuedConnection);
    });
    connect(horizontalHeader(), &QHeaderView::sectionClicked, this, &CandidateTable::sortBy);
}

void CandidateTable::setGrid(const Grid& grid, const QSet<QString>& ticked, bool overview)
{
    if (overview != overview_ || grid.columns.size() != grid_.columns.size()) { sorted_ = rank_column; }
    grid_ = grid;
    ticked_ = ticked;
    overview_ = overview;
    fill();
}

void CandidateTable::setFilter(const QString& text)
{
    filter_ = text;
    fill();
}

void CandidateTable::fill()
{
    if (QGuiApplication::mouseButtons() != Qt::NoButton && underMouse()) {
        if (!waiting_) {
            waiting_ = true;
            QTimer::singleShot(100, this, [this] {
                waiting_ = false;
                fill();
            });
        }
        return;
    }
    const QScopedValueRollback filling(filling_, true);
    const int row = currentRow(), column = currentColumn();
    const std::string at = row >= 0 && row < static_cast<int>(shown_.rows.size()) ? shown_.rows[static_cast<std::size_t>(row)].name : "";
    shown_ = grid_;
    filterRows(shown_, filter_);
    if (sorted_ == name_column) {
        std::stable_sort(shown_.rows.begin(), shown_.rows.end(),
                         [this](const GridRow& a, const GridRow& b) { return ascending_ ? a.name < b.name : b.name < a.name; });
    } else if (sorted_ == rank_column || sorted_ >= first_number) {
        sortRows(shown_, sorted_ == rank_column ? -1 : sorted_ - first_number, ascending_);
    }
    setRowCount(static_cast<int>(shown_.rows.size()));
    setColumnCount(first_number + static_cast<int>(shown_.columns.size()));
    QStringList heads{tr("Rank"), tr("Baseline"), tr("Fabric")};
    for (const GridColumn& each : shown_.columns) { heads << each.head; }
    setHorizontalHeaderLabels(heads);
    for (int i = 0; i < static_cast<int>(shown_.columns.size()); ++i) {
        horizontalHeaderItem(first_number + i)
            ->setToolTip(paragraph(shown_.columns[static_cast<std::size_t>(i)].tip + " " + tr("Click to rank and sort by this number.")));
    }
    for (int i = 0; i < rowCount(); ++i) { fillRow(i); }
    setColumnHidden(rank_column, overview_);
    horizontalHeader()->setSortIndicator(sorted_, ascending_ ? Qt::AscendingOrder : Qt::DescendingOrder);
    resizeColumnsToContents();
    setColumnWidth(name_column, std::clamp(columnWidth(name_column), 120, 260));
    shareWidth();
    resizeRowsToContents();
    for (int i = 0; i < rowCount(); ++i) {
        if (shown_.rows[static_cast<std::size_t>(i)].name == at) { setCurrentCell(i, std::max(column, 0)); }
    }
}

/// The numbers share the room that there is.
void CandidateTable::shareWidth()
{
    int needed = 0;
    for (int i = 0; i < columnCount(); ++i) {
        if (i >= first_number) { setColumnWidth(i, std::clamp(columnWidth(i), 150, 320)); }
        needed += columnWidth(i);
    }
    const int numbers = columnCount() - first_number, room = viewport()->width() - needed;
    if (numbers == 0 || room <= 0) { return; }
    for (int i = first_number; i < columnCount(); ++i) { setColumnWidth(i, std::min(360, columnWidth(i) + room / numbers)); }
}

void CandidateTable::resizeEvent(QResizeEvent* event)
{
    QTableWidget::resizeEvent(event);
    resizeColumnsToContents();
    setColumnWidth(name_column, std::clamp(columnWidth(name_column), 120, 260));
    shareWidth();
}

void CandidateTable::fillRow(int row)
{
    const GridRow& from = shown_.rows[static_cast<std::size_t>(row)];
    auto* rank = new QTableWidgetItem(from.rank);
    rank->setToolTip(
        paragraph(tr("1 is best by the number that sorts the table, or the first one. “=”: this simulation cannot tell them apart.")));
    setItem(row, rank_column, rank);
    const QString name = QString::fromStdString(from.name);
    auto* pin = new QTableWidgetItem(from.baseline ? QStringLiteral("◉") : QStringLiteral("○"));
    pin->setTextAlignment(Qt::AlignCenter);
    pin->setToolTip(
        paragraph(from.baseline ? tr("The others are compared with %1.").arg(name) : tr("Click to compare the others with %1.").arg(name)));
    pin->setData(Qt::AccessibleTextRole, from.baseline ? tr("%1 is the baseline").arg(name) : tr("Make %1 the baseline").arg(name));
    setItem(row, pin_column, pin);
    auto* title = new QTableWidgetItem(from.candidate ? name : name + "\n" + from.note);
    title->setToolTip(paragraph(name));
    if (!from.path.isEmpty() && !overview_) {
        title->setData(Qt::UserRole, from.path);
        title->setCheckState(ticked_.contains(from.path) ? Qt::Checked : Qt::Unchecked);
        title->setToolTip(paragraph(tr("%1. Tick two to four to see their maps and curves below.").arg(name)));
    }
    setItem(row, name_column, title);
    for (std::size_t i = 0; i < from.cells.size(); ++i) {
        setItem(row, first_number + static_cast<int>(i), itemOf(from.cells[i], static_cast<int>(i)));
    }
}

QTableWidgetItem* CandidateTable::itemOf(const GridCell& cell, int number) const
{
    auto* item = new QTableWidgetItem;
    const GridColumn& column = shown_.columns[static_cast<std::size_t>(number)];
    switch (cell.state) {
    case GridCell::State::number: {
        const QString shown = cell.measured.isEmpty() ? cell.number : cell.number + QStringLiteral(" · ") + cell.measured;
        item->setText(cell.verdict.isEmpty() ? shown : shown + "\n" + cell.verdict);
        const double width = column.high - column.low;
        item->setData(NumberDelegate::value_role, width > 0 ? (cell.value - column.low) / width : 0.5);
        if (width > 0) {
            item->setData(NumberDelegate::low_role, (cell.low - column.low) / width);
            item->setData(NumberDelegate::high_role, (cell.high - column.low) / width);
        }
        item->setToolTip(paragraph(column.tip + " " + cell.tip + "\n" + tr("Click to open the run.")));
        break;
    }
    case GridCell::State::no_number:
        item->setText(cell.verdict.isEmpty() ? QStringLiteral("–") : QStringLiteral("–\n") + cell.verdict);
        item->setToolTip(paragraph(cell.tip));
        break;
    case GridCell::State::reading: item->setText(tr("reading…")); break;
    case GridCell::State::missing:
        item->setText(!cell.verdict.isEmpty() ? cell.verdict : cell.failed ? tr("failed") : cell.outdated ? tr("outdated") : tr("not run"));
        item->setData(NumberDelegate::button_role, cell.verdict.isEmpty() && (overview_ || number == 0));
        item->setToolTip(paragraph(cell.tip));
        break;
    }
    return item;
}

void CandidateTable::sortBy(int column)
{
    if (column == pin_column) { return; }
    if (column == sorted_) {
        ascending_ = !ascending_;
    } else {
        sorted_ = column; // the best first
        ascending_ = column < first_number || shown_.columns[static_cast<std::size_t>(column - first_number)].info.better == Better::less;
    }
    fill();
    Q_EMIT rankingChanged();
}

const GridCell* CandidateTable::cellAt(int row, int column) const
{
    if (row < 0 || row >= static_cast<int>(shown_.rows.size()) || column < first_number || column >= columnCount()) { return nullptr; }
    return &shown_.rows[static_cast<std::size_t>(row)].cells[static_cast<std::size_t>(column - first_number)];
}

/// Opens the run, runs what is missing, or pins the baseline.
void CandidateTable::use(int row, int column)
{
    if (const GridCell* cell = cellAt(row, column)) {
        if (cell->state == GridCell::State::missing && cell->verdict.isEmpty()) {
            Q_EMIT runRequested(std::vector(cell->missing));
        } else if (cell->state == GridCell::State::number && !cell->path.isEmpty()) {
            Q_EMIT openRequested(QString(cell->path));
        }
    } else if (column == pin_column && row >= 0 && row < static_cast<int>(shown_.rows.size())) {
        Q_EMIT baselineRequested(std::string(shown_.rows[static_cast<std::size_t>(row)].name));
    }
}

void CandidateTable::contextMenuEvent(QContextMenuEvent* event)
{
    const QModelIndex index =
        event->reason() == QContextMenuEvent::Mouse ? indexAt(viewport()->mapFromGlobal(event->globalPos())) : currentIndex();
    if (!index.isValid()) { return; }
    const GridRow row = shown_.rows[static_cast<std::size_t>(index.row())];
    const GridCell* at = cellAt(index.row(), index.column());
    const GridCell cell = at ? *at : row.cells.empty() ? GridCell{} : row.cells.front();
    QMenu menu;
    QAction* baseline = menu.addAction(tr("Use as &Baseline"));
    baseline->setEnabled(!row.baseline);
    QAction* open = menu.addAction(tr("&Open This Run"));
    open->setEnabled(!cell.path.isEmpty());
    QAction* run = menu.addAction(tr("&Run What Is Missing"));
    run->setEnabled(!cell.missing.empty());
    const QAction* chosen =
        menu.exec(event->reason() == QContextMenuEvent::Mouse ? event->globalPos() : viewport()->mapToGlobal(visualRect(index).center()));
    if (chosen == baseline) { Q_EMIT baselineRequested(row.name); }
    if (chosen == open) { Q_EMIT openRequested(cell.path); }
    if (chosen == run) { Q_EMIT runRequested(cell.missing); }
}

void CandidateTable::mouseMoveEvent(QMouseEvent* event)
{
    const QModelIndex index = indexAt(event->position().toPoint());
    const GridCell* cell = cellAt(index.row(), index.column());
    const bool opens = index.column() == pin_column || (cell && cell->state == GridCell::State::number);
    viewport()->setCursor(opens ? Qt::PointingHandCursor : Qt::ArrowCursor);
    QTableWidget::mouseMoveEvent(event);
}

} // namespace hygroloom
