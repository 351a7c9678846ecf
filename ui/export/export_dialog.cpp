// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/export/export_dialog.h"

#include "core/base/error.h"
#include "ui/basics/appearance.h"
#include "ui/basics/ask.h"
#include "ui/basics/quantity_edit.h"
#include "ui/document/document.h"
#include "ui/results/playback.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDir>
#include <QElapsedTimer>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QStorageInfo>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

/// What is known of a choice once its textile has been built.
struct ExportDialog::Forecast {
    ExportEstimate size;
    MeshRequest mesh;
    int ends = 0;
    int picks = 0;
    int smooth_samples = 0;
    double free_bytes = -1; ///< on the disk; negative when it is not known
    QString complaint;      ///< about the piece; nothing else is known then
};

namespace {

constexpr double large_file = 1e9; // bytes

} // namespace

ExportDialog::ExportDialog(Document& document, Playback& playback, QWidget* parent)
    : QDialog(parent), document_(document), playback_(playback), fabric_(new QLabel), format_(new QComboBox), detail_(new QComboBox),
      piece_(new QComboBox), capped_(new QCheckBox(tr("&Close the ends with caps"))), flyaways_(new QCheckBox(tr("&Loops and hairs"))),
      file_(new QLineEdit), estimate_(new QLabel), progress_(new QProgressBar), result_(new QLabel),
      open_folder_(new QPushButton(tr("&Open Folder"))), export_(new QPushButton(tr("&Export"))), close_(new QPushButton(tr("Close"))),
      fields_(new QWidget)
{
    setWindowTitle(tr("Export Mesh"));
    setMinimumWidth(480);
    auto* form = new QFormLayout(fields_);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setLabelAlignment(Qt::AlignLeft);
    buildForm(form);
    prepareReport();
    arrange();
    connectButtons();
    const QSettings settings;
    chooseFolder(settings);
    showChoice(savedExportChoice(settings));
    connectFields();
    refresh();
    adjustSize();
    resize(width() + 40, height() + 3 * fontMetrics().lineSpacing()); // for the sentences beside the fields
}

/// Size, progress and result, with room that stays, so that the buttons do not move as sentences come and go.
void ExportDialog::prepareReport()
{
    for (QLabel* label : {fabric_, estimate_, result_}) {
        label->setTextFormat(Qt::PlainText); // names of fabrics and files
    }
    for (QLabel* label : {estimate_, result_}) {
        label->setWordWrap(true);
        label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    }
    estimate_->setAccessibleName(tr("Size of the export"));
    estimate_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    estimate_->setMinimumHeight(3 * fontMetrics().lineSpacing());
    result_->setAccessibleName(tr("Result of the export"));
    result_->setMinimumHeight(2 * fontMetrics().lineSpacing());
    progress_->setRange(0, 1000);
    progress_->setAccessibleName(tr("Progress of the export"));
    QSizePolicy stays = progress_->sizePolicy();
    stays.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(stays);
    progress_->hide();
}

void ExportDialog::arrange()
{
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(open_folder_);
    buttons->addStretch();
    buttons->addWidget(export_);
    buttons->addWidget(close_);
    export_->setDefault(true);
    close_->setAutoDefault(false);
    open_folder_->setAutoDefault(false);
    open_folder_->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(16);
    layout->addWidget(fields_);
    layout->addWidget(estimate_);
    layout->addStretch(1);
    layout->addWidget(progress_);
    layout->addWidget(result_);
    layout->addLayout(buttons);
}

void ExportDialog::connectButtons()
{
    connect(export_, &QPushButton::clicked, this, &ExportDialog::start);
    connect(close_, &QPushButton::clicked, this, &QDialog::reject);
    connect(open_folder_, &QPushButton::clicked, this, [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder_)); });
}

void ExportDialog::connectFields()
{
    const auto follow = [this] {
        refreshPieces();
        refresh();
    };
    connect(&document_, &Document::designChanged, this, follow);
    connect(&playback_, &Playback::runChanged, this, follow);
    connect(&playback_, &Playback::frameShown, this, &ExportDialog::refreshPieces); // the size stays
    for (QComboBox* box : {detail_, piece_}) { connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh); }
    connect(format_, &QComboBox::currentIndexChanged, this, &ExportDialog::takeEnding);
    for (QuantityEdit* edit : {repeats_[0], repeats_[1], size_[0], size_[1], samples_, sides_, seed_}) {
        connect(edit, &QLineEdit::textChanged, this, &ExportDialog::refresh);
    }
    for (QCheckBox* box : {capped_, flyaways_}) { connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh); }
    connect(file_, &QLineEdit::textEdited, this, &ExportDialog::setFile);
}

/// The folder of the last export, of the project, or the user's documents: the first that exists.
void ExportDialog::chooseFolder(const QSettings& settings)
{
    const QString beside = document_.path().isEmpty() ? QString() : QFileInfo(document_.path()).absolutePath();
    const QString folders[] = {settings.value("export/folder").toString(), beside,
                               QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)};
    const auto* there =
        std::find_if(std::begin(folders), std::end(folders), [](const QString& folder) { return QFileInfo(folder).isDir(); });
    folder_ = there == std::end(folders) ? QDir::homePath() : *there;
}

