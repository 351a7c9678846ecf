// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/preset_gallery.h"

#include "core/base/error.h"
#include "core/design/fabric_quantities.h"
#include "core/design/validate.h"
#include "ui/cloth_picture.h"
#include "ui/quantity.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardPaths>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int picture_side = 112; // pixels
constexpr double swatch_mm = 5;

/// So many millimetres of the cloth, flat, each yarn as wide as its pitch and shaded like a round one.
QImage swatchPicture(const Fabric& fabric, int pixels)
{
    const int ends = std::clamp(static_cast<int>(std::lround(fabric.ends_per_cm * swatch_mm / 10)), 6, pixels / 3);
    const int picks = std::clamp(static_cast<int>(std::lround(fabric.picks_per_cm * swatch_mm / 10)), 6, pixels / 3);
    const QImage flat = clothPicture(fabric, ends, picks);
    QImage picture(pixels, pixels, QImage::Format_RGB32);
    for (int y = 0; y < pixels; ++y) {
        for (int x = 0; x < pixels; ++x) {
            const double across = static_cast<double>(x) * ends / pixels, along = static_cast<double>(y) * picks / pixels;
            const int end = static_cast<int>(across), row = static_cast<int>(along);
            const bool warp = fabric.weave.warp_up(end, picks - 1 - row);
            const double off = 2 * std::abs((warp ? across - end : along - row) - 0.5);
            const QColor color = flat.pixelColor(end, row);
            const double light = 1 - 0.45 * off * off;
            picture.setPixelColor(x, y, QColor::fromRgbF(static_cast<float>(color.redF() * light), static_cast<float>(color.greenF() * light),
                                                         static_cast<float>(color.blueF() * light)));
        }
    }
    return picture;
}

QString yarnText(const Yarn& yarn)
{
    QStringList fibres;
    for (const MaterialShare& share : yarn.material) {
        fibres << (yarn.material.size() > 1 ? PresetGallery::tr("%1 % %2").arg(std::lround(share.share * 100)).arg(QString::fromStdString(share.name))
                                            : QString::fromStdString(share.name));
    }
    QString text = fibres.join(", ");
    if (yarn.linear_density_tex) {
        text += PresetGallery::tr(", %1 tex").arg(shownNumber(*yarn.linear_density_tex, 1));
    } else if (yarn.diameter_mm) {
        text += PresetGallery::tr(", %1 mm").arg(shownNumber(*yarn.diameter_mm, 3));
    }
    return text;
}

QString searchText(const Preset& preset)
{
    return QString::fromStdString(preset.fabric().name + " " + preset.group + " " + preset.note + " " + preset.fabric().weave.pattern()) + " "
        + yarnText(preset.fabric().warp) + " " + yarnText(preset.fabric().weft);
}

} // namespace

QString userLibraryPath()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath("library.json");
}

void keepInLibrary(const Design& design, const Fabric& fabric, const QString& path)
{
    QDir().mkpath(QFileInfo(path).absolutePath());
    std::vector<Preset> kept = read_library(path.toStdString());
    std::erase_if(kept, [&](const Preset& preset) { return preset.fabric().name == fabric.name; });
    kept.push_back(preset_of(design, fabric, PresetGallery::tr("My library").toStdString(), PresetGallery::tr("Kept by you.").toStdString()));
    write_library(kept, path.toStdString());
}

