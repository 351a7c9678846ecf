// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The runs of this window and the recordings it opened, so that earlier ones can be looked at again and compared.
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
    /// Takes away the oldest runs that are not saved, with their recordings, until the others fit into so many bytes.
    void dropOldest(double most_bytes);
    /// Runs that end with the window.
    std::vector<KeptRun> unsaved() const;

Q_SIGNALS:
    void changed();

private:
    std::vector<KeptRun> runs_;
};

/// Why two runs cannot stand side by side, in a sentence; empty when they can.
QString whyNotCompared(const KeptRun& one, const KeptRun& other);

} // namespace hygroloom
