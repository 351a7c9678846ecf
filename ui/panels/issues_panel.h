// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is wrong with the project, in sentences.
#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QLabel;
class QListWidget;

namespace hygroloom {

/// The issues to show, errors first. Those of a weft that is the same as the warp are shown once.
std::vector<const Issue*> shownIssues(const Document& document);
/// The sentence after what it is about: "Textile F, weft: ...".
QString issueInWords(const Design& design, const Issue& issue);

class IssuesPanel : public QWidget {
    Q_OBJECT
public:
    explicit IssuesPanel(Document& document, QWidget* parent = nullptr);

Q_SIGNALS:
    /// The user wants to see the field at this place.
    void issueActivated(const hygroloom::Place& where);

private:
    void refresh();

    Document& document_;
    QListWidget* list_;
    QLabel* empty_;
};

} // namespace hygroloom
