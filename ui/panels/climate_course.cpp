// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/climate_course.h"

#include "ui/basics/appearance.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/quantity_edit.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int columns = 4;
constexpr const char* keys[columns] = {"time_s", "temperature_c", "relative_humidity", "air_speed_m_s"};
constexpr int shown_rows = 5;
constexpr double last_moment = 86400; // s

double& valueIn(ClimateMoment& moment, int column)
{
    double* values[columns] = {&moment.time_s, &moment.climate.temperature_c, &moment.climate.relative_humidity,
                               &moment.climate.air_speed_m_s};
    return *values[column];
}

/// The start and the times after it.
std::vector<ClimateMoment> momentsOf(const Experiment& experiment)
{
    std::vector<ClimateMoment> moments{{0, experiment.climate}};
    moments.insert(moments.end(), experiment.climates.begin(), experiment.climates.end());
    return moments;
}

/// Edits a cell as any other number with a unit is edited.
class MomentDelegate : public QStyledItemDelegate {
public:
    explicit MomentDelegate(ClimateCourse* course) : QStyledItemDelegate(course), course_(course) {}

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const override
    {
        auto* editor = new QuantityEdit(ClimateCourse::quantity(index.column()), parent);
        editor->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal, Qt::ToolTipRole).toString());
        editor->setFrame(false);
        return editor;
    }

    void setEditorData(QWidget* editor, const QModelIndex& index) const override
    {
        auto* field = static_cast<QuantityEdit*>(editor);
        field->setValue(index.data(Qt::UserRole).toDouble());
        field->selectAll();
    }

    void setModelData(QWidget* editor, QAbstractItemModel*, const QModelIndex& index) const override
    {
        const auto* field = static_cast<QuantityEdit*>(editor);
        QString complaint;
        const auto value = field->typed(&complaint); // what is out of range does not enter the design
        if (value) {
            course_->setCell(index.row(), index.column(), *value);
        } else {
            QToolTip::showText(field->mapToGlobal(QPoint(0, field->height())), "<p>" + complaint.toHtmlEscaped() + "</p>", course_);
        }
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::paint(painter, option, index);
        if (const QVariant severity = index.data(Qt::UserRole + 1); severity.isValid()) {
            const QRect& cell = option.rect;
            painter->fillRect(QRect(cell.left() + 2, cell.bottom() - 2, cell.width() - 4, 2),
                              severityColor(static_cast<Severity>(severity.toInt()), option.palette));
        }
    }

private:
    ClimateCourse* course_;
};

} // namespace

ClimateCourse::ClimateCourse(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), table_(new QTableWidget(0, columns)), add_(new QToolButton), remove_(new QToolButton),
      note_(new QLabel)
{
    table_->setAccessibleName(tr("Climate over time"));
    table_->setHorizontalHeaderLabels({tr("Time"), tr("Temp."), tr("Humidity"), tr("Air")});
    const QString tips[columns] = {tr("Time from the start of the experiment"), tr("Temperature"), tr("Relative humidity"),
                                   tr("Air speed")};
    for (int column = 0; column < columns; ++column) { table_->horizontalHeaderItem(column)->setToolTip(tips[column]); }
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->horizontalHeader()->setHighlightSections(false);
    table_->horizontalHeader()->setMinimumSectionSize(40);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().lineSpacing() + 8);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::SelectedClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::AnyKeyPressed);
    table_->setItemDelegate(new MomentDelegate(this));
    table_->setTabKeyNavigation(false); // Tab leaves the table, except while a cell is edited
    const auto prepare = [this](QToolButton* button, const char* icon, const QString& name, void (ClimateCourse::*work)()) {
        button->setIcon(themedIcon(icon));
        button->setAutoRaise(true);
        button->setAccessibleName(name);
        button->setToolTip(name);
        connect(button, &QToolButton::clicked, this, work);
    };
    prepare(add_, "add", tr("Add a time"), &ClimateCourse::addMoment);
    prepare(remove_, "remove", tr("Remove the selected time"), &ClimateCourse::removeMoment);
    auto* remove = new QAction(table_);
    remove->setShortcut(QKeySequence::Delete);
    remove->setShortcutContext(Qt::WidgetShortcut);
    table_->addAction(remove);
    connect(remove, &QAction::triggered, this, &ClimateCourse::removeMoment);
    note_->setWordWrap(true);
    note_->setTextFormat(Qt::PlainText);
    note_->setAccessibleName(tr("About the climate over time"));
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(4);
    buttons->addWidget(add_);
    buttons->addWidget(remove_);
    buttons->addStretch();
    auto* texts = new QVBoxLayout;
    texts->setSpacing(4);
    texts->addWidget(table_);
    texts->addWidget(note_);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(texts, 1);
    layout->addLayout(buttons);
    connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) { remove_->setEnabled(row > 0); });
    connect(&document_, &Document::designChanged, this, &ClimateCourse::refresh);
    refresh();
}

Quantity ClimateCourse::quantity(int column)
{
    switch (column) {
    case 0: return Quantity::time(0, last_moment);
    case 1: return Quantity::temperature(-10, 60);
    case 2: return Quantity::percent(0, most_humidity);
    default: return Quantity::speed(20);
    }
}

