// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/recent_files.h"

#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace hygroloom {

namespace {

constexpr int most_recent_files = 8;

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
        QAction* action = menu_.addAction(QFileInfo(path).fileName());
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
