// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The fields of the export dialog: what they offer, what they say, and how format and file name go together.
#include "ui/basics/appearance.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/quantity_edit.h"
#include "ui/document/document.h"
#include "ui/export/export_dialog.h"
#include "ui/results/playback.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

namespace {

QWidget* pairOf(QuantityEdit* across, QuantityEdit* along)
{
    auto* pair = new QWidget;
    auto* layout = new QHBoxLayout(pair);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(across);
    layout->addWidget(new QLabel(QStringLiteral("×")));
    layout->addWidget(along);
    auto* directions = new QLabel(ExportDialog::tr("weft × warp"));
    directions->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(directions);
    layout->addStretch();
    return pair;
}

QuantityEdit* field(const Quantity& quantity, const QString& name, const QString& help)
{
    auto* edit = new QuantityEdit(quantity);
    edit->setAccessibleName(name);
    edit->setHelp(help);
    edit->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    return edit;
}

void addRow(QFormLayout* form, const QString& label, QWidget* widget, QWidget* buddy)
{
    auto* name = new QLabel(label);
    name->setBuddy(buddy);
    form->addRow(name, widget);
}

/// A name without the characters that some file systems refuse.
QString fileNameOf(const std::string& fabric)
{
    QString name = QString::fromStdString(fabric).simplified();
    for (QChar& letter : name) {
        if (QStringLiteral("/\\:*?\"<>|").contains(letter)) { letter = '-'; }
    }
    return name.isEmpty() ? QStringLiteral("fabric") : name;
}

/// Of several lines, whose height fitNotes() sets: QFormLayout takes a label's own height from other rows while some rows are hidden.
class Note : public QLabel {
public:
    bool hasHeightForWidth() const override { return false; }
};

} // namespace

void ExportDialog::say(QLabel* note, const QString& sentence, Severity severity)
{
    note->setText(sentence);
    note->setVisible(!sentence.isEmpty());
    QPalette palette = note->palette();
    palette.setColor(QPalette::WindowText, severityColor(severity, palette));
    note->setPalette(palette);
}

void ExportDialog::buildForm(QFormLayout* form)
{
    form->addRow(tr("Fabric"), fabric_);
    fabric_note_ = addNote(form);
    for (const MeshFormatTraits& format : mesh_formats()) {
        format_->addItem(tr("%1 (%2)").arg(format.name, format.ending), QString(format.ending));
    }
    format_->setAccessibleName(tr("Format"));
    addRow(form, tr("For&mat"), format_, format_);
    format_note_ = addNote(form);
    detail_->addItems({tr("Yarn centrelines"), tr("Yarn surfaces"), tr("Single fibres")});
    detail_->setAccessibleName(tr("Detail"));
    addRow(form, tr("&Detail"), detail_, detail_);
    addPieceRows(form);
    addTubeRows(form);
    addFileRow(form);
}

void ExportDialog::addPieceRows(QFormLayout* form)
{
    piece_->addItems({tr("Repeats of the fabric"), tr("By size"), {}, {}}); // refreshPieces() names the others
    piece_->setAccessibleName(tr("Piece"));
    addRow(form, tr("&Piece"), piece_, piece_);
    const QString along_weft = tr("Along the weft."), along_warp = tr("Along the warp.");
    repeats_[0] = field(Quantity::count(1, largest_yarn_order), tr("Repeats along the weft"), along_weft);
    repeats_[1] = field(Quantity::count(1, largest_yarn_order), tr("Repeats along the warp"), along_warp);
    size_[0] = field(Quantity::length(0.1, 2000), tr("Width along the weft"), along_weft);
    size_[1] = field(Quantity::length(0.1, 2000), tr("Height along the warp"), along_warp);
    repeats_row_ = pairOf(repeats_[0], repeats_[1]);
    size_row_ = pairOf(size_[0], size_[1]);
    addRow(form, tr("&Repeats"), repeats_row_, repeats_[0]);
    addRow(form, tr("Si&ze"), size_row_, size_[0]);
    piece_note_ = addNote(form);
}

void ExportDialog::addTubeRows(QFormLayout* form)
{
    samples_ = field(Quantity::count(1, most_samples), tr("Samples per crossing"),
                     tr("Rings of a tube, or points of a curve, from one crossing to the next."));
    sides_ = field(Quantity::count(3, most_sides), tr("Sides"), tr("Sides of the tube that represents a yarn or a fibre."));
    for (QuantityEdit* edit : {samples_, sides_}) { edit->setOptional(true); }
    addRow(form, tr("&Samples per crossing"), samples_, samples_);
    samples_note_ = addNote(form);
    addRow(form, tr("Sides of a &tube"), sides_, sides_);
    sides_note_ = addNote(form);
    capped_->setAccessibleName(tr("Close the ends with caps"));
    form->addRow(QString(), capped_);
    form->addRow(QString(), flyaways_);
    seed_ = field(Quantity::count(0, std::numeric_limits<int>::max()), tr("Seed of the fibres"),
                  tr("Start of the random numbers: equal seeds give equal fibres."));
    addRow(form, tr("Seed of the &fibres"), seed_, seed_);
    seed_note_ = addNote(form);
}

