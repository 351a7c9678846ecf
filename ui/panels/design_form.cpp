// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/design_form.h"

#include "ui/basics/appearance.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int label_width = 112;

QGridLayout* formGrid(QWidget* owner)
{
    auto* grid = new QGridLayout(owner);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 3);
    grid->setColumnStretch(2, 2);
    grid->setColumnMinimumWidth(0, label_width);
    return grid;
}

/// Flat although it is checked while its rows show. No style sheet: one would keep the colours of the look it was made in.
class SectionHeading : public QToolButton {
protected:
    void paintEvent(QPaintEvent*) override
    {
        QStyleOptionToolButton option;
        initStyleOption(&option);
        option.state &= ~(QStyle::State_On | QStyle::State_Sunken);
        QStylePainter(this).drawComplexControl(QStyle::CC_ToolButton, option);
    }
};

} // namespace

DesignForm::DesignForm(Document& document, QWidget* parent) : QWidget(parent), document_(document), grid_(formGrid(this)), target_(grid_)
{
    connect(&document_, &Document::designChanged, this, &DesignForm::refresh);
    connect(&document_, &Document::replaced, this, [this] {
        for (const Row& row : rows_) { row.edit->takeBack(); }
    });
}

void FormSection::open() const { heading->setChecked(true); }

void FormSection::setShown(bool shown) const
{
    heading->setVisible(shown);
    content->setVisible(shown && heading->isChecked());
}

int DesignForm::nextSection()
{
    target_ = grid_;
    const int row = grid_->rowCount();
    if (row > 1) { grid_->setRowMinimumHeight(row, 8); }
    return row + 1;
}

void DesignForm::addSection(const QString& title)
{
    auto* heading = new QLabel(title);
    QFont font = heading->font();
    font.setBold(true);
    heading->setFont(font);
    grid_->addWidget(heading, nextSection(), 0, 1, 3);
}

FormSection DesignForm::addFoldable(const QString& title, bool open)
{
    auto* button = new SectionHeading;
    button->setText(title);
    button->setAccessibleName(title);
    button->setToolTip(tr("Show or hide these fields."));
    button->setCheckable(true);
    button->setChecked(open);
    button->setAutoRaise(true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    QFont font = button->font();
    font.setBold(true);
    button->setFont(font);
    const int row = nextSection();
    auto* content = new QWidget(this);
    target_ = formGrid(content);
    const auto turn = [button, content](bool on) {
        button->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
        content->setVisible(on);
    };
    turn(open);
    connect(button, &QToolButton::toggled, content, turn);
    grid_->addWidget(button, row, 0, 1, 3);
    grid_->addWidget(content, row + 1, 0, 1, 3);
    sections_.push_back({button, content});
    return sections_.back();
}

QWidget* DesignForm::addGroup()
{
    auto* group = new QWidget(this);
    grid_->addWidget(group, grid_->rowCount(), 0, 1, 3);
    target_ = formGrid(group);
    return group;
}

QuantityEdit* DesignForm::addQuantity(const Quantity& quantity, const DesignField& field, bool optional)
{
    auto* edit = new QuantityEdit(quantity);
    addField(edit, field, optional);
    return edit;
}

void DesignForm::addField(QuantityEdit* edit, const DesignField& field, bool optional)
{
    edit->setOptional(optional);
    edit->setHelp(field.help);
    edit->setAccessibleName(field.label);
    edit->setObjectName(field.undo);
    addRow(field.label, edit, field.where);
    auto* complaint = new QLabel;
    complaint->setWordWrap(true);
    complaint->setVisible(false);
    addWide(complaint);
    rows_.push_back({edit, field, complaint, {}});
    connect(edit, &QuantityEdit::edited, this, [this, field](std::optional<double> value, bool) {
        document_.edit(field.undo, field.where(), [&](Design& design) { field.write(design, value); });
    });
    connect(edit, &QuantityEdit::strokeEnded, this, [this] { document_.endStroke(); });
    connect(edit, &QuantityEdit::complained, this, [this, place = rows_.size() - 1] { showComplaint(rows_[place]); });
}

void DesignForm::showComplaint(const Row& row) const
{
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, severityColor(Severity::error, colors));
    row.complaint->setPalette(colors);
    row.complaint->setText(row.edit->complaint());
    row.complaint->setVisible(!row.edit->complaint().isEmpty());
}

void DesignForm::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        for (const Row& row : rows_) { showComplaint(row); }
    }
    QWidget::changeEvent(event);
}

QLabel* DesignForm::addRow(const QString& label, QWidget* widget, std::function<std::string()> where)
{
    const int row = nextRow();
    auto* name = new QLabel(label);
    name->setBuddy(widget);
    auto* box = qobject_cast<QComboBox*>(widget);
    if (box) {
        // Its longest entry must not make the panel wider than its dock.
        box->setMinimumContentsLength(8);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    }
    target_->addWidget(name, row, 0);
    target_->addWidget(widget, row, 1, 1, box ? 2 : 1); // no note stands beside a choice
    if (widget->accessibleName().isEmpty()) { widget->setAccessibleName(label); }
    places_.push_back({widget, name, std::move(where)});
    return name;
}

