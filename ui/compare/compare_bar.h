// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Above the table of candidates: what is compared and how, running what is missing, and what can be done with the table.
#pragma once

#include "core/plan/fidelity.h"

#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace hygroloom {

class StudyRuns;

class CompareBar : public QWidget {
    Q_OBJECT
public:
    explicit CompareBar(const StudyRuns& runs, QWidget* parent = nullptr);

    /// The first is the overview of all.
    void setExperiments(const QStringList& names, int chosen);
    int experiment() const;
    void setFidelity(Fidelity fidelity);
    Fidelity fidelity() const;
    /// Panels and zones of a garment, the whole first; none of samples, and the field is hidden.
    void setParts(const QStringList& titles, int chosen);
    int part() const;
    /// While it is not known at which fidelity the kept runs are, the field names none.
    void setReading(bool reading);
    int replicates() const;
    void setReplicates(int count);
    /// The same, when it is not the user who chooses.
    void showReplicates(int count);
    /// From the fewest.
    std::vector<int> replicateChoices() const;
    /// What can be done with so many fabrics that have numbers of one experiment.
    void offerFiles(std::size_t fabrics);
    /// What Run All Missing would do; runs: none while that is not known; seconds: 0 where they are not known. why_not: why it cannot.
    void setMissing(std::optional<int> runs, double seconds, const QString& why_not);
    void showProgress();
    QPushButton* save() { return save_; }
    QPushButton* report() { return report_; }
    QPushButton* measured() { return measured_; }
    QPushButton* card() { return card_; }
    QPushButton* runAll() { return run_; }

Q_SIGNALS:
    void experimentChosen();
    void fidelityChosen();
    void partChosen();
    void replicatesChosen();
    void runAllRequested();
    void cancelRequested();
    void filterChanged(const QString& text);
    void saveRequested();
    void reportRequested();
    void measuredRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QHBoxLayout* toolRow();
    void elide();

    QComboBox* experiment_;
    QComboBox* fidelity_;
    QComboBox* part_;
    int unnamed_ = 0; ///< its place in the field, while that names none
    QComboBox* replicates_;
    QPushButton* run_;
    QLabel* state_;
    QProgressBar* progress_;
    QPushButton* cancel_;
    QLineEdit* filter_;
    QPushButton* card_;
    QPushButton* measured_;
    QPushButton* save_;
    QPushButton* report_;
    const StudyRuns& runs_;
    QString missing_;
    QString said_; ///< in full
};

} // namespace hygroloom
