// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The garment in 3D under the pointer: the nearest cloth is found from every side, a fabric is dropped on it, the wheel keeps it in sight.
#include "ui/basics/elided_combo.h"
#include "ui/garment/flat_view.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_panel.h"
#include "ui/garment/garment_view.h"
#include "ui/garment/lining_field.h"
#include "ui/garment/panel_table.h"
#include "ui/garment/shape_view.h"
#include "window_test.h"

#include <QDropEvent>
#include <QMimeData>
#include <QWheelEvent>

#include <cmath>

using namespace hygroloom;

class TestGarmentDrop : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void init()
    {
        openWindow({1280, 800});
        QVERIFY(window_->document().openExample(example("three-candidates")));
        window_->setWorkspace(Workspace::garment);
        window_->run().garment().choice().setGarmentIndex(addBuiltInGarment(window_->document(), "tee"));
        QTRY_VERIFY(window_->run().garment().choice().drawing());
        QTest::qWait(200);
    }
    void cleanup()
    {
        window_->document().history()->setClean();
        window_.reset();
    }

    /// What is picked is what the graphics card draws there, by its own depth.
    void theNearestPanelIsPickedFromEverySide()
    {
        const std::size_t fabrics = window_->document().design()->fabrics.size();
        QVERIFY(fabrics >= 3);
        for (std::size_t k = 0; k < panels().size(); ++k) { // a sleeve may look like the front, never like the back
            cut(k, k % fabrics);
        }
        for (const double turn : {0.0, 90.0, 155.0, 250.0}) {
            shape().lookFrom(turn);
            QTest::qWait(50);
            const QImage picture = shape().picture();
            int seen = 0, right = 0;
            for (int y = 3; y < shape().height(); y += 19) {
                for (int x = 3; x < shape().width(); x += 19) {
                    const GarmentSpot spot = shape().spotAt(QPointF(x + 0.5, y + 0.5));
                    if (spot.panel < 0 || isAtRim(QPointF(x + 0.5, y + 0.5), spot.panel)) { continue; }
                    ++seen;
                    right += nearestFabric(pixel(picture, x, y)) == static_cast<std::size_t>(spot.panel) % fabrics ? 1 : 0;
                }
            }
            QVERIFY2(seen > 20, qPrintable(QString::number(seen)));
            QVERIFY2(right > 0.97 * seen, qPrintable(QString("turned by %1: %2 of %3").arg(turn).arg(right).arg(seen)));
        }
    }

    void aFabricIsDroppedOnTheTurnedGarment()
    {
        shape().lookFrom(180);
        QTest::qWait(100);
        const QPointF at(0.5 * shape().width() + 0.5, 0.5 * shape().height() + 0.5);
        const GarmentSpot spot = shape().spotAt(at);
        QCOMPARE(panels()[static_cast<std::size_t>(spot.panel)].name, std::string("back"));
        QMimeData data;
        const std::string fabric = window_->document().design()->fabrics[1].name;
        data.setData(fabric_mime, QByteArray::fromStdString(fabric));
        const QColor before = pixel(shape().picture(), at.toPoint());
        QDragEnterEvent enter(at.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&shape(), &enter);
        QVERIFY(enter.isAccepted());
        move(at, data, true);
        const QColor marked = pixel(shape().picture(), at.toPoint());
        QVERIFY2(distance(before, marked) > 60, qPrintable(before.name() + " " + marked.name()));
        move(QPointF(3, 3), data, false); // beside the garment
        QVERIFY(distance(before, pixel(shape().picture(), at.toPoint())) < 3);
        move(at, data, true);
        QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&shape(), &drop);
        QVERIFY(drop.isAccepted());
        QCOMPARE(garment().cut_of("back")->fabric, fabric);
        QCOMPARE(garment().cut_of("front")->fabric, window_->document().design()->fabrics[0].name);
        QTest::qWait(50);
        QCOMPARE(nearestFabric(pixel(shape().picture(), at.toPoint())), std::size_t{1}); // and no longer marked
        window_->document().history()->undo();
        QCOMPARE(garment().cut_of("back")->fabric, window_->document().design()->fabrics[0].name);
    }

    /// The fault that was seen: the wheel beside the garment ended in an empty view.
    void zoomingBesideTheGarmentKeepsItInSight()
    {
        const auto shows = [](auto& view) {
            for (int x = 2; x < view.width(); x += 11) {
                for (int y = 2; y < view.height(); y += 11) {
                    if (view.spotAt(QPointF(x, y)).panel >= 0) { return true; }
                }
            }
            return false;
        };
        FlatView& flat = window_->run().garment().view().flat();
        const auto zoom = [&](auto& view) {
            for (const QPointF& at : {QPointF(3, 3), QPointF(view.width() - 3, view.height() / 2)}) {
                view.fit();
                QVERIFY(view.spotAt(at).panel < 0 && shows(view));
                for (int turn = 0; turn < 30; ++turn) {
                    QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
                    QCoreApplication::sendEvent(&view, &wheel);
                    if (turn % 5 < 4) { continue; }
                    QVERIFY2(shows(view), qPrintable(QString("%1 after %2").arg(view.metaObject()->className()).arg(turn)));
                }
            }
        };
        zoom(shape());
        zoom(flat);
    }

    void aLiningIsChosenForOnePanelOrForAll()
    {
        auto* field = window_->run().garment().panel().findChild<LiningField*>();
        QVERIFY(field);
        auto* lining = field->findChild<QComboBox*>();
        const auto choose = [&](int index) {
            lining->setCurrentIndex(index);
            Q_EMIT lining->activated(index);
        };
        const auto cut = [&](std::size_t panel) { return *window_->run().garment().choice().garment()->cut_of(panels()[panel].name); };
        const Design before = *window_->document().design();
        QCOMPARE(lining->currentIndex(), 0);
        choose(1); // the same fabric
        for (std::size_t k = 0; k < panels().size(); ++k) {
            QCOMPARE(cut(k).layers, 2);
            QVERIFY(cut(k).lining.empty());
        }
        window_->run().garment().panel().panels().choosePanel(1); // as a click on the cloth does
        QCOMPARE(lining->currentIndex(), 1);
        choose(3); // the second fabric
        QCOMPARE(cut(1).lining, before.fabrics[1].name);
        QVERIFY(cut(0).lining.empty());
        choose(0);
        QCOMPARE(cut(1).layers, 1);
        QCOMPARE(cut(0).layers, 2);
        for (int step = 0; step < 3; ++step) { window_->document().history()->undo(); }
        QCOMPARE(*window_->document().design(), before);
    }

    /// The fault that was seen: "Cottor".
    void theNamesOfFabricsAreReadWhole()
    {
        const auto boxes = window_->run().garment().panel().panels().findChildren<QComboBox*>();
        int seen = 0;
        for (QComboBox* box : boxes) {
            auto* fabric = dynamic_cast<ElidedCombo*>(box);
            if (!fabric) { continue; }
            ++seen;
            for (int i = 0; i < fabric->count(); ++i) {
                fabric->setCurrentIndex(i);
                QCOMPARE(fabric->shownText(), fabric->itemText(i));
            }
            const QImage drawn = fabric->grab().toImage();
            fabric->setItemText(fabric->currentIndex(), QString(80, 'm'));
            QVERIFY(fabric->shownText().endsWith(QChar(0x2026))); // and none is cut through a letter
            QVERIFY(fabric->grab().toImage() != drawn);
        }
        QCOMPARE(seen, static_cast<int>(panels().size()));
    }

    void whatIsNoFabricIsNotTaken()
    {
        QMimeData data;
        data.setText("a letter");
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        enter.ignore();
        QCoreApplication::sendEvent(&shape(), &enter);
        QVERIFY(!enter.isAccepted());
    }

