// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/steps_dialog.h"

#include "core/base/error.h"
#include "ui/basics/appearance.h"
#include "ui/garment/fields.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace hygroloom {

namespace {

constexpr std::array<WearValue, 2> kinds{WearValue::water, WearValue::share};

} // namespace

StepsDialog::StepsDialog(WearPlayback& playback, QWidget* parent)
    : QDialog(parent), playback_(playback), pages_(new QStackedWidget), complaint_(new QLabel), reset_(new QPushButton(tr("&Reset")))
{
    setWindowTitle(tr("Steps of the Colours"));
    for (const WearValue kind : kinds) { pages_->addWidget(makePage(kind)); }
    complaint_->setWordWrap(true);
    complaint_->setTextFormat(Qt::PlainText);
    complaint_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    complaint_->setMinimumHeight(3 * complaint_->fontMetrics().lineSpacing()); // nothing moves when it speaks
    complaint_->setAccessibleName(tr("Why the ends are not in use"));
    QPalette colors = complaint_->palette();
    colors.setColor(QPalette::WindowText, severityColor(Severity::error, colors));
    complaint_->setPalette(colors);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(reset_, QDialogButtonBox::ResetRole);
    reset_->setToolTip(tr("Even steps again, up to the end of the scale."));
    reset_->setAutoDefault(false);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false); // Enter commits a field
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(reset_, &QPushButton::clicked, this, &StepsDialog::reset);
    connect(&playback_, &WearPlayback::scaleChanged, this, &StepsDialog::refresh);
    connect(&playback_, &WearPlayback::runChanged, this, &StepsDialog::refresh);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(pages_);
    layout->addWidget(complaint_);
    layout->addWidget(buttons);
    refresh();
}

QWidget* StepsDialog::makePage(WearValue value)
{
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(0, 0, 0, 0);
    auto& ends = ends_[static_cast<std::size_t>(value)];
    for (std::size_t step = ends.size(); step-- > 0;) {
        const int row = static_cast<int>(ends.size() - 1 - step);
        const auto color = step_colour(step);
        auto* square = new QLabel;
        square->setPixmap(colorIcon(QColor(color[0], color[1], color[2])).pixmap(14, 14));
        ends[step] = new QuantityEdit(value == WearValue::water ? Quantity::arealDensity(100000) : Quantity::percent(0, 100));
        ends[step]->setAccessibleName(tr("End of step %1").arg(step + 1));
        auto* label = new QLabel(tr("Step %1 ends at").arg(step + 1));
        label->setBuddy(ends[step]);
        grid->addWidget(square, row, 0);
        grid->addWidget(label, row, 1);
        grid->addWidget(ends[step], row, 2);
        connect(ends[step], &QuantityEdit::edited, this, &StepsDialog::apply);
    }
    grid->setColumnStretch(2, 1);
    for (std::size_t step = ends.size(); step-- > 1;) { QWidget::setTabOrder(ends[step], ends[step - 1]); }
    return page;
}

QString StepsDialog::complaint() const { return complaint_->text(); }

/// Fields keep what was typed until all of it ascends.
void StepsDialog::apply()
{
    WearSteps steps;
    for (std::size_t step = 0; step < steps.size(); ++step) { steps[step] = end(step).value().value_or(0); }
    QString why;
    for (std::size_t step = 0; why.isEmpty() && step < steps.size(); ++step) {
        if (steps[step] > (step > 0 ? steps[step - 1] : 0)) { continue; }
        const Quantity& quantity = end(step).quantity();
        why = step == 0 ? tr("Step 1 must end above 0.")
                        : tr("Step %1 ends at %2; it must end above %3, where step %4 ends.")
                              .arg(step + 1)
                              .arg(quantity.text(steps[step]), quantity.text(steps[step - 1]))
                              .arg(step);
    }
    complaint_->setText(why);
    if (why.isEmpty()) { playback_.setSteps(playback_.value(), steps); }
    reset_->setEnabled(playback_.ownSteps() || !why.isEmpty());
}

void StepsDialog::reset()
{
    complaint_->clear();
    playback_.setSteps(playback_.value(), std::nullopt);
    refresh();
}

void StepsDialog::refresh()
{
    const auto page = static_cast<int>(playback_.value());
    if (page != pages_->currentIndex()) { complaint_->clear(); }
    pages_->setCurrentIndex(page);
    if (!complaint().isEmpty()) { return; } // what is to be corrected stays
    const WearSteps steps = playback_.steps();
    for (std::size_t step = 0; step < steps.size(); ++step) { end(step).setValue(steps[step]); }
    reset_->setEnabled(playback_.ownSteps().has_value());
}

} // namespace hygroloom
