// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/document/edit_design.h"

namespace hygroloom {

EditDesign::EditDesign(std::function<void(const DesignState&)> apply, const QString& text, DesignState before, DesignState after,
                       std::string field, int stroke)
    : QUndoCommand(text), apply_(std::move(apply)), before_(std::move(before)), after_(std::move(after)), field_(std::move(field)),
      stroke_(stroke)
{
}

void EditDesign::undo() { apply_(before_); }

void EditDesign::redo() { apply_(after_); }

bool EditDesign::mergeWith(const QUndoCommand* other)
{
    const auto& next = static_cast<const EditDesign&>(*other);
    if (field_.empty() || field_ != next.field_ || stroke_ != next.stroke_) { return false; }
    after_ = next.after_;
    return true;
}

} // namespace hygroloom
