// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The yarns of the chosen fabric, their colours, and the order in which they come: by text, or on the draft's bars.
#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QListWidget;
class QToolButton;

namespace hygroloom {

class OrderEdit;

class OrderEditor : public QWidget {
    Q_OBJECT
public:
    explicit OrderEditor(Document& document, QWidget* parent = nullptr);

    /// The yarn that is drawn with, as yarn_in() numbers them; 0 is the fabric's own warp or weft.
    int chosenYarn() const;
    void chooseYarn(int yarn);
    /// Makes an end (pick) of the given period the chosen yarn.
    void paintThread(Fabric& fabric, bool warp, int thread, int period) const;
    /// Gives the field of the ends' (picks') order the focus.
    void showOrder(bool warp);
    void addYarn();
    void removeYarn();
    void setColor(const QColor& color);

Q_SIGNALS:
    /// The user wants to see the fields of a yarn.
    void yarnActivated(int yarn);

private:
    void refresh();
    void pickColor();
    void setOrder(bool warp, const QString& text);
    void edit(const QString& undo, const std::string& field, const std::function<void(Fabric&)>& change);

    Document& document_;
    QListWidget* list_;
    QToolButton* remove_;
    OrderEdit* orders_[2]; ///< warp, weft
    int fabric_ = -1;      ///< the one shown
};

} // namespace hygroloom
