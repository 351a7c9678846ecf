// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the chosen fabric's weave is like: floats, balance, interlacings, how near the sett is to its limit, and what is wrong with it.
#pragma once

#include "ui/document/document.h"

#include <QScrollArea>

class QLabel;

namespace hygroloom {

/// A bar that fills to a share of a limit, where looms stop, which a line marks.
class LimitGauge : public QWidget {
    Q_OBJECT
public:
    explicit LimitGauge(QWidget* parent = nullptr);

    /// Negative when it is not known.
    void setPercent(double percent);
    double percent() const { return percent_; }
    QSize sizeHint() const override { return {80, 8}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double percent_ = -1;
};

/// Always as high: what lies above keeps its place while it is drawn on. More sentences than fit are scrolled.
class WeaveNotes : public QScrollArea {
    Q_OBJECT
public:
    explicit WeaveNotes(Document& document, QWidget* parent = nullptr);

    /// All sentences, as a reader sees them.
    QString text() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void fixHeight();
    void refresh();
    void refreshGauge();

    Document& document_;
    std::optional<Weave> shown_;
    QLabel* facts_;
    QLabel* sett_;
    LimitGauge* gauge_;
    QLabel* warnings_;
};

} // namespace hygroloom
