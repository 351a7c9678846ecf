// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/start_page.h"

#include "core/base/error.h"
#include "core/project/library.h"
#include "core/project/project_file.h"
#include "ui/basics/appearance.h"
#include "ui/basics/cache_folder.h"
#include "ui/basics/preferences.h"
#include "ui/weave/cloth_picture.h"

#include <QCheckBox>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QSaveFile>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int side = 88; // pixels of a picture
constexpr int path_role = Qt::UserRole, preset_role = Qt::UserRole + 1, example_role = Qt::UserRole + 2;

/// Whole crossings, as many as show the repeat and the stripes.
QImage pictureOf(const Fabric& fabric)
{
    constexpr int fewest = 22, most = 88;
    const int wanted = std::max({fabric.weave.ends(), fabric.weave.picks(), orderPeriod(fabric, true), orderPeriod(fabric, false)});
    const int ends = std::clamp(wanted, fewest, most);
    const int picks = std::clamp(static_cast<int>(std::lround(ends * fabric.picks_per_cm / fabric.ends_per_cm)), 1, 4 * most);
    return clothPicture(fabric, ends, picks).scaled(2 * side, 2 * side, Qt::IgnoreAspectRatio, Qt::FastTransformation);
}

/// Of a project's first fabric; null where there is none.
QImage pictureOfProject(const QString& path)
{
    const QFileInfo info(path);
    const QString key = path + QString::number(info.size()) + info.lastModified().toString(Qt::ISODateWithMs);
    const QString name = QCryptographicHash::hash(key.toUtf8(), QCryptographicHash::Sha1).toHex() + ".png";
    const QDir folder(cacheFolder() + "/pictures");
    QImage picture(folder.filePath(name));
    if (!picture.isNull()) { return picture; }
    try {
        const Design design = read_project(path.toStdString());
        if (!design.fabrics.empty()) { picture = pictureOf(design.fabrics.front()); }
    } catch (const std::exception&) { // opening it will say why
        return {};
    }
    QDir().mkpath(folder.path());
    QSaveFile file(folder.filePath(name));
    if (file.open(QIODevice::WriteOnly) && picture.save(&file, "PNG")) { file.commit(); }
    return picture;
}

QString titleOf(const QString& path) { return QFileInfo(path).completeBaseName().replace('-', ' '); }

QIcon iconOf(const QImage& picture)
{
    QPixmap pixmap = QPixmap::fromImage(picture);
    pixmap.setDevicePixelRatio(2);
    return QIcon(pixmap);
}

QIcon blank(const QPalette& palette)
{
    QPixmap pixmap(2 * side, 2 * side);
    pixmap.fill(palette.color(QPalette::AlternateBase));
    pixmap.setDevicePixelRatio(2);
    return QIcon(pixmap);
}

/// Pictures with their names in rows that are seen whole: what is left of the height stays free.
class CardList : public QListWidget {
public:
    CardList()
    {
        setViewMode(QListView::IconMode);
        setResizeMode(QListView::Adjust);
        setMovement(QListView::Static);
        setIconSize({side, side});
        setGridSize({side + 28, side + 20 + 2 * fontMetrics().lineSpacing()}); // two lines, and what the list keeps round them
        setWordWrap(true);                 // without uniform sizes: those of the first, of one line, would cut names of two
        setBackgroundRole(QPalette::Base); // below the rows, too
        setAutoFillBackground(true);
    }

    QSize sizeHint() const override { return {QListWidget::sizeHint().width(), heightOf(2)}; }
    QSize minimumSizeHint() const override { return {QListWidget::minimumSizeHint().width(), heightOf(1)}; }

protected:
    void resizeEvent(QResizeEvent* event) override
    {
        QListWidget::resizeEvent(event);
        const int room = height() - 2 * frameWidth(), row = gridSize().height();
        const int rest = room > row ? room % row : 0;
        if (viewportMargins().bottom() != rest) { setViewportMargins(0, 0, 0, rest); }
    }

private:
    int heightOf(int rows) const { return rows * gridSize().height() + 2 * frameWidth(); }
};

} // namespace

StartPage::StartPage(const QStringList& examples, const QStringList& recent, QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("Start"));
    auto* left = new QVBoxLayout;
    addButtons(*left);
    left->addSpacing(12);
    recent_ = addList(*left, tr("Recent"), new QListWidget);
    recent_->setIconSize({32, 32});
    recent_->setTextElideMode(Qt::ElideMiddle);
    auto* right = new QVBoxLayout;
    examples_ = addList(*right, tr("Examples"), new CardList);
    fabrics_ = addList(*right, tr("New project with a fabric of the library"), new CardList);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(16);
    columns->addLayout(left, 1);
    columns->addLayout(right, 3);
    auto* shown = new QCheckBox(tr("&Show at start"));
    shown->setChecked(preferences().start_page != 0);
    connect(shown, &QCheckBox::clicked, this, [](bool on) {
        Preferences chosen = preferences();
        chosen.start_page = on ? 1 : 0;
        setPreferences(chosen);
    });
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setText(tr("&Close"));
    buttons->button(QDialogButtonBox::Close)->setIcon({});
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(shown);
    bottom->addWidget(buttons);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 12);
    layout->setSpacing(12);
    layout->addLayout(columns, 1);
    layout->addLayout(bottom);
    resize(980, std::clamp(sizeHint().height(), 500, std::max(500, screen()->availableSize().height() - 48))); // with its frame
    fill(examples, recent);
}

