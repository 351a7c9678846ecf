// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/study_page.h"

#include "core/base/error.h"
#include "core/study/study_folder.h"
#include "core/wear/worn_candidate.h"
#include "ui/basics/appearance.h"
#include "ui/basics/ask.h"
#include "ui/document/document.h"
#include "ui/study/cluster_dialog.h"
#include "ui/study/effects_view.h"
#include "ui/study/indices_view.h"
#include "ui/study/pairs_view.h"
#include "ui/study/parallel_view.h"
#include "ui/study/study_setup.h"
#include "ui/study/study_table.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QTableView>

namespace hygroloom {

namespace {

constexpr const char* recent_setting = "study/recent";
constexpr int most_recent = 8;
constexpr qsizetype most_problems = 4;

} // namespace

StudyPage::StudyPage(Document& document, WindowQueue& queue, QWidget* parent)
    : QWidget(parent), document_(document), setup_(new StudySetup(document)), model_(new StudyTableModel(this)), effects_(new EffectsView),
      pairs_(new PairsView), parallel_(new ParallelView), indices_(new IndicesView), saved_(setup_->study()), name_(new QLabel),
      problems_(new QLabel), cost_(new QLabel), folder_(new QComboBox), run_(new QPushButton(tr("&Run"))),
      stop_(new QPushButton(tr("S&top"))), retry_(new QPushButton(tr("Run the &Failed Again"))),
      cluster_(new QPushButton(tr("For a C&luster…"))), failures_(new QPushButton(tr("&Why They Failed…"))), heading_(new QLabel),
      row_(new QLabel), candidate_(new QPushButton(tr("&Make Candidate"))), view_(new QTableView), tabs_(new QTabWidget),
      bar_(new QProgressBar), status_(new QLabel), job_(queue)
{
    for (QLabel* label : {problems_, cost_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    problems_->setAccessibleName(tr("What is wrong with the study"));
    cost_->setAccessibleName(tr("What the study will cost"));
    status_->setAccessibleName(tr("State of the study"));
    build();
    showRecent();
    connectParts();
    showResults(nullptr);
    refreshSetup();
    refreshRun();
}

StudyPage::~StudyPage() { job_.disconnect(this); }

QString StudyPage::cost() const { return cost_->text(); }
QString StudyPage::status() const { return status_->text(); }
QImage StudyPage::picture() const { return tabs_->currentWidget()->grab().toImage(); }
QString StudyPage::folder() const { return QDir::cleanPath(folder_->currentText().trimmed()); }
void StudyPage::setFolder(const QString& folder) { folder_->setEditText(folder); }
/// A study without factors that was never saved is none yet.
bool StudyPage::modified() const
{
    const Study study = setup_->study();
    return !(study == saved_) && !(path_.isEmpty() && study.factors.empty());
}

void StudyPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refreshSetup();
}

void StudyPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && isVisible()) { refreshSetup(); } // the red of the problems
}

void StudyPage::refreshSetup()
{
    const QString title = path_.isEmpty() ? tr("Unsaved study") : QFileInfo(path_).fileName();
    name_->setText(modified() ? tr("%1 (edited)").arg(title) : title);
    QStringList problems = setup_->problems();
    if (problems.size() > most_problems) {
        const qsizetype more = problems.size() - most_problems;
        problems = problems.mid(0, most_problems) << tr("and %1 more.").arg(more);
    }
    problems_->setText(problems.join('\n'));
    problems_->setVisible(!problems.isEmpty());
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, severityColor(Severity::error, palette()));
    problems_->setPalette(colors);
    const bool can = problems.isEmpty() && !job_.running() && !folder_->currentText().trimmed().isEmpty();
    run_->setEnabled(can);
    cluster_->setEnabled(can);
    cost_->setVisible(problems.isEmpty());
    foreteller_.drop();
    if (problems.isEmpty()) {
        cost_->setText(tr("The cost is being worked out."));
        pause_.start();
    }
}

std::shared_ptr<const Design> StudyPage::design() const
{
    if (document_.design()->garments.empty()) { return document_.design(); }
    return std::make_shared<const Design>(with_absolute_files(*document_.design(), document_.folder().toStdString()));
}

void StudyPage::foretell()
{
    if (!setup_->problems().isEmpty() || !isVisible()) { return; }
    foreteller_.run([this, design = this->design(), study = setup_->study()](const NewestJob::Turn& turn) {
        QString text;
        try {
            text = costText(foretellCost(*design, study, [&turn] { return turn.outdated(); }));
        } catch (const Error& error) {
            text = QString::fromStdString(error.what());
        }
        if (turn.outdated()) { return; }
        turn.deliver([this, text] {
            cost_->setText(text);
            Q_EMIT costForetold();
        });
    });
}

