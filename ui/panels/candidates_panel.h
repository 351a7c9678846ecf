// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The project's fabrics: which one is chosen, and adding, copying, naming and deleting them.
#pragma once

#include "core/project/library.h"
#include "ui/document/document.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QListWidgetItem;

namespace hygroloom {

class CandidatesPanel : public QWidget {
    Q_OBJECT
public:
    explicit CandidatesPanel(Document& document, QWidget* parent = nullptr);

    /// Add, duplicate, rename, delete, from the library and into it; for menus too.
    const QList<QAction*>& fabricActions() const { return actions_; }

    void addFabric();
    /// One more candidate, chosen; a name that is taken gets a number.
    void addFabric(const QString& undo, Fabric fabric);
    void duplicateFabric();
    void chooseFromLibrary();
    void addPreset(const Preset& preset);
    /// One of shipped_presets().
    void addShipped(int preset);
    void keepFabric();
    void renameFabric();
    void deleteFabric();

Q_SIGNALS:
    /// A sentence about what was done, or why it was not.
    void reported(const QString& sentence, bool problem);

private:
    void refresh();
    void finishRename(QListWidgetItem* item);

    Document& document_;
    QListWidget* list_;
    QLabel* empty_;
    QList<QAction*> actions_;
};

} // namespace hygroloom
