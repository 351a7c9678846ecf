// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run shows besides water: temperature and humidity on maps and in 3D, charts and reports in the user's units, its pictures as
// files. Needs a display: xvfb-run.
#include "ui/basics/film.h"
#include "ui/basics/film_end.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/picture/textile_canvas.h"
#include "ui/picture/viewport.h"
#include "ui/results/chart.h"
#include "ui/results/results_panel.h"
#include "ui/results/water_map_view.h"
#include "ui/window/run_film.h"
#include "window_test.h"

#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QProgressDialog>
#include <QPushButton>
#include <QRegularExpression>
#include <QStandardItemModel>
#include <QTimer>

using namespace hygroloom;

class TestRunViews : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        openWindow({1280, 800});
    }
    void cleanupTestCase() { window_.reset(); }
    void cleanup() { setPreferences(quickPreferences()); }

    void whatARunDoesNotModelCannotBeChosen()
    {
        QVERIFY(run("one-drop-on-cotton", 0.2));
        QComboBox& choice = waterMaps().quantityChoice();
        const auto* model = qobject_cast<QStandardItemModel*>(choice.model());
        for (const ShownQuantity each : {ShownQuantity::temperature, ShownQuantity::humidity}) {
            const QStandardItem* item = model->item(static_cast<int>(each));
            const std::string why = why_not_shown(playback().run()->plan, each);
            QCOMPARE(item->isEnabled(), why.empty());
            QCOMPARE(item->text().endsWith("(not modelled)"), !why.empty());
            QVERIFY(item->toolTip().contains(QString::fromStdString(why).toHtmlEscaped()));
        }
    }

    void dryingClothIsShownByItsTemperature()
    {
        QVERIFY(run("laboratory", 60, ExperimentType::drying));
        QVERIFY(playback().run()->plan.on("heat"));
        QSignalSpy maps(&waterMaps(), &WaterMapView::mapChanged);
        waterMaps().quantityChoice().setCurrentIndex(static_cast<int>(ShownQuantity::temperature));
        QTRY_VERIFY_WITH_TIMEOUT(maps.count() > 0, 10000);
        const CellMap& map = waterMaps().top().map();
        QCOMPARE(map.quantity, ShownQuantity::temperature);
        const auto [low, high] = std::minmax_element(map.water.begin(), map.water.end());
        QVERIFY(*low > 273 && *high < 313);
        QTRY_VERIFY(waterMaps().values().low <= *low && waterMaps().values().high >= *high);
        QTRY_VERIFY_WITH_TIMEOUT(waterMaps().top().accessibleDescription().startsWith("Temperatures from"), 5000);
        QVERIFY2(waterMaps().top().accessibleDescription().contains("°C"), qPrintable(waterMaps().top().accessibleDescription()));
        waterMaps().quantityChoice().setCurrentIndex(0);
        QTRY_COMPARE_WITH_TIMEOUT(waterMaps().top().map().quantity, ShownQuantity::water, 5000);
    }

    void aMapIsSavedAsItIsShown()
    {
        QVERIFY(run("one-drop-on-cotton", 0.2));
        QTRY_VERIFY_WITH_TIMEOUT(waterMaps().range() > 0 && !waterMaps().top().map().water.empty(), 10000);
        const QTemporaryDir folder;
        const QString picture = folder.filePath("top.png"), table = folder.filePath("bottom.csv");
        waterMaps().save(MapSide::top, picture);
        QVERIFY(!QImage(picture).isNull());
        waterMaps().save(MapSide::bottom, table);
        QFile file(table);
        QVERIFY(file.open(QIODevice::ReadOnly));
        int cells = 0;
        bool head = false;
        while (!file.atEnd()) {
            const QByteArray line = file.readLine();
            if (line.startsWith('#')) { continue; }
            if (std::exchange(head, true)) { ++cells; }
        }
        const CellMap& map = waterMaps().bottom().map();
        QCOMPARE(cells, map.columns * map.rows);
    }

    void chartsAndReportsHaveTheUsersUnits()
    {
        QVERIFY(run("one-drop-on-cotton", 0.2));
        QVERIFY2(chart().title().contains("mm"), qPrintable(chart().title()));
        const QString before = QString::fromStdString(html_of(results().report()));
        QVERIFY(before.contains("<th>thickness</th><td class=\"number\">") && before.contains("<td>mm</td>"));
        Preferences chosen = preferences();
        chosen.length = static_cast<int>(LengthUnit::inch);
        chosen.yarn = static_cast<int>(YarnUnit::ne);
        setPreferences(chosen);
        QTRY_VERIFY2(chart().title().endsWith("in"), qPrintable(chart().title()));
        const QString after = QString::fromStdString(html_of(results().report()));
        QVERIFY(after.contains("<td>in</td>") && after.contains("<td>Ne</td>"));
        QVERIFY(!after.contains("<td>mm</td>") && !after.contains("<td>tex</td>"));
        // So do the inputs, in words.
        const QRegularExpression millimetres("warp, diameter</th><td>[0-9.]+ mm"), inches("warp, diameter</th><td>[0-9.]+ in\\b");
        QVERIFY(before.contains(millimetres) && !before.contains(inches));
        QVERIFY(after.contains(inches) && !after.contains(millimetres) && !after.contains("diameter_mm"));
    }

    void picturesOfARunAreNumberedFiles()
    {
        QVERIFY(run("one-drop-on-cotton", 0.2));
        QTRY_VERIFY_WITH_TIMEOUT(window_->viewport().findChild<TextileCanvas*>()->fabric(), 10000); // without cloth no time is shown
        QTemporaryDir folder;
        const int frames = playback().frames(), shown = playback().current();
        QVERIFY(frames > 2);
        auto* film = new RunFilm(
            playback(), [this](const QString& clock) { return window_->viewport().picture(clock); }, "run", window_.get());
        QSignalSpy saved(film, &RunFilm::saved);
        film->savePictures(folder.path());
        QTRY_VERIFY_WITH_TIMEOUT(saved.count() == 1, 60000);
        const QStringList names = QDir(folder.path()).entryList(QDir::Files, QDir::Name);
        QCOMPARE(names.size(), frames);
        QCOMPARE(names.first(), QString("run-000001.png"));
        const QImage first(folder.filePath(names.first())), last(folder.filePath(names.last()));
        QCOMPARE(first.size(), window_->viewport().picture().size());
        QVERIFY(first != last); // the drop falls
        // Each has its own time in the upper left corner, and a picture that is no film's has none.
        const auto corner = [](const QImage& picture) { return picture.copy(10, 12, 90, 24); };
        for (int k = 1; k < names.size(); ++k) {
            const QImage before(folder.filePath(names[k - 1])), now(folder.filePath(names[k]));
            QVERIFY2(corner(before) != corner(now), qPrintable(names[k]));
        }
        QVERIFY(window_->viewport().picture("0 s") != window_->viewport().picture());
        QTRY_COMPARE(playback().current(), shown);
    }

    void theClockOfAPictureIsReadOnAnyCloth()
    {
        QVERIFY(run("one-drop-on-cotton", 0.2));
        QTRY_VERIFY_WITH_TIMEOUT(window_->viewport().findChild<TextileCanvas*>()->fabric(), 10000); // without cloth no time is shown
        const QString words = momentText(0.1, 0.2);
        for (const Appearance look : {Appearance::light, Appearance::dark}) {
            applyAppearance(look);
            const QImage bare = window_->viewport().picture(), timed = window_->viewport().picture(words);
            int changed = 0, low = 255, high = 0;
            for (int y = 12; y < 38; ++y) {
                for (int x = 12; x < 60; ++x) {
                    const int gray = qGray(timed.pixel(x, y));
                    low = std::min(low, gray);
                    high = std::max(high, gray);
                    changed += timed.pixel(x, y) != bare.pixel(x, y) ? 1 : 0;
                }
            }
            QVERIFY(changed > 100);
            QVERIFY2(high - low > 150, qPrintable(QString("%1 to %2").arg(low).arg(high))); // ink on its plate
        }
        applyAppearance(Appearance::light);
    }

    void aCancelledSequenceLeavesWholePicturesOnly()
    {
        QTemporaryDir folder;
        auto* film = new RunFilm(
            playback(), [this](const QString& clock) { return window_->viewport().picture(clock); }, "run", window_.get());
        QSignalSpy saved(film, &RunFilm::saved);
        film->savePictures(folder.path());
        auto* progress = window_->findChild<QProgressDialog*>();
        QVERIFY(progress);
        QTRY_VERIFY_WITH_TIMEOUT(progress->value() >= 1, 60000);
        progress->findChild<QPushButton*>()->click(); // QProgressDialog::cancel() would only hide it
        QCOMPARE(saved.count(), 1);
        QVERIFY(saved.first().first().toString().startsWith("Cancelled after "));
        for (const QString& name : QDir(folder.path()).entryList(QDir::Files)) {
            QVERIFY(name.endsWith(".png") && !QImage(folder.filePath(name)).isNull());
        }
    }

    void aFilmNeedsFfmpeg()
    {
        QTemporaryDir folder;
        const QByteArray path = qgetenv("PATH");
        qputenv("PATH", folder.path().toUtf8());
        window_->run().refreshActions();
        const QAction* action = nullptr;
        for (const QAction* each : window_->findChildren<QAction*>()) {
            if (each->text().remove('&').startsWith("Save Film")) { action = each; }
        }
        QVERIFY(!action->isEnabled());
        QVERIFY2(action->text().remove('&').endsWith("ffmpeg Is Not Installed"), qPrintable(action->text()));
        makeFfmpeg(folder, ""); // what stands in for it keeps what it is given
        window_->run().refreshActions();
        QVERIFY(action->isEnabled());
        auto* film = new RunFilm(
            playback(), [this](const QString& clock) { return window_->viewport().picture(clock); }, "run", window_.get());
        QSignalSpy saved(film, &RunFilm::saved);
        film->saveMovie(folder.filePath("run.mp4"));
        qputenv("PATH", path);
        QTRY_VERIFY_WITH_TIMEOUT(saved.count() == 1, 60000);
        const QImage one = window_->viewport().picture();
        const qint64 bytes = qint64{4} * (one.width() / 2 * 2) * (one.height() / 2 * 2);
        QCOMPARE(QFile(folder.filePath("run.mp4")).size(), playback().frames() * bytes);
        QVERIFY(!QFile::exists(folder.filePath("run.mp4.part")));
    }

    /// The fault that was seen: the program waited for ffmpeg with nothing on screen.
    void closingOverAFilmAsksAndShowsWhatItWaitsFor_data() { ends(); }
    void closingOverAFilmAsksAndShowsWhatItWaitsFor()
    {
        QFETCH(QByteArray, end);
        QFETCH(bool, kept);
        QVERIFY(run("one-drop-on-cotton", 0.2));
        QTemporaryDir folder;
        const QString file = folder.filePath("run.mp4");
        const QByteArray path = qgetenv("PATH");
        makeFfmpeg(folder, end);
        qputenv("PATH", folder.path().toUtf8() + ":" + path);
        auto* film = new RunFilm(
            playback(), [this](const QString& clock) { return window_->viewport().picture(clock); }, "run", window_.get());
        film->saveMovie(file);
        qputenv("PATH", path);
        const auto* progress = window_->findChild<QProgressDialog*>();
        QTRY_COMPARE_WITH_TIMEOUT(progress->value(), playback().frames(), 60000); // ffmpeg alone is still at work
        window_->document().history()->setClean();
        QString asked;
        QTimer answers;
        connect(&answers, &QTimer::timeout, this, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box) { return; }
            for (QAbstractButton* button : box->buttons()) {
                const QString text = button->text().remove('&');
                if (!text.startsWith("Delete the Run") && text != (kept ? "Finish the Film" : "Leave without It")) { continue; }
                asked = box->text();
                button->click();
                return;
            }
        });
        answers.start(50);
        QElapsedTimer taken;
        taken.start();
        QVERIFY(window_->close());
        QVERIFY2(taken.elapsed() < 20000, qPrintable(QString::number(taken.elapsed())));
        QCOMPARE(asked, QString("Finish the film before Hygroloom closes?"));
        QCOMPARE(QFile::exists(file), kept);
        QVERIFY(!QFile::exists(file + ".part"));
    }

    void theEndOfAFilmIsShownAndCanBeLeft_data() { ends(); }
    void theEndOfAFilmIsShownAndCanBeLeft()
    {
        QFETCH(QByteArray, end);
        QFETCH(bool, kept);
        QTemporaryDir folder;
        const QString file = folder.filePath("film.mp4");
        const QByteArray path = qgetenv("PATH");
        makeFfmpeg(folder, end);
        qputenv("PATH", folder.path().toUtf8() + ":" + path);
        Film film("film");
        QVERIFY(film.startMovie(file));
        QImage picture(40, 30, QImage::Format_RGB32);
        picture.fill(Qt::red);
        film.add(picture);
        qputenv("PATH", path);
        bool seen = false;
        QTimer::singleShot(300, this, [&] {
            auto* box = qobject_cast<QProgressDialog*>(QApplication::activeModalWidget());
            seen = box && box->isVisible() && box->labelText() == "The film is being written.";
            if (seen && !kept) { box->findChild<QPushButton*>()->click(); }
        });
        QElapsedTimer taken;
        taken.start();
        endInDialog(film, window_.get());
        QVERIFY(seen && !film.busy() && taken.elapsed() < 20000);
        QCOMPARE(QFile::exists(file), kept);
        QVERIFY(!QFile::exists(file + ".part"));
        endInDialog(film, window_.get()); // there is nothing to wait for
    }

