// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/run_questions.h"

#include "ui/basics/ask.h"
#include "ui/basics/quantity.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace hygroloom {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("hygroloom", text); }

} // namespace

bool wantsBeyondMemory(QWidget* parent, const QString& sentence)
{
    return confirm(parent, tr("The run needs more memory than is free"), sentence,
                   tr("Without enough memory the computer becomes slow, or ends the program; what is not saved is lost then."),
                   tr("&Run All the Same"));
}

QString memoryWarning() { return tr("This run takes most of the memory that is free. Other programs may slow down."); }

bool wantsStoppedRun(QWidget* parent, const QString& recording)
{
    const QString size = bytesText(static_cast<double>(QFileInfo(recording).size()));
    return ask(parent, {tr("The run was stopped"),
                        tr("Keep what it recorded?"),
                        tr("The recording takes %1 on the disk. If you discard it, its results leave the screen.").arg(size),
                        {{Reply::act, tr("&Keep")}, {Reply::lose, tr("&Discard")}},
                        Reply::act}) != Reply::lose;
}

} // namespace hygroloom
