// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A field for a yarn's count as the trade writes it: "Ne 60/2", "150/48 den".
#pragma once

#include "core/design/yarn_count.h"
#include "ui/basics/quantity_edit.h"

namespace hygroloom {

/// Its value is the whole yarn's linear density in tex; count() says plies and filaments, too.
class CountEdit : public QuantityEdit {
    Q_OBJECT
public:
    explicit CountEdit(QWidget* parent = nullptr);

    /// Shows the yarn's count; empty where it has none of its own.
    void setYarn(const Yarn& yarn);
    /// The count in another system that the trade uses.
    QString otherSystem(double tex) const;
    /// What was typed last, or stepped to.
    YarnCount count() const;

protected:
    std::optional<double> parse(const QString& typed, QString* complaint) const override;
    QString textOf(double tex) const override;
    QString shortTextOf(double tex) const override { return textOf(tex); }
    double next(double tex, double steps) const override;
    bool differs(std::optional<double> typed) const override;

private:
    int plies_ = 1;
    std::optional<int> filaments_;
    mutable std::optional<YarnCount> typed_;
};

} // namespace hygroloom
