// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/design_workspace.h"

#include "ui/document/document.h"
#include "ui/panels/candidates_panel.h"
#include "ui/panels/fabric_panel.h"
#include "ui/picture/viewport.h"
#include "ui/results/live_panel.h"
#include "ui/weave/draft_editor.h"
#include "ui/weave/order_editor.h"
#include "ui/weave/point_paper.h"
#include "ui/weave/weave_editor.h"
#include "ui/window/docks.h"

#include <algorithm>

namespace hygroloom {

DesignWorkspace::DesignWorkspace(Document& document, Viewport& viewport, QMainWindow& window)
    : document_(document), window_(window), candidates_(new CandidatesPanel(document)), weave_(new WeaveEditor(document)),
      draft_(new DraftEditor(document)), fabric_(new FabricPanel(document)), live_(new LivePanel(document))
{
    docks_.candidates = makeDock(window, "candidates", tr("Candidates"), candidates_);
    docks_.weave = makeDock(window, "weave", tr("Weave"), weave_);
    docks_.draft = makeDock(window, "draft", tr("Draft"), draft_);
    docks_.fabric = makeDock(window, "fabric", tr("Fabric"), fabric_);
    docks_.live = makeDock(window, "live", tr("Water, live"), live_);
    connectParts(viewport);
}

void DesignWorkspace::connectParts(Viewport& viewport)
{
    connect(weave_->paper(), &PointPaper::crossingHovered, &viewport, &Viewport::setHighlight);
    connect(&viewport, &Viewport::repeatHovered, weave_->paper(), &PointPaper::setHighlight);
    connect(&viewport, &Viewport::repeatSelected, weave_->paper(), &PointPaper::setSelectedYarn);
    connect(candidates_, &CandidatesPanel::reported, this, [this](const QString& sentence, bool problem) {
        if (problem) {
            Q_EMIT problemFound(sentence);
        } else {
            Q_EMIT messageShown(sentence, 4000);
        }
    });
    connect(weave_, &WeaveEditor::draftRequested, this, [this] {
        docks_.draft->setVisible(true);
        window_.resizeDocks({docks_.draft}, {std::max(300, window_.height() * 2 / 5)}, Qt::Vertical);
        draft_->paper()->setFocus();
    });
    connect(draft_->order(), &OrderEditor::yarnActivated, this, [this](int yarn) {
        reveal(docks_.fabric);
        fabric_->showYarn(yarn);
    });
}

void DesignWorkspace::showFabricIssue(const Place& where)
{
    const std::string part = where.key(2);
    if (part.empty() || part == "name") {
        reveal(docks_.candidates);
        candidates_->setFocus();
    } else if (part == "weave") {
        reveal(docks_.weave);
        weave_->paper()->setFocus();
    } else if (part == "warp_order" || part == "weft_order") {
        reveal(docks_.draft);
        draft_->order()->showOrder(part == "warp_order");
    } else {
        reveal(docks_.fabric);
        fabric_->showField(where);
    }
}

/// Under the fabric that uses the material, where one does.
void DesignWorkspace::showMaterialIssue(const Place& where)
{
    const Design& design = *document_.design();
    const std::size_t material = where.number(0).value_or(0);
    if (material >= design.materials.size()) { return; }
    const std::string& name = design.materials[material].name;
    const auto made_of = [&name](const Yarn& yarn) {
        const auto names = materials_in(yarn);
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    const auto uses = [&](const Fabric& fabric) {
        return made_of(fabric.warp) || made_of(fabric.weft) || std::any_of(fabric.extra_yarns.begin(), fabric.extra_yarns.end(), made_of);
    };
    if (!document_.fabric() || !uses(*document_.fabric())) {
        const auto found = std::find_if(design.fabrics.begin(), design.fabrics.end(), uses);
        if (found != design.fabrics.end()) { document_.setFabricIndex(static_cast<int>(found - design.fabrics.begin())); }
    }
    reveal(docks_.fabric);
    if (!fabric_->showField(where)) {
        Q_EMIT messageShown(tr("Edit this value of “%1” in the project file, under “materials”.").arg(QString::fromStdString(name)), 8000);
    }
}

} // namespace hygroloom
