// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which cloths lie on the table: the project's and the library's fabrics, two to four of them.
#pragma once

#include "core/lesson/lesson.h"

#include <QDialog>

class QDialogButtonBox;
class QLabel;
class QListWidget;

namespace hygroloom {

/// Fabrics that can lie on the table, the project's first.
std::vector<LessonCloth> clothsToChoose(const Design& design);

class ClothChoice : public QDialog {
    Q_OBJECT
public:
    ClothChoice(const Design& design, QWidget* parent = nullptr);

    std::vector<LessonCloth> chosen() const;
    QListWidget& list() { return *list_; }

private:
    void refresh();

    std::vector<LessonCloth> offered_;
    QListWidget* list_;
    QLabel* note_;
    QDialogButtonBox* buttons_;
};

} // namespace hygroloom
