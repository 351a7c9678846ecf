// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The start page, the preferences, and the room that runs take.
#include "ui/basics/ask.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/panels/start_page.h"
#include "ui/results/run_history.h"
#include "ui/window/examples.h"
#include "ui/window/main_window.h"
#include "ui/window/preferences_dialog.h"

#include <QDir>
#include <QScopedValueRollback>
#include <QSettings>

namespace hygroloom {

void MainWindow::showStartPage()
{
    if (start_page_) {
        start_page_->raise();
        start_page_->activateWindow();
        return;
    }
    QStringList examples;
    if (const QDir folder(examplesFolder()); !examplesFolder().isEmpty()) {
        for (const QString& file : folder.entryList({"*.hygro"}, QDir::Files, QDir::Name)) { examples << folder.filePath(file); }
    }
    start_page_ = new StartPage(examples, QSettings().value("recent").toStringList(), this);
    start_page_->setAttribute(Qt::WA_DeleteOnClose);
    connect(start_page_, &StartPage::newWanted, this, &MainWindow::newProject);
    connect(start_page_, &StartPage::openWanted, this, &MainWindow::chooseFile);
    connect(start_page_, &StartPage::guideWanted, this, &MainWindow::showGuide);
    connect(start_page_, &StartPage::exampleChosen, this, &MainWindow::openExample);
    connect(start_page_, &StartPage::fileChosen, this, &MainWindow::openFile);
    connect(start_page_, &StartPage::presetChosen, this, &MainWindow::newProjectOf);
    start_page_->open();
}

void MainWindow::showPreferences()
{
    if (!preferences_) {
        preferences_ = new PreferencesDialog(this);
        preferences_->setAttribute(Qt::WA_DeleteOnClose);
    }
    preferences_->show();
    preferences_->raise();
    preferences_->activateWindow();
}

void MainWindow::offerRoom()
{
    ProjectRuns& runs = compare_->project();
    const int most = preferences().runs_gigabytes;
    const QStringList oldest = runs.beyond(1e9 * most);
    if (oldest.isEmpty() || asking_room_ || closing_) { return; }
    const QScopedValueRollback asking(asking_room_, true);
    constexpr int named = 6;
    QStringList lines;
    double bytes = 0;
    for (const QString& path : oldest) {
        const KeptRun* run = compare_->runs().find(path);
        bytes += static_cast<double>(QFileInfo(path).size());
        if (lines.size() < named) { lines << (run ? runInWords(*run) : QFileInfo(path).fileName()); }
    }
    if (oldest.size() > named) { lines << tr("and %1 more").arg(oldest.size() - named); }
    const QString question = tr("The runs of this project take more than %1 GB. Delete the oldest that are not marked Keep?").arg(most);
    const QString consequence =
        tr("This frees %1. Edit ▸ Preferences ▸ Runs sets how much room runs may take.").arg(bytesText(bytes)) + "\n\n" + lines.join('\n');
    const QString button = oldest.size() == 1 ? tr("&Delete the Run") : tr("&Delete the Runs");
    if (!confirm(this, tr("Runs take much room"), question, consequence, button)) { return; }
    for (const QString& path : oldest) { runs.forget(path); }
}

} // namespace hygroloom
