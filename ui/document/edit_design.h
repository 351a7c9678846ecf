// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The one undo command: every edit replaces the whole design, which is cheap to copy.
#pragma once

#include "core/design/design.h"

#include <QUndoCommand>

#include <functional>
#include <memory>

namespace hygroloom {

/// What the document shows: the design, and which of its fabrics and experiments.
struct DesignState {
    std::shared_ptr<const Design> design;
    int fabric = 0;
    int experiment = 0;
    QString folder{}; ///< from which the design names files; empty: none
};

/// Consecutive edits with the same non-empty field and stroke become one, so that a drag is undone at once.
class EditDesign : public QUndoCommand {
public:
    /// apply: shows a state in the document.
    EditDesign(std::function<void(const DesignState&)> apply, const QString& text, DesignState before, DesignState after, std::string field,
               int stroke);

    void undo() override;
    void redo() override;
    int id() const override { return 1; }
    bool mergeWith(const QUndoCommand* other) override;

private:
    std::function<void(const DesignState&)> apply_;
    DesignState before_;
    DesignState after_;
    std::string field_;
    int stroke_;
};

} // namespace hygroloom
