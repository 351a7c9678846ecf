// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the forms of this room share: fields that follow the design, and edit it.
#pragma once

#include "core/design/fields.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity_edit.h"
#include "ui/document/document.h"

#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QSignalBlocker>

namespace hygroloom {

/// Fills a choice anew only where it differs, so that an open list stays.
inline void setChoices(QComboBox* box, const QStringList& names, int current, const std::function<QIcon(int)>& icon = {})
{
    const QSignalBlocker quiet(box);
    QStringList shown;
    for (int i = 0; i < box->count(); ++i) { shown << box->itemText(i); }
    if (shown != names) {
        box->clear();
        box->addItems(names);
        for (int i = 0; icon && i < names.size(); ++i) { box->setItemIcon(i, icon(i)); }
    }
    box->setCurrentIndex(current);
}

/// A square of a colour with a thin frame.
inline QIcon colorIcon(const QColor& color)
{
    QPixmap pixmap(14, 14);
    pixmap.fill(color);
    QPainter painter(&pixmap);
    painter.setPen(QColor(0, 0, 0, 120));
    painter.drawRect(0, 0, 13, 13);
    return QIcon(pixmap);
}

inline QLabel* heading(const QString& text)
{
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

inline QStringList namesOf(const std::vector<Fabric>& fabrics)
{
    QStringList names;
    for (const Fabric& fabric : fabrics) { names << QString::fromStdString(fabric.name); }
    return names;
}

/// A field whose edits are steps of the history: change is called with the value and the sentence for Undo merges while one steps.
template <typename Change>
QuantityEdit* quantityField(Document& document, const Quantity& quantity, const QString& name, const Change& change)
{
    auto* edit = new QuantityEdit(quantity);
    edit->setAccessibleName(name);
    QObject::connect(edit, &QuantityEdit::edited, edit, [&document, change](std::optional<double> value, bool stepping) {
        if (!value) { return; }
        change(*value);
        if (!stepping) { document.endStroke(); }
    });
    QObject::connect(edit, &QuantityEdit::strokeEnded, edit, [&document] { document.endStroke(); });
    return edit;
}
/// The same of the row of a key; without a name by its label.
template <typename Owner, typename Change>
QuantityEdit* rowField(Document& document, std::string_view key, const Change& change, const QString& name = {})
{
    const Field<Owner>& row = field_named<Owner>(key);
    QuantityEdit* edit = quantityField(document, Quantity::of(row), name.isEmpty() ? coreWord(row.label) : name, change);
    edit->setHelp(coreWord(row.help));
    return edit;
}

} // namespace hygroloom
