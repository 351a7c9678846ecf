// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Makes the pictures of the user's guide from the program itself. Needs a display; packaging/make-pictures.sh runs it.
#include "small_png.h"
#include "ui/basics/appearance.h"
#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_maps.h"
#include "ui/compare/compare_view.h"
#include "ui/garment/garment_edits.h"
#include "ui/picture/textile_canvas.h"
#include "ui/picture/view_bar.h"
#include "ui/results/run_panel.h"
#include "ui/results/water_map_view.h"
#include "ui/weave/weave_editor.h"
#include "ui/window/design_workspace.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QTemporaryDir>

#include <cstdio>
#include <map>
#include <stdexcept>

using namespace hygroloom;

namespace {

constexpr QSize picture_size(1280, 800);
constexpr int most_bytes = 195000; // of a picture

/// Handles events until the condition holds. Throws after the time limit.
template <typename Condition> void waitFor(const char* what, int limit_s, Condition condition)
{
    QElapsedTimer clock;
    clock.start();
    while (!condition()) {
        if (clock.elapsed() > 1000 * limit_s) { throw std::runtime_error(std::string("waited in vain for ") + what); }
        QApplication::processEvents(QEventLoop::AllEvents, 50);
    }
}

/// Lets pictures, maps and charts finish.
void settle(int ms = 2500)
{
    QElapsedTimer clock;
    clock.start();
    waitFor("the picture", 60, [&] { return clock.elapsed() > ms; });
}

class Photographer {
public:
    explicit Photographer(const QString& folder) : folder_(folder)
    {
        window_.resize(picture_size);
        window_.show();
        window_.openShippedExample();
        settle();
    }

    void save(const QString& name)
    {
        settle();
        // From the screen: what is written over the fabric is not in QWidget::grab().
        const QImage picture = window_.screen()->grabWindow(window_.winId()).toImage().convertToFormat(QImage::Format_RGB32);
        const QByteArray bytes = smallPng(picture, most_bytes);
        QFile file(folder_.filePath(name + ".png"));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
            throw std::runtime_error("cannot write " + file.fileName().toStdString());
        }
        std::printf("%s: %lld bytes\n", file.fileName().toUtf8().constData(), static_cast<long long>(bytes.size()));
    }

    void run()
    {
        RunWorkspace& runs = window_.run();
        runs.panel().setFidelity(Fidelity::draft);
        waitFor("the estimate", 30, [&] { return runs.panel().canRun(); });
        const std::size_t before = window_.compare().runs().runs().size();
        runs.start();
        waitFor("the run", 600, [&] { return !runs.run().running() && window_.compare().runs().runs().size() > before; });
    }

    void showTime(double seconds)
    {
        Playback& playback = window_.run().sample().playback();
        playback.show(playback.frameAt(seconds));
    }

    MainWindow& window() { return window_; }

private:
    QDir folder_;
    MainWindow window_;
};

/// A tee, 10 min into a run.
void takeGarment(Photographer& photographer)
{
    MainWindow& window = photographer.window();
    GarmentSubject& garment = window.run().garment();
    window.setWorkspace(Workspace::garment);
    garment.choice().setGarmentIndex(addBuiltInGarment(window.document(), "tee"));
    window.resize(picture_size); // other workspaces may have widened it
    waitFor("the estimate", 30, [&] { return window.run().panel().canRun(); });
    window.run().start();
    waitFor("the run of the garment", 600, [&] { return !window.run().run().running() && garment.playback().frames() > 0; });
    settle();
    garment.playback().show(garment.playback().run()->frameAt(600));
    photographer.save("garment");
}

/// A cloth with and without a finish, 4 replicates of each: the difference that is left beside what replicates scatter.
void takeCompare(Photographer& photographer)
{
    MainWindow& window = photographer.window();
    window.document().edit("finish", {}, [](Design& design) {
        Fabric fabric = design.fabrics[0];
        fabric.name += ", silicone";
        fabric.contact_angle_deg = 80;
        design.fabrics.push_back(fabric);
    });
    CompareView& view = window.compare().view();
    window.setWorkspace(Workspace::compare);
    view.showExperiment(window.document().design()->experiments.front().name);
    view.bar()->setReplicates(4);
    waitFor("the estimate", 60, [&] { return view.bar()->runAll()->isEnabled(); });
    view.bar()->runAll()->click();
    waitFor("the replicates", 1200, [&] { return view.comparison().complete && view.comparison().candidates.size() > 1; });
    for (const KeptRun& run : window.compare().runs().runs()) { view.choose(run.path, true); }
    view.findChild<CompareMaps*>()->show(CompareMaps::Shown::differences);
    window.resize(picture_size);
    photographer.save("compare");
}

/// All, or those of the compare workspace alone.
void takePictures(const QString& folder, bool compare_alone)
{
    Photographer photographer(folder);
    if (compare_alone) {
        photographer.run();
        takeCompare(photographer);
        return;
    }
    MainWindow& window = photographer.window();
    Viewport& view = window.viewport();
    view.setSwatch(0);
    settle();
    view.canvas()->fit(Framing::whole);
    view.lookFrom(-30, 50);
    photographer.save("design");

    view.bar().setSection({SectionPlane::Across::warp, 0, false});
    view.canvas()->fit(Framing::few_repeats);
    view.lookFrom(-20, 18);
    photographer.save("section");
    view.bar().setSection({});
    view.lookFrom(-45, 50);

    Q_EMIT window.findChild<WeaveEditor*>()->draftRequested();
    window.document().edit("stripes", {}, [](Design& design) {
        Fabric& fabric = design.fabrics[0];
        fabric.weave = weave_from_pattern("twill 2/2");
        fabric.extra_yarns = {fabric.warp};
        fabric.extra_yarns[0].color = Color{38, 84, 140};
        fabric.warp_order = {{0, 8}, {1, 4}};
        fabric.weft_order = {{0, 8}, {1, 4}};
    });
    settle();
    view.canvas()->fit(Framing::whole);
    photographer.save("draft");
    window.document().history()->undo();

    photographer.run();
    photographer.showTime(0.5);
    settle();
    view.canvas()->fit(Framing::whole);
    photographer.save("simulate");

    takeCompare(photographer);
    takeGarment(photographer);
}

} // namespace

int main(int argc, char* argv[])
{
    requestOpenGL();
    QApplication application(argc, argv);
    QTemporaryDir settings;
    QCoreApplication::setOrganizationName("hygroloom-pictures");
    QCoreApplication::setApplicationName("hygroloom-pictures");
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    QLocale::setDefault(QLocale::c());
    const std::map<QString, Appearance> looks{{"light", Appearance::light}, {"dark", Appearance::dark}, {"contrast", Appearance::contrast}};
    const QString look = argc > 2 ? argv[2] : "light";
    const bool compare_alone = argc > 3 && QString(argv[3]) == "compare";
    if (argc < 2 || argc > (compare_alone ? 4 : 3) || !QDir(argv[1]).exists() || !looks.contains(look)) {
        std::fputs("make_pictures FOLDER [light|dark|contrast [compare]]\n", stderr);
        return 2;
    }
    try {
        applyAppearance(looks.at(look));
        takePictures(argv[1], compare_alone);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
