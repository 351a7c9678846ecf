// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A field for one number with its unit.
#pragma once

#include "core/design/validate.h"
#include "ui/basics/quantity.h"

#include <QLineEdit>

class QAction;

namespace hygroloom {

/// Enter or leaving the field commits, Escape takes back what was typed, arrow keys and the wheel step (Shift: ten steps, Ctrl: a tenth).
/// An optional quantity may be emptied; the placeholder then says what stands in for it.
class QuantityEdit : public QLineEdit {
    Q_OBJECT
public:
    explicit QuantityEdit(Quantity quantity, QWidget* parent = nullptr);

    const Quantity& quantity() const { return quantity_; }
    std::optional<double> value() const { return value_; }
    /// What the text says, committed or not. Without a value, complaint says why; nothing where the field may be empty and is.
    std::optional<double> typed(QString* complaint) const;
    /// Shows a value without telling anyone; text being typed stays.
    void setValue(std::optional<double> value);
    void setOptional(bool optional);
    /// What an empty field stands for, in the stored unit.
    void setDerived(std::optional<double> derived);
    void setIssues(const std::vector<const Issue*>& issues);
    /// A sentence that explains the field; shown before the range.
    void setHelp(const QString& sentence);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    /// The user chose another value. stepping: by arrow key or wheel, so more may follow at once.
    void edited(std::optional<double> value, bool stepping);
    /// No more steps of the same stroke will follow.
    void strokeEnded();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// The text's value; of a text that shows the value, that one with all its digits.
    std::optional<double> read(QString* complaint) const;
    void commit();
    void step(double steps);
    void restoreText();
    void updateMarks();

    Quantity quantity_;
    std::optional<double> value_;
    std::optional<double> derived_;
    bool optional_ = false;
    bool stepped_ = false;
    QString help_;
    QString complaint_;     ///< why what was typed cannot be read
    QStringList sentences_; ///< from validate()
    std::optional<Severity> severity_;
    QAction* mark_ = nullptr;
};

} // namespace hygroloom
