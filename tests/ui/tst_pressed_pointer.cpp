// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Nothing moves under a pressed pointer: what is drawn on or dragged keeps its place and size while the rest follows. Needs a display:
// xvfb-run.
#include "ui/panels/candidates_panel.h"
#include "ui/picture/view_bar.h"
#include "ui/results/timeline.h"
#include "ui/weave/draft_editor.h"
#include "ui/weave/draft_paper.h"
#include "ui/weave/point_paper.h"
#include "ui/weave/weave_editor.h"
#include "ui/weave/weave_notes.h"
#include "ui/window/design_workspace.h"
#include "window_test.h"

#include <QDockWidget>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QSlider>

using namespace hygroloom;

class TestPressedPointer : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }

    void init()
    {
        openWindow({1280, 800});
        QVERIFY(window_->openFile(example("one-drop-on-cotton")));
        window_->document().edit("weave", {}, [](Design& d) { d.fabrics[0].weave = weave_from_pattern("plain"); });
        QTest::qWait(50);
    }
    void cleanup() { window_.reset(); }

    /// Each stroke leaves more ends and picks that never interlace, and issues.
    void pointPaperStaysWhileAWarningGrows()
    {
        auto* paper = window_->findChild<PointPaper*>();
        window_->document().edit("weave", {}, [](Design& d) { d.fabrics[0].weave = weave_from_pattern("twill 2/2 Z"); });
        QTest::qWait(50);
        const QRect place = placeOf(paper->viewport());
        const QRectF square = paper->squareOf(1, 2);
        const QString before = window_->findChild<WeaveNotes*>()->text();
        QTest::mousePress(paper->viewport(), Qt::LeftButton, {}, paper->squareOf(0, 0).center().toPoint());
        for (int end = 0; end < 4; ++end) {
            for (int pick = 0; pick < 4; ++pick) {
                const QPointF at = paper->squareOf(end, pick).center();
                QMouseEvent move(QEvent::MouseMove, at, paper->viewport()->mapToGlobal(at), Qt::LeftButton, Qt::LeftButton, {});
                QApplication::sendEvent(paper->viewport(), &move);
                QTest::qWait(1);
                QCOMPARE(placeOf(paper->viewport()), place);
                QCOMPARE(paper->squareOf(1, 2), square);
            }
        }
        QTest::mouseRelease(paper->viewport(), Qt::LeftButton, {}, paper->squareOf(3, 3).center().toPoint());
        QTest::qWait(50);
        QCOMPARE(placeOf(paper->viewport()), place);
        const QString after = window_->findChild<WeaveNotes*>()->text();
        QVERIFY2(after.contains("never interlace") && !before.contains("never interlace"), qPrintable(after));
    }

    void draftPaperStaysWhenTheNoteGoes()
    {
        window_->design().docks().draft->show();
        QTest::qWait(100);
        auto* editor = window_->findChild<DraftEditor*>();
        auto* paper = editor->paper();
        const QRect place = placeOf(paper);
        QVERIFY(!window_->document().fabric()->weave.draft());
        editor->findDraft();
        QTest::qWait(50);
        QVERIFY(window_->document().fabric()->weave.draft());
        QCOMPARE(placeOf(paper), place);
    }

    void theTimeSliderStaysWhileARunGoesOn()
    {
        window_->setWorkspace(Workspace::simulate);
        shortenExperiment(0.3, 4, 0.5);
        auto* slider = timeline().findChild<QSlider*>();
        QTest::qWait(500);
        const QRect place = placeOf(slider);
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        window_->run().start();
        QTRY_VERIFY_WITH_TIMEOUT(ended.count() == 1, 60000);
        QTest::qWait(50);
        QCOMPARE(placeOf(slider), place);
        for (const int index : {0, playback().frames() / 2, playback().frames() - 1}) {
            playback().show(index);
            QTest::qWait(50);
            QCOMPARE(placeOf(slider), place);
        }
    }

    void theSectionSliderStaysWhileItIsDragged()
    {
        window_->viewport().bar().setSection({SectionPlane::Across::warp, 0, false});
        QTest::qWait(50);
        auto* slider = window_->viewport().bar().findChild<QSlider*>();
        QVERIFY(slider->isVisible());
        const QRect place = placeOf(slider);
        for (const int value : {slider->minimum(), 0, slider->maximum()}) {
            slider->setValue(value);
            QTest::qWait(20);
            QCOMPARE(placeOf(slider), place);
        }
    }

    void candidatesStayWhileOneIsChosen_data()
    {
        QTest::addColumn<int>("workspace");
        QTest::newRow("design") << static_cast<int>(Workspace::design);
        QTest::newRow("simulate") << static_cast<int>(Workspace::simulate);
        QTest::newRow("compare") << static_cast<int>(Workspace::compare);
    }
    void candidatesStayWhileOneIsChosen()
    {
        QFETCH(int, workspace);
        window_->document().edit("candidates", {}, [](Design& d) {
            for (const char* name : {"second", "third"}) {
                d.fabrics.push_back(d.fabrics[0]);
                d.fabrics.back().name = name;
            }
        });
        window_->setWorkspace(static_cast<Workspace>(workspace));
        QDockWidget* dock = window_->design().docks().candidates;
        dock->show();
        QTest::qWait(300);
        auto* list = window_->design().candidates().findChild<QListWidget*>();
        QVERIFY(list->isVisible() && list->count() == 3);
        const QRect place = placeOf(list->viewport());
        for (const int row : {1, 2, 0}) {
            const QPoint at = list->visualItemRect(list->item(row)).center();
            QVERIFY(list->viewport()->rect().contains(at));
            QTest::mousePress(list->viewport(), Qt::LeftButton, {}, at);
            QCOMPARE(window_->document().fabricIndex(), row);
            QTest::qWait(300); // the picture and the fields follow
            QCOMPARE(placeOf(list->viewport()), place);
            QTest::mouseRelease(list->viewport(), Qt::LeftButton, {}, at);
        }
        window_->setWorkspace(Workspace::design);
    }

    void runPauseAndStopKeepTheirPlaces()
    {
        window_->setWorkspace(Workspace::simulate);
        shortenExperiment(60, 6, 1);
        simulationPanel().setFidelity(Fidelity::draft); // seconds long
        std::vector<QPushButton*> buttons;
        for (QPushButton* each : simulationPanel().findChildren<QPushButton*>()) {
            if (QStringList{"Run", "Pause", "Stop"}.contains(each->text())) { buttons.push_back(each); }
        }
        QCOMPARE(buttons.size(), std::size_t{3});
        const auto places = [&] {
            std::vector<QRect> found;
            for (const QPushButton* each : buttons) { found.push_back(each->isVisible() ? placeOf(each) : QRect()); }
            return found;
        };
        const auto enabled = [&] {
            QString found;
            for (const QPushButton* each : buttons) { found += each->isEnabled() ? each->text().at(0) : QChar('-'); }
            return found;
        };
        QTRY_COMPARE(enabled(), QString("R--"));
        QTest::qWait(500);
        const std::vector<QRect> before = places();
        QVERIFY(!before[0].intersects(before[1]) && !before[0].intersects(before[2]) && !before[1].intersects(before[2]));
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        buttons[0]->click();
        QTRY_VERIFY_WITH_TIMEOUT(playback().live() && playback().frames() > 0, 30000);
        simulation().setPaused(true);
        QCOMPARE(enabled(), QString("-RS")); // resume and stop
        QTest::qWait(50);
        QCOMPARE(places(), before);
        simulation().setPaused(false);
        QCOMPARE(enabled(), QString("-PS"));
        QCOMPARE(places(), before);
        simulation().cancel();
        QTRY_VERIFY_WITH_TIMEOUT(ended.count() == 1, 10000);
        QTest::qWait(50);
        QTRY_COMPARE(enabled(), QString("R--"));
        QCOMPARE(places(), before);
    }

private:
    static QRect placeOf(const QWidget* widget) { return {widget->mapToGlobal(QPoint(0, 0)), widget->size()}; }
};

QTEST_MAIN(TestPressedPointer)
#include "tst_pressed_pointer.moc"
