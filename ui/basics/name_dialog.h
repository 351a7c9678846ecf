// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Asks for a name; one that cannot be taken stays in the field, with the reason under it.
#pragma once

#include <QDialog>

#include <functional>

class QLabel;
class QLineEdit;

namespace hygroloom {

class NameDialog : public QDialog {
    Q_OBJECT
public:
    /// Why a name cannot be taken, in a sentence; empty: it can.
    using WhyNot = std::function<QString(const QString& name)>;

    NameDialog(const QString& title, const QString& now, WhyNot why_not, QWidget* parent);

    /// Without spaces around it.
    QString name() const;
    /// The sentence under the field.
    QString complaint() const;
    void accept() override;

private:
    void check(bool also_empty);

    WhyNot why_not_;
    QLineEdit* field_;
    QLabel* complaint_;
};

} // namespace hygroloom
