// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Under the list of runs: keep and forget the selected one, forget those of older designs, and the room they all take.
#pragma once

#include "ui/results/run_history.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace hygroloom {

class RunActions : public QWidget {
    Q_OBJECT
public:
    explicit RunActions(const RunHistory& history, QWidget* parent = nullptr);

    /// The selected run; empty: none.
    void setRun(const QString& path);

Q_SIGNALS:
    void markRequested(const QString& path, bool marked);
    /// The user has agreed where the recording is deleted.
    void forgetRequested(const QString& path);

private:
    void refresh();
    void forget();
    void forgetOlder();
    std::vector<KeptRun> older() const;
    bool mayDelete(const std::vector<KeptRun>& runs);

    const RunHistory& history_;
    QString path_;
    QPushButton* keep_;
    QPushButton* forget_;
    QPushButton* older_;
    QLabel* room_;
};

} // namespace hygroloom
