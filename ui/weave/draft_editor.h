// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The draft of the chosen fabric's weave, and the order of its yarns. A weave without a draft shows its smallest one.
#pragma once

#include "ui/document/document.h"
#include "ui/weave/draft_paper.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace hygroloom {

class OrderEditor;

class DraftEditor : public QWidget {
    Q_OBJECT
public:
    explicit DraftEditor(Document& document, QWidget* parent = nullptr);

    DraftPaper* paper() { return paper_; }
    OrderEditor* order() { return order_; }
    /// What is shown: the weave's own draft, or the smallest one.
    const Draft& draft() const { return paper_->draft(); }
    /// Gives the weave its smallest draft.
    void findDraft();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* buildBar();
    QSpinBox* addCount(QHBoxLayout* row, const QString& name, void (DraftEditor::*work)(int));
    void addChoices(QHBoxLayout* row);
    void refresh();
    struct PaintedCell {
        DraftPart part;
        QPoint cell;
        bool fill, add;
    };
    /// A fabric with what was painted since, and the draft that is shown with it.
    struct Sketch {
        Fabric fabric;
        Draft draft;
    };
    void paint(const PaintedCell& painted);
    void paintInto(Sketch& sketch, const std::vector<PaintedCell>& cells) const;
    void sketchStroke();
    void finishStroke();
    void setDraft(const QString& undo, const std::string& field, Draft draft);
    void setShafts(int shafts);
    void setTreadles(int treadles);

    Document& document_;
    DraftPaper* paper_;
    OrderEditor* order_;
    QSpinBox* shafts_ = nullptr;
    QSpinBox* treadles_ = nullptr;
    QComboBox* plan_ = nullptr;
    QComboBox* shed_ = nullptr;
    QPushButton* find_ = nullptr;
    QLabel* note_ = nullptr;
    std::optional<Fabric> shown_;
    std::vector<PaintedCell> stroke_; ///< what is painted and not yet in the design
    std::size_t sketched_ = 0;        ///< of the stroke
    std::optional<Sketch> sketch_;
    QTimer later_; ///< sketches a move at once, however many squares it passes
};

} // namespace hygroloom