void StudyPage::newStudy()
{
    if (!mayDiscardStudy()) { return; }
    path_.clear();
    Study fresh;
    fresh.points = 64;
    fresh.fidelity = Fidelity::draft;
    setup_->setStudy(fresh);
    saved_ = setup_->study();
    refreshSetup();
}

void StudyPage::chooseStudy()
{
    if (!mayDiscardStudy()) { return; }
    const QString start = path_.isEmpty() ? document_.folder() : QFileInfo(path_).path();
    const QString chosen = QFileDialog::getOpenFileName(this, tr("Open Study"), start, tr("Studies (*.json);;All files (*)"));
    if (!chosen.isEmpty()) { openStudy(chosen); }
}

bool StudyPage::openStudy(const QString& path)
{
    try {
        setup_->setStudy(read_study(path.toStdString()));
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
        return false;
    }
    path_ = path;
    saved_ = setup_->study();
    refreshSetup();
    return true;
}

bool StudyPage::saveStudy(const QString& path)
{
    // What cannot be read again is not written: the file would be lost.
    const Study study = setup_->study();
    try {
        if (!setup_->problems().isEmpty()) { parse_study(format_study(study), path.toStdString()); }
        write_study(study, path.toStdString());
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
        return false;
    }
    path_ = path;
    saved_ = study;
    refreshSetup();
    Q_EMIT messageShown(tr("Saved %1.").arg(path));
    return true;
}

bool StudyPage::save(bool as)
{
    QString path = path_;
    if (as || path.isEmpty()) {
        const QString start = path.isEmpty() ? QDir(document_.folder()).filePath("study.json") : path;
        path = QFileDialog::getSaveFileName(this, tr("Save Study"), start, tr("Studies (*.json)"));
        if (path.isEmpty()) { return false; }
        if (QFileInfo(path).suffix().isEmpty()) { path += ".json"; }
    }
    return saveStudy(path);
}

bool StudyPage::mayDiscardStudy()
{
    if (!modified()) { return true; }
    const Reply answer = ask(this, {tr("The study is not saved"),
                                    tr("Save the changes to the study?"),
                                    tr("Otherwise they are lost."),
                                    {{Reply::save, tr("&Save")}, {Reply::lose, tr("&Discard the Changes")}, {Reply::cancel, tr("Cancel")}},
                                    Reply::save});
    return answer == Reply::lose || (answer == Reply::save && save(false));
}

bool StudyPage::agreesToLeave()
{
    if (job_.running() && !confirm(this, tr("A study is in progress"), tr("Stop the study?"),
                                   tr("%1. Those are kept in its folder.").arg(job_.progressText()), tr("Stop the Study"))) {
        return false;
    }
    return mayDiscardStudy();
}

/// Until it has ended, 0.2 s or so, the window is drawn, but takes no input.
void StudyPage::stopRun()
{
    if (!job_.running()) { return; }
    QEventLoop end;
    connect(&job_, &StudyTask::ended, &end, &QEventLoop::quit);
    job_.cancel();
    end.exec(QEventLoop::ExcludeUserInputEvents);
}

void StudyPage::chooseFolder()
{
    const QString start = folder_->currentText().isEmpty() ? document_.folder() : folder();
    QFileDialog dialog(this, tr("Folder for the Results"), start);
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
    if (dialog.exec() == QDialog::Accepted) { setFolder(dialog.selectedFiles().value(0)); }
}

void StudyPage::chooseResults()
{
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Open the Folder of a Study"), folder());
    if (!chosen.isEmpty()) { openResults(chosen); }
}

void StudyPage::showRecent()
{
    const QSignalBlocker quiet(folder_);
    const QString at = folder_->currentText();
    folder_->clear();
    folder_->addItems(QSettings().value(recent_setting).toStringList());
    folder_->setEditText(at);
    if (at.isEmpty()) { proposeFolder(); }
}

/// Beside the project, unless the user has chosen another.
void StudyPage::proposeFolder()
{
    if (folder_->currentText() != proposed_) { return; }
    const QString base = document_.path().isEmpty() ? document_.title() : QFileInfo(document_.path()).completeBaseName();
    const QString name = base.isEmpty() ? QString("study") : base + "-study";
    proposed_ = QDir(document_.folder().isEmpty() ? QDir::homePath() : document_.folder()).filePath(QString(name).replace(' ', '-'));
    folder_->setEditText(proposed_);
}

void StudyPage::remember(const QString& folder)
{
    QStringList recent = QSettings().value(recent_setting).toStringList();
    recent.removeAll(folder);
    recent.prepend(folder);
    QSettings().setValue(recent_setting, recent.mid(0, most_recent));
    showRecent();
}

void StudyPage::showCluster()
{
    ClusterDialog dialog(design(), setup_->study(), folder(), this);
    dialog.exec();
}

} // namespace hygroloom
