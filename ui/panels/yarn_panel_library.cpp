// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The yarn and the user's library: taken from it, kept in it, replaced by it in all fabrics.
#include "core/base/error.h"
#include "ui/panels/preset_gallery.h"
#include "ui/panels/yarn_panel.h"

#include <QDir>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QToolButton>

namespace hygroloom {

void YarnPanel::addLibrary()
{
    auto* button = new QToolButton;
    button->setText(tr("Yarns…"));
    button->setPopupMode(QToolButton::InstantPopup);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setToolTip("<p>" + tr("Takes the yarn from your library, keeps it there, or replaces it in all fabrics of the project.") +
                       "</p>");
    auto* menu = new QMenu(button);
    button->setMenu(menu);
    form_.addRow(tr("Library"), button);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillLibrary(*menu); });
}

void YarnPanel::fillLibrary(QMenu& menu)
{
    menu.clear();
    qDeleteAll(menu.findChildren<QMenu*>(Qt::FindDirectChildrenOnly)); // which clear() leaves
    QMenu* taken = menu.addMenu(tr("&Take from Library"));
    connect(menu.addAction(tr("&Keep in Library…")), &QAction::triggered, this, &YarnPanel::askToKeep);
    QMenu* replaced = menu.addMenu(tr("&Replace in All Fabrics"));
    menu.setEnabled(yarn() != nullptr);
    try {
        for (const LibraryYarn& one : read_yarns(userLibraryPath().toStdString())) {
            const auto shown = [](const std::string& text) { return QString::fromStdString(text).replace('&', "&&"); };
            const QString name = shown(one.name);
            connect(taken->addAction(name), &QAction::triggered, this, [this, one] { take(one); });
            for (const YarnColour& colour : one.colours) {
                connect(taken->addAction(name + ", " + shown(colour.name)), &QAction::triggered, this,
                        [this, one, colour] { take(one, colour.color); });
            }
            connect(replaced->addAction(name), &QAction::triggered, this, [this, one] { replaceEverywhere(one); });
        }
    } catch (const Error& error) {
        taken->addAction(QString::fromStdString(error.what()))->setEnabled(false);
    }
    for (QMenu* each : {taken, replaced}) { each->setEnabled(!each->isEmpty()); }
}

void YarnPanel::take(const LibraryYarn& from, const std::optional<Color>& color)
{
    form_.document().edit(tr("%1 from the library").arg(kind_), {}, [&](Design& design) {
        const Yarn taken = take_yarn(design, from);
        writing([&](Yarn& own, std::optional<double>) {
            const std::optional<Color> before = own.color;
            own = taken;
            own.color = color ? color : before;
        })(design, {});
    });
    form_.document().endStroke();
}

void YarnPanel::keep(const QString& name, const QString& path) const
{
    QDir().mkpath(QFileInfo(path).absolutePath());
    std::vector<LibraryYarn> yarns = read_yarns(path.toStdString());
    keep_yarn(yarns, library_yarn(*form_.document().design(), *yarn(), name.toStdString()));
    write_yarns(yarns, path.toStdString());
}

void YarnPanel::askToKeep()
{
    const QString name = QInputDialog::getText(&form_, tr("Keep in Library"), tr("Name of the yarn; one of the same name is replaced:"));
    if (name.trimmed().isEmpty()) { return; }
    try {
        keep(name.trimmed(), userLibraryPath());
    } catch (const Error& error) {
        QMessageBox::warning(&form_, tr("Keep in Library"), QString::fromStdString(error.what()));
    }
}

int YarnPanel::replaceEverywhere(const LibraryYarn& by)
{
    const Yarn old = *yarn();
    int changed = 0;
    form_.document().edit(tr("yarn in all fabrics"), {}, [&](Design& design) { changed = replace_yarn(design, old, by); });
    form_.document().endStroke();
    return changed;
}

} // namespace hygroloom