ExportDialog::~ExportDialog() = default;

void ExportDialog::resizeEvent(QResizeEvent* event)
{
    QDialog::resizeEvent(event);
    fitNotes();
}

ExportSource ExportDialog::source() const
{
    ExportSource source;
    source.design = document_.design();
    source.fabric = document_.fabricIndex();
    source.fitted = document_.fitted();
    if (const Experiment* experiment = document_.experiment()) {
        source.sample_mm[0] = experiment->sample_mm[0];
        source.sample_mm[1] = experiment->sample_mm[1];
    }
    source.run = playback_.run();
    source.frame = playback_.frame();
    return source;
}

void ExportDialog::refresh()
{
    if (writing_) { return; }
    result_->clear(); // it was about an earlier choice
    nameFile();
    estimated_.reset();
    const auto piece = static_cast<ExportPiece>(piece_->currentIndex());
    const auto detail = static_cast<MeshDetail>(detail_->currentIndex());
    auto* form = static_cast<QFormLayout*>(fields_->layout());
    form->setRowVisible(repeats_row_, piece == ExportPiece::repeats);
    form->setRowVisible(size_row_, piece == ExportPiece::size);
    sides_->setEnabled(detail != MeshDetail::centreline);
    capped_->setEnabled(detail != MeshDetail::centreline);
    flyaways_->setEnabled(detail == MeshDetail::fibre);
    seed_->setEnabled(detail == MeshDetail::fibre);
    const std::optional<ExportChoice> chosen = choice();
    fitNotes();
    export_->setEnabled(chosen.has_value());
    estimate_->setEnabled(false); // until the new one is there
    if (!chosen) {
        estimator_.drop();
        estimate_->clear();
        say(format_note_, {});
        return;
    }
    estimator_.run([this, chosen = *chosen, source = source(), folder = QFileInfo(filePath()).absolutePath()](const NewestJob::Turn& turn) {
        Forecast forecast;
        try {
            const MeshExport made = meshExport(source, chosen);
            forecast.mesh = made.options.mesh;
            forecast.ends = made.textile.ends();
            forecast.picks = made.textile.picks();
            forecast.smooth_samples = made.smooth_samples;
            forecast.size = export_estimate(made.textile, made.fabric, made.options, mesh_format_of("x" + chosen.ending.toStdString()));
            if (const QStorageInfo disk(folder); disk.isValid()) { forecast.free_bytes = static_cast<double>(disk.bytesAvailable()); }
        } catch (const std::bad_alloc&) {
            forecast.complaint = tr("Not enough memory for this piece. Choose a smaller one.");
        } catch (const std::exception& error) {
            forecast.complaint = QString::fromStdString(error.what());
        }
        turn.deliver([this, forecast, turn] {
            if (!turn.outdated() && !writing_) { showForecast(forecast); }
        });
    });
}

void ExportDialog::showForecast(const Forecast& forecast)
{
    const ExportEstimate& size = forecast.size;
    const QLocale locale;
    const auto count = [&](std::size_t number) { return locale.toString(static_cast<qulonglong>(number)); };
    estimate_->setEnabled(true);
    if (forecast.complaint.isEmpty()) { estimated_ = size; }
    samples_->setDerived(forecast.mesh.samples_per_crossing);
    sides_->setDerived(forecast.mesh.sides);
    const bool large_piece = static_cast<double>(forecast.ends) * forecast.picks > most_crossings;
    say(piece_note_, large_piece ? QString::fromStdString(size.refusal) : forecast.complaint);
    say(format_note_, large_piece ? QString() : QString::fromStdString(size.refusal));
    say(samples_note_,
        forecast.mesh.samples_per_crossing < forecast.smooth_samples
            ? tr("%1 samples per crossing are too few for this twist. Use %2 for smooth fibres.")
                  .arg(forecast.mesh.samples_per_crossing)
                  .arg(forecast.smooth_samples)
            : QString(),
        Severity::warning);
    const bool refused = !forecast.complaint.isEmpty() || !size.refusal.empty();
    const bool full = !refused && forecast.free_bytes >= 0 && size.most_bytes > forecast.free_bytes;
    export_->setEnabled(!refused && !full);
    QStringList lines;
    if (forecast.complaint.isEmpty()) {
        lines << tr("%1 ends × %2 picks")
                     .arg(count(static_cast<std::size_t>(forecast.ends)), count(static_cast<std::size_t>(forecast.picks)));
    }
    if (!refused) {
        lines << (size.curves > 0 ? tr("%1 curves with %2 points").arg(count(size.curves), count(size.vertices))
                                  : tr("%1 triangles, %2 vertices").arg(count(size.triangles), count(size.vertices)));
        lines << tr("about %1").arg(bytesText(size.bytes));
    }
    QString text = lines.isEmpty() ? QString() : lines.join(", ") + ".";
    if (full) {
        text +=
            "\n" +
            tr("The file may need up to %1; only %2 are free on the disk.").arg(bytesText(size.most_bytes), bytesText(forecast.free_bytes));
    } else if (!refused && size.bytes > large_file) {
        text += "\n" + tr("Many programs cannot open files larger than 1 GB.");
    }
    QPalette palette = estimate_->palette();
    palette.setColor(QPalette::WindowText, full                      ? severityColor(Severity::error, palette)
                                           : size.bytes > large_file ? severityColor(Severity::warning, palette)
                                                                     : this->palette().color(QPalette::WindowText));
    estimate_->setPalette(palette);
    estimate_->setText(text);
    fitNotes();
    Q_EMIT estimated();
}