private:
    /// What ffmpeg does after the last picture, and whether its film is kept then.
    static void ends()
    {
        QTest::addColumn<QByteArray>("end");
        QTest::addColumn<bool>("kept");
        QTest::newRow("finished") << QByteArray("exec sleep 1") << true;
        QTest::newRow("left") << QByteArray("exec sleep 60") << false;
    }
    /// A script that stands in for it.
    static void makeFfmpeg(const QTemporaryDir& folder, const QByteArray& end)
    {
        QFile program(folder.filePath("ffmpeg"));
        QVERIFY(program.open(QIODevice::WriteOnly));
        program.write("#!/bin/sh\nfor last; do :; done\n/bin/cat > \"$last\"\n" + end + "\n");
        program.close();
        QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner));
    }
    /// A short run of an example's experiment of a type, to its end.
    bool run(const QString& project, double duration_s, ExperimentType type = ExperimentType::droplet)
    {
        window_.reset(); // a changed project would ask
        window_ = std::make_unique<MainWindow>();
        window_->resize(800, 600);
        window_->show();
        if (!QTest::qWaitForWindowExposed(window_.get()) || !window_->openFile(example(project))) { return false; }
        const auto& all = window_->document().design()->experiments;
        const auto found = std::find_if(all.begin(), all.end(), [type](const Experiment& e) { return e.type == type; });
        if (found == all.end()) { return false; }
        const auto index = found - all.begin();
        window_->document().setExperimentIndex(static_cast<int>(index));
        window_->document().edit("short", {}, [&](Design& d) {
            Experiment& e = d.experiments[static_cast<std::size_t>(index)];
            e.duration_s = duration_s;
            e.sample_mm = {12, 12}; // from afar yarns are drawn with less detail
            if (type == ExperimentType::droplet) { e.droplets = {Droplet{1, 0, {0, 0}, 0.05, 0}}; }
        });
        simulationPanel().setFidelity(Fidelity::live);
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        window_->run().start();
        return QTest::qWaitFor([&] { return ended.count() == 1 && playback().metrics() && playback().frame(); }, 120000);
    }
};

QTEST_MAIN(TestRunViews)
#include "tst_run_views.moc"
