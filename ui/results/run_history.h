// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The runs of the open project and the recordings that were opened, to be shown again and compared.
#pragma once

#include "core/analysis/comparison.h"
#include "core/analysis/metrics.h"
#include "core/wear/wear_recording.h"

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <vector>

namespace hygroloom {

struct KeptRun {
    QString path;                           ///< of its recording
    std::shared_ptr<const RunRecord> run;   ///< of a garment: what a record of cloth has, too; its fabric is the garment's name
    std::shared_ptr<const Metrics> metrics; ///< nullptr until its frames have been read, and of a garment
    bool worn = false;                      ///< of a garment
    bool own = false;                       ///< a run of the open project
    bool saved = false;                     ///< it lies in a file that outlives the window
    bool marked = false;                    ///< with "keep"
    bool current = false;                   ///< of the design as it is now; the history finds out
    double bytes = 0;                       ///< of its file; the history finds out
    QDateTime written{};                    ///< its file, last; the history finds out
    int number = 0;                         ///< the history counts those without
    QString copy{};                         ///< where it was saved; that file may have changed since
    QString problem{};                      ///< why it cannot be read, in a sentence; empty: it can
    /// Of a garment, what it gave; nullptr until its frames have been read.
    std::shared_ptr<const Candidate> numbers{};

    bool complete() const { return run->wall > 0; }
    bool measured() const { return worn ? numbers != nullptr : metrics != nullptr; }
    /// What it is of in a comparison: its fabric; of a garment the one that it is cut from, empty where that are several.
    std::string cloth() const;
};

class RunHistory : public QObject {
    Q_OBJECT
public:
    explicit RunHistory(QObject* parent = nullptr);

    /// By number.
    const std::vector<KeptRun>& runs() const { return runs_; }
    /// nullptr where there is none.
    const KeptRun* find(const QString& path) const;
    /// Adds it, or renews what is known of the recording at its path.
    void keep(const KeptRun& run);
    /// The recording at path was saved to another file, in place of what was saved there.
    void markCopied(const QString& path, const QString& copy);
    void setMarked(const QString& path, bool marked);
    void setMetrics(const QString& path, const std::shared_ptr<const Metrics>& metrics);
    void setNumbers(const QString& path, const std::shared_ptr<const Candidate>& numbers);
    /// The recording lies at another path from now on, with the project or not; a run of the project has the number that it has there.
    void move(const QString& from, const QString& to, bool saved);
    /// The recording at this path has been replaced or deleted.
    void forget(const QString& path);
    /// Another project is open; recordings that were opened stay.
    void forgetOwn();
    /// Finds out which runs are of this design; a change is also one of what others differ in.
    void setDesign(const std::shared_ptr<const Design>& design);
    /// Whether runs of the project are still being found: until then nobody knows which it has.
    void setListing(bool listing);
    bool listing() const { return listing_; }
    /// As setDesign() was given it.
    const std::shared_ptr<const Design>& design() const { return design_; }

Q_SIGNALS:
    void changed();

private:
    void renumber(KeptRun& run, int number);

    std::vector<KeptRun> runs_;
    std::shared_ptr<const Design> design_;
    bool listing_ = false;
};

/// A run's experiment and its liquid, whatever it is called; of a garment also that, whatever it is cut from.
Design conditionsOf(const RunRecord& run);

/// What a run depends on that differs in a design or in this program, in words: "sample", "fibres", "fabric is gone", "program". Empty: its
/// results hold for it. A garment that was cut from one fabric is taken to be cut from that in the design, too, as comparisons cut it.
QStringList differencesOf(const RunRecord& run, const Design& design);

/// Whether the results of a run hold for a design: nothing that they depend on differs from what was run.
bool holdsFor(const RunRecord& run, const Design& design);

/// What a list of runs needs of a worn garment's. wall: s; 0: it did not come to its end.
std::shared_ptr<const RunRecord> runOfGarment(const WearRecord& record, double wall);

/// The same of a garment's run, with the garment as the design cuts it. Files are known by name.
bool garmentHoldsFor(const Design& then, const std::string& garment, const std::string& experiment, const Design& now);

/// Without the folders of files, which change as a project is saved elsewhere.
Design anywhere(Design design);

/// Whether it lies in a file that outlives the window, or its copy does: still there and of its size.
bool isSaved(const KeptRun& run);

/// Whether the file at its path is no more the one that was listed.
bool isAnotherNow(const KeptRun& run);

/// A run in a few words, for questions and lists: its number, fabric, experiment and size.
QString runInWords(const KeptRun& run);

/// Why two runs cannot stand side by side, in a sentence; empty when they can.
QString whyNotCompared(const KeptRun& one, const KeptRun& other);

} // namespace hygroloom
