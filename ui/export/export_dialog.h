// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What to export of the chosen fabric as a mesh or as curves, how large it will be, and the writing itself.
#pragma once

#include "core/design/validate.h"
#include "ui/basics/newest_job.h"
#include "ui/export/mesh_export.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSettings;

namespace hygroloom {

class Document;
class Playback;
class QuantityEdit;

/// Follows the document and the recording while it is open, and does not block the window. Writes what both were when it began.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    ExportDialog(Document& document, Playback& playback, QWidget* parent = nullptr);
    ~ExportDialog() override;

    /// The ending chooses the format.
    void setFile(const QString& path);
    bool writing() const { return writing_; }
    /// Asks before it replaces a file.
    void start();
    /// The file that was there stays, and no new one comes.
    void cancel();
    /// While it writes, closing only cancels.
    void done(int result) override;

Q_SIGNALS:
    /// The shown size is that of the present choice.
    void estimated();
    void written(const QString& sentence);
    /// Written, cancelled or failed.
    void ended();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Forecast;
    void prepareReport();
    void arrange();
    void connectButtons();
    void connectFields();
    void chooseFolder(const QSettings& settings);
    void refresh();
    void showForecast(const Forecast& forecast);
    void end(const QString& sentence, bool problem, const QString& path);
    void setWriting(bool writing);
    ExportSource source() const;
    bool mayReplace(const QString& path, const ExportChoice& choice);
    std::vector<std::filesystem::path> filesOf(const QString& path, const ExportChoice& choice) const;
    // export_dialog_fields.cpp
    void buildForm(QFormLayout* form);
    void addPieceRows(QFormLayout* form);
    void addTubeRows(QFormLayout* form);
    void addFileRow(QFormLayout* form);
    QLabel* addNote(QFormLayout* form);
    /// Gives each sentence beside the fields the height that its lines take.
    void fitNotes();
    static void say(QLabel* note, const QString& sentence, Severity severity = Severity::error);
    void showChoice(const ExportChoice& choice);
    void refreshPieces();
    /// No value when a field is wrong; the note beside it then gives the reason.
    std::optional<ExportChoice> choice();
    /// Fills the numbers of a choice; complaints: by field.
    struct Complaints;
    void readNumbers(ExportChoice& chosen, Complaints& complaints) const;
    QString sampleComplaint() const;
    QString fabricComplaint() const;
    QString fileComplaint() const;
    QString filePath() const;
    void takeEnding();
    void nameFile();
    void browse();

    Document& document_;
    Playback& playback_;
    QLabel* fabric_;
    QLabel* fabric_note_ = nullptr;
    QComboBox* format_;
    QLabel* format_note_ = nullptr;
    QComboBox* detail_;
    QComboBox* piece_;
    QWidget* repeats_row_;
    QWidget* size_row_;
    QuantityEdit* repeats_[2];
    QuantityEdit* size_[2];
    QLabel* piece_note_ = nullptr;
    QuantityEdit* samples_;
    QLabel* samples_note_ = nullptr;
    QuantityEdit* sides_;
    QLabel* sides_note_ = nullptr;
    QCheckBox* capped_;
    QCheckBox* flyaways_;
    QuantityEdit* seed_;
    QLabel* seed_note_ = nullptr;
    QLineEdit* file_;
    QLabel* file_note_ = nullptr;
    QLabel* estimate_;
    QProgressBar* progress_;
    QLabel* result_;
    QPushButton* open_folder_;
    QPushButton* export_;
    QPushButton* close_;
    QWidget* fields_;
    QString folder_;     ///< of the file when its name says none
    QString agreed_;     ///< a file that may be replaced by the next export
    bool named_ = false; ///< by hand
    bool writing_ = false;
    std::optional<ExportEstimate> estimated_; ///< of the present choice, once it is known
    std::shared_ptr<std::atomic<bool>> stop_; ///< the export that is being written
    NewestJob estimator_;                     // last: their deliveries use the rest
    NewestJob exporter_;
};

} // namespace hygroloom
