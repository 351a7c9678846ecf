// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/parts_table.h"

#include "core/wear/wear_outcomes.h"
#include "ui/basics/core_words.h"
#include "ui/basics/words.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLocale>
#include <QMenu>
#include <QScrollBar>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

struct Line {
    QString name;
    const WearPart* newest;
    const WearPart* kept;
};

const WearPart* named(const std::vector<WearPart>& parts, const std::string& name)
{
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const WearPart& part) { return part.name == name; });
    return found == parts.end() ? nullptr : &*found;
}

std::vector<Line> linesOf(const WearMetrics& newest, const WearMetrics* kept)
{
    std::vector<Line> lines{{tr("Garment"), &newest.all(), kept ? &kept->all() : nullptr}};
    for (const WearPart& part : newest.panels()) {
        lines.push_back({tr("Panel: %1").arg(QString::fromStdString(part.name)), &part, kept ? named(kept->panels(), part.name) : nullptr});
    }
    for (const WearPart& part : newest.zones()) {
        lines.push_back({tr("Zone: %1").arg(coreWord(part.name)), &part, kept ? named(kept->zones(), part.name) : nullptr});
    }
    return lines;
}

/// With as many decimals as all numbers of its column, so that points stand under each other.
QString inColumn(double value, int decimals)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double least = 0.5 * std::pow(10.0, -decimals);
    return locale.toString(std::abs(value) < least ? 0.0 : value, 'f', decimals); // no "-0.0"
}

/// As people read it; NaN: there is none.
double valueOf(const WearNumber& number, const WearMetrics& metrics, const WearPart* part, double time)
{
    if (!part || part->course.empty() || time > part->course.back().time + 1e-3) { return nan(""); }
    const auto after =
        std::upper_bound(part->course.begin(), part->course.end(), time + 1e-9, [](double t, const WearNow& now) { return t < now.time; });
    const std::optional<double> value = number.value({metrics, *part, after == part->course.begin() ? *after : *(after - 1)});
    return value ? shown(number.info, *value).value : nan("");
}

} // namespace

PartsTable::PartsTable(WearPlayback& playback, QWidget* parent) : QTableWidget(parent), playback_(playback)
{
    setEditTriggers(NoEditTriggers);
    setSelectionBehavior(SelectRows);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Numbers per panel and zone"));
    for (const auto signal : {&WearPlayback::runChanged, &WearPlayback::framesChanged, &WearPlayback::frameShown}) {
        connect(&playback_, signal, this, &PartsTable::refresh);
    }
    refresh();
}

void PartsTable::refresh()
{
    const auto& run = playback_.run();
    const bool known = run && run->metrics;
    const bool compares = known && playback_.kept() && playback_.kept() != run && playback_.kept()->metrics;
    QStringList titles{tr("Part")};
    for (const WearNumber& number : wear_numbers()) {
        if (!number.decimals) { continue; }
        const QString title = capital(coreWord(number.info.title)) + ", " + QString::fromStdString(shown(number.info, 0).unit);
        if (compares) {
            titles << "A " + title << "B " + title << QStringLiteral("B − A");
        } else {
            titles << title;
        }
    }
    std::vector<Line> lines;
    if (known) { lines = linesOf(*run->metrics, compares ? playback_.kept()->metrics.get() : nullptr); }
    const bool anew = columnCount() != titles.size() || rowCount() != static_cast<int>(lines.size());
    setColumnCount(static_cast<int>(titles.size()));
    setRowCount(static_cast<int>(lines.size()));
    if (anew) { setHorizontalHeaderLabels(titles); }
    const auto put = [this](int row, int column, const QString& text, double value = nan("")) {
        QTableWidgetItem* cell = item(row, column);
        if (!cell) {
            setItem(row, column, cell = new QTableWidgetItem);
            if (column > 0) { cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter); }
        }
        cell->setText(text);
        cell->setData(Qt::UserRole, std::isnan(value) ? QVariant() : QVariant(value));
    };
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const int row = static_cast<int>(k);
        put(row, 0, lines[k].name);
        int at = 1;
        for (const WearNumber& number : wear_numbers()) {
            if (!number.decimals) { continue; }
            const auto text = [&](double value) { return std::isnan(value) ? QStringLiteral("–") : inColumn(value, *number.decimals); };
            const double newest = valueOf(number, *run->metrics, lines[k].newest, playback_.time());
            if (compares) {
                const double kept = valueOf(number, *playback_.kept()->metrics, lines[k].kept, playback_.time());
                const double less = newest - kept; // NaN where one of them is
                put(row, at++, text(kept), kept);
                put(row, at++, text(newest), newest);
                put(row, at++, text(less), less);
            } else {
                put(row, at++, text(newest), newest);
            }
        }
    }
    if (anew) { resizeColumnsToContents(); }
    for (int column = 0; column < columnCount(); ++column) { // numbers grow with time
        if (const int needed = sizeHintForColumn(column); needed > columnWidth(column)) { setColumnWidth(column, needed); }
    }
}

QString PartsTable::csv() const
{
    if (rowCount() == 0) { return {}; }
    const auto quoted = [](QString text) {
        return text.contains(',') || text.contains('"') ? '"' + text.replace('"', "\"\"") + '"' : text;
    };
    QStringList rows, head;
    for (int column = 0; column < columnCount(); ++column) { head << quoted(horizontalHeaderItem(column)->text()); }
    rows << head.join(',');
    for (int row = 0; row < rowCount(); ++row) {
        QStringList cells{quoted(item(row, 0)->text())};
        for (int column = 1; column < columnCount(); ++column) {
            const QVariant value = item(row, column)->data(Qt::UserRole);
            cells << (value.isValid() ? QString::number(value.toDouble(), 'g', 8) : QString());
        }
        rows << cells.join(',');
    }
    return rows.join('\n') + '\n';
}

void PartsTable::copy() const { QApplication::clipboard()->setText(csv()); }

void PartsTable::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Copy)) {
        copy();
        return;
    }
    QTableWidget::keyPressEvent(event);
}

void PartsTable::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    connect(menu.addAction(tr("Copy as CSV")), &QAction::triggered, this, &PartsTable::copy);
    menu.exec(event->globalPos());
}

} // namespace hygroloom
