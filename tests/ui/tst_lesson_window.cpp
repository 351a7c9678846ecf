// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The lesson on screen: a click is seen at once and becomes water on its cloth, words add up, steps go on, and films are written.
#include "core/base/units.h"
#include "core/project/library.h"
#include "lesson_test.h"
#include "ui/basics/film.h"
#include "ui/lesson/cloth_choice.h"
#include "ui/lesson/lesson_words.h"
#include "ui/lesson/magnifier.h"

#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>

#include <ctime>

using namespace hygroloom;

namespace {

double brightness(const QImage& image)
{
    double sum = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) { sum += qGray(image.pixel(x, y)); }
    }
    return sum / (image.width() * image.height());
}

} // namespace

class TestLessonWindow : public LessonTest {
    Q_OBJECT

private Q_SLOTS:
    void init() { openLesson(); }
    void cleanup() { window_.reset(); }

    void aClickIsSeenAtOnceAndBecomesWater()
    {
        window_->setPaused(true);
        QTest::qWait(100);
        LessonScene& scene = window_->scene();
        const QRectF area = scene.clothArea(2);
        const QPoint at = area.center().toPoint();
        const QRect about(at - QPoint(8, 8), QSize(16, 16));
        const QImage before = scene.grab(about).toImage();
        QTest::mouseClick(&scene, Qt::LeftButton, {}, at);
        const QImage after = scene.grab(about).toImage(); // no event has passed in between
        QVERIFY(before != after);
        window_->setPaused(false);
        QTRY_COMPARE_WITH_TIMEOUT(dropsOn(*window_, 2), 1, patience);
        QCOMPARE(dropsOn(*window_, 0), 0);
        QTRY_VERIFY_WITH_TIMEOUT(!window_->table()->view(2)->frame->caps.empty(), patience);
        const FrameCap cap = window_->table()->view(2)->frame->caps[0];
        QVERIFY(std::abs(cap.x) < 0.3e-3 && std::abs(cap.y) < 0.3e-3); // to the pixel
        QVERIFY(scene.slowestAnswer() >= 0);
        qInfo("seen %.0f ms after the click", 1000 * scene.slowestAnswer());
    }
    void holdingTheButtonPours()
    {
        LessonScene& scene = window_->scene();
        const QPoint at = scene.clothArea(0).center().toPoint();
        QTest::mousePress(&scene, Qt::LeftButton, {}, at);
        QTRY_VERIFY_WITH_TIMEOUT(dropsOn(*window_, 0) >= 4, patience);
        QTest::mouseRelease(&scene, Qt::LeftButton, {}, at);
        const auto view = window_->table()->view(0);
        const RecordedCloth recorded = [&] {
            std::atomic<bool> taken{false};
            RecordedCloth cloth;
            window_->table()->record(0, [&](const RecordedCloth& what) {
                cloth = what;
                taken = true;
            });
            while (!taken) { QTest::qWait(10); }
            return cloth;
        }();
        const std::vector<Droplet>& drops = recorded.run.design.experiments[0].droplets;
        QVERIFY(drops.size() >= 3);
        const double apart = (drops.back().time_s - drops.front().time_s) / static_cast<double>(drops.size() - 1);
        QVERIFY2(apart >= 0.12, qPrintable(QString::number(apart))); // 0.2 s of the clock, from which looks differ by 0.1 s at most
    }
    void wetClothIsDarker()
    {
        LessonScene& scene = window_->scene();
        const QPoint at = scene.clothArea(0).center().toPoint();
        const QRect about(at - QPoint(10, 10), QSize(20, 20));
        QTest::qWait(200); // until the cloth that was laid out is looked at
        const double dry = brightness(scene.grab(about).toImage());
        scene.drop(0, 0, 0);
        QTRY_VERIFY_WITH_TIMEOUT(dropsOn(*window_, 0) == 1 && window_->table()->view(0)->score.absorbed_s >= 0, patience);
        QTest::qWait(100);
        const double wet = brightness(scene.grab(about).toImage());
        QVERIFY2(wet < 0.9 * dry, qPrintable(QString("%1, dry %2").arg(wet).arg(dry)));
        QVERIFY(window_->table()->view(0)->score.wet_area_mm2 > 1);
    }
    void stepsGoOnWhenSeen()
    {
        QCOMPARE(window_->steps().step(), 0);
        for (int k = 0; k < 3; ++k) { window_->scene().drop(k, 0, 0); }
        QTRY_COMPARE_WITH_TIMEOUT(window_->steps().step(), 1, patience);
        window_->steps().back();
        QCOMPARE(window_->steps().step(), 0);
    }
    void handsChangeTheAir()
    {
        window_->controls().windSlider().setValue(30);
        window_->controls().temperatureSlider().setValue(50);
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(window_->table()->view(2)->air.temperature + window_->table()->view(2)->air.air_warmth -
                                          kelvin_from_celsius(50)) < 1e-9,
                                 patience);
        window_->reset();
        QTRY_VERIFY_WITH_TIMEOUT(laidOut(*window_), patience);
        QCOMPARE(window_->controls().air().temperature_c, 25.0);
    }
    void theMagnifierShowsTheYarnsNumbers()
    {
        const auto view = window_->table()->view(0);
        auto frame = std::make_shared<Frame>(*view->frame);
        const Textile& textile = view->run->textile;
        const int end = textile.ends() / 2, pick = textile.picks() / 2;
        const YarnKind top = textile.warp_up(end, pick) ? YarnKind::warp : YarnKind::weft;
        const auto i = static_cast<std::size_t>(textile.segment(top, end, pick));
        frame->saturation[i] = 0.63F;
        frame->regain[i] = 0.2F;
        frame->vapour[i] = static_cast<float>(view->air.vapour + 0.01);
        ClothView changed = *view;
        changed.frame = frame;
        const YarnLook yarn = yarnAt(changed, textile.x_of_end(end), textile.y_of_pick(pick));
        QVERIFY(std::abs(yarn.saturation - 0.63) < 1e-6 && std::abs(yarn.regain - 0.2) < 1e-6);
        QVERIFY(std::abs(yarn.leaving / (0.01 * view->air.mass_transfer * 3.6e6) - 1) < 1e-3); // g/(m2 h)
        QVERIFY(magnifierLines(yarn)[0].contains("63"));
        QVERIFY(yarn.growth > 1.05 && yarn.growth < 1.3);
    }
    void waterIsSaidInDropsThatAddUp()
    {
        QCOMPARE(waterInWords({3, 19, 6, 4, 1, 0}),
                 QString("Of 3 drops: 1.9 in the yarns, 0.6 in the fibres, 0.4 in the air, 0.1 still standing."));
        QCOMPARE(waterInWords({1, 10, 0, 0, 0, 0}), QString("Of 1 drop: 1.0 in the yarns."));
        QVERIFY(waterInWords({1, 8, -1, 3, 0, 0}).contains("0.1 of the fibres’ own water gone"));
    }
    void aPictureTakesLessThanAThirtiethOfASecond()
    {
        for (int k = 0; k < 3; ++k) { window_->scene().drop(k, 2e-3, 0); }
        QTRY_VERIFY_WITH_TIMEOUT(window_->table()->view(0)->score.wet_area_mm2 > 0, patience);
        window_->setPaused(true);
        QTest::qWait(300);
        constexpr int pictures = 40;
        const std::clock_t begin = std::clock();
        for (int k = 0; k < pictures; ++k) { window_->scene().grab(); }
        const double each = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / pictures;
        qInfo("%.1f ms of CPU a picture", 1000 * each);
        QVERIFY(each < 1.0 / 30);
    }
    void aWrongFileIsSaid()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("x.json");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"format": "hygroloom-lesson", "version": 3})");
        file.close();
        QSignalSpy failed(window_.get(), &LessonWindow::failed);
        QVERIFY(!window_->openLesson(path));
        QCOMPARE(failed.count(), 1);
        QVERIFY(failed[0][0].toString().contains("version") && failed[0][0].toString().contains("x.json"));
        QCOMPARE(window_->table()->cloths(), 3); // the lesson before stays
    }
    void clothsOfTheProjectAndTheLibraryCanBeChosen()
    {
        ClothChoice choice(*document_->design());
        QVERIFY(choice.list().count() > 20);
        choice.list().item(0)->setCheckState(Qt::Checked);
        choice.list().item(2)->setCheckState(Qt::Checked);
        QCOMPARE(choice.chosen().size(), std::size_t{2});
        Lesson lesson;
        lesson.cloths = choice.chosen();
        window_->showLesson(lesson);
        QCOMPARE(window_->table()->cloths(), 2);
        QTRY_VERIFY_WITH_TIMEOUT(laidOut(*window_), patience);
        QVERIFY(window_->steps().isHidden());
    }
    void clothsThatDropsFallThroughCannotBeChosen()
    {
        const std::vector<Preset>& presets = shipped_presets();
        const auto sheeting =
            std::find_if(presets.begin(), presets.end(), [](const Preset& p) { return p.design.fabrics[0].name == "Sheeting"; });
        QVERIFY(sheeting != presets.end());
        Design design = sheeting->design;
        const ClothChoice dense(design);
        design.fabrics[0].ends_per_cm = design.fabrics[0].picks_per_cm = 3;
        design.fabrics[0].contact_angle_deg = 120;
        const ClothChoice open(design);
        const auto ticks = [](const ClothChoice& choice) {
            return choice.findChild<QListWidget*>()->item(0)->flags().testFlag(Qt::ItemIsUserCheckable);
        };
        QVERIFY(ticks(dense) && !ticks(open));
        QVERIFY(open.findChild<QListWidget*>()->item(0)->toolTip().contains("caps"));
    }
    void filmedPicturesHaveAClock()
    {
        window_->setPaused(true);
        LessonScene& scene = window_->scene();
        const QImage early = scene.picture("1.0 s"), late = scene.picture("2.0 s");
        QRect changed;
        for (int y = 0; y < early.height(); ++y) {
            for (int x = 0; x < early.width(); ++x) {
                if (early.pixel(x, y) != late.pixel(x, y)) { changed |= QRect(x, y, 1, 1); }
            }
        }
        QVERIFY(!changed.isEmpty());
        QVERIFY(changed.right() < early.width() / 4 && changed.bottom() < early.height() / 10);
    }
    /// The first line under a cloth is as tall as the letters of a 45th of the height, and nothing runs out of the window.
    void wordsGrowWithTheWindow()
    {
        for (const QSize size : {QSize(1280, 800), QSize(1280, 1200), QSize(3840, 2160)}) {
            window_->resize(size);
            QTest::qWait(150); // the clock is set by a timer
            LessonScene& scene = window_->scene();
            QCOMPARE(scene.height(), size.height());
            const QImage picture = scene.grab().toImage();
            const QColor table = picture.pixelColor(1, 1);
            const QRect area = scene.clothArea(0).toRect();
            const auto anyWord = [&](int y) {
                for (int x = 1; x < picture.width() / 3; ++x) {
                    if (qAbs(qGray(picture.pixel(x, y)) - qGray(table.rgb())) > 60) { return true; }
                }
                return false;
            };
            int top = area.bottom() + 8;
            while (top < picture.height() - 1 && !anyWord(top)) { ++top; }
            int bottom = top;
            while (bottom < picture.height() - 1 && anyWord(bottom)) { ++bottom; }
            QVERIFY2(bottom - top >= 0.7 * size.height() / 45, qPrintable(QString("%1 of %2").arg(bottom - top).arg(size.height())));
            for (int y = picture.height() - 3; y < picture.height(); ++y) { QVERIFY(!anyWord(y)); }
            QVERIFY(area.width() >= 200);
            const auto labels = window_->findChildren<QLabel*>();
            const QLabel* clock = *std::find_if(labels.begin(), labels.end(), [](QLabel* l) { return l->accessibleName() == "Clock"; });
            QVERIFY(45 * clock->font().pixelSize() >= size.height());
        }
    }
    void picturesAndFilmsAreWritten()
    {
        QTemporaryDir folder;
        Film film("lesson");
        QSignalSpy finished(&film, &Film::finished), failed(&film, &Film::failed);
        QImage picture(41, 30, QImage::Format_RGB32);
        picture.fill(Qt::darkCyan);
        film.startPictures(folder.path());
        for (int k = 0; k < 3; ++k) { film.add(picture); }
        film.finish();
        QCOMPARE(finished.count(), 1);
        QCOMPARE(QImage(folder.filePath("lesson-000003.png")).pixel(5, 5), picture.pixel(5, 5));

        const QByteArray path = qgetenv("PATH");
        qputenv("PATH", folder.path().toUtf8());
        QVERIFY(!film.startMovie(folder.filePath("film.mp4")));
        QVERIFY(failed.count() == 1 && failed[0][0].toString().contains("ffmpeg"));
        // What stands in for it keeps what it is given.
        QFile program(folder.filePath("ffmpeg"));
        QVERIFY(program.open(QIODevice::WriteOnly));
        program.write("#!/bin/sh\nfor last; do :; done\n/bin/cat > \"$last\"\n");
        program.close();
        QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner));
        QVERIFY(film.startMovie(folder.filePath("film.mp4")));
        qputenv("PATH", path);
        for (int k = 0; k < 5; ++k) { film.add(picture); }
        film.finish();
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 2, 10000);
        QCOMPARE(QFile(folder.filePath("film.mp4")).size(), qint64{5 * 40 * 30 * 4}); // even sides
        QVERIFY(!QFile::exists(folder.filePath("film.mp4.part")));
    }
    void escapeLeaves()
    {
        QTest::keyClick(window_.get(), Qt::Key_Escape);
        QVERIFY(!window_->isVisible());
    }
};

QTEST_MAIN(TestLessonWindow)
#include "tst_lesson_window.moc"
