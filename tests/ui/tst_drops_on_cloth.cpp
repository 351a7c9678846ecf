// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Drops are dragged, added and deleted on the cloth, with the mouse in the picture. Needs a display: xvfb-run.
#include "ui/picture/textile_canvas.h"
#include "window_test.h"

#include <QMouseEvent>

using namespace hygroloom;

class TestDropsOnCloth : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }

    void init()
    {
        openWindow({1280, 800});
        QVERIFY(window_->openFile(example("one-drop-on-cotton")));
        window_->document().edit("drops", {}, [](Design& d) {
            Experiment& e = d.experiments[0];
            e.sample_mm = {20, 20};
            e.droplets = {Droplet{1, 0, {0, 0}, 0.05, 0}, Droplet{2, 0.5, {5, -4}, 0.05, 0}};
        });
        window_->document().history()->clear();
        window_->setWorkspace(Workspace::simulate);
        canvas_ = window_->viewport().canvas();
        if (!canvas_) { QSKIP("no OpenGL"); }
        QTRY_VERIFY_WITH_TIMEOUT(canvas_->fabric() && canvas_->fabric()->high().x() > 9, 10000);
        canvas_->fit(Framing::whole);
        QCOMPARE(canvas_->drops().size(), std::size_t{2});
    }
    void cleanup() { window_.reset(); }

    void aMarkerIsDraggedWhileTheCameraKeepsStill()
    {
        const QMatrix4x4 view = canvas_->camera().view();
        const QImage before = canvas_->grabFramebuffer();
        press({5, -4});
        move({3.43, 3.27});
        QCOMPARE(canvas_->camera().view(), view);
        QVERIFY(near(canvas_->drops()[1], {3.4, 3.3}));
        QVERIFY(canvas_->grabFramebuffer() != before);
        QCOMPARE(window_->document().history()->count(), 0); // one step, when it is let go
        release({3.43, 3.27});
        QCOMPARE(window_->document().history()->count(), 1);
        QVERIFY(near(drop(1), {3.4, 3.3}));
        QVERIFY(near(drop(0), {0, 0}));
        QCOMPARE(canvas_->camera().view(), view);
        window_->document().history()->undo();
        QVERIFY(near(drop(1), {5, -4}));
        QVERIFY(near(canvas_->drops()[1], {5, -4}));
    }

    void besideAMarkerTheCameraTurns()
    {
        const QMatrix4x4 view = canvas_->camera().view();
        press({-6, 6});
        move({-2, 6});
        release({-2, 6});
        QVERIFY(canvas_->camera().view() != view);
        QCOMPARE(window_->document().history()->count(), 0);
    }

    void itSnapsToTheMiddleAndToOtherDrops()
    {
        const double reach = 3 * canvas_->camera().millimetrePerPixel(QSizeF(canvas_->size()));
        press({5, -4});
        move({reach, 6.12});
        QVERIFY(near(canvas_->drops()[1], {0, 6.1}));
        release({reach, 6.12});
        window_->document().edit("away", {}, [](Design& d) { d.experiments[0].droplets[0].at_mm = {-3.37, 2.21}; });
        press({0, 6.1});
        move({-3.37 + reach, 2.21 - reach});
        QVERIFY(near(canvas_->drops()[1], {-3.37, 2.21}));
        release({-3.37 + reach, 2.21 - reach});
    }

    void itStaysOnTheClothAndEscapePutsItBack()
    {
        press({5, -4});
        move({30, -4});
        QVERIFY(canvas_->drops()[1].x() <= canvas_->fabric()->high().x() + 0.06);
        QTest::keyClick(canvas_, Qt::Key_Escape);
        QVERIFY(near(canvas_->drops()[1], {5, -4}));
        release({30, -4});
        QCOMPARE(window_->document().history()->count(), 0);
    }

    void atTheEdgeItStaysOnTheSample()
    {
        window_->document().edit("size", {}, [](Design& d) { d.experiments[0].sample_mm = {17.72, 17.72}; });
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(canvas_->fabric()->high().x() - 8.857) < 0.001, 10000); // 62 whole ends of 35/cm
        press({5, -4});
        move({30, 0});
        release({30, 0});
        QVERIFY2(near(drop(1), {canvas_->fabric()->high().x(), 0}), qPrintable(QString::number(drop(1).x()))); // 8.9 is off the sample
        QVERIFY(!window_->document().hasError());
    }

    void aDoubleClickAddsAndDeleteRemoves()
    {
        QTest::mouseDClick(canvas_, Qt::LeftButton, {}, at({-6, 5}));
        QCOMPARE(window_->document().experiment()->droplets.size(), std::size_t{3});
        QVERIFY2(near(drop(2), {-6, 5}, 0.15), qPrintable(QString("%1 %2").arg(drop(2).x()).arg(drop(2).y())));
        QCOMPARE(canvas_->drops().size(), std::size_t{3});
        QTest::keyClick(canvas_, Qt::Key_Delete); // the new one is marked
        QCOMPARE(window_->document().experiment()->droplets.size(), std::size_t{2});
        QVERIFY(near(drop(1), {5, -4}));
        QTest::mouseClick(canvas_, Qt::LeftButton, {}, at({0, 0}));
        QTest::keyClick(canvas_, Qt::Key_Delete);
        QCOMPARE(window_->document().experiment()->droplets.size(), std::size_t{1});
        QVERIFY(near(drop(0), {5, -4}));
        window_->document().history()->undo();
        window_->document().history()->undo();
        window_->document().history()->undo();
        QCOMPARE(window_->document().experiment()->droplets.size(), std::size_t{2});
    }

    void elsewhereNothingIsAddedOrDeleted()
    {
        window_->setWorkspace(Workspace::design);
        QVERIFY(canvas_->drops().empty());
        QTest::mouseDClick(canvas_, Qt::LeftButton, {}, canvas_->rect().center());
        QTest::keyClick(canvas_, Qt::Key_Delete);
        QCOMPARE(window_->document().experiment()->droplets.size(), std::size_t{2});
    }

private:
    static bool near(const QPointF& a, const QPointF& b, double within = 1e-6)
    {
        return std::abs(a.x() - b.x()) < within && std::abs(a.y() - b.y()) < within;
    }
    QPointF drop(std::size_t index) const
    {
        const auto& at = window_->document().experiment()->droplets[index].at_mm;
        return {at[0], at[1]};
    }
    /// On the plane of the upper face.
    QPoint at(const QPointF& mm) const
    {
        return canvas_->camera()
            .project({static_cast<float>(mm.x()), static_cast<float>(mm.y()), canvas_->fabric()->high().z() / 2}, QSizeF(canvas_->size()))
            .toPoint();
    }
    void press(const QPointF& mm) { QTest::mousePress(canvas_, Qt::LeftButton, {}, at(mm)); }
    void move(const QPointF& mm)
    {
        // To the exact place: whole pixels are coarser than a step.
        const QPointF place = canvas_->camera().project(
            {static_cast<float>(mm.x()), static_cast<float>(mm.y()), canvas_->fabric()->high().z() / 2}, QSizeF(canvas_->size()));
        QMouseEvent event(QEvent::MouseMove, place, canvas_->mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(canvas_, &event);
    }
    void release(const QPointF& mm) { QTest::mouseRelease(canvas_, Qt::LeftButton, {}, at(mm)); }

    TextileCanvas* canvas_ = nullptr;
};

QTEST_MAIN(TestDropsOnCloth)
#include "tst_drops_on_cloth.moc"