void DesignForm::putBeside(QWidget* choice, QWidget* button)
{
    int row = 0, column = 0, rows = 0, columns = 0;
    target_->getItemPosition(target_->indexOf(choice), &row, &column, &rows, &columns);
    target_->removeWidget(choice);
    target_->addWidget(choice, row, column);
    target_->addWidget(button, row, column + 1);
}

void DesignForm::setLabel(QWidget* field, const QString& label)
{
    const auto place = std::find_if(places_.begin(), places_.end(), [field](const Place& p) { return p.field == field; });
    place->label->setText(label);
    field->setAccessibleName(label);
}

void DesignForm::addWide(QWidget* widget) { target_->addWidget(widget, nextRow(), 0, 1, 3); }

QLabel* DesignForm::addDerived(const QString& label, const QString& help)
{
    const int row = nextRow();
    auto* name = new QLabel(label);
    auto* value = new QLabel;
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setAccessibleName(label);
    if (!help.isEmpty()) {
        name->setToolTip("<p>" + help + "</p>");
        value->setToolTip("<p>" + help + "</p>");
    }
    target_->addWidget(name, row, 0);
    target_->addWidget(value, row, 1, 1, 2);
    return value;
}

QLabel* DesignForm::noteBeside(QWidget* field)
{
    int row = 0, column = 0, rows = 0, columns = 0;
    target_->getItemPosition(target_->indexOf(field), &row, &column, &rows, &columns);
    auto* note = new QLabel;
    note->setForegroundRole(QPalette::PlaceholderText);
    note->setWordWrap(true); // or a long one makes the form wider than its dock
    target_->setColumnMinimumWidth(2, note->fontMetrics().horizontalAdvance("8888.8/888"));
    note->setAccessibleName(tr("The same in other units"));
    target_->addWidget(note, row, 2);
    return note;
}

void DesignForm::refresh()
{
    for (Row& row : rows_) {
        std::string at = row.field.where();
        if (at != row.at) { row.edit->takeBack(); } // another fabric's value
        row.at = std::move(at);
        row.edit->setValue(row.field.read());
        auto issues = document_.issuesAt(row.at);
        if (issues.empty() && row.field.within) { issues = document_.issuesAt(row.field.within()); }
        row.edit->setIssues(issues);
    }
    for (const auto& work : afterwards_) { work(); }
}

/// Groups are hidden for a reason; a closed section can be opened.
bool DesignForm::canBeShown(const QWidget* field) const
{
    const QWidget* part = field->parentWidget();
    return !part->isHidden() || std::any_of(sections_.begin(), sections_.end(), [part](const FormSection& section) {
        return section.content == part && !section.heading->isHidden();
    });
}

QWidget* DesignForm::fieldAt(const std::string& where) const
{
    const auto within = [](const std::string& part, const std::string& whole) {
        return part.starts_with(whole + ".") || part.starts_with(whole + "[");
    };
    QWidget* whole = nullptr;
    QWidget* part = nullptr;
    for (const Place& place : places_) {
        const std::string path = place.where ? place.where() : std::string();
        if (path.empty() || !canBeShown(place.field)) { continue; }
        if (path == where) { return place.field; }
        whole = within(where, path) ? place.field : whole;
        part = !part && within(path, where) ? place.field : part;
    }
    return whole ? whole : part;
}

bool DesignForm::showField(const std::string& where)
{
    QWidget* field = fieldAt(where);
    if (!field || !field->isEnabled()) { return false; }
    for (const FormSection& section : sections_) {
        if (section.content->isAncestorOf(field)) { section.open(); }
    }
    field->setFocus(Qt::OtherFocusReason);
    // The form has to know its size before it can scroll there.
    QMetaObject::invokeMethod(
        field,
        [field] {
            for (QWidget* parent = field->parentWidget(); parent; parent = parent->parentWidget()) {
                if (auto* panel = qobject_cast<QScrollArea*>(parent)) {
                    panel->widget()->layout()->activate();
                    panel->ensureWidgetVisible(field, 0, 40);
                    return;
                }
            }
        },
        Qt::QueuedConnection);
    return true;
}

void DesignForm::fill(QScrollArea* panel)
{
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(this);
    layout->addStretch();
    panel->setWidget(content);
    panel->setWidgetResizable(true);
    panel->setFrameShape(QFrame::NoFrame);
    // Fields are not to be cut off, however small the window is.
    panel->setMinimumWidth(content->minimumSizeHint().width() + panel->verticalScrollBar()->sizeHint().width());
}

int DesignForm::nextRow() { return target_->rowCount(); }

} // namespace hygroloom
