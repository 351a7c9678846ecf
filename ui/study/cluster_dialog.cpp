// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/cluster_dialog.h"

#include "core/base/error.h"
#include "core/study/slurm.h"

#include <QApplication>
#include <QBoxLayout>
#include <QCheckBox>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>

namespace hygroloom {

ClusterDialog::ClusterDialog(std::shared_ptr<const Design> design, Study study, const QString& folder, QWidget* parent)
    : QDialog(parent), design_(std::move(design)), study_(std::move(study)), folder_(folder), options_(new QLineEdit), tasks_(new QSpinBox),
      gpus_(new QCheckBox(tr("One &GPU for each task"))), command_(new QPlainTextEdit), write_(new QPushButton(tr("&Write the Folder"))),
      submit_(new QPushButton(tr("&Submit Here"))), said_(new QLabel)
{
    build();
    connect(options_, &QLineEdit::textChanged, this, &ClusterDialog::refresh);
    connect(tasks_, &QSpinBox::valueChanged, this, &ClusterDialog::refresh);
    connect(gpus_, &QCheckBox::toggled, this, &ClusterDialog::refresh);
    connect(write_, &QPushButton::clicked, this, &ClusterDialog::write);
    connect(submit_, &QPushButton::clicked, this, &ClusterDialog::submit);
    refresh();
}

void ClusterDialog::build()
{
    setWindowTitle(tr("Study for a Cluster"));
    options_->setPlaceholderText("--partition=long --time=2:00:00");
    options_->setAccessibleName(tr("Options for sbatch"));
    tasks_->setRange(0, 100000);
    tasks_->setSpecialValueText(tr("16 runs each"));
    tasks_->setAccessibleName(tr("Tasks of the job array"));
    command_->setReadOnly(true);
    command_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    command_->setFixedHeight(110);
    command_->setTabChangesFocus(true);
    command_->setAccessibleName(tr("What to type on the cluster"));
    said_->setWordWrap(true);
    said_->setTextFormat(Qt::PlainText);
    auto* about =
        new QLabel(tr("The folder receives the project and the study. It must be on a disk that all machines of the cluster have, "
                      "or be copied there. Then type on the cluster:"));
    about->setWordWrap(true);
    auto* form = new QFormLayout;
    auto* place = new QLabel(folder_);
    place->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(tr("Folder:"), place);
    form->addRow(tr("Options for sbatch:"), options_);
    form->addRow(tr("Tasks:"), tasks_);
    form->addRow(QString(), gpus_);
    auto* copy = new QPushButton(tr("&Copy the Commands"));
    connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_->toPlainText()); });
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(write_, QDialogButtonBox::ActionRole);
    buttons->addButton(submit_, QDialogButtonBox::ActionRole);
    buttons->addButton(copy, QDialogButtonBox::ActionRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(about);
    layout->addWidget(command_);
    layout->addWidget(said_);
    layout->addWidget(buttons);
    submit_->setToolTip("<p>" + tr("Write the folder and submit the job array."));
    resize(640, 360);
}

QString ClusterDialog::command() const { return command_->toPlainText(); }
QString ClusterDialog::said() const { return said_->text(); }

void ClusterDialog::refresh()
{
    const auto word = [](const QString& text) { return QString::fromStdString(shell_word(text.toStdString())); };
    const QString sweep = "hygroloom-cli sweep -o " + word(folder_);
    QString line = sweep + " --slurm";
    if (!QDir(folder_ + "/parts").isEmpty()) { line += " --resume"; } // it has rows
    if (!options_->text().trimmed().isEmpty()) { line += " --sbatch " + word(options_->text().trimmed()); }
    if (tasks_->value() > 0) { line += QString(" --tasks %1").arg(tasks_->value()); }
    if (gpus_->isChecked()) { line += " --gpus"; }
    command_->setPlainText(line + "\nsqueue --me\n" + sweep + " --merge");
}

void ClusterDialog::say(const QString& sentence, bool failed)
{
    said_->setText(sentence);
    said_->setForegroundRole(failed ? QPalette::BrightText : QPalette::WindowText);
}

bool ClusterDialog::write()
{
    try {
        StudyOptions how;
        how.resume = true;
        const StudyFolder all = folder_of(*design_, study_);
        prepared_rows(all, folder_.toStdString(), how); // refuses a folder of another study
        write_study_folder(all, folder_.toStdString());
        say(tr("Written to %1.").arg(folder_), false);
        return true;
    } catch (const std::exception& error) {
        say(QString::fromStdString(error.what()), true);
        return false;
    }
}

void ClusterDialog::submit()
{
    try {
        StudyOptions rows;
        rows.resume = true;
        SlurmOptions how;
        how.sbatch = options_->text().toStdString();
        how.tasks = tasks_->value();
        how.gpus = gpus_->isChecked();
        const QString program = QApplication::applicationDirPath() + "/hygroloom-cli";
        how.program = QFileInfo(program).isExecutable() ? program.toStdString() : "hygroloom-cli";
        const SlurmJob job = submit_study(*design_, study_, folder_.toStdString(), rows, how);
        say(tr("Submitted job %1 with %2 tasks.").arg(QString::fromStdString(job.id)).arg(job.submitted), false);
    } catch (const std::exception& error) {
        say(QString::fromStdString(error.what()), true);
    }
}

} // namespace hygroloom
