// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The lesson on screen, 1280 x 800: a drop on each of its three cloths of 40 x 40 mm, ten seconds long. Pictures a second, simulated time
// per real time, ms from a click to its picture. QT_QPA_PLATFORM=offscreen will do.
#include "ui/basics/appearance.h"
#include "ui/document/document.h"
#include "ui/lesson/lesson_scene.h"
#include "ui/lesson/lesson_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QEventLoop>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <vector>

using namespace hygroloom;

namespace {

/// Counts pictures of the widget that it watches.
class Pictures : public QObject {
public:
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::Paint) {
            if (clock.isValid()) { apart.push_back(1e-9 * static_cast<double>(clock.nsecsElapsed())); }
            clock.start();
        }
        return false;
    }
    QElapsedTimer clock;
    std::vector<double> apart; ///< s, from one picture to the next
};

void wait(int ms)
{
    QEventLoop waits;
    QTimer::singleShot(ms, &waits, &QEventLoop::quit);
    waits.exec();
}

} // namespace

int main(int argc, char** argv)
{
    const QApplication application(argc, argv);
    useResources();
    const Document document;
    LessonWindow window(document);
    window.resize(1280, 800);
    window.show();
    const auto laid_out = [&] {
        for (int k = 0; k < window.table()->cloths(); ++k) {
            if (!window.table()->view(k)) { return false; }
        }
        return true;
    };
    while (!laid_out()) { wait(20); }
    constexpr int seconds = 10;
    Pictures pictures;
    window.scene().installEventFilter(&pictures);
    for (int k = 0; k < window.table()->cloths(); ++k) { window.scene().drop(k, 0, 0); }
    const double before = window.table()->clock();
    QElapsedTimer real;
    real.start();
    double pace = 1;
    while (real.elapsed() < 1000 * seconds) {
        wait(200);
        pace = std::min(pace, window.table()->pace());
    }
    std::vector<double>& apart = pictures.apart;
    if (apart.empty()) { return 1; }
    const double all = static_cast<double>(apart.size());
    std::sort(apart.begin(), apart.end());
    const double wall = 1e-3 * static_cast<double>(real.elapsed());
    std::printf(
        "%d cloths: %.1f pictures/s, half of them within %.0f ms, the longest after %.0f ms; simulated time %.2f of real time, at the "
        "least %.2f; a click was seen after %.0f ms at the latest\n",
        window.table()->cloths(), all / wall, 1e3 * apart[apart.size() / 2], 1e3 * apart.back(), (window.table()->clock() - before) / wall,
        pace, 1e3 * window.scene().slowestAnswer());
}
