// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A study for a cluster: writes its folder, says what to type there, or submits it where Slurm is at hand.
#pragma once

#include "core/study/study.h"

#include <QDialog>

#include <memory>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace hygroloom {

class ClusterDialog : public QDialog {
    Q_OBJECT
public:
    /// Preconditions: validate() found no error in both.
    ClusterDialog(std::shared_ptr<const Design> design, Study study, const QString& folder, QWidget* parent = nullptr);

    /// Writes project.hygro and study.json into the folder. False after the reason was shown.
    bool write();
    QString command() const;
    QString said() const;

private:
    void build();
    void refresh();
    void submit();
    void say(const QString& sentence, bool failed);

    std::shared_ptr<const Design> design_;
    Study study_;
    QString folder_;
    QLineEdit* options_;
    QSpinBox* tasks_;
    QCheckBox* gpus_;
    QPlainTextEdit* command_;
    QPushButton* write_;
    QPushButton* submit_;
    QLabel* said_;
};

} // namespace hygroloom
