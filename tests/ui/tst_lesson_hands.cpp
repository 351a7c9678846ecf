// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A lesson in careless hands: the wheel, Reset and Esc lose nothing unasked, keys do what the mouse does, and what failed is said.
#include "lesson_test.h"

#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

#include <limits>

using namespace hygroloom;

class TestLessonHands : public LessonTest {
    Q_OBJECT

private Q_SLOTS:
    void init() { openLesson(); }
    void cleanup() { window_.reset(); }

    void stepsLeaveTimeToReadAndStayAfterBack()
    {
        Lesson lesson;
        LessonGoal at_once;
        lesson.steps = {{"Short.", "", at_once}, {std::string(100, 'a'), "", at_once}, {"End.", "", {}}};
        TableState state;
        state.cloths.resize(2);
        LessonSteps steps;
        steps.setLesson(lesson);
        steps.look(state, 0);
        QVERIFY(steps.seen());
        QCOMPARE(steps.msToNext(), 2500);
        steps.next();
        steps.look(state, 1);
        QCOMPARE(steps.msToNext(), 6000); // 60 ms a character
        steps.back();
        steps.look(state, 2);
        QVERIFY(steps.seen());
        QCOMPARE(steps.msToNext(), 0);
        steps.next();
        steps.look(state, 3);
        QCOMPARE(steps.msToNext(), 6000);
    }
    void theWheelScrollsAndChangesNothing()
    {
        const QSlider& wind = window_->controls().windSlider();
        auto* lessons = window_->findChild<QComboBox*>();
        const int before = wind.value(), chosen = lessons->currentIndex();
        for (QWidget* each : {static_cast<QWidget*>(&window_->controls().windSlider()), static_cast<QWidget*>(lessons)}) {
            const QPointF at = each->rect().center();
            QWheelEvent event(at, each->mapToGlobal(at), {}, {0, -240}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
            QApplication::sendEvent(each, &event);
        }
        QCOMPARE(wind.value(), before);
        QCOMPARE(lessons->currentIndex(), chosen);
    }
    void resetAsksOnceDropsHaveFallen()
    {
        auto* reset = button<QToolButton>("Reset");
        const LessonTable* table = window_->table();
        bool asked = false;
        const auto answer = [&](const QString& with) {
            QTimer::singleShot(200, this, [&asked, with] {
                auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                asked = box != nullptr;
                if (!box) { return; }
                for (QAbstractButton* each : box->buttons()) {
                    if (each->text().remove('&') == with) { return each->click(); }
                }
                box->reject();
            });
        };
        window_->scene().drop(0, 0, 0);
        QTRY_COMPARE_WITH_TIMEOUT(dropsOn(*window_, 0), 1, patience);
        answer("Cancel");
        reset->click();
        QVERIFY(asked);
        QVERIFY(window_->table() == table);
        QCOMPARE(dropsOn(*window_, 0), 1);
        answer("Cancel");
        auto* lessons = window_->findChild<QComboBox*>();
        lessons->setCurrentIndex(1);
        Q_EMIT lessons->activated(1);
        QVERIFY(asked);
        QCOMPARE(lessons->currentIndex(), 0);
        answer("Reset");
        reset->click();
        QTRY_VERIFY_WITH_TIMEOUT(laidOut(*window_), patience);
        QCOMPARE(dropsOn(*window_, 0), 0);
        asked = false;
        answer("Cancel");
        reset->click(); // nothing to lose
        QTest::qWait(400);
        QVERIFY(!asked);
    }
    void keysDropWaterWhereTheMarkerIs()
    {
        LessonScene& scene = window_->scene();
        window_->activateWindow();
        QTRY_VERIFY(window_->isActiveWindow());
        scene.setFocus();
        QTRY_VERIFY(scene.hasFocus());
        const auto picture = [&] { return scene.grab(scene.clothArea(1).toRect()).toImage(); };
        window_->setPaused(true);
        const QImage before = picture();
        QTest::keyClick(&scene, Qt::Key_2);
        const QImage chosen = picture();
        QVERIFY(chosen != before);
        for (int k = 0; k < 3; ++k) { QTest::keyClick(&scene, Qt::Key_Right); }
        QTest::keyClick(&scene, Qt::Key_Down, Qt::ShiftModifier);
        QVERIFY(picture() != chosen);
        QTest::keyClick(&scene, Qt::Key_Return);
        window_->setPaused(false);
        QTRY_VERIFY_WITH_TIMEOUT(!window_->table()->view(1)->frame->caps.empty(), patience);
        const FrameCap cap = window_->table()->view(1)->frame->caps[0];
        QVERIFY(std::abs(cap.x - 3e-3) < 1e-6 && std::abs(cap.y + 5e-3) < 1e-6);
        QCOMPARE(dropsOn(*window_, 0), 0);
        for (int k = 0; k < 100; ++k) { QTest::keyClick(&scene, Qt::Key_Up); } // not over the edge
        QTest::keyClick(&scene, Qt::Key_4);                                    // there is none
        QVERIFY(window_->isVisible());
    }
    void squeezePressesWaterOutAlsoWhilePaused()
    {
        window_->table()->drop(1, 0, 0, 20e-9);
        QTRY_VERIFY_WITH_TIMEOUT(window_->table()->view(1)->score.standing_ul > 1, patience);
        window_->setPaused(true);
        window_->activateWindow();
        QTRY_VERIFY(window_->isActiveWindow());
        QTest::keyClick(window_.get(), Qt::Key_Q);
        QTRY_COMPARE_WITH_TIMEOUT(window_->table()->view(1)->score.standing_ul, 0.0, patience);
        QVERIFY(window_->table()->view(1)->score.run_off_ul > 1);
        QCOMPARE(window_->table()->view(0)->score.run_off_ul, 0.0);
    }
    void keysOpenSaveAndTurnSteps()
    {
        window_->activateWindow();
        QTRY_VERIFY(window_->isActiveWindow());
        auto* save = button<QToolButton>("Save");
        bool opened = false;
        QTimer::singleShot(300, this, [&] {
            opened = save->menu()->isVisible();
            save->menu()->close();
        });
        QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(opened);
        auto *next = button<QPushButton>("Next"), *back = button<QPushButton>("Back");
        next->setFocus();
        QTest::keyClick(next, Qt::Key_Space);
        QCOMPARE(window_->steps().step(), 1);
        QTest::keyClick(next, Qt::Key_Return);
        QCOMPARE(window_->steps().step(), 2);
        back->setFocus();
        QTest::keyClick(back, Qt::Key_Space);
        QCOMPARE(window_->steps().step(), 1);
        QTest::qWait(200); // a shortcut presses its button for a moment
        QVERIFY(!button<QToolButton>("Pause")->isChecked());
        window_->scene().setFocus();
        QTest::keyClick(&window_->scene(), Qt::Key_Space);
        QTRY_VERIFY(button<QToolButton>("Pause")->isChecked());
    }
    void aClothThatGoesWrongSaysSoAndTakesNoDrops()
    {
        LessonScene& scene = window_->scene();
        const QColor notice("#ffd08a");
        const auto said = [&] {
            const QImage image = scene.grab(scene.clothArea(0).toRect()).toImage();
            int count = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) { count += image.pixelColor(x, y) == notice ? 1 : 0; }
            }
            return count > 50;
        };
        QVERIFY(!said());
        window_->table()->blow({std::numeric_limits<double>::quiet_NaN(), 0.5, 1});
        QTRY_VERIFY_WITH_TIMEOUT(!window_->table()->failure(0).empty(), patience);
        QTest::qWait(100);
        QVERIFY(said());
        const QImage before = scene.grab(scene.clothArea(0).toRect()).toImage();
        scene.drop(0, 0, 0);
        QCOMPARE(scene.grab(scene.clothArea(0).toRect()).toImage(), before);
    }
    void aClothThatCannotBeLaidOutIsNotWaitedFor()
    {
        Lesson lesson = window_->lesson();
        lesson.cloths[1].design = {}; // without a fabric
        window_->showLesson(lesson);
        const auto waits = [&] {
            for (const QLabel* label : window_->findChildren<QLabel*>()) {
                if (label->text() == "The cloths are being laid out.") { return true; }
            }
            return false;
        };
        QVERIFY(waits());
        QTRY_VERIFY_WITH_TIMEOUT(!waits(), patience);
        QVERIFY(!window_->table()->failure(1).empty());
    }
    void endingsAreAddedBeforeTheFileIsLookedFor()
    {
        QTemporaryDir folder;
        save("Recording of", folder.filePath("a"));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder.filePath("a.hygrorec")), patience);
        save("Recording of", folder.filePath("B.HYGROREC"));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder.filePath("B.HYGROREC")), patience);
        save("Recording of", folder.filePath("a.first"));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder.filePath("a.first.hygrorec")), patience);
    }
    void aRecordingThatWasAskedForIsWrittenBeforeTheLessonCloses()
    {
        QTemporaryDir folder;
        save("Recording of", folder.filePath("a"));
        window_->close();
        QVERIFY(QFile::exists(folder.filePath("a.hygrorec")));
    }
    void aFilmThatRunsIsKeptOnEscape()
    {
        QTemporaryDir folder;
        QFile program(folder.filePath("ffmpeg"));
        QVERIFY(program.open(QIODevice::WriteOnly));
        program.write("#!/bin/sh\nfor last; do :; done\n/bin/cat > \"$last\"; sleep 0.5\n");
        program.close();
        QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner));
        const QByteArray path = qgetenv("PATH");
        qputenv("PATH", folder.path().toUtf8() + ":" + path);
        save("Film (MP4)", folder.filePath("film"));
        qputenv("PATH", path);
        QTest::qWait(300);
        QTest::keyClick(window_.get(), Qt::Key_Escape);
        QVERIFY(window_->isVisible()); // it is still being written
        QVERIFY(entry("Film (MP4)") == nullptr && entry("The film is being written") != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(!window_->isVisible(), 20000);
        QVERIFY(QFile(folder.filePath("film.mp4")).size() > 0);
        QVERIFY(!QFile::exists(folder.filePath("film.mp4.part")));
    }

private:
    template <typename Button> Button* button(const QString& text)
    {
        for (Button* each : window_->findChildren<Button*>()) {
            if (each->text() == text) { return each; }
        }
        return nullptr;
    }

    /// Of the menu Save, by how its text begins.
    QAction* entry(const QString& text)
    {
        QMenu* menu = button<QToolButton>("Save")->menu();
        Q_EMIT menu->aboutToShow();
        for (QAction* each : menu->actions()) {
            if (each->text().startsWith(text)) { return each; }
        }
        return nullptr;
    }

    /// As typed into the dialog.
    void save(const QString& text, const QString& path)
    {
        QAction* action = entry(text);
        QVERIFY2(action, qPrintable(text));
        QTimer::singleShot(200, this, [path] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            dialog->setDirectory(QFileInfo(path).path());
            dialog->findChild<QLineEdit*>("fileNameEdit")->setText(QFileInfo(path).fileName());
            static_cast<QDialog*>(dialog)->accept();
        });
        action->trigger();
    }
};

QTEST_MAIN(TestLessonHands)
#include "tst_lesson_hands.moc"
