// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/quantity_edit.h"

#include "ui/basics/appearance.h"
#include "ui/basics/design_undo.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/preferences.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QMetaMethod>
#include <QPainter>
#include <QStatusTipEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace hygroloom {

QuantityEdit::QuantityEdit(Quantity quantity, QWidget* parent) : QLineEdit(parent), quantity_(std::move(quantity))
{
    new DesignUndo(this);
    mark_ = addAction(themedIcon("warning"), QLineEdit::TrailingPosition);
    mark_->setVisible(false);
    connect(mark_, &QAction::triggered, this, [this] { QToolTip::showText(mapToGlobal(QPoint(0, height())), toolTip(), this); });
    connect(this, &QLineEdit::textEdited, this, [this] { complain({}); });
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, [this] {
        if (quantity_.measure == Measure::other) { return; }
        if (!isModified()) { restoreText(); }
        if (derived_) { setDerived(derived_); }
        updateMarks();
    });
    updateMarks();
}

std::optional<double> QuantityEdit::read(QString* complaint) const
{
    return value_ && text() == textOf(*value_) ? value_ : parse(text(), complaint);
}

std::optional<double> QuantityEdit::typed(QString* complaint) const
{
    if (optional_ && text().trimmed().isEmpty()) { return {}; }
    const std::optional<double> value = read(complaint);
    if (value && (*value < quantity_.minimum || *value > quantity_.maximum)) {
        if (complaint) { *complaint = tr("%1 is out of range. %2").arg(text().trimmed(), quantity_.range()); }
        return {};
    }
    return value;
}

void QuantityEdit::setValue(std::optional<double> value)
{
    const bool stays = value == value_ && isModified() && (hasFocus() || !complaint_.isEmpty());
    value_ = value;
    if (!stays) { restoreText(); }
}

void QuantityEdit::setOptional(bool optional)
{
    optional_ = optional;
    setPlaceholderText(optional ? tr("auto") : QString());
}

void QuantityEdit::setRange(double minimum, double maximum)
{
    quantity_.minimum = minimum;
    quantity_.maximum = maximum;
    updateMarks();
}

void QuantityEdit::setDerived(std::optional<double> derived)
{
    derived_ = derived;
    setPlaceholderText(derived ? tr("auto %1").arg(shortTextOf(*derived)) : tr("auto"));
    updateMarks();
}

void QuantityEdit::setIssues(const std::vector<const Issue*>& issues)
{
    sentences_.clear();
    severity_.reset();
    for (const Issue* issue : issues) {
        sentences_ << issueText(*issue);
        severity_ = severity_ ? std::max(*severity_, issue->severity) : issue->severity;
    }
    updateMarks();
}

void QuantityEdit::setHelp(const QString& sentence)
{
    help_ = sentence;
    updateMarks();
}

QSize QuantityEdit::sizeHint() const { return {fontMetrics().horizontalAdvance("0000.000 /cm") + 24, QLineEdit::sizeHint().height()}; }

QSize QuantityEdit::minimumSizeHint() const
{
    return {fontMetrics().horizontalAdvance("auto 0.000 mm") + 16, QLineEdit::minimumSizeHint().height()};
}

void QuantityEdit::keyPressEvent(QKeyEvent* event)
{
    const double size = event->modifiers() & Qt::ShiftModifier ? 10 : event->modifiers() & Qt::ControlModifier ? 0.1 : 1;
    switch (event->key()) {
    case Qt::Key_Up: step(size); return;
    case Qt::Key_Down: step(-size); return;
    case Qt::Key_PageUp: step(10); return;
    case Qt::Key_PageDown: step(-10); return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        commit();
        selectAll();
        return;
    case Qt::Key_Escape:
        if (isModified() || !complaint_.isEmpty()) {
            restoreText();
            selectAll();
            return;
        }
        break;
    default: break;
    }
    QLineEdit::keyPressEvent(event);
}

