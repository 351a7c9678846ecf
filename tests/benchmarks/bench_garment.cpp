// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment in the workspace Run, a tee of textile F, draft: seconds from the start of a run to its first map, and pictures a second while
// the garment is turned with its map, 1280 x 800. Needs a display: xvfb-run.
#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_view.h"
#include "ui/garment/shape_view.h"
#include "ui/picture/viewport.h"
#include "ui/results/project_runs.h"
#include "ui/results/run_history.h"
#include "ui/results/run_panel.h"
#include "ui/window/examples.h"
#include "ui/window/run_workspace.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMainWindow>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <vector>

using namespace hygroloom;

namespace {

/// Handles events until something is so; false after a minute.
bool wait(const std::function<bool()>& so)
{
    QElapsedTimer clock;
    clock.start();
    while (!so() && clock.elapsed() < 60000) QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 20);
    return so();
}

/// Seconds from one shown picture to the next, the median.
double turning(ShapeView& shape)
{
    constexpr int first = 6, counted = 40;
    std::vector<double> seconds;
    QElapsedTimer clock;
    int shown = 0;
    QObject::connect(&shape, &QOpenGLWidget::frameSwapped, &shape, [&] {
        if (shown > first) seconds.push_back(1e-9 * static_cast<double>(clock.nsecsElapsed()));
        clock.start();
        if (++shown <= first + counted) shape.lookFrom(3.0 * shown);
    });
    shape.lookFrom(3);
    if (!wait([&] { return shown > first + counted; })) return 0;
    std::sort(seconds.begin(), seconds.end());
    return seconds[seconds.size() / 2];
}

} // namespace

int main(int count, char** arguments)
{
    const QApplication app(count, arguments);
    const QTemporaryDir folder;
    Document document;
    Recovery recovery(document, folder.path());
    if (!document.openExample(QDir(examplesFolder()).filePath("textile-F.hygro"))) return 1;
    QMainWindow window;
    RunHistory history;
    ProjectRuns project(document, recovery, history);
    WindowQueue queue;
    Viewport viewport;
    RunWorkspace run(document, history, project, queue, viewport, window);
    run.setSubject(Subject::garment);
    GarmentSubject& garment = run.garment();
    window.setCentralWidget(&garment.view());
    window.resize(1280, 800);
    window.show();
    garment.choice().setGarmentIndex(addBuiltInGarment(document, "tee"));
    if (!wait([&] { return run.panel().canRun(); })) return 1;

    QElapsedTimer clock;
    clock.start();
    run.start();
    if (!wait([&] { return garment.playback().frames() > 1; })) return 1;
    std::printf("first map of the run after %.2f s\n", 1e-3 * static_cast<double>(clock.elapsed()));
    if (!wait([&] { return !run.run().running(); })) return 1;
    std::printf("all of it after %.1f s\n", 1e-3 * static_cast<double>(clock.elapsed()));
    for (ShapeView* shape : window.findChildren<ShapeView*>()) {
        if (!shape->isVisible()) continue;
        const double seconds = turning(*shape);
        if (seconds > 0) std::printf("%d x %d: %.1f pictures a second\n", shape->width(), shape->height(), 1 / seconds);
    }
    return 0;
}
