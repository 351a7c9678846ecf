// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/recent_files.h"

#include <QFileInfo>
#include <QMenu>
#include <QSettings>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int most_recent_files = 8;

/// The last folders of a file's path, this many.
QString lastFolders(const QString& path, int count)
{
    const QStringList folders = QFileInfo(path).absolutePath().split('/', Qt::SkipEmptyParts);
    return folders.mid(std::max<qsizetype>(0, folders.size() - count)).join('/');
}

/// The file's name; where another of the files has it, too, with as many folders as tell them apart.
QString nameAmong(const QString& path, const QStringList& files)
{
    const QString name = QFileInfo(path).fileName();
    const auto reads_alike = [&](int folders) {
        return std::any_of(files.begin(), files.end(), [&](const QString& other) {
            return other != path && QFileInfo(other).fileName() == name && lastFolders(other, folders) == lastFolders(path, folders);
        });
    };
    int folders = 0;
    while (reads_alike(folders) && folders < path.count('/')) { ++folders; }
    return folders == 0 ? name : RecentFiles::tr("%1 in %2").arg(name, lastFolders(path, folders));
}

} // namespace

RecentFiles::RecentFiles(QMenu& menu, QObject* parent) : QObject(parent), menu_(menu)
{
    menu_.setToolTipsVisible(true);
    refresh();
}

void RecentFiles::add(const QString& path)
{
    QSettings settings;
    QStringList files = settings.value("recent").toStringList();
    files.removeAll(path);
    files.prepend(path);
    settings.setValue("recent", files.mid(0, most_recent_files));
    refresh();
}

void RecentFiles::refresh()
{
    menu_.clear();
    const QStringList files = QSettings().value("recent").toStringList();
    for (const QString& path : files) {
        QAction* action = menu_.addAction(nameAmong(path, files).replace('&', "&&"));
        action->setToolTip("<p>" + path.toHtmlEscaped() + "</p>");
        action->setStatusTip(path);
        connect(action, &QAction::triggered, this, [this, path] { Q_EMIT chosen(path); });
    }
    if (!files.isEmpty()) {
        menu_.addSeparator();
        connect(menu_.addAction(tr("&Clear List")), &QAction::triggered, this, [this] {
            QSettings().remove("recent");
            refresh();
        });
    }
    menu_.setEnabled(!files.isEmpty());
}

} // namespace hygroloom
