// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The weave of the chosen fabric: a pattern from the list, or a matrix drawn and changed with tools.
#pragma once

#include "ui/document/document.h"
#include "ui/weave/weave_edits.h"

#include <QWidget>

class QComboBox;
class QGridLayout;
class QLabel;
class QSpinBox;

namespace hygroloom {

class PointPaper;
class WeaveNotes;

class WeaveEditor : public QWidget {
    Q_OBJECT
public:
    explicit WeaveEditor(Document& document, QWidget* parent = nullptr);

    PointPaper* paper() { return paper_; }
    const WeaveNotes* notes() const { return notes_; }
    /// Of tools and of what they do, by object name ("rectangle", "mirror-ends", ...); nullptr when there is none.
    QAction* action(const QString& name) const;

Q_SIGNALS:
    void draftRequested();

private:
    void addPatterns();
    void refresh();
    void choosePattern();
    void resizeRepeat();
    void setWeave(const QString& undo, const std::string& field, const Weave& weave);
    // weave_editor_actions.cpp
    QAction* addTool(const QString& name, const QString& text, const QKeySequence& shortcut, std::function<void()> work);
    void addPaperTools();
    void addTurns();
    void addClipboard();
    void addInsertions();
    QWidget* buildTools();
    /// Of the selection when there is one, else of the whole repeat.
    void change(const QString& undo, const std::function<Weave(const Weave&)>& work);
    void copy();
    void paste();
    void clear(const QString& undo);
    void complain(QWidget* at, const QString& sentence);

    Document& document_;
    QComboBox* pattern_;
    QSpinBox* ends_;
    QSpinBox* picks_;
    PointPaper* paper_;
    WeaveNotes* notes_;
    QList<QAction*> actions_;
};

} // namespace hygroloom
