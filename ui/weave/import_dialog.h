// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What was understood of an imported draft and what was repaired, before it becomes a candidate.
#pragma once

#include "core/project/draft_import.h"

#include <QDialog>

class QCheckBox;
class QLineEdit;

namespace hygroloom {

class ImportDialog : public QDialog {
    Q_OBJECT
public:
    explicit ImportDialog(DraftImport draft, QWidget* parent = nullptr);

    /// With the name and the suggested numbers that were chosen.
    Fabric fabric() const;

private:
    QWidget* buildReport();
    QWidget* buildPreview();
    QCheckBox* addSuggestion(const QString& label, const QString& unit, const Suggestion& suggestion);

    DraftImport draft_;
    QLineEdit* name_;
    QCheckBox* ends_ = nullptr;
    QCheckBox* picks_ = nullptr;
    QCheckBox* warp_ = nullptr;
    QCheckBox* weft_ = nullptr;
};

} // namespace hygroloom
