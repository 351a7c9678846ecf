// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The question for a folder to write to, which need not be there yet.
#pragma once

#include <QDir>
#include <QFileDialog>

namespace hygroloom {

/// Makes the folder that is typed. Where that fails, the dialog says that it is not there.
class FolderDialog : public QFileDialog {
public:
    FolderDialog(QWidget* parent, const QString& title, const QString& start) : QFileDialog(parent, title, start)
    {
        setFileMode(Directory);
        setOption(ShowDirsOnly);
    }
    void accept() override
    {
        for (const QString& folder : selectedFiles()) { QDir().mkpath(folder); }
        QFileDialog::accept();
    }
};

/// Empty: none was chosen.
inline QString askForFolder(QWidget* parent, const QString& title, const QString& start)
{
    FolderDialog dialog(parent, title, start);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace hygroloom
