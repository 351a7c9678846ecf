// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cloth from afar shows no bands that it does not have: its picture, blurred, is that of all its yarns drawn far finer. Needs a display:
// xvfb-run. At rest it is drawn until its edges are smooth, and then no more.
#include "core/project/library.h"
#include "core/project/wet_look.h"
#include "ui/basics/appearance.h"
#include "ui/picture/framing.h"
#include "ui/picture/swatch_painter.h"
#include "ui/picture/textile_canvas.h"

#include <QElapsedTimer>
#include <QOpenGLFramebufferObject>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

using namespace hygroloom;

namespace tst_far_cloth {
namespace {

const QSize picture(320, 256);
constexpr int finer = 4;

struct Grey {
    int width = 0, height = 0;
    std::vector<float> at;
    float& of(int x, int y) { return at[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]; }
};

/// Luminance of linear light (Rec. 709), means of squares of that many pixels. The target has no samples.
Grey luminanceOf(QOpenGLFramebufferObject& target, int times)
{
    const int width = target.width(), height = target.height();
    std::vector<float> texels(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    target.bind();
    QOpenGLContext::currentContext()->functions()->glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, texels.data());
    target.release();
    Grey grey{width / times, height / times, {}};
    grey.at.resize(static_cast<std::size_t>(grey.width) * static_cast<std::size_t>(grey.height));
    const float* texel = texels.data();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, texel += 4) {
            grey.of(x / times, grey.height - 1 - y / times) +=
                (0.2126F * texel[0] + 0.7152F * texel[1] + 0.0722F * texel[2]) / static_cast<float>(times * times);
        }
    }
    return grey;
}

/// By a bell of that many pixels.
Grey blurred(Grey from, double sigma)
{
    const int reach = static_cast<int>(3 * sigma) + 1;
    for (const bool down : {false, true}) {
        Grey to = from;
        for (int y = 0; y < from.height; ++y) {
            for (int x = 0; x < from.width; ++x) {
                double sum = 0, weights = 0;
                for (int i = -reach; i <= reach; ++i) {
                    const double weight = std::exp(-0.5 * i * i / (sigma * sigma));
                    const int there = std::clamp((down ? y : x) + i, 0, (down ? from.height : from.width) - 1);
                    sum += weight * static_cast<double>(down ? from.of(x, there) : from.of(there, y));
                    weights += weight;
                }
                to.of(x, y) = static_cast<float>(sum / weights);
            }
        }
        from = std::move(to);
    }
    return from;
}

/// Shares of the reference's brightness.
struct Misses {
    double bands = 0;    ///< root mean square of what differs but for the mean
    double brighter = 0; ///< mean
};

} // namespace

class TestFarCloth : public QObject {
    Q_OBJECT

public:
    static void initMain() { requestOpenGL(); }

private Q_SLOTS:
    void initTestCase()
    {
        useResources();
        surface_ = swatchSurface();
        QVERIFY(surface_);
        QVERIFY(context_.create() && context_.makeCurrent(surface_.get()));
        QVERIFY2(renderer_.initialize(), qPrintable(renderer_.problem()));
    }

    void cleanupTestCase()
    {
        context_.makeCurrent(surface_.get());
        renderer_.release();
        context_.doneCurrent();
    }

    void aPlainWeaveHasNoBandsAtAnyDistance_data()
    {
        QTest::addColumn<int>("farther");
        for (const int farther : {1, 2, 4, 16}) { QTest::addRow("%d times the near distance", farther) << farther; }
    }
    void aPlainWeaveHasNoBandsAtAnyDistance()
    {
        QFETCH(int, farther);
        const Misses misses = missesOf(50, farther, -28, 48);
        qInfo("bands %.4f, brighter by %.4f", misses.bands, misses.brighter);
        QVERIFY2(misses.bands < 0.025, qPrintable(QString::number(misses.bands)));
        QVERIFY2(std::abs(misses.brighter) < 0.08, qPrintable(QString::number(misses.brighter)));
    }

