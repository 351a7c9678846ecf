// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/window_queue.h"

#include <QTimer>

namespace hygroloom {

WindowQueue::WindowQueue(QObject* parent)
    : QObject(parent), queue_([this] {
          constexpr int pause = 100; // ms
          if (told_.exchange(true)) { return; }
          const auto tell = [this] {
              told_ = false;
              Q_EMIT changed();
          };
          QMetaObject::invokeMethod(
              this, [this, tell] { QTimer::singleShot(pause, this, tell); }, Qt::QueuedConnection);
      })
{
}

} // namespace hygroloom
