// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// All runs of the project, also of older designs, and recordings that were opened; to be opened, kept, forgotten and ticked.
#pragma once

#include "ui/results/run_history.h"

#include <QWidget>

#include <functional>

class QTreeWidget;
class QTreeWidgetItem;

namespace hygroloom {

class RunActions;

class RunList : public QWidget {
    Q_OBJECT
public:
    /// why_not: why a run cannot be ticked now; empty when it can.
    RunList(RunHistory& history, std::function<QString(const KeptRun&)> why_not, QWidget* parent = nullptr);
    /// Which follows the history and has nothing to tick.
    explicit RunList(RunHistory& history, QWidget* parent = nullptr);

    void refresh(const QStringList& ticked);

Q_SIGNALS:
    void tickRequested(const QString& path, bool on);
    void openRequested(const QString& path);
    void markRequested(const QString& path, bool marked);
    void forgetRequested(const QString& path);

private:
    void build();
    void fill(QTreeWidgetItem* item, const KeptRun& run, bool ticked);
    bool hasTicks() const { return static_cast<bool>(why_not_); }

    RunHistory& history_;
    std::function<QString(const KeptRun&)> why_not_;
    QTreeWidget* list_;
    RunActions* actions_;
};

/// The fabric, or the garment and what it is cut from, with the run's number where the history has more runs of it.
QString nameOfRun(const RunHistory& history, const KeptRun& run);

} // namespace hygroloom