    void nearlyFromAboveItIsAsBrightAsItsYarns()
    {
        const Misses misses = missesOf(50, 4, 20, 85);
        qInfo("bands %.4f, brighter by %.4f", misses.bands, misses.brighter);
        QVERIFY2(std::abs(misses.brighter) < 0.08, qPrintable(QString::number(misses.brighter)));
    }

    void wetClothIsAsMuchDarkerAsTheLawOfTheFilmSays_data()
    {
        QTest::addColumn<double>("pixels");
        for (const double pixels : {3, 16, 60, 400}) { QTest::addRow("a pitch of %g pixels", pixels) << pixels; }
    }
    void wetClothIsAsMuchDarkerAsTheLawOfTheFilmSays()
    {
        QFETCH(double, pixels);
        const auto fabric = prepare_fabric(cloth(20));
        context_.makeCurrent(surface_.get());
        renderer_.setFabric(fabric);
        const SceneView view = viewOf(*fabric, pixels);
        PictureColors colors = pictureColors(QPalette());
        colors.water = WaterColors::natural;
        colors.background = Qt::black; // what is seen through gaps does not get wet
        const auto lightOfCloth = [&](float saturation) {
            renderer_.setWater(std::vector<float>(static_cast<std::size_t>(fabric->textile.segments()), saturation), 1);
            Grey seen = drawn(fabric, view, 1, colors);
            double sum = 0;
            for (int y = seen.height / 4; y < 3 * seen.height / 4; ++y) {
                for (int x = seen.width / 4; x < 3 * seen.width / 4; ++x) { sum += static_cast<double>(seen.of(x, y)); }
            }
            return sum;
        };
        const double seen = lightOfCloth(1) / lightOfCloth(0);
        renderer_.setWater({}, 1);
        const bool one_yarn = pixels > 0.5 * picture.width(); // then most of the picture is one end, else as much of both systems is seen
        double dry = 0, wet = 0;                              // by the law
        for (const QColor& color : {colors.warp, one_yarn ? colors.warp : colors.weft}) {
            const QVector3D light = lightOf(color);
            for (const auto& [axis, weight] : {std::pair(0, 0.2126), {1, 0.7152}, {2, 0.0722}}) {
                dry += 0.5 * weight * static_cast<double>(light[axis]);
                wet += 0.5 * weight * wet_reflectance(static_cast<double>(light[axis]));
            }
        }
        qInfo("wet over dry: %.3f, by the law without gloss %.3f", seen, wet / dry);
        // A film mirrors 2 % of what comes square on, and takes part of what the fibres mirrored.
        QVERIFY2(seen > wet / dry - (1 - film_entry) && seen < (wet + 1 - film_entry) / dry, qPrintable(QString::number(seen)));
        if (!seen_first_) { seen_first_ = seen; }
        QVERIFY2(one_yarn || std::abs(seen - *seen_first_) < 0.01, "near and far differ");
    }

    void fibresAreLeftOutWhereAPictureIsNotToBeSoFine()
    {
        FabricScene scene;
        const auto fabric = prepare_fabric(cloth(20));
        scene.setFabric(fabric);
        SceneView view = viewOf(*fabric, 400);
        const auto finest = [&] {
            int level = 0;
            scene.update(view, 0, [](const MeshKey&) { return true; });
            scene.settle();
            for (const CellBatch& batch : scene.batches()) { level = std::max(level, batch.key.level); }
            return level;
        };
        QCOMPARE(finest(), fibre_level);
        view.finest = fibre_level - 1;
        QCOMPARE(finest(), fibre_level - 1);
    }

