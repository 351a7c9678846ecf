// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The weave editor's tools: what they are called, their keys, and what they do to the weave.
#include "ui/basics/appearance.h"
#include "ui/weave/point_paper.h"
#include "ui/weave/weave_editor.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QGridLayout>
#include <QToolButton>
#include <QToolTip>

namespace hygroloom {

namespace {

constexpr int tools_in_a_row = 8;

} // namespace

QAction* WeaveEditor::action(const QString& name) const
{
    for (QAction* action : actions_) {
        if (action->objectName() == name) { return action; }
    }
    return nullptr;
}

QAction* WeaveEditor::addTool(const QString& name, const QString& text, const QKeySequence& shortcut, std::function<void()> work)
{
    auto* action = new QAction(themedIcon(name), text, this);
    action->setObjectName(name);
    action->setShortcut(shortcut);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(tr("%1 (%2)").arg(text, shortcut.toString(QKeySequence::NativeText)));
    connect(action, &QAction::triggered, this, [this, work = std::move(work)] {
        if (document_.fabric()) { work(); }
    });
    paper_->addAction(action);
    actions_ << action;
    return action;
}

void WeaveEditor::addPaperTools()
{
    auto* group = new QActionGroup(this);
    const auto tool = [&](const char* name, const QString& text, const char* key, PaperTool chosen) {
        QAction* action = addTool(name, text, QKeySequence(key), [this, chosen] { paper_->setTool(chosen); });
        action->setCheckable(true);
        action->setChecked(chosen == PaperTool::brush);
        group->addAction(action);
    };
    tool("brush", tr("Brush"), "B", PaperTool::brush);
    tool("line", tr("Line"), "L", PaperTool::line);
    tool("rectangle", tr("Rectangle"), "R", PaperTool::rectangle);
    tool("fill", tr("Fill"), "F", PaperTool::fill);
    tool("select", tr("Select"), "S", PaperTool::select);
    addTool("zoom-in", tr("Zoom In"), QKeySequence("+"), [this] { paper_->zoomBy(1.25); });
    addTool("zoom-out", tr("Zoom Out"), QKeySequence("-"), [this] { paper_->zoomBy(0.8); });
    addTool("fit", tr("Fit the Repeat"), QKeySequence("0"), [this] { paper_->zoomToFit(); });
}

void WeaveEditor::addTurns()
{
    addTool("mirror-ends", tr("Mirror Left and Right"), QKeySequence("H"), [this] { change(tr("mirrored ends"), endsMirrored); });
    addTool("mirror-picks", tr("Mirror Top and Bottom"), QKeySequence("V"), [this] { change(tr("mirrored picks"), picksMirrored); });
    addTool("invert", tr("Invert"), QKeySequence("I"), [this] { change(tr("inverted weave"), inverted); });
    addTool("rotate", tr("Rotate by 90°"), QKeySequence("T"), [this] { change(tr("rotated weave"), rotated); });
    const auto shift = [&](const char* name, const QString& text, const char* key, int ends, int picks) {
        addTool(name, text, QKeySequence(key),
                [=, this] { change(tr("shifted weave"), [=](const Weave& w) { return shifted(w, ends, picks); }); });
    };
    shift("shift-left", tr("Shift Left"), "Alt+Left", -1, 0);
    shift("shift-right", tr("Shift Right"), "Alt+Right", 1, 0);
    shift("shift-up", tr("Shift Up"), "Alt+Up", 0, 1);
    shift("shift-down", tr("Shift Down"), "Alt+Down", 0, -1);
}

/// With the keys by name: QKeySequence::Paste also is Shift+Insert on some desktops, which inserts a pick here.
void WeaveEditor::addClipboard()
{
    addTool("cut", tr("Cut"), QKeySequence("Ctrl+X"), [this] {
        copy();
        clear(tr("cut weave"));
    });
    addTool("copy", tr("Copy"), QKeySequence("Ctrl+C"), [this] { copy(); });
    addTool("paste", tr("Paste"), QKeySequence("Ctrl+V"), [this] { paste(); });
    addTool("clear", tr("Clear"), QKeySequence::Delete, [this] { clear(tr("cleared weave")); });
}

void WeaveEditor::addInsertions()
{
    const auto weave = [this]() -> const Weave& { return document_.fabric()->weave; };
    addTool("insert-end", tr("Insert End"), QKeySequence("Insert"), [=, this] {
        if (weave().ends() < largest_repeat) { setWeave(tr("inserted end"), {}, withEndInserted(weave(), paper_->cursor().x())); }
    });
    addTool("insert-pick", tr("Insert Pick"), QKeySequence("Shift+Insert"), [=, this] {
        if (weave().picks() < largest_repeat) { setWeave(tr("inserted pick"), {}, withPickInserted(weave(), paper_->cursor().y())); }
    });
    addTool("delete-end", tr("Delete End"), QKeySequence("Ctrl+Delete"), [=, this] {
        if (weave().ends() > 1) { setWeave(tr("deleted end"), {}, withoutEnd(weave(), paper_->cursor().x())); }
    });
    addTool("delete-pick", tr("Delete Pick"), QKeySequence("Ctrl+Shift+Delete"), [=, this] {
        if (weave().picks() > 1) { setWeave(tr("deleted pick"), {}, withoutPick(weave(), paper_->cursor().y())); }
    });
}

QWidget* WeaveEditor::buildTools()
{
    addPaperTools();
    addTurns();
    addClipboard();
    addInsertions();
    auto* tools = new QWidget;
    auto* grid = new QGridLayout(tools);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(1);
    for (int i = 0; i < actions_.size(); ++i) {
        auto* button = new QToolButton;
        button->setDefaultAction(actions_[i]);
        button->setAutoRaise(true);
        button->setIconSize({16, 16});
        button->setAccessibleName(actions_[i]->text());
        grid->addWidget(button, i / tools_in_a_row, i % tools_in_a_row);
    }
    grid->setColumnStretch(tools_in_a_row, 1);
    paper_->setContextMenuPolicy(Qt::ActionsContextMenu);
    return tools;
}

void WeaveEditor::change(const QString& undo, const std::function<Weave(const Weave&)>& work)
{
    const Weave& whole = document_.fabric()->weave;
    const QRect area = paper_->selection();
    if (area.isEmpty()) {
        setWeave(undo, {}, work(whole));
        return;
    }
    setWeave(undo, {}, withPart(whole, area.topLeft(), work(partOf(whole, area))));
}

void WeaveEditor::copy()
{
    const Weave& whole = document_.fabric()->weave;
    const QRect area = paper_->selection();
    QApplication::clipboard()->setText(gridText(area.isEmpty() ? whole : partOf(whole, area)));
}

void WeaveEditor::paste()
{
    QString why;
    const std::optional<Weave> part = weaveFromText(QApplication::clipboard()->text(), &why);
    const Weave& whole = document_.fabric()->weave;
    if (part && (part->ends() > whole.ends() || part->picks() > whole.picks())) {
        why = tr("The copied part of %1 × %2 crossings does not fit into the repeat of %3 × %4. Enlarge the repeat first.")
                  .arg(part->ends())
                  .arg(part->picks())
                  .arg(whole.ends())
                  .arg(whole.picks());
    }
    if (!why.isEmpty()) {
        complain(paper_, why);
        return;
    }
    const QPoint at = paper_->selection().isEmpty() ? paper_->cursor() : paper_->selection().topLeft();
    setWeave(tr("pasted weave"), {}, withPart(whole, at, *part));
    paper_->setSelection({at, QSize(part->ends(), part->picks())});
}

void WeaveEditor::clear(const QString& undo)
{
    const Weave& whole = document_.fabric()->weave;
    const QRect area = paper_->selection();
    setWeave(undo, {}, withPainted(whole, areaOf(area.isEmpty() ? QRect(0, 0, whole.ends(), whole.picks()) : area), false));
}

void WeaveEditor::complain(QWidget* at, const QString& sentence)
{
    QToolTip::showText(at->mapToGlobal(QPoint(0, at->height())), "<p>" + sentence.toHtmlEscaped() + "</p>", at);
}

} // namespace hygroloom
