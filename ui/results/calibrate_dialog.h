// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fits what is not known of the selected fabric to a measurement, shows the fit, and takes it over.
#pragma once

#include "ui/document/document.h"
#include "ui/results/calibration_run.h"

#include <QDialog>

#include <array>
#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace hygroloom {

class FitChart;

/// Of the fabric that is selected when it opens. It is modal: the design stays as it is meanwhile, but for Apply.
class CalibrateDialog : public QDialog {
    Q_OBJECT
public:
    CalibrateDialog(Document& document, WindowQueue& queue, Fidelity fidelity, const std::string& backend, QWidget* parent = nullptr);

    /// The measured file; read at once.
    void setFile(const QString& path);
    CalibrationRun& run() { return run_; }
    /// Why it cannot run, or what came out, in a sentence.
    QString message() const;
    /// Runs, or cancels the run.
    void startOrCancel();
    /// The fitted values into the document, one step of its history.
    void apply();
    /// While it runs, closing only cancels.
    void done(int result) override;

private:
    void buildForm(QFormLayout* form);
    void buildResult();
    void arrange(QFormLayout* form);
    void browse();
    void readFile();
    void refresh();
    void showEnd(const std::shared_ptr<const Calibration>& result, const QString& sentence);
    void showInputs();
    void saveReport();
    /// Those ticked.
    std::vector<FreeInput> chosenInputs() const;
    const Experiment* experiment() const;
    /// Why it cannot run; empty: it can.
    QString complaint() const;

    struct Input {
        QCheckBox* box = nullptr;
        std::optional<FreeInput> input; ///< none: known
    };

    Document& document_;
    const std::string backend_;
    std::array<Input, 3> inputs_;
    QComboBox* experiments_;
    QComboBox* fidelity_;
    QLineEdit* file_;
    QPushButton* browse_;
    std::optional<MeasuredData> data_;
    QString file_complaint_;
    FitChart* chart_;
    QTableWidget* table_;
    QLabel* message_;
    QProgressBar* progress_;
    QPushButton* start_;
    QPushButton* apply_;
    QPushButton* report_;
    std::shared_ptr<const Calibration> result_;
    CalibrationRun run_; // last: its thread ends before the rest goes
};

} // namespace hygroloom