    void atRestThePictureIsDrawnAFewTimesMoreAndThenNoMore()
    {
        TextileCanvas canvas;
        canvas.resize(picture);
        canvas.setShadowShown(false);
        canvas.show();
        QVERIFY(QTest::qWaitForWindowExposed(&canvas));
        connect(&canvas, &TextileCanvas::meshesWanted, &canvas, [&] {
            make_wanted(
                canvas.fabric(), canvas.scene().wanted(), [] { return false; },
                [&](const std::shared_ptr<const PreparedView>& ready) {
                    QMetaObject::invokeMethod(
                        &canvas, [&canvas, ready] { canvas.addMeshes(*ready); }, Qt::QueuedConnection);
                });
        });
        canvas.setView(prepare_view(cloth(20), canvas.sceneView(), Framing::whole, [] { return false; }));
        canvas.fit(Framing::whole);
        QTRY_VERIFY_WITH_TIMEOUT(canvas.rests(), 60000);
        const QImage smooth = canvas.grabFramebuffer();
        QSignalSpy drawn(&canvas, &QOpenGLWidget::frameSwapped);
        QTest::qWait(800);
        QCOMPARE(drawn.count(), 0);
        QVERIFY(canvas.rests());
        canvas.zoomBy(1.01);
        QVERIFY(!canvas.rests());
        QTRY_VERIFY_WITH_TIMEOUT(canvas.rests(), 60000);
        canvas.zoomBy(1 / 1.01);
        const QImage saved = canvas.picture(); // with a few samples, without waiting for more
        QVERIFY2(levelsAlongTheEdge(saved) > 12, qPrintable(QString::number(levelsAlongTheEdge(saved))));
        QVERIFY2(levelsAlongTheEdge(smooth) > 12, qPrintable(QString::number(levelsAlongTheEdge(smooth))));
    }

    /// The fault that was seen: it was drawn for ever.
    void aPictureIsTakenBeforeThereIsCloth()
    {
        TextileCanvas canvas;
        canvas.resize(picture);
        canvas.show();
        QVERIFY(QTest::qWaitForWindowExposed(&canvas));
        QVERIFY(!canvas.fabric());
        QCOMPARE(canvas.picture().size(), picture);
    }

    void playingDoesNotProlongMotion()
    {
        TextileCanvas canvas;
        canvas.resize(picture);
        canvas.show();
        QVERIFY(QTest::qWaitForWindowExposed(&canvas));
        canvas.setView(prepare_view(cloth(20), canvas.sceneView(), Framing::whole, [] { return false; }));
        canvas.zoomBy(1.1);
        QVERIFY(canvas.moves());
        QElapsedTimer clock;
        clock.start();
        for (float water = 0; canvas.moves() && clock.elapsed() < 3000; water += 0.01F) { // as a run that plays
            canvas.setWater(std::vector<float>(static_cast<std::size_t>(canvas.fabric()->textile.segments()), water), 1);
            QTest::qWait(20);
        }
        QVERIFY(!canvas.moves());
    }

private:
    /// Shades of grey that the first pixels of the cloth have, row by row, from the left: few where its edge is jagged.
    static int levelsAlongTheEdge(const QImage& image)
    {
        std::set<int> levels;
        const int background = qGray(image.pixel(image.width() / 2, 2));
        for (int y = image.height() / 3; y < 2 * image.height() / 3; ++y) {
            for (int x = 0; x < image.width() / 2; ++x) {
                if (const int here = qGray(image.pixel(x, y)); std::abs(here - background) > 2) {
                    levels.insert(here);
                    break;
                }
            }
        }
        return static_cast<int>(levels.size());
    }

    /// Whether cloth alone is near that pixel.
    static bool within(const PreviewFabric& fabric, const SceneView& view, int x, int y, int edge)
    {
        for (const int corner : {0, 1, 2, 3}) {
            const QPointF at(x + (corner & 1 ? edge : -edge), y + (corner & 2 ? edge : -edge));
            const Ray ray = view.camera.ray(at, view.size);
            const QVector3D on = ray.from - ray.from.z() / ray.direction.z() * ray.direction;
            if (on.x() < fabric.low().x() || on.x() > fabric.high().x() || on.y() < fabric.low().y() || on.y() > fabric.high().y()) {
                return false;
            }
        }
        return true;
    }

