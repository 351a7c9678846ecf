// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The project's fabrics: which one is chosen, and adding, copying, naming and deleting them.
#pragma once

#include "ui/document.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QListWidgetItem;

namespace hygroloom {

class CandidatesPanel : public QWidget {
    Q_OBJECT
public:
    explicit CandidatesPanel(Document& document, QWidget* parent = nullptr);

    /// Add, duplicate, rename and delete, for menus too.
    const QList<QAction*>& fabricActions() const { return actions_; }

    void addFabric();
    void duplicateFabric();
    void renameFabric();
    void deleteFabric();

private:
    void refresh();
    void finishRename(QListWidgetItem* item);

    Document& document_;
    QListWidget* list_;
    QLabel* empty_;
    QList<QAction*> actions_;
};

} // namespace hygroloom
