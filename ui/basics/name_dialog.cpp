// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/name_dialog.h"

#include "ui/basics/appearance.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace hygroloom {

NameDialog::NameDialog(const QString& title, const QString& now, WhyNot why_not, QWidget* parent)
    : QDialog(parent), why_not_(std::move(why_not)), field_(new QLineEdit(now)), complaint_(new QLabel)
{
    setWindowTitle(title);
    field_->selectAll();
    field_->setMinimumWidth(field_->fontMetrics().horizontalAdvance('m') * 24);
    field_->setAccessibleName(tr("Name"));
    complaint_->setWordWrap(true);
    complaint_->setTextFormat(Qt::PlainText);
    complaint_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    complaint_->setMinimumHeight(2 * complaint_->fontMetrics().lineSpacing()); // nothing moves when it speaks
    complaint_->setAccessibleName(tr("Why the name cannot be taken"));
    QPalette colors = complaint_->palette();
    colors.setColor(QPalette::WindowText, severityColor(Severity::error, colors));
    complaint_->setPalette(colors);
    auto* form = new QFormLayout;
    auto* label = new QLabel(tr("&Name"));
    label->setBuddy(field_);
    form->addRow(label, field_);
    form->addRow(QString(), complaint_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &NameDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(field_, &QLineEdit::textChanged, this, [this] { check(false); });
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(buttons);
}

QString NameDialog::name() const { return field_->text().trimmed(); }

QString NameDialog::complaint() const { return complaint_->text(); }

/// While one types, an empty field is no mistake yet.
void NameDialog::check(bool also_empty)
{
    const QString why = name().isEmpty() && !also_empty ? QString() : why_not_(name());
    complaint_->setText(why);
    field_->setAccessibleDescription(why);
}

void NameDialog::accept()
{
    check(true);
    if (complaint().isEmpty()) {
        QDialog::accept();
    } else {
        field_->setFocus();
    }
}

} // namespace hygroloom
