// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The picture of the fabric: what is drawn how finely, choosing, measuring, cutting open. Needs a display: xvfb-run.
#include "core/base/units.h"
#include "core/project/project_file.h"
#include "core/solver/droplet.h"
#include "ui/picture/view_bar.h"
#include "ui/weave/point_paper.h"
#include "ui/weave/weave_editor.h"
#include "window_test.h"

#include <QElapsedTimer>

#include <array>
#include <cmath>

using namespace hygroloom;

namespace {

/// Mean red, green and blue of a picture without its written edges.
std::array<double, 3> meanColor(const QImage& picture)
{
    std::array<double, 3> sum{};
    const QRect middle(picture.width() / 4, picture.height() / 4, picture.width() / 2, picture.height() / 2);
    for (int y = middle.top(); y <= middle.bottom(); ++y) {
        for (int x = middle.left(); x <= middle.right(); ++x) {
            const QColor color = picture.pixelColor(x, y);
            sum[0] += color.red();
            sum[1] += color.green();
            sum[2] += color.blue();
        }
    }
    for (double& value : sum) { value /= static_cast<double>(middle.width()) * middle.height(); }
    return sum;
}

/// Share of the pixels that stand out from all four neighbours.
double dots(const QImage& picture)
{
    int found = 0;
    const QRect middle(picture.width() / 4, picture.height() / 4, picture.width() / 2, picture.height() / 2);
    for (int y = middle.top(); y <= middle.bottom(); ++y) {
        for (int x = middle.left(); x <= middle.right(); ++x) {
            const auto off = [&](int dx, int dy) { return qGray(picture.pixel(x, y)) - qGray(picture.pixel(x + dx, y + dy)); };
            const int offs[] = {off(1, 0), off(-1, 0), off(0, 1), off(0, -1)};
            found += *std::min_element(offs, offs + 4) > 8 || *std::max_element(offs, offs + 4) < -8 ? 1 : 0;
        }
    }
    return found / (static_cast<double>(middle.width()) * middle.height());
}

double difference(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

} // namespace

class TestView : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        openWindow({1100, 760});
        QSignalSpy preview(&window_->viewport(), &Viewport::previewUpdated);
        QVERIFY(window_->openFile(example("textile-F")));
        QTRY_VERIFY_WITH_TIMEOUT(preview.count() > 0, 5000);
        canvas_ = window_->viewport().canvas();
        QVERIFY(canvas_);
    }

    void cleanupTestCase() { window_.reset(); }

    void init()
    {
        canvas_->select({});
        canvas_->setMeasuring(false);
        canvas_->setSection({});
        canvas_->setWater({}, 1);
        canvas_->setWaterColors(WaterColors::blue);
        canvas_->setParallel(false);
        lookDown();
        canvas_->fit(Framing::few_repeats);
    }

    void onlyWhatIsSeenIsDrawn()
    {
        const std::size_t cells =
            static_cast<std::size_t>(canvas_->fabric()->columns()) * static_cast<std::size_t>(canvas_->fabric()->rows());
        canvas_->fit(Framing::whole);
        window_->viewport().picture();
        QCOMPARE(canvas_->scene().visibleCells(), cells);
        canvas_->fit(Framing::few_repeats);
        window_->viewport().picture();
        QVERIFY(canvas_->scene().visibleCells() < cells / 4);
        zoom(30);
        window_->viewport().picture();
        QVERIFY(canvas_->scene().visibleCells() <= 9);
        QVERIFY(canvas_->scene().visibleCells() >= 1);
    }

    void equalCellsShareOneMesh()
    {
        window_->viewport().picture();
        std::size_t meshes = 0;
        for (const CellBatch& batch : canvas_->scene().batches()) {
            meshes += batch.key.ends == canvas_->fabric()->cell_ends && batch.key.picks == canvas_->fabric()->cell_picks ? 1 : 0;
        }
        QVERIFY(canvas_->scene().visibleCells() > 9);
        QVERIFY2(meshes <= 2, qPrintable(QString::number(meshes))); // two levels at most, seen square on
    }

    void theSamePictureComesFromEveryLevel()
    {
        std::vector<std::array<double, 3>> means;
        std::vector<int> levels;
        for (const double pixels : {12.0, 15.0, 22.0, 38.0, 70.0}) {
            lookDown();
            canvas_->fit(Framing::few_repeats);
            const double pitch = canvas_->fabric()->pitch().x() / canvas_->camera().millimetrePerPixel(QSizeF(canvas_->size()));
            zoom(pixels / pitch);
            means.push_back(meanColor(window_->viewport().picture()));
            levels.push_back(canvas_->scene().batches().front().key.level);
            qInfo("pitch %.0f pixels: level %d, %zu cells, %zu triangles, mean %.0f %.0f %.0f", pixels, levels.back(),
                  canvas_->scene().visibleCells(), canvas_->triangles(), means.back()[0], means.back()[1], means.back()[2]);
        }
        for (std::size_t i = 1; i < means.size(); ++i) {
            QVERIFY2(difference(means[i - 1], means[i]) < 14, qPrintable(QString::number(i)));
        }
        QVERIFY(levels.front() < levels.back());
    }

    void fibresAreDrawnFromNear()
    {
        QElapsedTimer timer;
        timer.start();
        const CellMesh mesh = mesh_cell(*canvas_->fabric(), {8, 8}, fibre_level);
        qInfo("fibres of a cell: %.1f ms, %zu triangles", static_cast<double>(timer.nsecsElapsed()) * 1e-6, mesh.indices.size() / 3);
        QVERIFY(mesh.indices.size() / 3 > 20000);
        const double pitch = canvas_->fabric()->pitch().x() / canvas_->camera().millimetrePerPixel(QSizeF(canvas_->size()));
        zoom(180 / pitch);
        // The same piece of fabric in both pictures.
        const QImage wide = window_->viewport().picture();
        const QSize part(static_cast<int>(wide.width() / 1.6), static_cast<int>(wide.height() / 1.6));
        const auto far = meanColor(wide.copy(QRect(QPoint((wide.width() - part.width()) / 2, (wide.height() - part.height()) / 2), part)));
        QVERIFY(canvas_->scene().batches().back().key.level < fibre_level);
        zoom(1.6);
        const auto near = meanColor(window_->viewport().picture());
        int finest = 0;
        for (const CellBatch& batch : canvas_->scene().batches()) { finest = std::max(finest, batch.key.level); }
        QCOMPARE(finest, fibre_level);
        // So much by which crossing lies in the middle: a weft over a warp, or the other way round.
        QVERIFY2(difference(far, near) < 35, qPrintable(QString("%1 to %2").arg(far[0]).arg(near[0])));
        qInfo("fibres: %zu cells, %zu triangles", canvas_->scene().visibleCells(), canvas_->triangles());
    }

    void skinsBlendIntoFibresWithoutDots()
    {
        const double pitch = canvas_->fabric()->pitch().x() / canvas_->camera().millimetrePerPixel(QSizeF(canvas_->size()));
        zoom(0.5 * (fibre_belt_pixels[0] + fibre_belt_pixels[1]) / pitch);
        const QImage picture = window_->viewport().picture();
        const auto& batches = canvas_->scene().batches();
        QVERIFY(std::any_of(batches.begin(), batches.end(), [](const CellBatch& batch) { return !batch.of(CellRole::fibres).empty(); }));
        QVERIFY2(dots(picture) < 0.01, qPrintable(QString::number(dots(picture))));
        QVERIFY(qAlpha(picture.pixel(picture.rect().center())) == 255);
    }

    void fibresTakeTheColourOfTheirWater()
    {
        const double pitch = canvas_->fabric()->pitch().x() / canvas_->camera().millimetrePerPixel(QSizeF(canvas_->size()));
        zoom(400 / pitch);
        const auto dry = meanColor(window_->viewport().picture());
        QCOMPARE(canvas_->scene().batches().back().key.level, fibre_level);
        canvas_->setWater(std::vector<float>(static_cast<std::size_t>(canvas_->fabric()->textile.segments()), 0.6F), 1);
        const auto wet = meanColor(window_->viewport().picture());
        canvas_->setWater({}, 1);
        QVERIFY(dry[2] < dry[0]);
        QVERIFY2(wet[2] > wet[0] + 20, qPrintable(QString("%1 %2").arg(wet[0]).arg(wet[2])));
    }

    void naturallyWetYarnsDarkenAndKeepTheirHue_data()
    {
        QTest::addColumn<double>("pixels");
        for (const double pixels : {4, 60, 400}) { QTest::addRow("a pitch of %g pixels", pixels) << pixels; }
    }
    void naturallyWetYarnsDarkenAndKeepTheirHue()
    {
        QFETCH(double, pixels);
        zoom(pixels * canvas_->camera().millimetrePerPixel(QSizeF(canvas_->size())) / canvas_->fabric()->pitch().x());
        const auto segments = static_cast<std::size_t>(canvas_->fabric()->textile.segments());
        const auto look = [&](float saturation, double range) {
            canvas_->setWater(std::vector<float>(segments, saturation), range);
            return meanColor(window_->viewport().picture());
        };
        canvas_->setWaterColors(WaterColors::natural);
        const auto dry = look(0, 1), half = look(0.5F, 1), wet = look(1, 1), ranged = look(0.5F, 0.5);
        QVERIFY2(half[1] < dry[1] && half[1] > wet[1] && wet[1] < 0.95 * dry[1], qPrintable(QString("%1 %2").arg(dry[1]).arg(wet[1])));
        QVERIFY(wet[0] >= wet[1] && wet[1] > wet[2]); // no blue
        QVERIFY(difference(half, ranged) < 0.5);      // how wet yarns look depends on no range of colours
    }

    void coloursOfWaterAreThoseOfTheLegend()
    {
        zoom(60 * canvas_->camera().millimetrePerPixel(QSizeF(canvas_->size())) / canvas_->fabric()->pitch().x());
        canvas_->setWaterColors(WaterColors::cividis);
        const Textile& textile = canvas_->fabric()->textile;
        canvas_->setWater(std::vector<float>(static_cast<std::size_t>(textile.segments()), 1.0F), 1);
        const QImage shown = window_->viewport().picture(), legend = waterRamp(WaterColors::cividis);
        const QColor full = legend.pixelColor(legend.width() - 1, 0); // dark blue without red, of which gloss would bring some
        const int end = textile.ends() / 2, pick = textile.picks() / 2;
        const QPoint on_yarn = placeOf(textile.x_of_end(end), textile.y_of_pick(pick)).toPoint();
        for (int y = -3; y <= 3; ++y) {
            const QColor here = shown.pixelColor(on_yarn + QPoint(0, y));
            QVERIFY2(here.red() <= full.red() + 5 && here.blue() <= full.blue() + 5, qPrintable(here.name() + full.name()));
        }
    }

    void stripesHaveTheColoursOfTheDraft()
    {
        window_->document().edit("stripes", {}, [](Design& d) {
            Fabric& fabric = d.fabrics[0];
            fabric.extra_yarns = {fabric.warp};
            fabric.extra_yarns[0].color = Color{200, 30, 30};
            fabric.warp_order = {{0, 35}, {1, 35}};
        });
        QTRY_VERIFY_WITH_TIMEOUT(canvas_->fabric()->end_yarns.back()->color, 5000);
        QCOMPARE(canvas_->fabric()->period_ends, 2); // colour alone needs no other mesh
        for (const Framing framing : {Framing::few_repeats, Framing::whole}) {
            canvas_->fit(framing);
            const QImage picture = window_->viewport().picture();
            const auto left = meanColor(picture.copy(0, 0, picture.width() / 2, picture.height()));
            const auto right = meanColor(picture.copy(picture.width() / 2, 0, picture.width() / 2, picture.height()));
            QVERIFY(std::abs(left[0] - left[1]) < 20);
            QVERIFY(right[0] - right[1] > 40);
        }
        window_->document().history()->undo();
        QTest::qWait(100);
    }

    void levelsFadeIntoEachOther()
    {
        FabricScene scene;
        scene.setFabric(canvas_->fabric());
        SceneView view = canvas_->sceneView();
        const auto all = [](const MeshKey&) { return true; };
        scene.update(view, 0, all);
        QVERIFY(!scene.fading());
        view.camera.zoom(1.9, QPointF(0.5 * view.size.width(), 0.5 * view.size.height()), view.size);
        scene.update(view, 0, all);
        QVERIFY(scene.fading());
        scene.update(view, 1, all);
        QVERIFY(!scene.fading());
    }

    void whatIsShownStaysUntilTheFinerIsThere()
    {
        FabricScene scene;
        scene.setFabric(canvas_->fabric());
        SceneView view = canvas_->sceneView();
        scene.update(view, 0, [](const MeshKey& key) { return key.level <= 1; });
        QVERIFY(!scene.wanted().empty());
        for (const CellBatch& batch : scene.batches()) { QVERIFY(batch.key.level <= 1); }
        QVERIFY(!scene.batches().empty());
    }

    void aClickChoosesAYarnAndTheGridShowsIt()
    {
        QSignalSpy selected(canvas_, &TextileCanvas::yarnSelected);
        canvas_->setFocus();
        const Textile& textile = canvas_->fabric()->textile;
        const int end = 36, pick = 35;
        const bool up = textile.warp_up(end, pick);
        QTest::mouseClick(canvas_, Qt::LeftButton, Qt::NoModifier, placeOf(textile.x_of_end(end), textile.y_of_pick(pick)).toPoint());
        QCOMPARE(selected.count(), 1);
        QCOMPARE(canvas_->selected().kind, up ? YarnKind::warp : YarnKind::weft);
        QCOMPARE(canvas_->selected().yarn, up ? end : pick);
        const QPoint marked = window_->findChild<PointPaper*>()->selectedYarn();
        QCOMPARE(up ? marked.x() : marked.y(), (up ? end : pick) % 2);
        QCOMPARE(up ? marked.y() : marked.x(), -1);
        QTest::keyClick(canvas_, Qt::Key_BracketRight);
        QCOMPARE(canvas_->selected().yarn, (up ? end : pick) + 1);
        QTest::keyClick(canvas_, Qt::Key_Escape);
        QCOMPARE(canvas_->selected().yarn, -1);
        QCOMPARE(window_->findChild<PointPaper*>()->selectedYarn(), QPoint(-1, -1));
    }

    void theChosenYarnIsTinted()
    {
        const auto before = meanColor(window_->viewport().picture());
        canvas_->select({YarnKind::warp, 35});
        QVERIFY(difference(before, meanColor(window_->viewport().picture())) > 0.5);
    }

    void freeLiquidIsSeenAsASkinOrAsParticles()
    {
        const QImage dry = window_->viewport().picture();
        canvas_->setLiquid(liquid_surface(standingDrop(), {}));
        const QImage skin = window_->viewport().picture();
        QTest::keyClick(canvas_, Qt::Key_P);
        QVERIFY(QSettings().value("view/particles").toBool());
        const QImage particles = window_->viewport().picture();
        QVERIFY2(difference(meanColor(dry), meanColor(skin)) > 5, "no skin");
        QVERIFY2(difference(meanColor(skin), meanColor(particles)) > 2, "no particles");
        // Beside the drop nothing has changed.
        const QRect beside(20, dry.height() / 2, 60, 60);
        QCOMPARE(skin.copy(beside), dry.copy(beside));
        QCOMPARE(particles.copy(beside), dry.copy(beside));
        QVERIFY2(dots(particles) > dots(skin), "balls have edges, a skin has few");
        QTest::keyClick(canvas_, Qt::Key_P);
        QVERIFY(!QSettings().value("view/particles").toBool());
        QCOMPARE(window_->viewport().picture(), skin);
        canvas_->setLiquid({});
        QCOMPARE(window_->viewport().picture(), dry);
    }

    void aSectionCutsTheLiquidToo()
    {
        canvas_->setLiquid(liquid_surface(standingDrop(), {}));
        SectionPlane section;
        section.across = SectionPlane::Across::warp;
        section.position = 0;
        window_->viewport().bar().setSection(section);
        for (const bool particles : {false, true}) {
            canvas_->setParticlesShown(particles);
            const QImage cut = window_->viewport().picture();
            const QPoint away = placeOf(0, -0.3e-3).toPoint(), kept = placeOf(0, 0.3e-3).toPoint();
            QCOMPARE(cut.pixelColor(away), QColor("#e9ecee"));
            QVERIFY(cut.pixelColor(kept) != QColor("#e9ecee"));
        }
        canvas_->setParticlesShown(false);
        canvas_->setLiquid({});
        window_->viewport().bar().setSection({});
    }

    void twoEndsArePitchesApart()
    {
        const Textile& textile = canvas_->fabric()->textile;
        QTest::keyClick(canvas_, Qt::Key_M);
        QVERIFY(canvas_->measuring());
        // On crossings of one pick where the end lies on top.
        const int pick = 35, first = textile.warp_up(34, pick) ? 34 : 35;
        canvas_->click(placeOf(textile.x_of_end(first), textile.y_of_pick(pick)));
        QVERIFY(!canvas_->measurement());
        canvas_->click(placeOf(textile.x_of_end(first + 2), textile.y_of_pick(pick)));
        QVERIFY(canvas_->measurement());
        const QVector3D way = canvas_->measurement()->to - canvas_->measurement()->from;
        const double expected = 2 * 10 / 35.0; // mm, two pitches at 35 ends per cm
        QVERIFY2(std::abs(way.x() - expected) < 0.001, qPrintable(QString::number(way.x())));
        QVERIFY(std::abs(canvas_->measurement()->length() - expected) < 0.02);
        QTest::keyClick(canvas_, Qt::Key_Escape);
        QVERIFY(!canvas_->measurement());
        QVERIFY(canvas_->measuring());
        QTest::keyClick(canvas_, Qt::Key_Escape);
        QVERIFY(!canvas_->measuring());
    }

    void aSectionTakesAwayWhatLiesBeforeIt()
    {
        const Textile& textile = canvas_->fabric()->textile;
        window_->viewport().picture();
        const std::size_t whole = canvas_->scene().visibleCells();
        const QImage before = window_->viewport().picture();
        SectionPlane section;
        section.across = SectionPlane::Across::warp;
        section.position = mm_from_metre(textile.y_of_pick(36));
        window_->viewport().bar().setSection(section);
        const QImage after = window_->viewport().picture();
        QVERIFY(canvas_->scene().visibleCells() < whole);
        const QPointF cut_away = placeOf(textile.x_of_end(35), textile.y_of_pick(33));
        const QPointF kept = placeOf(textile.x_of_end(35), textile.y_of_pick(38));
        QCOMPARE(after.pixelColor(cut_away.toPoint()), QColor("#e9ecee"));
        QVERIFY(before.pixelColor(cut_away.toPoint()) != QColor("#e9ecee"));
        QVERIFY(after.pixelColor(kept.toPoint()) != QColor("#e9ecee"));
        // What is cut away cannot be chosen.
        canvas_->click(cut_away);
        QCOMPARE(canvas_->selected().yarn, -1);
        section.flipped = true;
        window_->viewport().bar().setSection(section);
        QVERIFY(window_->viewport().picture().pixelColor(cut_away.toPoint()) != QColor("#e9ecee"));
        window_->viewport().bar().setSection({});
    }

    void aLevelSectionShowsTubesFromAfarToo()
    {
        canvas_->fit(Framing::whole);
        SectionPlane section;
        section.across = SectionPlane::Across::thickness;
        window_->viewport().bar().setSection(section);
        const QImage picture = window_->viewport().picture();
        QVERIFY(difference(meanColor(picture), {233, 236, 238}) > 20);
        for (const CellBatch& batch : canvas_->scene().batches()) { QVERIFY(batch.key.level > 0); }
        window_->viewport().bar().setSection({});
    }

    void theStandardViewsLookWhereTheySay()
    {
        const std::pair<Qt::Key, QVector3D> views[] = {{Qt::Key_1, {0, -1, 0}}, {Qt::Key_2, {0, 1, 0}}, {Qt::Key_3, {1, 0, 0}},
                                                       {Qt::Key_4, {-1, 0, 0}}, {Qt::Key_7, {0, 0, 1}}, {Qt::Key_8, {0, 0, -1}}};
        for (const auto& [key, from] : views) {
            QTest::keyClick(canvas_, key);
            QVERIFY((canvas_->camera().direction() - from).length() < 1e-4F);
        }
        QTest::keyClick(canvas_, Qt::Key_5);
        QVERIFY(canvas_->camera().parallel());
        QTest::keyClick(canvas_, Qt::Key_5);
        QVERIFY(!canvas_->camera().parallel());
    }

    void turningKeepsWhatIsHeldInItsPlace()
    {
        for (const bool parallel : {false, true}) {
            Camera camera = canvas_->camera();
            camera.setParallel(parallel);
            camera.lookFrom(20, 40);
            const QSizeF size(canvas_->size());
            const QVector3D held = camera.target() + QVector3D(0.8F, -0.5F, 0.1F);
            const QPointF before = camera.project(held, size);
            camera.orbit({35, -20}, held);
            QVERIFY((camera.direction() - canvas_->camera().direction()).length() > 0.1F);
            const QPointF after = camera.project(held, size);
            QVERIFY2(std::hypot(after.x() - before.x(), after.y() - before.y()) < 0.1, qPrintable(QString::number(after.x() - before.x())));
        }
    }

    void zoomingKeepsThePointUnderThePointer()
    {
        for (const bool parallel : {false, true}) {
            Camera camera = canvas_->camera();
            camera.setParallel(parallel);
            const QSizeF size(canvas_->size());
            const QPointF at(0.3 * size.width(), 0.7 * size.height());
            const QVector3D target = camera.target();
            const Ray ray = camera.ray(at, size);
            const QVector3D point = ray.from + QVector3D::dotProduct(target - ray.from, camera.direction()) /
                                                   QVector3D::dotProduct(ray.direction, camera.direction()) * ray.direction;
            camera.zoom(3, at, size);
            const QPointF after = camera.project(point, size);
            QVERIFY(std::hypot(after.x() - at.x(), after.y() - at.y()) < 0.5);
        }
    }

    void zoomingNeverPassesWhatIsPointedAt()
    {
        Camera camera = canvas_->camera();
        camera.lookFrom(-28, 48);
        const QSizeF size(canvas_->size());
        const QVector3D point = camera.target() + QVector3D(1.5F, -2, 0.1F);
        const QPointF before = camera.project(point, size);
        for (int i = 0; i < 30; ++i) { camera.zoomTo(1.2, point); }
        const QPointF after = camera.project(point, size);
        QVERIFY(std::hypot(after.x() - before.x(), after.y() - before.y()) < 0.5);
        QVERIFY(camera.depth(point) > 0);
    }

    void anEditShowsSoon()
    {
        for (const Framing framing : {Framing::few_repeats, Framing::whole}) {
            canvas_->fit(framing);
            window_->viewport().picture();
            double sum = 0;
            for (int i = 0; i < 6; ++i) {
                QTest::qWait(250); // the picture before is drawn
                QSignalSpy preview(&window_->viewport(), &Viewport::previewUpdated);
                QElapsedTimer timer;
                timer.start();
                window_->document().edit("ends", {}, [i](Design& d) { d.fabrics[0].ends_per_cm = 33 + 0.2 * i; });
                while (preview.isEmpty() && timer.elapsed() < 5000) { QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5); }
                sum += static_cast<double>(timer.nsecsElapsed()) * 1e-6;
                QVERIFY(!preview.isEmpty());
            }
            QElapsedTimer timer;
            timer.start();
            prepare_view(canvas_->fabric()->request, canvas_->sceneView(), framing, [] { return false; });
            qInfo("meshes alone: %.1f ms", static_cast<double>(timer.nsecsElapsed()) * 1e-6);
            qInfo("edit to meshes, %s: %.1f ms; %zu cells, %zu triangles", framing == Framing::whole ? "whole 2 cm" : "few repeats",
                  sum / 6, canvas_->scene().visibleCells(), canvas_->triangles());
        }
        while (window_->document().history()->canUndo()) { window_->document().history()->undo(); }
        QTest::qWait(100);
    }

    void aLargeSwatchIsDrawnWithFewTriangles()
    {
        window_->viewport().setSwatch(3);
        QTRY_COMPARE_WITH_TIMEOUT(canvas_->fabric()->textile.ends(), 350, 5000);
        canvas_->fit(Framing::whole);
        const QImage picture = window_->viewport().picture();
        QVERIFY(picture.pixelColor(picture.width() / 2, picture.height() / 2) != QColor("#e9ecee"));
        QVERIFY(canvas_->triangles() < 20000);
        window_->viewport().setSwatch(first_swatch);
        QTRY_COMPARE_WITH_TIMEOUT(canvas_->fabric()->textile.ends(), 70, 5000); // 2 cm at 35 a cm, and whole repeats
        QCOMPARE(canvas_->fabric()->textile.ends() % canvas_->fabric()->textile.weave.ends(), 0);
    }

