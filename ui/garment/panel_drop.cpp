// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/panel_drop.h"

#include "ui/garment/garment_panel.h"

#include <QDropEvent>
#include <QMimeData>
#include <QWidget>

namespace hygroloom {

PanelDrop::PanelDrop(QWidget* widget, std::function<int(const QPointF&)> panel_at)
    : QObject(widget), widget_(widget), panel_at_(std::move(panel_at))
{
    widget->setAcceptDrops(true);
    widget->installEventFilter(this);
}

void PanelDrop::setTarget(int panel)
{
    if (panel == target_) { return; }
    target_ = panel;
    widget_->update();
}

bool PanelDrop::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::DragEnter: {
        auto* enter = static_cast<QDragEnterEvent*>(event);
        if (enter->mimeData()->hasFormat(fabric_mime)) { enter->acceptProposedAction(); }
        return true;
    }
    case QEvent::DragMove: {
        auto* move = static_cast<QDragMoveEvent*>(event);
        setTarget(panel_at_(move->position()));
        move->setAccepted(target_ >= 0);
        return true;
    }
    case QEvent::DragLeave: setTarget(-1); return true;
    case QEvent::Drop: {
        auto* drop = static_cast<QDropEvent*>(event);
        const int panel = panel_at_(drop->position());
        setTarget(-1);
        if (panel < 0) { return true; }
        drop->acceptProposedAction();
        Q_EMIT dropped(panel, QString::fromUtf8(drop->mimeData()->data(fabric_mime)));
        return true;
    }
    default: return QObject::eventFilter(watched, event);
    }
}

} // namespace hygroloom
