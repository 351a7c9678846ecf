// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The workspace in which fabrics are designed: its panels, and what they do to each other.
#pragma once

#include <QObject>

class QDockWidget;
class QMainWindow;

namespace hygroloom {

class CandidatesPanel;
class Document;
class DraftEditor;
class FabricPanel;
class LivePanel;
class Place;
class Viewport;
class WeaveEditor;

class DesignWorkspace : public QObject {
    Q_OBJECT
public:
    struct Docks {
        QDockWidget* candidates = nullptr;
        QDockWidget* weave = nullptr;
        QDockWidget* draft = nullptr;
        QDockWidget* fabric = nullptr;
        QDockWidget* live = nullptr;
    };

    DesignWorkspace(Document& document, Viewport& viewport, QMainWindow& window);

    CandidatesPanel& candidates() { return *candidates_; }
    LivePanel& live() { return *live_; }
    const Docks& docks() const { return docks_; }
    /// Focuses the field of a value of the chosen fabric. where: its path in the project; part: the same within the fabric.
    void showFabricIssue(const Place& where);
    /// Focuses the field of a value of one of the project's own materials, and selects a fabric that uses it.
    void showMaterialIssue(const Place& where);

Q_SIGNALS:
    void problemFound(const QString& sentence);
    /// For the status bar, for a time in ms.
    void messageShown(const QString& sentence, int ms);

private:
    void connectParts(Viewport& viewport);

    Document& document_;
    QMainWindow& window_;
    CandidatesPanel* candidates_;
    WeaveEditor* weave_;
    DraftEditor* draft_;
    FabricPanel* fabric_;
    LivePanel* live_;
    Docks docks_;
};

} // namespace hygroloom
