// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fabrics that are dragged over a picture of a garment, and dropped on one of its panels.
#pragma once

#include <QObject>
#include <QPointF>

#include <functional>

class QWidget;

namespace hygroloom {

class PanelDrop : public QObject {
    Q_OBJECT
public:
    /// Watches the drags over a widget, its parent. panel_at: the panel at a pixel of it, -1: none.
    PanelDrop(QWidget* widget, std::function<int(const QPointF&)> panel_at);

    /// The panel under a dragged fabric; -1: none.
    int target() const { return target_; }

Q_SIGNALS:
    void dropped(int panel, const QString& fabric);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setTarget(int panel);

    QWidget* widget_;
    std::function<int(const QPointF&)> panel_at_;
    int target_ = -1;
};

} // namespace hygroloom
