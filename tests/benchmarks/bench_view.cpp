// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The picture in 3D, 1280 x 800: frames a second while it is turned, seconds until it is smooth, and the light of dry and wet cloth, at
// six distances. bench_view [FOLDER [PIXELS ...]] also saves the pictures; PIXELS are the widths of a pitch, 0 for the whole sample. Needs
// a display: xvfb-run.
#include "core/project/project_file.h"
#include "ui/basics/appearance.h"
#include "ui/picture/textile_canvas.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QThreadPool>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

using namespace hygroloom;

namespace {

const QSize pixels(1280, 800);

/// Until nothing more is wanted and the picture rests.
void rest(TextileCanvas& canvas)
{
    QElapsedTimer clock;
    clock.start();
    while ((!canvas.rests() || !canvas.scene().wanted().empty()) && clock.elapsed() < 60000) {
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 20);
    }
}

/// Seconds from one shown picture to the next while an arrow key is held, without the first few.
std::vector<double> turning(TextileCanvas& canvas, double& processor_seconds)
{
    constexpr int first = 6, counted = 24;
    std::vector<double> seconds;
    QElapsedTimer clock;
    QEventLoop waits;
    int shown = 0;
    std::clock_t began = 0;
    const auto connection = QObject::connect(&canvas, &QOpenGLWidget::frameSwapped, [&] {
        if (shown > first) { seconds.push_back(1e-9 * static_cast<double>(clock.nsecsElapsed())); }
        clock.start();
        if (shown == first) { began = std::clock(); }
        if (++shown > first + counted) {
            waits.quit();
        } else {
            canvas.turnBy({shown % 2 == 0 ? 3.0 : -3.0, 0});
        }
    });
    canvas.turnBy({3, 0});
    waits.exec();
    QObject::disconnect(connection);
    processor_seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC / counted; // of all cores
    return seconds;
}

/// Mean luminance of the middle in linear light (IEC 61966-2-1, Rec. 709).
double luminance(const QImage& picture)
{
    const QImage part = picture.copy(picture.width() / 3, picture.height() / 3, picture.width() / 3, picture.height() / 3);
    const auto light = [](int value) {
        const double v = value / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    double sum = 0;
    for (int y = 0; y < part.height(); ++y) {
        for (int x = 0; x < part.width(); ++x) {
            const QRgb p = part.pixel(x, y);
            sum += 0.2126 * light(qRed(p)) + 0.7152 * light(qGreen(p)) + 0.0722 * light(qBlue(p));
        }
    }
    return sum / (part.width() * static_cast<double>(part.height()));
}

void measure(TextileCanvas& canvas, double pitch_pixels, const QString& folder, const char* cloth)
{
    const QSizeF size(pixels);
    Camera camera = canvas.camera();
    camera.lookFrom(-28, 48);
    canvas.setCamera(camera);
    canvas.fit(Framing::few_repeats);
    camera = canvas.camera();
    if (pitch_pixels > 0) {
        camera.zoom(pitch_pixels * camera.millimetrePerPixel(size) / canvas.fabric()->pitch().x(), {640, 400}, size);
        canvas.setCamera(camera);
    } else {
        canvas.fit(Framing::whole);
    }
    canvas.setWater({}, 1);
    rest(canvas);
    double processor_seconds = 0;
    std::vector<double> seconds = turning(canvas, processor_seconds);
    std::sort(seconds.begin(), seconds.end());
    QElapsedTimer clock;
    clock.start();
    rest(canvas);
    const double rested = 1e-3 * static_cast<double>(clock.elapsed());
    const QImage dry = canvas.picture();
    canvas.setWater(std::vector<float>(static_cast<std::size_t>(canvas.fabric()->textile.segments()), 1.0F), 1);
    const QImage wet = canvas.picture();
    canvas.setWater({}, 1);
    const double before = luminance(dry), after = luminance(wet);
    std::printf("%-8s pitch %3.0f pixels: median %5.1f frames/s, slowest %5.1f, %4.0f ms of processor a frame, %8zu triangles, smooth "
                "after %.2f s; light %.4f, wet %.4f: "
                "%.1f %% less\n",
                cloth, pitch_pixels, 1 / seconds[seconds.size() / 2], 1 / seconds.back(), 1e3 * processor_seconds, canvas.triangles(),
                rested, before, after, 100 * (1 - after / before));
    std::fflush(stdout);
    if (!folder.isEmpty()) {
        const auto save = [&](const QImage& picture, const char* state) {
            picture.save(QDir(folder).filePath(QString("%1-%2-%3.png").arg(cloth, state).arg(pitch_pixels)));
        };
        save(dry, "dry");
        save(wet, "wet");
    }
}

} // namespace

int main(int argc, char** argv)
{
    requestOpenGL();
    QApplication application(argc, argv);
    useResources();
    const QString folder = argc > 1 ? QString(argv[1]) : QString();
    std::vector<double> pitches;
    for (int i = 2; i < argc; ++i) { pitches.push_back(QString(argv[i]).toDouble()); }
    if (pitches.empty()) { pitches = {0, 8, 17, 60, 250, 500}; }
    for (const bool dyed : {false, true}) {
        auto design = std::make_shared<Design>(read_project(HYGROLOOM_SOURCE_DIR "/resources/examples/textile-F.hygro"));
        if (dyed) {
            design->fabrics[0].warp.color = Color{150, 24, 30};
            design->fabrics[0].weft.color = Color{28, 52, 120};
        }
        TextileCanvas canvas;
        canvas.resize(pixels);
        canvas.setWaterColors(WaterColors::natural);
        canvas.show();
        QObject::connect(
            &canvas, &TextileCanvas::meshesWanted, &canvas,
            [&] {
                const auto wanted = canvas.scene().wanted();
                make_wanted(
                    canvas.fabric(), wanted, [] { return false; },
                    [&](const std::shared_ptr<const PreparedView>& ready) { canvas.addMeshes(*ready); });
            },
            Qt::QueuedConnection);
        PreviewRequest request;
        request.design = design;
        request.whole = swatch_region(design->fabrics[0], 20);
        canvas.setView(prepare_view(request, canvas.sceneView(), Framing::few_repeats, [] { return false; }));
        for (const double pitch : pitches) { measure(canvas, pitch, folder, dyed ? "dyed" : "undyed"); }
    }
    return 0;
}
