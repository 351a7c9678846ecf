// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The runs of this window and the recordings it opened, to be shown again and compared.
#pragma once

#include "core/analysis/metrics.h"

#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace hygroloom {

struct KeptRun {
    QString path; ///< of its recording
    std::shared_ptr<const RunRecord> run;
    std::shared_ptr<const Metrics> metrics;
    bool saved = false; ///< in a file that outlives the window
    bool own = false;   ///< its file goes with the window
    double elapsed = 0; ///< s from its start to its end in this window; 0: it ran elsewhere
    int number = 0;     ///< in the order they came; the history counts

    bool complete() const { return run->wall > 0; }
};

class RunHistory : public QObject {
    Q_OBJECT
public:
    explicit RunHistory(QObject* parent = nullptr);

    /// The oldest first.
    const std::vector<KeptRun>& runs() const { return runs_; }
    /// Adds it, or renews what is known of the recording at its path.
    void keep(const KeptRun& run);
    void markSaved(const QString& path);
    /// The recording at this path has been replaced or deleted.
    void forget(const QString& path);
    /// Deletes runs and their recordings until the others fit into most_bytes: those saved elsewhere first, then the oldest.
    /// The newest run stays. How many were not saved.
    int dropOldest(double most_bytes);
    /// Runs that end with the window.
    std::vector<KeptRun> unsaved() const;

Q_SIGNALS:
    void changed();

private:
    std::vector<KeptRun>::iterator nextToDrop();

    std::vector<KeptRun> runs_;
    int count_ = 0;
};

/// Why two runs cannot stand side by side, in a sentence; empty when they can.
QString whyNotCompared(const KeptRun& one, const KeptRun& other);

} // namespace hygroloom