private:
    void lookDown()
    {
        Camera camera = canvas_->camera();
        camera.setParallel(false);
        camera.lookFrom(0, 90);
        canvas_->setCamera(camera);
    }
    void zoom(double factor)
    {
        Camera camera = canvas_->camera();
        const QSizeF size(canvas_->size());
        camera.zoom(factor, QPointF(0.5 * size.width(), 0.5 * size.height()), size);
        canvas_->setCamera(camera);
    }
    /// A ball of 500 particles on the fabric, 1 mm across.
    Frame standingDrop() const
    {
        const double volume = 4.0 / 3.0 * pi * 0.125e-9, spacing = std::cbrt(volume / 500);
        Frame frame;
        frame.ledger.water_free = 1000 * volume;
        for (const Vec3d& place : droplet_lattice(500, spacing)) {
            const double height = canvas_->fabric()->textile.half_thickness() + 0.5e-3;
            frame.positions.push_back({static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z + height)});
        }
        return frame;
    }
    /// Where the fabric's top is in the picture, metres.
    QPointF placeOf(double x, double y) const
    {
        const auto& textile = canvas_->fabric()->textile;
        return canvas_->camera().project(QVector3D(static_cast<float>(mm_from_metre(x)), static_cast<float>(mm_from_metre(y)),
                                                   static_cast<float>(mm_from_metre(textile.half_thickness()))),
                                         QSizeF(canvas_->size()));
    }

    TextileCanvas* canvas_ = nullptr;
};

QTEST_MAIN(TestView)
#include "tst_view.moc"
