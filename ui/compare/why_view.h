// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Why one fabric of the project is better than another: the inputs that differ, and, once their mixtures have been run, what each makes.
#pragma once

#include "core/analysis/why.h"
#include "ui/basics/newest_job.h"
#include "ui/compare/study_runs.h"

#include <QWidget>

#include <set>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace hygroloom {

/// What is compared, as the workspace has it.
struct WhyStudy {
    Comparison comparison; ///< judged; without candidates: no experiment is chosen
    std::shared_ptr<const Design> design;
    StudyChoice choice;
    bool own = true;    ///< the experiment is the project's
    QString cannot_run; ///< why nothing can be run; empty: it can
};

class WhyView : public QWidget {
    Q_OBJECT
public:
    explicit WhyView(StudyRuns& runs, QWidget* parent = nullptr);

    void setStudy(WhyStudy study);
    /// nullptr: it has not been found out.
    std::shared_ptr<const Why> why() const { return why_; }
    /// Fabrics by name, a number by its place among the criteria.
    void choose(const QString& fabric, const QString& against, int metric);
    /// Runs what is missing, or cancels it.
    void findOut();

Q_SIGNALS:
    void found();

private:
    /// What mixtures gave, as long as the project's content is the same.
    struct Known {
        std::pair<ReplicateKey, ReplicateKey> keys; ///< of the fabric and of the other
        std::map<Mixture, Candidate> mixtures;
        std::set<std::pair<Mixture, int>> ended;               ///< with their replicates
        std::map<std::pair<Mixture, int>, std::string> failed; ///< why; Find Out runs them again
    };
    /// What a plan is of.
    struct Planned {
        std::shared_ptr<const Design> design;
        std::string experiment, fabric, against;
        bool replicates = false;
        QStringList units{}; ///< of its inputs
        bool operator==(const Planned&) const = default;
    };
    QWidget* head();
    void fillBoxes();
    void connectParts();
    void plan();
    void refresh();
    void showParts();
    void showWhy();
    void showState();
    void end();
    double secondsOfRun() const;
    void take(const StudyJob& job, const Candidate& candidate);
    QString whyNot() const;
    const Candidate* candidateOf(const QComboBox* box) const;
    bool complete(const Candidate& candidate) const;
    std::pair<ReplicateKey, ReplicateKey> keys() const;
    const Known* known(const std::pair<ReplicateKey, ReplicateKey>& keys) const;
    std::vector<StudyJob> missing() const;
    void addRow(const QStringList& cells, bool strong = false);
    void addBar(const Compared& compared, double low, double high);
    void shareWidth();

    StudyRuns& runs_;
    WhyStudy study_;
    Planned planned_;             ///< what plan_ is of, or is being made of
    std::optional<WhyPlan> plan_; ///< none: not made yet
    std::shared_ptr<const Why> why_;
    std::vector<Known> known_;
    std::pair<ReplicateKey, ReplicateKey> asked_; ///< of which fabrics the mixtures are that run
    bool asking_ = false;                         ///< there are such runs
    bool proposing_ = true;                       ///< until the user chooses fabrics
    bool ranking_ = true;                         ///< the same of the number
    QComboBox* fabric_;
    QComboBox* against_;
    QComboBox* metric_;
    QPushButton* find_;
    QLabel* state_;
    QLabel* heading_;
    QTableWidget* table_;
    QLabel* note_;
    NewestJob planner_;
};

} // namespace hygroloom
