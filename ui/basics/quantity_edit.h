// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A field for one number with its unit.
#pragma once

#include "core/design/validate.h"
#include "ui/basics/quantity.h"

#include <QLineEdit>

class QAction;

namespace hygroloom {

/// Enter or leaving the field commits what may stand there; what may not stays typed, with the reason, and nobody is told a value.
/// Escape takes back what was typed, arrow keys and the wheel step (Shift: ten steps, Ctrl: a tenth).
/// An optional quantity may be emptied; the placeholder then says what stands in for it.
class QuantityEdit : public QLineEdit {
    Q_OBJECT
public:
    explicit QuantityEdit(Quantity quantity, QWidget* parent = nullptr);

    const Quantity& quantity() const { return quantity_; }
    std::optional<double> value() const { return value_; }
    /// What the text says, committed or not. Without a value, complaint says why; nothing where the field may be empty and is.
    std::optional<double> typed(QString* complaint) const;
    /// Shows a value without telling anyone; text being typed stays, and text that was refused.
    void setValue(std::optional<double> value);
    /// Shows the value in place of what was typed.
    void takeBack() { restoreText(); }
    /// Why what was typed is refused; empty where it is not.
    const QString& complaint() const { return complaint_; }
    void setOptional(bool optional);
    /// Of the values that are allowed, stored unit.
    void setRange(double minimum, double maximum);
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
    /// What was typed is refused for complaint(), or no longer. Where nobody listens, the field says it itself.
    void complained();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

    /// The stored value of a text, or why it cannot be read.
    virtual std::optional<double> parse(const QString& typed, QString* complaint) const { return quantity_.parse(typed, complaint); }
    virtual QString textOf(double value) const { return quantity_.text(value); }
    virtual QString shortTextOf(double derived) const { return quantity_.shortText(derived); }
    virtual double next(double value, double steps) const { return quantity_.stepped(value, steps); }
    /// Whether what was typed says something else than what is shown.
    virtual bool differs(std::optional<double> typed) const { return typed != value_; }

private:
    /// The text's value; of a text that shows the value, that one with all its digits.
    std::optional<double> read(QString* complaint) const;
    void commit();
    void complain(const QString& sentence);
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
