// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// All runs of the project, also those of older designs, and recordings that were opened; to be ticked, kept and forgotten.
#pragma once

#include "ui/results/run_history.h"

#include <QWidget>

#include <functional>

class QTreeWidget;

namespace hygroloom {

class RunActions;

class RunList : public QWidget {
    Q_OBJECT
public:
    /// why_not: why a run cannot be ticked now; empty when it can.
    RunList(RunHistory& history, std::function<QString(const KeptRun&)> why_not, QWidget* parent = nullptr);

    void refresh(const QStringList& ticked);

Q_SIGNALS:
    void tickRequested(const QString& path, bool on);
    void openRequested(const QString& path);
    void markRequested(const QString& path, bool marked);
    void forgetRequested(const QString& path);

private:
    RunHistory& history_;
    std::function<QString(const KeptRun&)> why_not_;
    QTreeWidget* list_;
    RunActions* actions_;
};

/// The fabric, with the run's number where the history has more runs of it.
QString nameOfRun(const RunHistory& history, const KeptRun& run);

} // namespace hygroloom