std::string ClimateCourse::path(int row, int column) const
{
    return "experiments[" + std::to_string(document_.experimentIndex()) + "].climate[" + std::to_string(row) + "]." + keys[column];
}

void ClimateCourse::refresh()
{
    const Experiment* experiment = document_.experiment();
    const bool course = experiment && !experiment->climates.empty();
    const QSignalBlocker quiet(table_);
    std::vector<ClimateMoment> moments;
    if (course) { moments = momentsOf(*experiment); }
    table_->setRowCount(static_cast<int>(moments.size()));
    QStringList faults;
    for (int row = 0; row < table_->rowCount(); ++row) {
        for (int column = 0; column < columns; ++column) {
            QTableWidgetItem* item = table_->item(row, column);
            if (!item) {
                item = new QTableWidgetItem;
                table_->setItem(row, column, item);
            }
            const double value = valueIn(moments[static_cast<std::size_t>(row)], column);
            item->setText(quantity(column).text(value));
            item->setData(Qt::UserRole, value);
            item->setFlags(row == 0 && column == 0 ? Qt::ItemIsSelectable | Qt::ItemIsEnabled
                                                   : Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsEditable);
            QStringList sentences;
            const auto issues = document_.issuesAt(path(row, column));
            for (const Issue* issue : issues) {
                sentences << issueText(*issue);
                faults << tr("Row %1: %2").arg(row).arg(sentences.last());
            }
            item->setData(Qt::UserRole + 1, issues.empty() ? QVariant() : QVariant(static_cast<int>(issues.front()->severity)));
            item->setToolTip("<p>" + (sentences << quantity(column).range()).join('\n').toHtmlEscaped().replace('\n', "</p><p>") + "</p>");
        }
    }
    if (course) {
        for (const Issue* issue : document_.issuesAt(path(0, 0).substr(0, path(0, 0).rfind('[')))) { faults << issueText(*issue); }
    }
    const int rows = std::min(table_->rowCount(), shown_rows);
    table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() + rows * table_->verticalHeader()->defaultSectionSize() +
                           2 * table_->frameWidth());
    table_->setVisible(course);
    remove_->setVisible(course);
    remove_->setEnabled(table_->currentRow() > 0);
    add_->setEnabled(experiment);
    note_->setForegroundRole(faults.isEmpty() ? QPalette::PlaceholderText : QPalette::WindowText);
    note_->setText(!faults.isEmpty() ? faults.join('\n')
                   : course          ? tr("The climate changes linearly between these times and is constant after the last.")
                                     : tr("The climate is constant. Add a time to change it."));
}

void ClimateCourse::edit(const QString& undo, const std::string& field, const std::function<void(Experiment&)>& change)
{
    const auto index = static_cast<std::size_t>(document_.experimentIndex());
    document_.endStroke();
    document_.edit(undo, field, [&](Design& design) { change(design.experiments[index]); });
}

void ClimateCourse::setCell(int row, int column, double value)
{
    const Experiment* experiment = document_.experiment();
    if (!experiment || row > static_cast<int>(experiment->climates.size())) { return; }
    ClimateMoment moment = momentsOf(*experiment)[static_cast<std::size_t>(row)];
    if (valueIn(moment, column) == value) { return; }
    valueIn(moment, column) = value;
    edit(tr("climate over time"), {}, [&](Experiment& e) {
        if (row == 0) {
            e.climate = moment.climate;
        } else {
            e.climates[static_cast<std::size_t>(row - 1)] = moment;
        }
    });
}

void ClimateCourse::addMoment()
{
    const Experiment* experiment = document_.experiment();
    if (!experiment) { return; }
    const std::vector<ClimateMoment> moments = momentsOf(*experiment);
    const int last = static_cast<int>(moments.size()) - 1;
    const int row = table_->currentRow() >= 0 && table_->currentRow() <= last ? table_->currentRow() : last;
    ClimateMoment made = moments[static_cast<std::size_t>(row)];
    if (row < last) {
        made.time_s = 0.5 * (made.time_s + moments[static_cast<std::size_t>(row) + 1].time_s);
        made.climate = climate_at(*experiment, made.time_s);
    } else {
        made.time_s = experiment->duration_s > made.time_s ? experiment->duration_s : std::min(last_moment, made.time_s + 60);
    }
    edit(tr("add climate time"), {}, [&](Experiment& e) { e.climates.insert(e.climates.begin() + row, made); });
    table_->setCurrentCell(row + 1, 0);
    table_->setFocus();
}

void ClimateCourse::removeMoment()
{
    const int row = table_->currentRow();
    const Experiment* experiment = document_.experiment();
    if (experiment && row > 0 && row <= static_cast<int>(experiment->climates.size())) {
        edit(tr("remove climate time"), {}, [&](Experiment& e) { e.climates.erase(e.climates.begin() + row - 1); });
    }
}

bool ClimateCourse::showField(const std::string& where)
{
    for (int row = 0; row < table_->rowCount(); ++row) {
        for (int column = 0; column < columns; ++column) {
            if (path(row, column) == where) {
                table_->setFocus();
                table_->setCurrentCell(row, column);
                return true;
            }
        }
    }
    return false;
}

} // namespace hygroloom
