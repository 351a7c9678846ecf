// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The experiment panel: the climate over time, the project's own liquids, where an issue leads; and the results of a run.
#include "core/plan/model_plan.h"
#include "core/project/project_file.h"
#include "place_of.h"
#include "tests/support/drop_design.h"
#include "ui/basics/quantity_edit.h"
#include "ui/panels/climate_course.h"
#include "ui/panels/experiment_panel.h"
#include "ui/panels/issues_panel.h"
#include "ui/panels/liquid_panel.h"
#include "ui/results/chart.h"
#include "ui/results/playback.h"
#include "ui/results/queued_run.h"
#include "ui/results/results_panel.h"
#include "ui/window/examples.h"

#include <QDir>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

using namespace hygroloom;

class TestExperimentPanel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        document_ = std::make_unique<Document>();
        QVERIFY(document_->openExample(QDir(examplesFolder()).filePath("laboratory.hygro")));
        panel_ = std::make_unique<ExperimentPanel>(*document_);
        panel_->resize(310, 700);
        panel_->show();
        QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
    }
    void cleanup()
    {
        panel_.reset();
        document_.reset();
    }

    void everyTypeFitsANarrowPanel_data() { everyType(); }
    void everyTypeFitsANarrowPanel()
    {
        QFETCH(int, type);
        document_->setExperimentIndex(type);
        QCOMPARE(static_cast<int>(document_->experiment()->type), type);
        document_->edit("course", {}, [type](Design& d) { d.experiments[static_cast<std::size_t>(type)].climates = {{5, {}}}; });
        QCoreApplication::processEvents();
        QVERIFY2(panel_->widget()->width() <= panel_->viewport()->width(), qPrintable(QString::number(panel_->widget()->width())));
        for (QWidget* widget : panel_->findChildren<QWidget*>()) {
            if (widget->isVisible() && widget->focusPolicy() != Qt::NoFocus && panel_->widget()->isAncestorOf(widget)) {
                const int right = widget->mapTo(panel_->widget(), QPoint(widget->width(), 0)).x();
                QVERIFY2(right <= panel_->viewport()->width(), qPrintable(widget->accessibleName()));
            }
        }
    }

    void itsNameFollowsTheTypeUntilItIsChanged()
    {
        const auto name = [this] { return QString::fromStdString(document_->experiment()->name); };
        const auto choose = [this](ExperimentType type) {
            auto* types = named<QComboBox>("Type of experiment");
            types->setCurrentIndex(static_cast<int>(type));
            Q_EMIT types->activated(static_cast<int>(type));
        };
        document_->edit("one", {}, [](Design& d) {
            Experiment drop = standard_experiment(ExperimentType::droplet);
            drop.name = "one drop 2";
            Experiment drying = standard_experiment(ExperimentType::drying);
            drying.name = "drying";
            d.experiments = {drop, drying};
        });
        document_->setExperimentIndex(0);
        choose(ExperimentType::moisture_management);
        QCOMPARE(name(), "moisture management");
        choose(ExperimentType::drying);
        QCOMPARE(name(), "drying 2"); // the other one has the name
        document_->edit("name", {}, [](Design& d) { d.experiments[0].name = "drying of my cloth"; });
        choose(ExperimentType::droplet);
        QCOMPARE(name(), "drying of my cloth");
    }

    void aStripHasAWidthAndALength()
    {
        document_->setExperimentIndex(0);
        QVERIFY(field("Along the weft") && !field("Strip width"));
        document_->setExperimentIndex(static_cast<int>(ExperimentType::vertical_wicking));
        QVERIFY(field("Strip width") && field("Strip length"));
        document_->edit("strip", {}, [](Design& d) { d.experiments[2].sample_mm[0] = -1; });
        QVERIFY(field("Strip width")->accessibleDescription().contains("strip's size must be"));
    }

    void aFeedsDropsAreTypedWithTheirUnit()
    {
        document_->setExperimentIndex(0);
        QVERIFY(!field("Drop volume")->isVisibleTo(panel_.get()));
        document_->setExperimentIndex(static_cast<int>(ExperimentType::moisture_management));
        const std::string before = text();
        QuantityEdit* drops = field("Drop volume");
        QVERIFY(drops->isVisibleTo(panel_.get()) && drops->toolTip().contains("evenly"));
        QCOMPARE(drops->value().value(), 25.0);
        drops->setFocus();
        drops->selectAll();
        QTest::keyClicks(drops, "0.01 ml");
        QTest::keyClick(drops, Qt::Key_Return);
        QCOMPARE(document_->experiment()->drop_ul, 10.0);
        document_->history()->undo();
        QCOMPARE(text(), before);
        QCOMPARE(drops->value().value(), 25.0);
        document_->edit("drops", {}, [](Design& d) {
            d.experiments[1].volume_ul = 1e4;
            d.experiments[1].drop_ul = 2;
        });
        QVERIFY(field("Drop volume")->accessibleDescription().contains("of 2.5 ul or more"));
    }

    void theClimateIsConstantUntilATimeIsAdded()
    {
        QVERIFY(!table()->isVisibleTo(panel_.get()));
        const std::string before = text();
        course()->addMoment();
        QCOMPARE(document_->experiment()->climates.size(), std::size_t(1));
        QCOMPARE(document_->experiment()->climates[0].time_s, document_->experiment()->duration_s);
        QCOMPARE(document_->experiment()->climates[0].climate, document_->experiment()->climate);
        QVERIFY(table()->isVisibleTo(panel_.get()));
        QCOMPARE(table()->rowCount(), 2);
        document_->history()->undo();
        QCOMPARE(text(), before);
        QVERIFY(!table()->isVisibleTo(panel_.get()));
    }

    void aCellIsTypedWithItsUnit()
    {
        course()->addMoment();
        const std::string before = text();
        type(1, 0, "0.1 min");
        type(1, 1, "303.15 K");
        type(1, 2, "80");
        type(1, 3, "3.6 km/h");
        const ClimateMoment& moment = document_->experiment()->climates[0];
        QCOMPARE(moment.time_s, 6.0);
        QVERIFY(std::abs(moment.climate.temperature_c - 30) < 1e-9);
        QCOMPARE(moment.climate.relative_humidity, 0.8);
        QCOMPARE(moment.climate.air_speed_m_s, 1.0);
        QCOMPARE(table()->item(1, 2)->text(), QString("80 %").replace(' ', QChar(0x00a0)));
        type(0, 1, "10");
        QCOMPARE(document_->experiment()->climate.temperature_c, 10.0);
        QCOMPARE(field("Temperature")->value().value(), 10.0);
        for (int i = 0; i < 5; ++i) { document_->history()->undo(); }
        QCOMPARE(text(), before);
    }

    void whatCannotBeReadChangesNothing()
    {
        course()->addMoment();
        const std::string before = text();
        type(1, 1, "warm");
        type(0, 0, "3");
        QCOMPARE(text(), before);
    }

    void aNewTimeIsHalfWayToTheNext()
    {
        course()->addMoment();
        type(1, 1, "45");
        table()->setCurrentCell(0, 0);
        course()->addMoment();
        QCOMPARE(table()->rowCount(), 3);
        QCOMPARE(document_->experiment()->climates[0].time_s, 5.0);
        QCOMPARE(document_->experiment()->climates[0].climate.temperature_c, 35.0); // half-way from 25 to 45
        QCOMPARE(table()->currentRow(), 1);
        QTest::keyClick(table(), Qt::Key_Delete);
        QCOMPARE(document_->experiment()->climates.size(), std::size_t(1));
        table()->setCurrentCell(0, 0);
        course()->removeMoment();
        QCOMPARE(document_->experiment()->climates.size(), std::size_t(1));
    }

    void errorsOfATimeAreShownBesideIt()
    {
        course()->addMoment();
        course()->addMoment();
        type(2, 0, "1");
        type(1, 2, "150");
        QVERIFY(table()->item(2, 0)->toolTip().contains("must rise"));
        QVERIFY(table()->item(1, 2)->toolTip().contains("relative humidity")); // more than the air can hold
        const QString reported = named<QLabel>("About the climate over time")->text();
        QVERIFY(reported.contains("Row 2: ") && reported.contains("Row 1: "));
        const std::string before = text();
        type(0, 1, "99"); // out of range, which never enters the design
        type(1, 2, "900");
        QCOMPARE(text(), before);
    }

    void aLiquidIsMadeAndUsed()
    {
        const std::string before = text();
        liquids()->addLiquid();
        QCOMPARE(document_->design()->liquids.size(), std::size_t(1));
        QCOMPARE(document_->experiment()->liquid, std::string("water 2"));
        QCOMPARE(named<QComboBox>("Liquid")->currentText(), QString("water 2"));
        QuantityEdit* tension = field("Surface tension");
        QVERIFY(tension->isVisibleTo(panel_.get()));
        tension->selectAll();
        QTest::keyClicks(tension, "0.03 N/m");
        QTest::keyClick(tension, Qt::Key_Return);
        QCOMPARE(document_->design()->liquids[0].surface_tension_mn_m, 30.0);
        QVERIFY(named<QLabel>("About the liquid")->text().startsWith("30"));
        liquids()->duplicateLiquid();
        QCOMPARE(document_->design()->liquids[1].name, std::string("water 2 2"));
        QCOMPARE(document_->design()->liquids[1].surface_tension_mn_m, 30.0);
        QCOMPARE(document_->experiment()->liquid, std::string("water 2"));
        for (int i = 0; i < 3; ++i) { document_->history()->undo(); }
        QCOMPARE(text(), before);
    }

    void aRenamedLiquidStaysInItsExperiments()
    {
        liquids()->addLiquid();
        document_->edit("liquid", {}, [](Design& d) { d.experiments[6].liquid = "water 2"; });
        const std::string before = text();
        QString why;
        QVERIFY(!liquids()->rename("water", &why));
        QVERIFY(why.contains("water"));
        QVERIFY(!liquids()->rename(" ", &why));
        QCOMPARE(text(), before);
        QVERIFY(liquids()->rename("soap", &why));
        QCOMPARE(document_->design()->experiments[0].liquid, std::string("soap"));
        QCOMPARE(document_->design()->experiments[6].liquid, std::string("soap"));
        QVERIFY(document_->issues().empty() || !document_->hasError());
        document_->history()->undo();
        QCOMPARE(text(), before);
    }

    void deletingALiquidInUseAsksAndItsExperimentsUseWater()
    {
        liquids()->addLiquid();
        const std::string before = text();
        const auto answer = [this](const char* button, QString* asked) {
            QTimer::singleShot(0, this, [button, asked] {
                if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                    *asked = box->text() + " " + box->informativeText();
                    for (QAbstractButton* one : box->buttons()) {
                        if (one->text().remove('&') == button) {
                            one->click();
                            return;
                        }
                    }
                }
            });
            named<QToolButton>("Delete the liquid")->click();
        };
        QString asked;
        answer("Cancel", &asked);
        QVERIFY(asked.contains("one drop") && asked.contains("water"));
        QCOMPARE(text(), before);
        answer("Delete", &asked);
        QVERIFY(document_->design()->liquids.empty());
        QCOMPARE(document_->experiment()->liquid, std::string("water"));
        QVERIFY(!document_->hasError());
        document_->history()->undo();
        QCOMPARE(text(), before);
    }

    void aMissingLiquidIsSaid()
    {
        document_->edit("liquid", {}, [](Design& d) { d.experiments[0].liquid = "ink"; });
        QCOMPARE(named<QComboBox>("Liquid")->currentText(), QString("ink (missing)"));
        QVERIFY(named<QLabel>("About the liquid")->text().contains("Choose another"));
    }

    void anIssueLeadsToItsField_data()
    {
        QTest::addColumn<int>("experiment");
        QTest::addColumn<QString>("where");
        QTest::addColumn<QString>("field");
        QTest::newRow("a number") << 0 << "experiments[0].duration_s"
                                  << "Duration";
        QTest::newRow("a whole of two") << 0 << "experiments[0].sample_mm"
                                        << "Along the weft";
        QTest::newRow("a strip") << 2 << "experiments[2].strip_mm[1]"
                                 << "Strip length";
        QTest::newRow("a feed's drops") << 1 << "experiments[1].drop_ul"
                                        << "Drop volume";
        QTest::newRow("a climate") << 1 << "experiments[1].climate.air_speed_m_s"
                                   << "Air speed";
        QTest::newRow("one that a type has") << 5 << "experiments[5].initial.relative_humidity"
                                             << "Initial humidity";
        QTest::newRow("a liquid's name") << 0 << "experiments[0].liquid"
                                         << "Liquid";
        QTest::newRow("a droplet") << 0 << "experiments[0].droplets[1].volume_ul"
                                   << "Volume";
        QTest::newRow("a folded section") << 0 << "liquids[1].viscosity_mpa_s"
                                          << "Viscosity";
        QTest::newRow("a moment") << 6 << "experiments[6].climate[2].temperature_c"
                                  << "Climate over time";
        QTest::newRow("the start of a course") << 6 << "experiments[6].climate[0].temperature_c"
                                               << "Temperature";
        QTest::newRow("what has no field") << 0 << "experiments[0].name"
                                           << "Experiment";
    }
    void anIssueLeadsToItsField()
    {
        QFETCH(int, experiment);
        QFETCH(QString, where);
        QFETCH(QString, field);
        document_->edit("more", {}, [](Design& d) {
            d.experiments[0].droplets.push_back({20, 1});
            d.experiments[6].climates = {{100, {}}, {200, {}}};
            d.liquids = {{"soap"}, {"oil"}};
        });
        document_->setExperimentIndex(experiment);
        QApplication::setActiveWindow(panel_.get());
        panel_->showField(placeOf(where));
        QCoreApplication::processEvents();
        QWidget* focus = panel_->focusWidget();
        QVERIFY(focus);
        QCOMPARE(focus->accessibleName(), field);
        QVERIFY(focus->isVisibleTo(panel_.get()));
        QVERIFY(!focus->visibleRegion().isEmpty());
        if (where.contains("droplets")) { QCOMPARE(static_cast<QuantityEdit*>(focus)->value().value(), 20.0); }
        if (where.contains("climate[2]")) { QCOMPARE(table()->currentRow(), 2); }
    }

    void resultsAndCurvesAreThoseOfTheType_data() { everyType(); }
    void resultsAndCurvesAreThoseOfTheType()
    {
        QFETCH(int, type);
        const char* results[] = {"Absorbency time",   "Overall capability (OMMC)", "Height", "Wicking rate", "Steady drying rate",
                                 "Regain at the end", "Largest wetted radius"};
        const char* titles[] = {"Wetted radius, mm", "Water content, % of dry mass", "Height, mm", "Wetted radius, mm", "Temperature, °C",
                                "Temperature, °C",   "Water in the faces, mg"};
        Playback playback;
        const ResultsPanel panel(playback);
        const Chart chart(playback);
        QVERIFY(panel.text().contains("Run the experiment"));
        auto run = std::make_shared<RunRecord>();
        run->design = *document_->design();
        run->fabric = run->design.fabrics[0].name;
        run->experiment = run->design.experiments[static_cast<std::size_t>(type)].name;
        run->textile = build_textile(run->design, run->design.fabrics[0], {0, 0, 8, 8});
        playback.begin(run, {});
        MetricsCollector collector;
        collector.start(*run);
        for (int i = 0; i < 3; ++i) {
            auto frame = std::make_shared<Frame>();
            frame->time = i;
            for (auto* values : {&frame->saturation, &frame->liquid, &frame->regain, &frame->vapour}) {
                values->assign(static_cast<std::size_t>(run->textile.segments()), i == 2 ? 0.5F : 0.0F);
            }
            frame->temperature.assign(static_cast<std::size_t>(run->textile.segments()), 298.15F);
            frame->ledger.water_delivered = 1e-6;
            collector.add(*frame);
            playback.append(frame, std::make_shared<const Metrics>(collector.metrics()));
        }
        QVERIFY2(panel.text().contains(results[type]), qPrintable(panel.text()));
        QCOMPARE(chart.title(), QString::fromUtf8(titles[type]));
        QCOMPARE(chart.points().size(), 3);
        const bool limited = type < 4;
        QCOMPARE(panel.text().contains("limited by"), limited);
    }
    void aPartSwitchedOnDuringTheRunIsShownWithTheResults()
    {
        auto design = std::make_shared<Design>(drop_design(20)); // a spot on polyester that gets wider than the plan expects
        design->fabrics[0].warp.material = design->fabrics[0].weft.material = {{"polyester", 1.0}};
        Experiment experiment = standard_experiment(ExperimentType::horizontal_wicking);
        experiment.closure = Closure::paper;
        experiment.volume_ul = 1;
        experiment.sample_mm = {16, 16};
        experiment.duration_s = 200;
        experiment.climate = {21, 0.9955, 0};
        design->experiments = {experiment};
        Playback playback;
        const ResultsPanel panel(playback);
        WindowQueue queue;
        QueuedRun run(queue);
        QSignalSpy ended(&run, &QueuedRun::ended);
        RunOptions options;
        options.fidelity = Fidelity::draft;
        RunJob job{design, experiment.name, "cloth", {}, options};
        job.beside.started = [&](const RunRecord& record) {
            run.post([&playback, begun = std::make_shared<const RunRecord>(record)] { playback.begin(begun, {}); });
        };
        job.measured = [&](const std::shared_ptr<const Frame>& frame, const std::shared_ptr<const MetricsCollector>& so_far) {
            run.post([&playback, frame, metrics = std::make_shared<const Metrics>(so_far->metrics())] { playback.append(frame, metrics); });
        };
        run.start(std::move(job), "cpu", {}, [](RunResult&) {});
        QTRY_VERIFY_WITH_TIMEOUT(ended.count() == 1, 120000);
        QVERIFY2(panel.text().contains("Vapour was left out until ") && panel.text().contains(" %, over the 1 %"),
                 qPrintable(panel.text()));
    }

