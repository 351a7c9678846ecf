// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Every preference acts, at once, on what it is about. Needs a display: xvfb-run.
#include "project_runs_test.h"
#include "ui/basics/cache_folder.h"
#include "ui/basics/preferences.h"
#include "ui/compare/candidate_table.h"
#include "ui/panels/start_page.h"
#include "ui/picture/pointer.h"
#include "ui/results/device_choice.h"
#include "ui/results/results_panel.h"
#include "ui/window/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSpinBox>
#include <QWheelEvent>

#include <utility>

using namespace hygroloom;

class TestPreferences : public ProjectRunsTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        qputenv("XDG_CACHE_HOME", folder_.filePath("cache").toUtf8());
        useOwnSettings();
    }

    void init()
    {
        setPreferences(quickPreferences());
        openProject();
        trigger("Preferences…");
        dialog_ = window_->findChild<PreferencesDialog*>();
        QVERIFY(dialog_ && dialog_->isVisible());
    }

    void cleanup()
    {
        closeProject();
        applyAppearance(Appearance::light);
    }

    void theStartPageComesOnlyWhenItIsAskedFor()
    {
        QVERIFY(!window_->findChild<StartPage*>());
        dialog_->close();
        trigger("Start Page…");
        auto* page = window_->findChild<StartPage*>();
        QVERIFY(page && page->isVisible());
        auto* fabrics = page->findChildren<QListWidget*>().last();
        fabrics->setCurrentRow(0);
        fabrics->setFocus();
        QTest::keyClick(fabrics, Qt::Key_Return);
        QTRY_VERIFY(window_->document().path().isEmpty()); // a new project
        QCOMPARE(window_->document().design()->fabrics.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(window_->document().fabric()->name), fabrics->item(0)->text());
        QVERIFY(!window_->document().modified());
    }

    void lengthsReachFieldsLabelsAndTables()
    {
        run();
        const QString before = textOf("Yarn layer");
        QVERIFY2(before.endsWith(QString::fromUtf8(" mm")), qPrintable(before));
        choose("Lengths", 2);
        QVERIFY2(textOf("Yarn layer").endsWith(QString::fromUtf8(" in")), qPrintable(textOf("Yarn layer")));
        QVERIFY2(results().text().contains(QRegularExpression("Largest wetted radius\t[0-9.]+.in")), qPrintable(results().text()));
        window_->setWorkspace(Workspace::compare);
        QTRY_COMPARE(compareView().table()->horizontalHeaderItem(CandidateTable::first_number)->text(),
                     QString("Stain radius by area, top (in)"));
    }

    void settsAndCountsReachTheirFields()
    {
        choose("Sett", 1);
        QVERIFY2(field("Ends")->text().endsWith("/in"), qPrintable(field("Ends")->text()));
        choose("Yarn count", 1);
        const QLineEdit* count = field("Count");
        QVERIFY2((count->text() + count->placeholderText()).contains("Ne"), qPrintable(count->text() + count->placeholderText()));
        window_->setWorkspace(Workspace::simulate);
        choose("Temperature", 1);
        bool found = false;
        for (const QLineEdit* each : window_->findChildren<QLineEdit*>()) {
            found = found || each->text().endsWith(QString::fromUtf8("°F"));
        }
        QVERIFY(found);
    }

    void lookActsAtOnce()
    {
        choose("Appearance", 2);
        QVERIFY(isDark(QApplication::palette()));
        QCOMPARE(savedAppearance(), Appearance::dark);
        choose("Appearance", 1);
        QVERIFY(!isDark(QApplication::palette()));
    }

    void waterColoursFollowWithTheirMenu()
    {
        choose("Water colours", 1);
        for (const QAction* action : window_->findChildren<QAction*>()) {
            if (action->text() == "Cividis") { QVERIFY(action->isChecked()); }
        }
        trigger("Blue");
        QCOMPARE(box("Water colours")->currentIndex(), 0);
    }

    void buttonsOfTheMouseTurnAsElsewhere()
    {
        QVERIFY(dragOf(Qt::LeftButton, {}) == PointerDrag::orbit && dragOf(Qt::RightButton, {}) == PointerDrag::pan);
        choose("Buttons", 3); // CLO
        QVERIFY(dragOf(Qt::RightButton, {}) == PointerDrag::orbit && dragOf(Qt::MiddleButton, {}) == PointerDrag::pan);
        QVERIFY(dragOf(Qt::LeftButton, {}) == PointerDrag::none);
        TextileCanvas* canvas = window_->viewport().canvas();
        if (!canvas) { QSKIP("This display has no OpenGL."); }
        const QVector3D before = canvas->camera().direction();
        drag(*canvas, Qt::LeftButton);
        QCOMPARE(canvas->camera().direction(), before);
        drag(*canvas, Qt::RightButton);
        QVERIFY(canvas->camera().direction() != before);
    }

    void enterInAFieldRestoresNothing()
    {
        choose("Lengths", 2);
        QSpinBox* number = spinBox("Threads of a run on the CPU");
        QVERIFY(number);
        dialog_->findChild<QListWidget*>()->setCurrentRow(5);
        number->setFocus();
        number->findChild<QLineEdit*>()->setText("3");
        QTest::keyClick(number, Qt::Key_Return);
        QCOMPARE(preferences().threads, 3);
        QCOMPARE(preferences().length, 2);
        QTest::keyClick(dialog_->findChild<QListWidget*>(), Qt::Key_Return);
        QCOMPARE(preferences().length, 2);
        QVERIFY(dialog_->isVisible());
    }

    void theWheelOverTheirPagesChangesNothing()
    {
        QSpinBox* threads = spinBox("Threads of a run on the CPU");
        QVERIFY(threads);
        const int before = threads->value();
        dialog_->findChild<QListWidget*>()->setFocus();
        wheel(*threads, 240);
        QCOMPARE(threads->value(), before);
        wheel(*box("Lengths"), -240);
        QCOMPARE(preferences().length, 0);
    }

    void theWheelZoomsAsPreferred()
    {
        QVERIFY(wheelZoom(120) > 1);
        choose("Wheel", 1);
        QVERIFY(wheelZoom(120) < 1);
        TextileCanvas* canvas = window_->viewport().canvas();
        if (!canvas) { QSKIP("This display has no OpenGL."); }
        const QSizeF size(canvas->size());
        const double before = canvas->camera().millimetrePerPixel(size);
        wheel(*canvas, 120);
        QVERIFY(canvas->camera().millimetrePerPixel(size) > before);
        tick("Zoom to the pointer, not to the middle");
        QCOMPARE(zoomedAt({10, 10}, size), QPointF(0.5 * size.width(), 0.5 * size.height()));
    }

    void picturesAreRefinedAtRestOnlyIfPreferred()
    {
        TextileCanvas* canvas = window_->viewport().canvas();
        if (!canvas) { QSKIP("This display has no OpenGL."); }
        const auto at_rest = [canvas] {
            QTest::qWait(400); // longer than a motion
            return QTest::qWaitFor([canvas] { return canvas->rests(); }, 20000) ? canvas->grabFramebuffer() : QImage();
        };
        QImage plain = at_rest();
        QTRY_VERIFY(std::exchange(plain, at_rest()) == plain); // meshes come one after the other
        tick("Refine pictures of cloth while nothing moves");
        const QImage fine = at_rest();
        QVERIFY(!fine.isNull() && !plain.isNull() && plain != fine);
        tick("Refine pictures of cloth while nothing moves");
        QCOMPARE(at_rest(), plain);
        QVERIFY(canvas->picture() != plain); // what is saved is fine
    }

    void copiesOfUnsavedWorkComeAsOftenAsPreferred()
    {
        setNumber("Keep a copy every", 1);
        Document document;
        QVERIFY(document.open(project_));
        Recovery recovery(document, folder_.filePath("autosave"));
        QSignalSpy kept(&recovery, &Recovery::kept);
        document.edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm += 1; });
        QTest::qWait(2000);
        QCOMPARE(kept.count(), 0); // it waits for a minute
        setNumber("Keep a copy every", 0);
        QTRY_COMPARE_WITH_TIMEOUT(kept.count(), 1, 5000);
    }

    void threadsAreThoseOfTheNextRun()
    {
        setNumber("Threads of a run on the CPU", 1);
        run();
        QCOMPARE(playback().run()->threads, 1);
    }

    void tooManyRunsAreOfferedToGo()
    {
        run();
        const QString kept = recordingsIn(runFolderOf(project_)).first();
        Q_EMIT compareView().markRequested(kept, true);
        QFile large(runFolderOf(project_) + "/run-2.hygrorec");
        QVERIFY(large.open(QIODevice::WriteOnly) && large.resize(qint64{1} << 31)); // sparse: it takes no room
        large.close();
        setNumber("Room for the runs of a project", 1);
        QVERIFY(window_->compare().project().beyond(1e9).isEmpty()); // it is the newest
        const auto asked = press("Delete the Run");
        run();
        QTRY_VERIFY2_WITH_TIMEOUT(asked->contains("more than 1 GB"), qPrintable(*asked), 10000);
        QTRY_VERIFY(!QFile::exists(large.fileName()));
        QVERIFY(QFile::exists(kept) && QFile::exists(playback().path()));
    }

    void theCacheIsClearedWhenItIsAskedFor()
    {
        QVERIFY(QDir().mkpath(cacheFolder() + "/pictures"));
        QFile file(cacheFolder() + "/pictures/one.png");
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QByteArray(3000, 'x')) == 3000);
        file.close();
        for (QPushButton* each : dialog_->findChildren<QPushButton*>()) {
            if (each->text().remove('&') == "Clear the Cache") { each->click(); }
        }
        QVERIFY(!QFile::exists(file.fileName()));
        for (const QLabel* each : dialog_->findChildren<QLabel*>()) {
            if (each->accessibleName() == "Cache") { QVERIFY2(each->text().contains(cacheFolder()), qPrintable(each->text())); }
        }
    }

    void devicesAreListedAndPreferred()
    {
        QCOMPARE(preferredBackend(), std::string("auto"));
        choose("For new runs", 1);
        QCOMPARE(preferredBackend(), std::string("cpu"));
        QCOMPARE(backendOfMany(), std::string("cpu"));
        QCOMPARE(simulationPanel().backend(), std::string("cpu"));
        dialog_->showPage(6);
        QStringList lines;
        for (const QLabel* each : dialog_->findChildren<QLabel*>()) { lines << each->text(); }
        for (const DeviceLine& line : devicesOfThisMachine()) {
            QVERIFY2(lines.filter(line.name).size() == 1, qPrintable(line.name));
            QVERIFY(line.problem.isEmpty() || lines.filter(line.name).first().contains(line.problem));
        }
        Preferences gpu = preferences();
        gpu.backend = 2;
        setPreferences(gpu);
        const auto all = devicesOfThisMachine();
        const bool usable = std::any_of(all.begin(), all.end(), [](const DeviceLine& d) { return d.is_gpu && d.problem.isEmpty(); });
        QCOMPARE(preferredBackend(), std::string(usable ? "cuda" : "auto"));
    }

    void languageIsKeptForTheNextStart()
    {
        choose("Language", 2);
        QCOMPARE(QSettings().value("look/language").toString(), QString("de"));
    }

    void defaultsComeBackOnAllPages()
    {
        choose("Lengths", 1);
        choose("Appearance", 2);
        choose("Language", 2);
        setNumber("Keep a copy every", 7);
        QCOMPARE(QSettings().value("autosave/minutes").toInt(), 7);
        dialog_->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
        QVERIFY(preferences() == Preferences());
        QCOMPARE(savedAppearance(), Appearance::desktop);
        QCOMPARE(box("Lengths")->currentIndex(), 0);
        QCOMPARE(box("Language")->currentIndex(), 0);
        QCOMPARE(QSettings().value("autosave/minutes").toInt(), 0);
    }

