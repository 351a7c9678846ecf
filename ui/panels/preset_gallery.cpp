// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/preset_gallery.h"

#include "core/base/error.h"
#include "core/design/fitted_fabric.h"
#include "core/design/validate.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity.h"
#include "ui/picture/swatch_painter.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStandardPaths>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int picture_side = 112; // pixels

QString yarnText(const Yarn& yarn)
{
    QStringList fibres;
    for (const MaterialShare& share : yarn.material) {
        fibres << (yarn.material.size() > 1 ? PresetGallery::tr("%1 % %2").arg(std::lround(share.share * 100)).arg(coreWord(share.name))
                                            : coreWord(share.name));
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
    return QString::fromStdString(preset.fabric().name + " " + preset.group + " " + preset.note + " " + preset.fabric().weave.pattern()) +
           " " + coreWord(preset.group) + " " + yarnText(preset.fabric().warp) + " " + yarnText(preset.fabric().weft);
}

} // namespace

QString userLibraryPath() { return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath("library.json"); }

void keepInLibrary(const Design& design, const Fabric& fabric, const QString& path)
{
    keep_in_library(
        preset_of(design, fabric, PresetGallery::tr("My library").toStdString(), PresetGallery::tr("Saved by you.").toStdString()),
        path.toStdString());
}

PresetGallery::PresetGallery(const QString& library, QWidget* parent)
    : QDialog(parent), library_(library), groups_(new QComboBox), words_(new QLineEdit), list_(new QListWidget), about_(new QLabel),
      surface_(swatchSurface())
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
    list_->setGridSize({picture_side + 24, picture_side + 40});
    list_->setWordWrap(true);
    list_->setUniformItemSizes(true);
    about_->setWordWrap(true);
    about_->setAccessibleName(tr("About the selected fabric"));
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
    resize(990, 620);

    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(remove_, &QPushButton::clicked, this, &PresetGallery::removeChosen);
    connect(list_, &QListWidget::itemActivated, this, &QDialog::accept);
    connect(list_, &QListWidget::currentItemChanged, this, &PresetGallery::describe);
    connect(groups_, &QComboBox::currentIndexChanged, this, &PresetGallery::fill);
    connect(words_, &QLineEdit::textChanged, this, &PresetGallery::fill);
    connect(list_->verticalScrollBar(), &QScrollBar::valueChanged, this, &PresetGallery::paintVisible);
    connect(list_->verticalScrollBar(), &QScrollBar::rangeChanged, this, &PresetGallery::paintVisible);
    readUserLibrary();
}

PresetGallery::~PresetGallery() = default;

void PresetGallery::readUserLibrary()
{
    painter_.drop();
    pictures_.clear();
    presets_ = shipped_presets();
    shipped_ = presets_.size();
    try {
        for (Preset& preset : read_library(library_.toStdString())) { presets_.push_back(std::move(preset)); }
    } catch (const Error& error) {
        problem_ = QString::fromStdString(error.what());
    }
    const QSignalBlocker quiet(groups_);
    const QString before = groups_->currentText();
    groups_->clear();
    groups_->addItem(tr("All groups"));
    for (const Preset& preset : presets_) {
        if (const QString group = coreWord(preset.group); groups_->findText(group) < 0) { groups_->addItem(group); }
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
    for (std::size_t i = 0; i < presets_.size(); ++i) {
        const Preset& preset = presets_[i];
        const QString text = searchText(preset);
        const bool inGroup = groups_->currentIndex() <= 0 || coreWord(preset.group) == groups_->currentText();
        if (!inGroup ||
            !std::all_of(words.begin(), words.end(), [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); })) {
            continue;
        }
        auto* item = new QListWidgetItem(QString::fromStdString(preset.fabric().name), list_);
        item->setData(Qt::UserRole, static_cast<int>(i));
        if (const auto painted = pictures_.find(static_cast<int>(i)); painted != pictures_.end()) {
            item->setIcon(painted->second);
        } else {
            QPixmap blank(picture_side, picture_side);
            blank.fill(palette().color(QPalette::AlternateBase));
            item->setIcon(blank);
        }
    }
    list_->setCurrentRow(list_->count() > 0 ? 0 : -1);
    describe();
    paintVisible();
}

