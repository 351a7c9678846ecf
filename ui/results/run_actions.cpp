// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/run_actions.h"

#include "ui/basics/ask.h"
#include "ui/basics/quantity.h"
#include "ui/document/run_folder.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <iterator>

namespace hygroloom {

RunActions::RunActions(const RunHistory& history, QWidget* parent)
    : QWidget(parent), history_(history), keep_(new QPushButton(tr("&Keep"))), forget_(new QPushButton(tr("For&get…"))),
      older_(new QPushButton(tr("Forget &Older…"))), room_(new QLabel)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 4);
    keep_->setCheckable(true);
    keep_->setToolTip(tr("Mark the selected run: Forget Older leaves it."));
    forget_->setToolTip(tr("Delete the selected run's recording, after a question. A recording that was opened only leaves the list."));
    older_->setToolTip(tr("Delete the runs of older designs that are not marked with Keep, after a question."));
    layout->setSpacing(4);
    for (QPushButton* button : {keep_, forget_, older_}) { // as narrow as their words, to leave room for the size
        button->setMaximumWidth(button->fontMetrics().horizontalAdvance(button->text()) + 28);
        layout->addWidget(button);
    }
    room_->setForegroundRole(QPalette::PlaceholderText);
    room_->setAccessibleName(tr("Size of the project's runs"));
    room_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    room_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // more runs make no dock wider
    layout->addWidget(room_, 1);
    connect(keep_, &QPushButton::clicked, this, [this](bool on) { Q_EMIT markRequested(path_, on); });
    connect(forget_, &QPushButton::clicked, this, &RunActions::forget);
    connect(older_, &QPushButton::clicked, this, &RunActions::forgetOlder);
    connect(&history_, &RunHistory::changed, this, &RunActions::refresh);
    refresh();
}

void RunActions::setRun(const QString& path)
{
    path_ = path;
    refresh();
}

void RunActions::refresh()
{
    const KeptRun* run = history_.find(path_);
    keep_->setEnabled(run && run->own);
    keep_->setChecked(run && run->marked);
    forget_->setEnabled(run);
    older_->setEnabled(!older().empty());
    double bytes = 0;
    int own = 0;
    for (const KeptRun& each : history_.runs()) {
        bytes += each.own ? each.bytes : 0;
        own += each.own;
    }
    room_->setText(own == 0   ? QString()
                   : own == 1 ? tr("1 run, %1").arg(bytesText(bytes))
                              : tr("%1 runs, %2").arg(own).arg(bytesText(bytes)));
    room_->setToolTip(room_->text());
}

std::vector<KeptRun> RunActions::older() const
{
    std::vector<KeptRun> found;
    const auto& runs = history_.runs();
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(found),
                 [](const KeptRun& run) { return run.own && !run.current && !run.marked; });
    return found;
}

bool RunActions::mayDelete(const std::vector<KeptRun>& runs)
{
    QStringList names;
    double bytes = 0;
    for (const KeptRun& run : runs) {
        names << runInWords(run);
        bytes += run.bytes;
    }
    const QString question =
        runs.size() == 1 ? tr("Forget this run?") : tr("Forget these %1 runs, %2?").arg(runs.size()).arg(bytesText(bytes));
    const QString lost = runs.size() == 1 ? tr("Its recording is deleted.") : tr("Their recordings are deleted.");
    return ask(this, {tr("Forget runs"),
                      question,
                      names.join('\n') + "\n\n" + lost,
                      {{Reply::lose, tr("&Forget")}, {Reply::cancel, tr("Cancel")}}}) == Reply::lose;
}

void RunActions::forget()
{
    const KeptRun* run = history_.find(path_);
    if (!run) { return; }
    const QString path = path_; // selects another meanwhile
    if (!run->own || mayDelete({*run})) { Q_EMIT forgetRequested(path); }
}

void RunActions::forgetOlder()
{
    const std::vector<KeptRun> runs = older();
    if (!runs.empty() && mayDelete(runs)) {
        for (const KeptRun& run : runs) {
            if (!isMarked(run.path)) { Q_EMIT forgetRequested(run.path); } // another window may have marked it
        }
    }
}

} // namespace hygroloom