private:
    QComboBox* box(const QString& name)
    {
        for (QComboBox* each : dialog_->findChildren<QComboBox*>()) {
            if (each->accessibleName() == name) { return each; }
        }
        return nullptr;
    }

    /// As a user does: what is chosen by hand is told by activated().
    void choose(const QString& name, int index)
    {
        QComboBox* found = box(name);
        QVERIFY2(found, qPrintable(name));
        found->setCurrentIndex(index);
        QMetaObject::invokeMethod(found, "activated", Q_ARG(int, index));
    }

    QSpinBox* spinBox(const QString& name)
    {
        for (QSpinBox* each : dialog_->findChildren<QSpinBox*>()) {
            if (each->accessibleName() == name) { return each; }
        }
        return nullptr;
    }

    void setNumber(const QString& name, int value)
    {
        QSpinBox* box = spinBox(name);
        QVERIFY2(box, qPrintable(name));
        box->setValue(value);
    }

    void tick(const QString& name)
    {
        for (QCheckBox* each : dialog_->findChildren<QCheckBox*>()) {
            if (each->text() == name) { return each->click(); }
        }
        QFAIL(qPrintable(name));
    }

    QString textOf(const QString& name)
    {
        for (const QLabel* each : window_->findChildren<QLabel*>()) {
            if (each->accessibleName() == name) { return each->text().replace(QChar(0x00a0), ' '); }
        }
        return {};
    }

    QLineEdit* field(const QString& name)
    {
        for (QLineEdit* each : window_->findChildren<QLineEdit*>()) {
            if (each->accessibleName() == name) { return each; }
        }
        return nullptr;
    }

    static void drag(QWidget& on, Qt::MouseButton button)
    {
        const QPoint from = on.rect().center();
        QTest::mousePress(&on, button, {}, from);
        for (int step = 1; step <= 4; ++step) {
            const QPointF at = from + QPoint(10 * step, 6 * step);
            QMouseEvent move(QEvent::MouseMove, at, on.mapToGlobal(at), Qt::NoButton, button, {});
            QApplication::sendEvent(&on, &move);
        }
        QTest::mouseRelease(&on, button, {}, from + QPoint(40, 24));
    }

    static void wheel(QWidget& on, int delta)
    {
        const QPointF at = on.rect().center();
        QWheelEvent event(at, on.mapToGlobal(at), {}, {0, delta}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&on, &event);
    }

    PreferencesDialog* dialog_ = nullptr;
};

QTEST_MAIN(TestPreferences)
#include "tst_preferences.moc"
