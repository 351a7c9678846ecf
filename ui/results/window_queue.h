// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The one queue that all runs of the window go through.
#pragma once

#include "core/queue/run_queue.h"

#include <QObject>

namespace hygroloom {

class WindowQueue : public QObject {
    Q_OBJECT
public:
    explicit WindowQueue(QObject* parent = nullptr);

    RunQueue& runs() { return queue_; }
    std::vector<BatchState> list() const { return queue_.list(); }

Q_SIGNALS:
    /// list() may say something else; in the thread of this object, some ten times a second at most.
    void changed();

private:
    std::atomic<bool> told_ = false; ///< changed() will be emitted
    RunQueue queue_;                 // last: its runs end before the rest goes
};

} // namespace hygroloom
