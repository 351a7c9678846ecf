// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The menu of projects and recordings that were opened or saved last.
#pragma once

#include <QObject>

class QMenu;

namespace hygroloom {

class RecentFiles : public QObject {
    Q_OBJECT
public:
    /// Fills the menu, and keeps it up to date.
    RecentFiles(QMenu& menu, QObject* parent);

    void add(const QString& path);

Q_SIGNALS:
    void chosen(const QString& path);

private:
    void refresh();

    QMenu& menu_;
};

} // namespace hygroloom
