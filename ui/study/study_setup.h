// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The form of a study: what it runs, its factors, its points, its metrics; and what is wrong with it.
#pragma once

#include "ui/study/factor_form.h"
#include "ui/study/study_fields.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QPushButton;
class QSpinBox;
class QTreeWidget;

namespace hygroloom {

class Document;

class StudySetup : public QWidget {
    Q_OBJECT
public:
    explicit StudySetup(Document& document, QWidget* parent = nullptr);

    void setStudy(const Study& study);
    /// As the form has it, in the study's own form where that can be read. Only of use where problems() is empty.
    Study study() const;
    /// Why it cannot be run, in sentences; empty: it can.
    const QStringList& problems() const { return problems_; }

    /// As the user does it.
    void tick(const QString& fabric_or_experiment, bool on);
    void tickMetric(const std::string& key, bool on);
    void addFactors(const std::vector<StudyField>& fields);
    void removeFactor();
    void selectFactor(int row);
    FactorForm& form() { return *form_; }
    /// The reader has others now.
    void refreshUnits();
    void setPoints(Sampling sampling, int points);
    void setFidelity(Fidelity fidelity);

Q_SIGNALS:
    /// By the user, or the project is another.
    void changed();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    QWidget* buildFactors();
    QWidget* buildPoints();
    void connectFields();
    void refreshLists();
    void refreshMetrics();
    bool ofGarments() const;
    void addMetricsOf(const std::string& experiment, std::vector<std::string>& known, std::vector<std::string>& compared) const;
    void refreshFactors();
    void refreshProblems();
    void pickFields();
    void showFactor(std::size_t row);
    void takeFactor();
    void edited();
    Study read() const;
    QString placeInWords(const Place& where) const;

    Document& document_;
    Study kept_; ///< what the form does not show: knobs
    std::vector<DraftFactor> drafts_;
    QStringList problems_;
    bool filling_ = false, stale_ = false;
    std::vector<std::string> known_metrics_; ///< that the list was made for

    QListWidget* fabrics_;
    QListWidget* experiments_;
    QListWidget* metrics_;
    QTreeWidget* factors_;
    FactorForm* form_;
    QPushButton* add_;
    QPushButton* remove_;
    QComboBox* sampling_;
    QSpinBox* points_;
    QSpinBox* replicates_;
    QComboBox* fidelity_;
    QDoubleSpinBox* error_;
    QComboBox* sensitivity_;
    QLineEdit* seed_;
    QFormLayout* numbers_ = nullptr;
};

} // namespace hygroloom