PresetGallery::PresetGallery(const QString& library, QWidget* parent)
    : QDialog(parent)
    , library_(library)
    , groups_(new QComboBox)
    , words_(new QLineEdit)
    , list_(new QListWidget)
    , about_(new QLabel)
{
    setWindowTitle(tr("Add a Fabric from the Library"));
    groups_->setAccessibleName(tr("Group of fabrics"));
    words_->setAccessibleName(tr("Search the library"));
    words_->setPlaceholderText(tr("Search: name, fibre, weave"));
    words_->setClearButtonEnabled(true);
    list_->setAccessibleName(tr("Fabrics of the library"));
    list_->setViewMode(QListView::IconMode);
    list_->setResizeMode(QListView::Adjust);
    list_->setMovement(QListView::Static);
    list_->setIconSize({picture_side, picture_side});
    list_->setGridSize({picture_side + 24, picture_side + 48});
    list_->setWordWrap(true);
    list_->setUniformItemSizes(true);
    about_->setWordWrap(true);
    about_->setAccessibleName(tr("About the chosen fabric"));
    about_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    about_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    about_->setFixedWidth(230);

    auto* top = new QHBoxLayout;
    top->addWidget(groups_);
    top->addWidget(words_, 1);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(12);
    middle->addWidget(list_, 1);
    middle->addWidget(about_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    add_ = buttons->button(QDialogButtonBox::Ok);
    add_->setText(tr("Add Fabric"));
    remove_ = buttons->addButton(tr("Remove from My Library"), QDialogButtonBox::ActionRole);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addLayout(middle, 1);
    layout->addWidget(buttons);
    resize(920, 600);

    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(remove_, &QPushButton::clicked, this, &PresetGallery::removeChosen);
    connect(list_, &QListWidget::itemActivated, this, &QDialog::accept);
    connect(list_, &QListWidget::currentItemChanged, this, &PresetGallery::describe);
    connect(groups_, &QComboBox::currentIndexChanged, this, &PresetGallery::fill);
    connect(words_, &QLineEdit::textChanged, this, &PresetGallery::fill);
    readUserLibrary();
}

void PresetGallery::readUserLibrary()
{
    presets_ = shipped_presets();
    shipped_ = presets_.size();
    try {
        for (Preset& preset : read_library(library_.toStdString())) {
            presets_.push_back(std::move(preset));
        }
    } catch (const Error& error) {
        problem_ = QString::fromStdString(error.what());
    }
    const QSignalBlocker quiet(groups_);
    const QString before = groups_->currentText();
    groups_->clear();
    groups_->addItem(tr("All groups"));
    for (const Preset& preset : presets_) {
        if (const QString group = QString::fromStdString(preset.group); groups_->findText(group) < 0) {
            groups_->addItem(group);
        }
    }
    groups_->setCurrentIndex(std::max(0, groups_->findText(before)));
    fill();
}

void PresetGallery::search(const QString& group, const QString& words)
{
    groups_->setCurrentIndex(group.isEmpty() ? 0 : groups_->findText(group));
    words_->setText(words);
}

void PresetGallery::fill()
{
    const QSignalBlocker quiet(list_);
    list_->clear();
    const QStringList words = words_->text().split(' ', Qt::SkipEmptyParts);
    std::vector<std::pair<int, Fabric>> missing;
    for (std::size_t i = 0; i < presets_.size(); ++i) {
        const Preset& preset = presets_[i];
        const QString text = searchText(preset);
        const bool inGroup = groups_->currentIndex() <= 0 || QString::fromStdString(preset.group) == groups_->currentText();
        if (!inGroup || !std::all_of(words.begin(), words.end(), [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); })) {
            continue;
        }
        auto* item = new QListWidgetItem(QString::fromStdString(preset.fabric().name), list_);
        item->setData(Qt::UserRole, static_cast<int>(i));
        QPixmap blank(picture_side, picture_side);
        blank.fill(palette().color(QPalette::AlternateBase));
        item->setIcon(blank);
        missing.emplace_back(static_cast<int>(i), preset.fabric());
    }
    list_->setCurrentRow(list_->count() > 0 ? 0 : -1);
    describe();
    const int pixels = static_cast<int>(picture_side * devicePixelRatioF());
    painter_.run([this, missing, pixels](const NewestJob::Turn& turn) {
        for (const auto& [preset, fabric] : missing) {
            if (turn.outdated()) {
                return;
            }
            const QImage picture = swatchPicture(fabric, pixels);
            turn.deliver([this, number = preset, picture] { showPicture(number, picture); });
        }
    });
}

void PresetGallery::showPicture(int preset, const QImage& picture)
{
    for (int row = 0; row < list_->count(); ++row) {
        if (list_->item(row)->data(Qt::UserRole).toInt() == preset) {
            list_->item(row)->setIcon(QPixmap::fromImage(picture));
        }
    }
}

const Preset* PresetGallery::chosen() const
{
    const QListWidgetItem* item = list_->currentItem();
    return item ? &presets_[static_cast<std::size_t>(item->data(Qt::UserRole).toInt())] : nullptr;
}

void PresetGallery::describe()
{
    const Preset* preset = chosen();
    add_->setEnabled(preset != nullptr);
    remove_->setEnabled(preset && preset - presets_.data() >= static_cast<std::ptrdiff_t>(shipped_));
    if (!preset) {
        about_->setText(problem_.isEmpty() ? tr("No fabric has these words. Take some away.") : problem_);
        return;
    }
    const Fabric& fabric = preset->fabric();
    QString text = "<h4>" + QString::fromStdString(fabric.name).toHtmlEscaped() + "</h4><p>" + QString::fromStdString(preset->note).toHtmlEscaped() + "</p><p>";
    if (!has_error(validate(preset->design))) {
        text += tr("%1 g/m²").arg(shownNumber(quantities_in_use(preset->design, fabric).areal_density_g_m2, 0)) + "<br>";
    }
    text += tr("%1 × %2 per cm").arg(shownNumber(fabric.ends_per_cm, 1), shownNumber(fabric.picks_per_cm, 1)) + "<br>";
    text += QString::fromStdString(fabric.weave.pattern()).toHtmlEscaped() + "</p><p>";
    text += tr("Warp: %1").arg(yarnText(fabric.warp).toHtmlEscaped()) + "<br>" + tr("Weft: %1").arg(yarnText(fabric.weft).toHtmlEscaped()) + "</p>";
    if (!problem_.isEmpty()) {
        text += "<p>" + problem_.toHtmlEscaped() + "</p>";
    }
    about_->setText(text);
}

void PresetGallery::removeChosen()
{
    const Preset* preset = chosen();
    if (!preset || preset - presets_.data() < static_cast<std::ptrdiff_t>(shipped_)) {
        return;
    }
    std::vector<Preset> kept(presets_.begin() + static_cast<std::ptrdiff_t>(shipped_), presets_.end());
    kept.erase(kept.begin() + (preset - presets_.data() - static_cast<std::ptrdiff_t>(shipped_)));
    try {
        write_library(kept, library_.toStdString());
        problem_.clear();
    } catch (const Error& error) {
        problem_ = QString::fromStdString(error.what());
    }
    painter_.drop();
    readUserLibrary();
}

} // namespace hygroloom
