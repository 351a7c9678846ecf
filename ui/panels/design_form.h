// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Rows of fields that show values of the design and write them back as undoable edits.
#pragma once

#include "core/design/fields.h"
#include "ui/basics/core_words.h"
#include "ui/basics/language.h"
#include "ui/basics/quantity_edit.h"
#include "ui/document/document.h"

#include <QComboBox>
#include <QWidget>

class QAbstractButton;
class QGridLayout;
class QLabel;
class QScrollArea;

namespace hygroloom {

/// Where a number lives in the design.
struct DesignField {
    QString label;
    QString undo;                       ///< completes "Undo ...": "picks per cm"
    std::function<std::string()> where; ///< path into the project, for issues
    std::function<std::optional<double>()> read;
    std::function<void(Design&, std::optional<double>)> write;
    QString help;
    std::function<std::string()> within = {}; ///< path of the whole whose contradictions this field can mend
};

/// The object of the design whose numbers a form shows.
template <typename Owner> struct FormOwner {
    std::function<std::string()> path;   ///< into the project, before a key: "fabrics[0].warp."
    std::function<const Owner*()> shown; ///< nullptr: there is none now
    std::function<void(Design&, const std::function<void(Owner&)>&)> change;
    QString kind = {}; ///< before a field in the history: "weft"
};

/// Of the row of a key.
template <typename Owner> DesignField field_of(const FormOwner<Owner>& owner, std::string_view key)
{
    const Field<Owner>& row = field_named<Owner>(key);
    const QString label = coreWord(row.label), name = withinSentence(label);
    return {label,
            owner.kind.isEmpty() ? name : owner.kind + " " + name,
            [path = owner.path, &row] { return path() + row.key; },
            [shown = owner.shown, &row] { return shown() ? field_value(row, *shown()) : std::nullopt; },
            [change = owner.change, &row](Design& design, std::optional<double> value) {
                change(design, [&](Owner& of) { set_field(row, of, value); });
            },
            coreWord(row.help)};
}

/// A heading that folds the rows below it away.
struct FormSection {
    QAbstractButton* heading = nullptr;
    QWidget* content = nullptr;

    void open() const;
    /// Takes heading and rows out of the form, or puts them back as they were.
    void setShown(bool shown) const;
};

/// Refreshes itself whenever the document changes.
class DesignForm : public QWidget {
    Q_OBJECT
public:
    explicit DesignForm(Document& document, QWidget* parent = nullptr);

    /// A heading over the rows that follow.
    void addSection(const QString& title);
    /// The same; the rows fold away with it.
    FormSection addFoldable(const QString& title, bool open = true);
    /// A part without a heading, for rows that are shown and hidden together; it ends with the next section or group.
    QWidget* addGroup();
    QuantityEdit* addQuantity(const Quantity& quantity, const DesignField& field, bool optional = false);
    /// Of the row of a key, or as its field was changed.
    template <typename Owner> QuantityEdit* addNumber(const FormOwner<Owner>& owner, std::string_view key)
    {
        return addNumber<Owner>(key, field_of(owner, key));
    }
    template <typename Owner> QuantityEdit* addNumber(std::string_view key, const DesignField& field)
    {
        const Field<Owner>& row = field_named<Owner>(key);
        return addQuantity(Quantity::of(row), field, row.is_optional());
    }
    /// The same with a field of another kind. What it refuses is said under it.
    void addField(QuantityEdit* edit, const DesignField& field, bool optional);
    /// Any other widget in the field column, with its label, and the path of what it edits where an issue may be about that.
    QLabel* addRow(const QString& label, QWidget* widget, std::function<std::string()> where = {});
    /// A button that has the room of notes, beside a choice that was just added.
    void putBeside(QWidget* choice, QWidget* button);
    /// A button by which the value at a path is changed, as its field: issues lead to it.
    void setPlace(QWidget* button, std::function<std::string()> where) { places_.push_back({button, nullptr, std::move(where)}); }
    void setLabel(QWidget* field, const QString& label);
    /// A widget over the whole width.
    void addWide(QWidget* widget);
    /// A pair of a name and a number that the program works out.
    QLabel* addDerived(const QString& label, const QString& help = {});
    /// The quiet text behind the last field.
    QLabel* noteBeside(QWidget* field);
    /// Work to do at each refresh, after the fields.
    void onRefresh(std::function<void()> work) { afterwards_.push_back(std::move(work)); }
    void refresh();
    /// The field of the value at a path, else of the whole it is part of, else of its first part; nullptr where there is none.
    QWidget* fieldAt(const std::string& where) const;
    /// Unfolds its section, scrolls to it and gives it the focus. False where there is no such field that can be edited.
    bool showField(const std::string& where);
    /// Puts the form into a panel in which it scrolls up and down.
    void fill(QScrollArea* panel);

    Document& document() { return document_; }

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QuantityEdit* edit;
        DesignField field;
        QLabel* complaint;
        std::string at; ///< where the value stood that is shown
    };
    void showComplaint(const Row& row) const;
    bool canBeShown(const QWidget* field) const;
    int nextRow();
    int nextSection();

    Document& document_;
    QGridLayout* grid_;
    struct Place {
        QWidget* field;
        QLabel* label; ///< nullptr: it is a button
        std::function<std::string()> where;
    };
    std::vector<Row> rows_;
    std::vector<Place> places_; ///< of all fields
    std::vector<FormSection> sections_;
    std::vector<std::function<void()>> afterwards_;
    QGridLayout* target_ = nullptr;
};

} // namespace hygroloom
