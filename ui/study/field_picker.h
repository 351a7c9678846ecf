// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The choice of fields that a study changes: the numbers of a project, found by letters of their names.
#pragma once

#include "core/study/study.h"
#include "ui/study/study_fields.h"

#include <QDialog>

class QDialogButtonBox;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace hygroloom {

class FieldPicker : public QDialog {
    Q_OBJECT
public:
    /// taken: paths that are factors already, which cannot be chosen again; nor can what the study does not run.
    FieldPicker(const Design& design, const Study& study, const QStringList& taken, QWidget* parent = nullptr);

    std::vector<StudyField> chosen() const;
    void setFilter(const QString& letters);
    /// Of the fields that the filter leaves.
    QStringList shownPaths() const;
    /// Selects fields by their paths.
    void select(const QStringList& paths);

private:
    void fill(const Design& design, const Study& study, const QStringList& taken);
    void filter();

    std::vector<StudyField> fields_;
    QLineEdit* letters_;
    QTreeWidget* tree_;
    QDialogButtonBox* buttons_;
};

} // namespace hygroloom