void ExportDialog::addFileRow(QFormLayout* form)
{
    auto* place = new QWidget;
    auto* layout = new QHBoxLayout(place);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(file_, 1);
    auto* browse = new QPushButton(tr("&Browse…"));
    browse->setAutoDefault(false);
    connect(browse, &QPushButton::clicked, this, &ExportDialog::browse);
    layout->addWidget(browse);
    file_->setAccessibleName(tr("File"));
    addRow(form, tr("F&ile"), place, file_);
    file_note_ = addNote(form);
}

void ExportDialog::fitNotes()
{
    fields_->layout()->activate();
    for (QLabel* note : {fabric_note_, format_note_, piece_note_, samples_note_, sides_note_, seed_note_, file_note_}) {
        const int width = file_note_->parentWidget()->width() - file_->parentWidget()->x();
        note->setMinimumHeight(note->isHidden() ? 0 : note->heightForWidth(width));
    }
}

QLabel* ExportDialog::addNote(QFormLayout* form)
{
    auto* note = new Note;
    note->setWordWrap(true);
    note->setTextFormat(Qt::PlainText);
    note->hide();
    form->addRow(QString(), note);
    return note;
}

void ExportDialog::showChoice(const ExportChoice& choice)
{
    format_->setCurrentIndex(std::max(0, format_->findData(choice.ending)));
    detail_->setCurrentIndex(static_cast<int>(choice.detail));
    piece_->setCurrentIndex(static_cast<int>(choice.piece));
    refreshPieces();
    for (int i = 0; i < 2; ++i) {
        repeats_[i]->setValue(choice.repeats[i]);
        size_[i]->setValue(choice.size_mm[i]);
    }
    samples_->setValue(choice.samples ? std::optional<double>(*choice.samples) : std::nullopt);
    sides_->setValue(choice.sides ? std::optional<double>(*choice.sides) : std::nullopt);
    capped_->setChecked(choice.capped);
    flyaways_->setChecked(choice.flyaways);
    seed_->setValue(choice.seed);
}

void ExportDialog::refreshPieces()
{
    const auto offer = [this](ExportPiece piece, const QString& text, bool there) {
        const int row = static_cast<int>(piece);
        piece_->setItemText(row, text);
        static_cast<QStandardItemModel*>(piece_->model())->item(row)->setEnabled(there);
        if (!there && piece_->currentIndex() == row) { piece_->setCurrentIndex(static_cast<int>(ExportPiece::repeats)); }
    };
    const Experiment* experiment = document_.experiment();
    offer(ExportPiece::sample,
          experiment ? tr("Sample of the experiment, %1 × %2 mm")
                           .arg(shownNumber(experiment->sample_mm[0], 2), shownNumber(experiment->sample_mm[1], 2))
                     : tr("Sample of the experiment (there is none)"),
          experiment != nullptr);
    const bool wet = playback_.run() && playback_.frame();
    offer(ExportPiece::simulated,
          wet ? tr("Simulated piece with its water at %1 s").arg(shownNumber(playback_.frame()->time, 2))
              : tr("Simulated piece (open a recording, or run)"),
          wet);
}

QString ExportDialog::sampleComplaint() const
{
    const std::string sample = "experiments[" + std::to_string(document_.experimentIndex()) + "].sample_mm";
    for (const char* axis : {"[0]", "[1]"}) {
        for (const Issue* issue : document_.issuesAt(sample + axis)) {
            if (issue->severity == Severity::error) { return issueText(*issue); }
        }
    }
    return {};
}

/// What is wrong with the numbers, by field.
struct ExportDialog::Complaints {
    QString repeats, size, samples, sides, seed;
};

void ExportDialog::readNumbers(ExportChoice& chosen, Complaints& complaints) const
{
    const auto number = [&](const QuantityEdit* edit, QString& complaint) {
        QString why;
        const std::optional<double> value = edit->typed(&why);
        complaint = complaint.isEmpty() ? why : complaint;
        return value;
    };
    const auto whole = [&](const QuantityEdit* edit, QString& complaint) {
        const std::optional<double> value = number(edit, complaint);
        return value ? std::optional<int>(static_cast<int>(std::lround(*value))) : std::nullopt;
    };
    for (int i = 0; i < 2; ++i) {
        chosen.repeats[i] = whole(repeats_[i], complaints.repeats).value_or(1);
        chosen.size_mm[i] = number(size_[i], complaints.size).value_or(1);
    }
    chosen.samples = whole(samples_, complaints.samples);
    chosen.sides = whole(sides_, complaints.sides);
    chosen.seed = whole(seed_, complaints.seed).value_or(1);
}