private:
    void everyType()
    {
        QTest::addColumn<int>("type");
        for (int type = 0; type < experiment_types; ++type) { QTest::newRow(name_of(static_cast<ExperimentType>(type))) << type; }
    }
    ClimateCourse* course() { return panel_->findChild<ClimateCourse*>(); }
    QTableWidget* table() { return panel_->findChild<QTableWidget*>(); }
    LiquidPanel* liquids() { return panel_->findChild<LiquidPanel*>(); }
    std::string text() const { return format_project(*document_->design()); }
    void type(int row, int column, const QString& typed)
    {
        table()->setCurrentCell(row, column);
        table()->edit(table()->currentIndex());
        for (auto* editor : table()->viewport()->findChildren<QuantityEdit*>()) {
            editor->selectAll();
            QTest::keyClicks(editor, typed);
            QTest::keyClick(editor, Qt::Key_Return);
        }
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QuantityEdit* field(const QString& name) { return named<QuantityEdit>(name); }
    template <typename Widget> Widget* named(const QString& name)
    {
        for (Widget* widget : panel_->findChildren<Widget*>()) {
            if (widget->accessibleName() == name) { return widget; }
        }
        return nullptr;
    }

    std::unique_ptr<Document> document_;
    std::unique_ptr<ExperimentPanel> panel_;
};

QTEST_MAIN(TestExperimentPanel)
#include "tst_experiment_panel.moc"
