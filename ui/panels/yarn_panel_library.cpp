// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The yarn and the user's library: taken from it, kept in it, replaced by it in all fabrics.
#include "core/base/error.h"
#include "ui/basics/core_words.h"
#include "ui/panels/preset_gallery.h"
#include "ui/panels/yarn_panel.h"

#include <QInputDialog>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QToolButton>

#include <set>

namespace hygroloom {

void YarnPanel::addLibrary()
{
    library_ = new QToolButton;
    QToolButton* button = library_;
    button->setText(tr("Yarns…"));
    button->setPopupMode(QToolButton::InstantPopup);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setToolTip("<p>" +
                       tr("Takes the yarn from your library, keeps it there, or replaces it in all fabrics of the project. A yarn that "
                          "was taken from it or kept in it bears its name here, and can be brought up to date with it.") +
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
    QAction* updated = menu.addAction(tr("&Update All from Library"));
    updated->setToolTip(tr("Brings all yarns of the project that were taken from the library up to date with it."));
    connect(updated, &QAction::triggered, this, &YarnPanel::updateAndSay);
    QAction* parted = menu.addAction(tr("&Separate from Library"));
    parted->setEnabled(yarn() && !yarn()->library_yarn.empty());
    connect(parted, &QAction::triggered, this,
            [this] { editYarn(tr("separated from the library"), {}, [](Yarn& y) { y.library_yarn.clear(); }); });
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
        Yarn taken = yarn_in_place(design, *yarn(), from);
        if (color) { taken.color = color; }
        writing([&](Yarn& own, std::optional<double>) { own = taken; })(design, {});
    });
    form_.document().endStroke();
}

void YarnPanel::keep(const QString& name, const QString& path)
{
    keep_in_library(library_yarn(*form_.document().design(), *yarn(), name.toStdString()), path.toStdString());
    editYarn(tr("%1 kept in the library").arg(kind_), {}, [&](Yarn& y) { y.library_yarn = name.toStdString(); });
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
    const LibraryYarn old = library_yarn(*form_.document().design(), *yarn(), {});
    std::set<std::string> fabrics;
    form_.document().edit(tr("yarn in all fabrics"), {}, [&](Design& design) {
        for (const YarnUpdate& each : replace_yarn(design, old, by)) { fabrics.insert(each.fabric); }
    });
    form_.document().endStroke();
    return static_cast<int>(fabrics.size());
}

std::vector<YarnUpdate> YarnPanel::updateFrom(const QString& path)
{
    const std::vector<LibraryYarn> library = read_yarns(path.toStdString());
    Design tried = *form_.document().design();
    std::vector<YarnUpdate> updates = update_yarns(tried, library);
    if (tried == *form_.document().design()) { return updates; }
    form_.document().edit(tr("yarns from the library"), {}, [&](Design& design) { update_yarns(design, library); });
    form_.document().endStroke();
    return updates;
}

QString YarnPanel::saidOf(const std::vector<YarnUpdate>& updates)
{
    if (updates.empty()) { return tr("All yarns that were taken from the library are as they are there."); }
    const QLocale locale;
    const auto shown = [&locale](const std::string& text) {
        return text.empty() ? tr("not given") : QString::fromStdString(text).replace('.', locale.decimalPoint());
    };
    QStringList lines;
    for (const YarnUpdate& update : updates) {
        const QString where = update.key == "warp" ? tr("warp") : update.key == "weft" ? tr("weft") : tr("stripe yarn");
        const QString name = QString::fromStdString(update.library_yarn);
        lines << tr("%1, %2: %3").arg(QString::fromStdString(update.fabric), where, name);
        if (update.is_missing) { lines << "    " + tr("The library has no such yarn. It stays as it is."); }
        for (const YarnChange& change : update.changes) {
            lines << "    " + tr("%1: %2 → %3").arg(coreWord(change.label), shown(change.before), shown(change.after));
        }
    }
    return lines.join('\n');
}

void YarnPanel::updateAndSay()
{
    try {
        QMessageBox::information(&form_, tr("Update All from Library"), saidOf(updateFrom(userLibraryPath())));
    } catch (const Error& error) {
        QMessageBox::warning(&form_, tr("Update All from Library"), QString::fromStdString(error.what()));
    }
}

void YarnPanel::refreshLibrary()
{
    const bool refers = yarn() && !yarn()->library_yarn.empty();
    library_->setText(refers ? QString::fromStdString(yarn()->library_yarn).replace('&', "&&") : tr("Yarns…"));
}

} // namespace hygroloom