    static PreviewRequest cloth(double side_mm)
    {
        auto design = std::make_shared<Design>(shipped_presets().front().design);
        design->fabrics[0].weave = weave_from_pattern("plain");
        PreviewRequest request;
        request.design = design;
        request.whole = swatch_region(design->fabrics[0], side_mm);
        return request;
    }

    /// From above, aslant.
    static SceneView viewOf(const PreviewFabric& fabric, double pitch_pixels)
    {
        SceneView view;
        view.size = picture;
        view.camera.lookFrom(-28, 48);
        view.camera = framed(view.camera, fabric, Framing::few_repeats, view.size);
        const double now = pitch_scale(fabric, view) / view.camera.millimetrePerPixel(view.size);
        view.camera.zoom(pitch_pixels / now, {0.5 * picture.width(), 0.5 * picture.height()}, view.size);
        return view;
    }

    Grey drawn(const std::shared_ptr<const PreviewFabric>& fabric, SceneView view, int times)
    {
        PictureColors colors = pictureColors(QPalette());
        colors.background = QColor(160, 150, 140); // about as the cloth: its edge does not count
        return drawn(fabric, view, times, colors);
    }
    Grey drawn(const std::shared_ptr<const PreviewFabric>& fabric, const SceneView& view, int times, const PictureColors& colors)
    {
        FabricScene scene;
        scene.setFabric(fabric);
        complete(scene, renderer_, view);
        const auto target = lightPicture(picture * times, times > 1 ? 4 : 0), light = lightPicture(picture * times);
        target->bind();
        renderer_.draw(view, scene.batches(), target->size(), colors);
        target->release();
        QOpenGLFramebufferObject::blitFramebuffer(light.get(), target.get());
        return luminanceOf(*light, times);
    }

    Misses missesOf(double side_mm, int farther, double turn, double lift)
    {
        const auto fabric = prepare_fabric(cloth(side_mm));
        context_.makeCurrent(surface_.get()); // a canvas has one of its own
        renderer_.setFabric(fabric);
        SceneView view;
        view.size = picture;
        view.camera.lookFrom(turn, lift);
        view.camera = framed(view.camera, *fabric, Framing::few_repeats, view.size);
        view.camera.zoom(1.0 / farther, {0.5 * picture.width(), 0.5 * picture.height()}, view.size);
        const double pitch = pitch_scale(*fabric, view) / view.camera.millimetrePerPixel(view.size);
        const double sigma = std::max(3.0, pitch);
        Grey seen = blurred(drawn(fabric, view, 1), sigma);
        view.detail = std::max<double>(finer, 60 / pitch); // yarns as tubes, however far
        Grey real = blurred(drawn(fabric, view, finer), sigma);
        double sum = 0, squares = 0, bright = 0, pixels = 0;
        const int edge = static_cast<int>(2 * sigma) + 1;
        for (int y = edge; y < picture.height() - edge; ++y) {
            for (int x = edge; x < picture.width() - edge; ++x) {
                if (!within(*fabric, view, x, y, edge)) { continue; }
                const double more = static_cast<double>(seen.of(x, y) - real.of(x, y));
                sum += more;
                squares += more * more;
                bright += static_cast<double>(real.of(x, y));
                ++pixels;
            }
        }
        const double mean = sum / pixels;
        return {std::sqrt(std::max(0.0, squares / pixels - mean * mean)) * pixels / bright, sum / bright};
    }

    std::unique_ptr<QOffscreenSurface> surface_;
    QOpenGLContext context_;
    TextileRenderer renderer_;
    std::optional<double> seen_first_; ///< wet over dry, of the first distance
};

} // namespace tst_far_cloth

QTEST_MAIN(tst_far_cloth::TestFarCloth)
#include "tst_far_cloth.moc"
