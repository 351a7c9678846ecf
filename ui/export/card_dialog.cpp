// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/export/card_dialog.h"

#include "ui/basics/ask.h"
#include "ui/basics/core_words.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/results/report_file.h"

#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace hygroloom {
namespace {

enum Column { title_column, value_column, range_column, unit_column, standard_column, run_column, columns };

QString words(const std::string& text) { return QString::fromStdString(text); }

} // namespace

CardDialog::CardDialog(Document& document, WindowQueue& queue, QWidget* parent)
    : QDialog(parent), document_(document), numbers_(document, queue), file_(document, this), fabric_(new QLabel),
      table_(new QTableWidget(0, columns)), notes_(new QLabel), message_(new QLabel), progress_(new QProgressBar), start_(new QPushButton),
      save_(new QPushButton(tr("&Save Card…")))
{
    setWindowTitle(tr("Technical Card"));
    arrange();
    connect(&numbers_, &CardNumbers::changed, this, &CardDialog::refresh);
    connect(&numbers_, &CardNumbers::progressed, this, [this](double share) { progress_->setValue(static_cast<int>(1000 * share)); });
    connect(&numbers_, &CardNumbers::failed, &file_, &CardExport::failed);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &CardDialog::refresh);
    connect(start_, &QPushButton::clicked, this, &CardDialog::startOrCancel);
    connect(save_, &QPushButton::clicked, this, [this] { file_.save(numbers_.card()); });
    refresh();
    resize(900, 640);
}

void CardDialog::arrange()
{
    fabric_->setTextFormat(Qt::PlainText);
    table_->setHorizontalHeaderLabels({tr("number"), tr("value"), tr("range"), tr("unit"), tr("standard"), tr("run")});
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->setAccessibleName(tr("Numbers of the card"));
    notes_->setTextFormat(Qt::PlainText);
    notes_->setWordWrap(true);
    notes_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    notes_->setAccessibleName(tr("Notes of the card"));
    message_->setTextFormat(Qt::PlainText);
    message_->setWordWrap(true);
    progress_->setRange(0, 1000);
    progress_->setAccessibleName(tr("Progress of the runs"));
    QSizePolicy stays = progress_->sizePolicy();
    stays.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(stays);
    auto* close = new QPushButton(tr("Close"));
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    start_->setToolTip("<p>" +
                       tr("Runs absorbency, wicking, moisture management, drying and regain at the fidelity live, in the background. Takes "
                          "a minute or two.") +
                       "</p>");
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(start_);
    buttons->addWidget(progress_, 1);
    buttons->addWidget(save_);
    buttons->addWidget(close);
    auto* all = new QVBoxLayout(this);
    all->addWidget(fabric_);
    all->addWidget(table_, 1);
    all->addWidget(notes_);
    all->addWidget(message_);
    all->addLayout(buttons);
}

void CardDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    numbers_.follow(true);
}

void CardDialog::hideEvent(QHideEvent* event)
{
    QDialog::hideEvent(event);
    if (!event->spontaneous()) { numbers_.follow(false); }
}

QString CardDialog::message() const { return message_->text(); }

void CardDialog::startOrCancel()
{
    if (numbers_.running()) {
        numbers_.cancel();
    } else if (numbers_.canRun()) {
        progress_->setValue(0);
        numbers_.run();
    }
}

QString CardDialog::state() const
{
    if (!document_.fabric()) { return tr("The project has no fabric."); }
    if (!document_.fitted()) { return tr("The fabric has errors; see Issues. Mend them first."); }
    if (!numbers_.card()) { return tr("The numbers are being computed."); }
    if (numbers_.paused()) { return tr("The tests are paused. The queue of runs, below in the main window, lets them go on."); }
    return numbers_.canRun() ? tr("Numbers in grey need runs.") : QString();
}

/// What the page says below its numbers, in its language.
QString CardDialog::notes() const
{
    if (!numbers_.card()) { return {}; }
    QStringList lines;
    for (const std::string& sentence : sentences_below(*numbers_.card())) { lines << words(sentence); }
    return lines.join('\n');
}

bool CardDialog::agreesToStopTests(QWidget* window) const
{
    return !numbers_.running() ||
           confirm(window, tr("Tests are in progress"), tr("Stop the tests of the technical card?"),
                   tr("Numbers of tests that have ended are lost, too, unless the card is saved."), tr("Stop the Tests"));
}

void CardDialog::refresh()
{
    fabric_->setText(document_.fabric() ? words(document_.fabric()->name) : QString());
    const std::vector<CardNumbers::Row> rows = numbers_.rows();
    const std::vector<PageRow> construction =
        numbers_.card() ? construction_rows(*numbers_.card(), unitsOfReader()) : std::vector<PageRow>();
    const int above = static_cast<int>(construction.size());
    table_->setRowCount(above + static_cast<int>(rows.size()));
    for (int i = 0; i < above; ++i) { fillConstruction(i, construction[static_cast<std::size_t>(i)]); }
    for (std::size_t i = 0; i < rows.size(); ++i) { fillRow(above + static_cast<int>(i), rows[i]); }
    notes_->setText(notes());
    notes_->setVisible(!notes_->text().isEmpty());
    message_->setText(state());
    progress_->setVisible(numbers_.running());
    start_->setText(numbers_.running() ? tr("&Cancel") : tr("&Run the Tests"));
    start_->setEnabled(numbers_.running() || numbers_.canRun());
    save_->setEnabled(numbers_.card() != nullptr);
}

void CardDialog::fillConstruction(int row, const PageRow& of)
{
    const QString number = words(of[1].text).replace('.', QLocale().decimalPoint());
    const QStringList texts{coreWord(of[0].text), number, {}, words(of[2].text), of.size() > 3 ? words(of[3].text) : QString(), {}};
    for (int column = 0; column < columns; ++column) {
        auto* item = new QTableWidgetItem(texts[column]);
        if (column == value_column) { item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter); }
        table_->setItem(row, column, item);
    }
}

void CardDialog::fillRow(int row, const CardNumbers::Row& of)
{
    const LaboratoryNumber seen = in_units(of.number, unitsOfReader());
    const QLocale locale;
    const auto shown = [&locale](const std::string& text) { return words(text).replace('.', locale.decimalPoint()); };
    const QString grade = seen.grade > 0 ? " " + tr("(grade %1)").arg(seen.grade) : QString();
    const QString value = !of.known ? QStringLiteral("…") : seen.text.empty() ? shown(value_text(seen)) + grade : coreWord(seen.text);
    QString range;
    if (of.known && seen.estimate.low < seen.estimate.high) {
        range = tr("%1 to %2").arg(significant(seen.estimate.low), significant(seen.estimate.high));
    }
    const QStringList texts{coreWord(seen.title), value, range, words(seen.unit), words(seen.standard), words(seen.run)};
    for (int column = 0; column < columns; ++column) {
        auto* item = new QTableWidgetItem(texts[column]);
        item->setToolTip(words(seen.conditions));
        if (!of.known) { item->setForeground(palette().brush(QPalette::Disabled, QPalette::Text)); }
        if (column == value_column || column == range_column) { item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter); }
        table_->setItem(row, column, item);
    }
}

} // namespace hygroloom