void StartPage::addButtons(QVBoxLayout& into)
{
    const auto add = [&](const QString& icon, const QString& text, const QString& tip, void (StartPage::*wanted)()) {
        auto* button = new QPushButton(text);
        if (!icon.isEmpty()) { button->setIcon(themedIcon(icon)); }
        button->setToolTip("<p>" + tip + "</p>");
        button->setMinimumHeight(34);
        button->setAutoDefault(false);
        into.addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, wanted] {
            accept();
            Q_EMIT(this->*wanted)();
        });
    };
    add("add", tr("&New Project"), tr("Start with a plain-weave fabric and one droplet."), &StartPage::newWanted);
    add("open", tr("&Open…"), tr("Open a project or a recording."), &StartPage::openWanted);
    add({}, tr("User's &Guide"), tr("How to design a fabric and to run an experiment."), &StartPage::guideWanted);
}

QListWidget* StartPage::addList(QVBoxLayout& into, const QString& title, QListWidget* list)
{
    auto* heading = new QLabel(title);
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    list->setAccessibleName(title);
    into.addWidget(heading);
    into.addWidget(list, 1);
    connect(list, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { choose(*item); }); // the Enter key
    connect(list, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { choose(*item); });
    return list;
}

void StartPage::fill(const QStringList& examples, const QStringList& recent)
{
    const QIcon none = blank(palette());
    for (const QString& path : recent) {
        if (!QFileInfo::exists(path)) { continue; }
        auto* item = new QListWidgetItem(none, QFileInfo(path).fileName(), recent_);
        item->setData(path_role, path);
        item->setToolTip("<p>" + path.toHtmlEscaped() + "</p>");
    }
    for (const QString& path : examples) {
        auto* item = new QListWidgetItem(none, titleOf(path), examples_);
        item->setData(path_role, path);
        item->setData(example_role, true);
        item->setToolTip("<p>" + item->text().toHtmlEscaped() + "</p>");
    }
    int number = 0;
    for (const Preset& preset : shipped_presets()) {
        auto* item = new QListWidgetItem(none, QString::fromStdString(preset.fabric().name), fabrics_);
        item->setData(preset_role, number++);
        item->setToolTip("<p>" + QString::fromStdString(preset.note).toHtmlEscaped() + "</p>");
    }
    for (QListWidget* list : {recent_, examples_, fabrics_}) { list->setCurrentRow(0, QItemSelectionModel::NoUpdate); }
}

/// A double click chooses with its first.
void StartPage::choose(const QListWidgetItem& item)
{
    if (!isVisible()) { return; }
    const QString path = item.data(path_role).toString();
    const bool example = item.data(example_role).toBool();
    const int preset = path.isEmpty() ? item.data(preset_role).toInt() : -1;
    accept();
    if (preset >= 0) {
        Q_EMIT presetChosen(preset);
    } else if (example) {
        Q_EMIT exampleChosen(path);
    } else {
        Q_EMIT fileChosen(path);
    }
}

void StartPage::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    if (!std::exchange(painted_, true)) { QMetaObject::invokeMethod(this, &StartPage::paintPictures, Qt::QueuedConnection); }
}

void StartPage::paintPictures()
{
    struct Wanted {
        QListWidget* list;
        int row;
        QString path;
        int preset;
    };
    std::vector<Wanted> all;
    for (QListWidget* list : {examples_, fabrics_, recent_}) {
        for (int row = 0; row < list->count(); ++row) {
            const QListWidgetItem* item = list->item(row);
            all.push_back({list, row, item->data(path_role).toString(), item->data(preset_role).toInt()});
        }
    }
    painter_.run([all](const NewestJob::Turn& turn) {
        for (const Wanted& one : all) {
            if (turn.outdated()) { return; }
            QImage picture;
            if (one.path.isEmpty()) {
                picture = pictureOf(shipped_presets()[static_cast<std::size_t>(one.preset)].fabric());
            } else if (one.path.endsWith(".hygro", Qt::CaseInsensitive)) {
                picture = pictureOfProject(one.path);
            }
            if (picture.isNull()) { continue; }
            turn.deliver([one, picture] { one.list->item(one.row)->setIcon(iconOf(picture)); });
        }
    });
}

} // namespace hygroloom