void QuantityEdit::wheelEvent(QWheelEvent* event)
{
    // Only a focused field: a wheel over a panel is for scrolling it.
    if (!hasFocus() || event->angleDelta().y() == 0) {
        event->ignore();
        return;
    }
    step(event->angleDelta().y() > 0 ? 1 : -1);
    event->accept();
}

void QuantityEdit::focusInEvent(QFocusEvent* event)
{
    QLineEdit::focusInEvent(event);
    if (event->reason() != Qt::MouseFocusReason) { selectAll(); }
    QStatusTipEvent tip(quantity_.range());
    QApplication::sendEvent(this, &tip);
}

void QuantityEdit::focusOutEvent(QFocusEvent* event)
{
    commit();
    if (std::exchange(stepped_, false)) { Q_EMIT strokeEnded(); }
    QStatusTipEvent tip{QString()};
    QApplication::sendEvent(this, &tip);
    QLineEdit::focusOutEvent(event);
}

void QuantityEdit::paintEvent(QPaintEvent* event)
{
    QLineEdit::paintEvent(event);
    if (complaint_.isEmpty() && !severity_) { return; }
    const Severity severity = complaint_.isEmpty() ? *severity_ : Severity::error;
    QPainter painter(this);
    painter.fillRect(QRect(2, height() - 3, width() - 4, 2), severityColor(severity, palette()));
}

void QuantityEdit::commit()
{
    if (!isModified()) { return; }
    QString why;
    const std::optional<double> wanted = typed(&why);
    complain(why);
    if (!why.isEmpty()) { return; }
    const bool changed = differs(wanted);
    value_ = wanted;
    restoreText();
    if (changed) {
        Q_EMIT strokeEnded();
        Q_EMIT edited(value_, false);
    }
}

void QuantityEdit::complain(const QString& sentence)
{
    const bool news = sentence != complaint_;
    complaint_ = sentence;
    updateMarks();
    if (isSignalConnected(QMetaMethod::fromSignal(&QuantityEdit::complained))) {
        if (news) { Q_EMIT complained(); }
    } else if (!sentence.isEmpty()) {
        QToolTip::showText(mapToGlobal(QPoint(0, height())), "<p>" + sentence.toHtmlEscaped() + "</p>", this);
    }
}

void QuantityEdit::step(double steps)
{
    commit();
    const std::optional<double> from = value_ ? value_ : derived_;
    if (isReadOnly() || !isEnabled() || !from) { return; }
    const double stepped = next(*from, quantity_.decimals == 0 && std::abs(steps) < 1 ? (steps > 0 ? 1 : -1) : steps);
    if (value_ && stepped == *value_) { return; }
    value_ = stepped;
    stepped_ = true;
    restoreText();
    selectAll();
    Q_EMIT edited(value_, true);
}

void QuantityEdit::restoreText()
{
    setText(value_ ? textOf(*value_) : QString());
    setModified(false);
    setCursorPosition(0);
    complain({});
}

void QuantityEdit::updateMarks()
{
    const bool marked = !complaint_.isEmpty() || severity_;
    const Severity severity = complaint_.isEmpty() ? severity_.value_or(Severity::note) : Severity::error;
    mark_->setVisible(marked);
    mark_->setIcon(severityIcon(severity));
    QStringList lines;
    if (!complaint_.isEmpty()) { lines << complaint_; }
    lines << sentences_;
    if (!help_.isEmpty()) { lines << help_; }
    if (value_ && quantity_.shortens(*value_)) { lines << tr("In full: %1.").arg(quantity_.fullText(*value_)); }
    if (derived_ && !value_) { lines << tr("Calculated: %1.").arg(quantity_.fullText(*derived_)); }
    lines << quantity_.range();
    setAccessibleDescription(lines.join(' '));
    // Rich text, so that long sentences wrap.
    std::transform(lines.begin(), lines.end(), lines.begin(), [](const QString& line) { return line.toHtmlEscaped(); });
    setToolTip("<p>" + lines.join("</p><p>") + "</p>");
    update();
}

} // namespace hygroloom