void ExportDialog::start()
{
    const std::optional<ExportChoice> chosen = choice();
    const QString path = filePath();
    if (writing_ || !chosen || !mayReplace(path, *chosen)) { return; }
    agreed_.clear();
    folder_ = QFileInfo(path).absolutePath();
    file_->setText(QDir::toNativeSeparators(path)); // a name alone is one in folder_, which may be another now
    stop_ = std::make_shared<std::atomic<bool>>(false);
    setWriting(true);
    exporter_.run([this, chosen = *chosen, source = source(), path, stop = stop_](const NewestJob::Turn& turn) {
        QElapsedTimer reported;
        const auto progress = [&](double share) {
            if (!reported.isValid() || reported.elapsed() > 50) {
                reported.start();
                turn.deliver([this, share] { progress_->setValue(static_cast<int>(1000 * share)); });
            }
            return !*stop && !turn.outdated();
        };
        QString sentence;
        bool problem = true;
        try {
            const MeshExport made = meshExport(source, chosen);
            const Exported exported = export_textile(made.textile, made.fabric, made.options, path.toStdString(), progress);
            QStringList names;
            for (const auto& file : exported.files) { names << QString::fromStdString(file.filename().string()); }
            sentence = tr("Wrote %1, %2.").arg(names.join(tr(" and ")), bytesText(static_cast<double>(exported.bytes)));
            problem = false;
        } catch (const Cancelled&) {
            sentence = tr("Cancelled. No file was written.");
        } catch (const std::bad_alloc&) {
            sentence = tr("Not enough memory for this export. Choose a smaller piece.");
        } catch (const std::exception& error) {
            sentence = QString::fromStdString(error.what());
        }
        turn.deliver([this, sentence, problem, path] { end(sentence, problem, path); });
    });
}

void ExportDialog::cancel()
{
    // The job runs to its end and reports it; a job dropped before it began would not.
    if (writing_) {
        *stop_ = true;
        close_->setText(tr("Cancelling…"));
        close_->setEnabled(false);
    }
}

void ExportDialog::end(const QString& sentence, bool problem, const QString& path)
{
    setWriting(false);
    refresh();
    result_->setText(sentence);
    open_folder_->setVisible(!problem);
    if (!problem) { Q_EMIT written(tr("Exported %1.").arg(path)); }
    Q_EMIT ended();
}

void ExportDialog::setWriting(bool writing)
{
    writing_ = writing;
    fields_->setEnabled(!writing);
    export_->setEnabled(!writing);
    close_->setText(writing ? tr("Cancel") : tr("Close"));
    close_->setEnabled(true);
    progress_->setValue(0);
    progress_->setVisible(writing);
    if (writing) {
        result_->clear();
        open_folder_->hide();
        close_->setFocus();
    }
}

void ExportDialog::done(int result)
{
    if (writing_) {
        cancel();
        return;
    }
    QSettings settings;
    if (const std::optional<ExportChoice> chosen = choice()) { saveExportChoice(settings, *chosen); }
    settings.setValue("export/folder", folder_);
    QDialog::done(result);
}

std::vector<std::filesystem::path> ExportDialog::filesOf(const QString& path, const ExportChoice& choice) const
{
    try {
        if (estimated_) { return files_of_export(path.toStdString(), *estimated_); }
        const MeshExport made = meshExport(source(), choice);
        return files_of_export(path.toStdString(),
                               export_estimate(made.textile, made.fabric, made.options, mesh_format_of(path.toStdString())));
    } catch (const std::exception&) { // the export reports the reason
        return {};
    }
}

bool ExportDialog::mayReplace(const QString& path, const ExportChoice& choice)
{
    QStringList there;
    for (const auto& written : filesOf(path, choice)) {
        const QFileInfo file(QString::fromStdString(written.string()));
        if (file.filePath() != agreed_ && file.exists()) { there << file.fileName(); }
    }
    if (there.isEmpty()) { return true; }
    const QString question = there.size() == 1 ? tr("%1 already exists. Replace it?") : tr("%1 already exist. Replace them?");
    return confirm(this, windowTitle(), question.arg(there.join(tr(" and "))), tr("What is in it now is lost."), tr("&Replace"));
}

} // namespace hygroloom
