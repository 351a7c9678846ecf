// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers of the garment, its panels and zones at the time shown; of A and B side by side where a run is kept.
#pragma once

#include "ui/garment/wear_playback.h"

#include <QTableWidget>

namespace hygroloom {

class PartsTable : public QTableWidget {
    Q_OBJECT
public:
    explicit PartsTable(WearPlayback& playback, QWidget* parent = nullptr);

    /// All of it, with a line of titles; numbers with a point.
    QString csv() const;
    void copy() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void refresh();

    WearPlayback& playback_;
};

} // namespace hygroloom