void PresetGallery::paintVisible()
{
    std::vector<std::pair<int, std::shared_ptr<const Design>>> missing;
    for (int row = 0; row < list_->count(); ++row) {
        const int preset = list_->item(row)->data(Qt::UserRole).toInt();
        if (!pictures_.count(preset) && list_->visualItemRect(list_->item(row)).intersects(list_->viewport()->rect())) {
            const Design& design = presets_[static_cast<std::size_t>(preset)].design;
            if (!has_error(validate(design))) { missing.emplace_back(preset, std::make_shared<const Design>(design)); }
        }
    }
    if (missing.empty()) { return; }
    painter_.run([this, missing, surface = surface_.get(), pixels = static_cast<int>(picture_side * devicePixelRatioF()),
                  colors = pictureColors(palette())](const NewestJob::Turn& turn) {
        SwatchPainter painter(surface, QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).filePath("swatches"), pixels,
                              colors);
        for (const auto& [preset, design] : missing) {
            turn.deliver([this, number = preset, picture = painter.picture(design), turn] {
                if (!turn.outdated()) { showPicture(number, picture); }
            });
            if (turn.outdated()) { return; }
        }
    });
}

void PresetGallery::showPicture(int preset, const QImage& picture)
{
    QPixmap pixmap = QPixmap::fromImage(picture);
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // its own colours, chosen or not
    pictures_[preset] = icon;
    for (int row = 0; row < list_->count(); ++row) {
        if (list_->item(row)->data(Qt::UserRole).toInt() == preset) { list_->item(row)->setIcon(icon); }
    }
}

void PresetGallery::resizeEvent(QResizeEvent* event)
{
    QDialog::resizeEvent(event);
    QTimer::singleShot(0, this, &PresetGallery::paintVisible); // when the list has its new size
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
        about_->setText(problem_.isEmpty() ? tr("No fabric matches. Use fewer words.") : "<p>" + problem_.toHtmlEscaped() + "</p>");
        return;
    }
    const Fabric& fabric = preset->fabric();
    QString text = "<h4>" + QString::fromStdString(fabric.name).toHtmlEscaped() + "</h4><p>" +
                   QString::fromStdString(preset->note).toHtmlEscaped() + "</p><p>";
    if (!has_error(validate(preset->design))) {
        text += tr("%1 g/m²").arg(shownNumber(quantities_in_use(preset->design, fabric).areal_density_g_m2, 0)) + "<br>";
    }
    text += tr("%1 × %2 per cm").arg(shownNumber(fabric.ends_per_cm, 1), shownNumber(fabric.picks_per_cm, 1)) + "<br>";
    text += QString::fromStdString(fabric.weave.pattern()).toHtmlEscaped() + "</p><p>";
    text += tr("Warp: %1").arg(yarnText(fabric.warp).toHtmlEscaped()) + "<br>" + tr("Weft: %1").arg(yarnText(fabric.weft).toHtmlEscaped()) +
            "</p>";
    if (!problem_.isEmpty()) { text += "<p>" + problem_.toHtmlEscaped() + "</p>"; }
    about_->setText(text);
}

void PresetGallery::removeChosen()
{
    const Preset* preset = chosen();
    if (!preset || preset - presets_.data() < static_cast<std::ptrdiff_t>(shipped_)) { return; }
    std::vector<Preset> kept(presets_.begin() + static_cast<std::ptrdiff_t>(shipped_), presets_.end());
    kept.erase(kept.begin() + (preset - presets_.data() - static_cast<std::ptrdiff_t>(shipped_)));
    try {
        write_library(kept, library_.toStdString());
        problem_.clear();
    } catch (const Error& error) {
        problem_ = QString::fromStdString(error.what());
    }
    readUserLibrary();
}

} // namespace hygroloom