QString ExportDialog::fabricComplaint() const
{
    if (!document_.fabric()) { return tr("This project has no fabric to export."); }
    if (document_.fabricHasError()) { return tr("This fabric has an error and cannot be exported. See the Issues panel."); }
    return {};
}

QString ExportDialog::fileComplaint() const
{
    const QFileInfo file(filePath()), folder(file.absolutePath());
    if (file_->text().trimmed().isEmpty()) { return tr("Enter a file name."); }
    if (file.isDir()) { return tr("This is a folder. Enter a file name."); }
    if (!folder.isDir()) { return tr("The folder %1 does not exist.").arg(folder.filePath()); }
    if (!folder.isWritable()) { return tr("The folder %1 cannot be written to.").arg(folder.filePath()); }
    return {};
}

std::optional<ExportChoice> ExportDialog::choice()
{
    ExportChoice chosen;
    chosen.ending = format_->currentData().toString();
    chosen.detail = static_cast<MeshDetail>(detail_->currentIndex());
    chosen.piece = static_cast<ExportPiece>(piece_->currentIndex());
    chosen.capped = capped_->isChecked();
    chosen.flyaways = flyaways_->isChecked();
    Complaints wrong;
    readNumbers(chosen, wrong);

    const bool wet = chosen.piece == ExportPiece::simulated;
    fabric_->setText(wet                  ? QString::fromStdString(playback_.run()->fabric)
                     : document_.fabric() ? QString::fromStdString(document_.fabric()->name)
                                          : QString());
    const std::pair<QLabel*, QString> complaints[] = {
        {fabric_note_, wet ? QString() : fabricComplaint()},
        {piece_note_, chosen.piece == ExportPiece::repeats  ? wrong.repeats
                      : chosen.piece == ExportPiece::size   ? wrong.size
                      : chosen.piece == ExportPiece::sample ? sampleComplaint()
                                                            : QString()},
        {samples_note_, wrong.samples},
        {sides_note_, chosen.detail == MeshDetail::centreline ? QString() : wrong.sides},
        {seed_note_, chosen.detail == MeshDetail::fibre ? wrong.seed : QString()},
        {file_note_, fileComplaint()},
    };
    const bool good =
        std::all_of(std::begin(complaints), std::end(complaints), [](const auto& complaint) { return complaint.second.isEmpty(); });
    for (const auto& [note, sentence] : complaints) {
        // Notes of the forecast about a good choice stay until there is a new forecast.
        if (!good || (note != piece_note_ && note != samples_note_)) { say(note, sentence); }
    }
    return good ? std::optional(chosen) : std::nullopt;
}

void ExportDialog::setFile(const QString& path)
{
    named_ = true;
    if (file_->text() != path) { file_->setText(path); }
    if (const int row = format_->findData("." + QFileInfo(path).suffix().toLower()); row >= 0) {
        const QSignalBlocker quiet(format_);
        format_->setCurrentIndex(row);
    }
    refresh();
}

void ExportDialog::takeEnding()
{
    QString name = file_->text();
    const QString before = QFileInfo(name).suffix();
    if (!before.isEmpty() && format_->findData("." + before.toLower()) >= 0) { name.chop(before.size() + 1); }
    if (!name.isEmpty()) { file_->setText(name + format_->currentData().toString()); }
    refresh();
}

void ExportDialog::nameFile()
{
    if (!named_) {
        const bool wet = piece_->currentIndex() == static_cast<int>(ExportPiece::simulated);
        const std::string name = wet ? playback_.run()->fabric : document_.fabric() ? document_.fabric()->name : std::string();
        file_->setText(QDir::toNativeSeparators(QDir(folder_).filePath(fileNameOf(name) + format_->currentData().toString())));
    }
}

QString ExportDialog::filePath() const
{
    const QString path = QDir(folder_).absoluteFilePath(QDir::fromNativeSeparators(file_->text().trimmed()));
    const QString ending = format_->currentData().toString();
    return path.endsWith(ending, Qt::CaseInsensitive) || QFileInfo(path).isDir() ? path : path + ending;
}

void ExportDialog::browse()
{
    QStringList filters;
    for (int row = 0; row < format_->count(); ++row) {
        filters << tr("%1 (*%2)").arg(QString(mesh_formats()[static_cast<std::size_t>(row)].name), format_->itemData(row).toString());
    }
    QString filter = filters[format_->currentIndex()];
    const QString path = QFileDialog::getSaveFileName(this, tr("Export Mesh"), filePath(), filters.join(";;"), &filter);
    if (path.isEmpty()) { return; }
    const QString ending = format_->itemData(static_cast<int>(filters.indexOf(filter))).toString();
    const bool known = format_->findData("." + QFileInfo(path).suffix().toLower()) >= 0;
    setFile(known ? path : path + ending);
    agreed_ = known ? path : QString(); // the file dialog has confirmed it
}

} // namespace hygroloom