private:
    ShapeView& shape() { return *window_->run().garment().view().newest().shape(); }
    const std::vector<DrawnPanel>& panels() { return window_->run().garment().choice().drawing()->panels; }
    const Garment& garment() { return window_->document().design()->garments.front(); }
    /// Its line is drawn there, over the cloth.
    bool isAtRim(const QPointF& at, int panel)
    {
        constexpr double near = 3; // pixels
        for (const QPointF& step : {QPointF(near, 0), QPointF(-near, 0), QPointF(0, near), QPointF(0, -near)}) {
            if (shape().spotAt(at + step).panel != panel) { return true; }
        }
        return false;
    }
    void cut(std::size_t panel, std::size_t fabric)
    {
        editCut(window_->document(), "cut", 0, panels()[panel].name, {},
                [&](PanelCut& cut) { cut.fabric = window_->document().design()->fabrics[fabric].name; });
    }
    void move(const QPointF& at, const QMimeData& data, bool accepted)
    {
        QDragMoveEvent event(at.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&shape(), &event);
        QCOMPARE(event.isAccepted(), accepted);
        QTest::qWait(50);
    }
    static QColor pixel(const QImage& picture, int x, int y)
    {
        const double ratio = picture.devicePixelRatio();
        return picture.pixelColor(static_cast<int>((x + 0.5) * ratio), static_cast<int>((y + 0.5) * ratio));
    }
    static QColor pixel(const QImage& picture, const QPoint& at) { return pixel(picture, at.x(), at.y()); }
    static int distance(const QColor& a, const QColor& b)
    {
        return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
    }
    /// Light dims all three colours alike.
    std::size_t nearestFabric(const QColor& drawn)
    {
        std::size_t best = 0;
        double least = 1e9;
        for (std::size_t k = 0; k < window_->document().design()->fabrics.size(); ++k) {
            const QColor own = fabricColor(static_cast<int>(k));
            const double bright = static_cast<double>(drawn.red() + drawn.green() + drawn.blue()) / (own.red() + own.green() + own.blue());
            const double off =
                std::hypot(drawn.red() - bright * own.red(), drawn.green() - bright * own.green(), drawn.blue() - bright * own.blue());
            if (off < least) {
                least = off;
                best = k;
            }
        }
        return best;
    }
};

QTEST_MAIN(TestGarmentDrop)
#include "tst_garment_drop.moc"
