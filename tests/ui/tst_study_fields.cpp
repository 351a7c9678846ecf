// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a study may change, as people read it and pick it, and what its charts are drawn from.
#include "study_test.h"
#include "tests/support/drop_design.h"
#include "ui/basics/preferences.h"
#include "ui/study/effect_curve.h"
#include "ui/study/factor_form.h"
#include "ui/study/field_picker.h"
#include "ui/study/study_chart.h"
#include "ui/study/study_data.h"
#include "ui/study/study_table.h"

#include <QElapsedTimer>
#include <QFile>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace hygroloom;

class TestStudyFields : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fieldsHaveNamesUnitsAndPresentValues()
    {
        const StudyField sett = fieldAt(drop_design(), ends);
        QCOMPARE(sett.group, QString("cloth"));
        QCOMPARE(fieldTitle(sett, true), QString("cloth: ends (/cm)"));
        QCOMPARE(*sett.value, drop_design().fabrics[0].ends_per_cm);
        QCOMPARE(fieldTitle(fieldAt(drop_design(), volume), false), QString("droplets 1, volume (µl)"));
        const auto title = [](const char* path) { return fieldTitle(fieldAt(drop_design(), path), false); };
        QCOMPARE(title("fabrics[0].flyaway.loop_density_per_mm"), QString("flyaway, loops (/mm)")); // as the form says it
        QCOMPARE(title("fabrics[0].warp.fibres_per_yarn"), QString("warp, fibres drawn"));
        QCOMPARE(title("experiments[0].droplets[0].at_mm[1]"), QString("droplets 1, at 2 (mm)")); // which has no row
        // Every field that is offered is one that a study may have.
        const Design design = drop_design();
        for (const StudyField& field : studyFields(design)) {
            if (!field.value || field.path.starts_with("fidelity.")) { continue; }
            Study study;
            study.points = 4;
            study.factors.push_back(proposedFactor(field.path, field.value));
            study.factors[0].distribution.low = *field.value;
            study.factors[0].distribution.high = std::nextafter(*field.value, 1e9);
            for (const Issue& issue : validate(study, design)) {
                QVERIFY2(!QString::fromStdString(issue.where.text()).endsWith("path") ||
                             issue.text().find("There is no") == std::string::npos,
                         (field.path + ": " + issue.text()).c_str());
            }
        }
    }

    void axesAndTableAreInTheUsersUnits()
    {
        QTemporaryDir folder;
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
        const QString path = folder.filePath("results.csv");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(
            file.write("point,replicate,fabrics[0].ends_per_cm,status,maximum_wetted_radius_top_mm,absorbency_time_s,wall_s,device,commit,"
                       "reason\n0,0,20,done,50.8,3,1,cpu,,\n1,0,30,done,25.4,4,1,cpu,,\n") > 0);
        file.close();
        StudyTableModel table;
        const auto shown = [&table](int row, int column) { return table.index(row, column).data().toString(); };
        table.setStudy(readStudyData(path));
        QCOMPARE(table.headerData(4, Qt::Horizontal, Qt::DisplayRole).toString(), QString("wetted radius, top (mm)"));
        QCOMPARE(shown(0, 4), QString("50.8"));
        Preferences inches = preferences();
        inches.length = static_cast<int>(LengthUnit::inch);
        inches.sett = static_cast<int>(SettUnit::per_inch);
        setPreferences(inches);
        const auto data = readStudyData(path);
        setPreferences({});
        table.setStudy(data);
        QCOMPARE(table.headerData(4, Qt::Horizontal, Qt::DisplayRole).toString(), QString("wetted radius, top (in)"));
        QCOMPARE(shown(0, 4), QString("2"));
        QCOMPARE(shown(0, 5), QString("3")); // of no such unit
        QVERIFY(data->axes[0].title.endsWith("(/in)"));
        QCOMPARE(shown(1, 2), QString("76.2"));
        QCOMPARE(data->axes[0].low, 50.8);
        QCOMPARE(data->axes[1].high, 2.0);
        table.sort(4, Qt::AscendingOrder);
        QCOMPARE(shown(0, 4), QString("1"));
        QCOMPARE(data->table.columns[4].numbers[0], 50.8); // what is written elsewhere stays
    }

    void thePickerFindsByLettersAndKeepsFactorsFromBeingTakenTwice()
    {
        FieldPicker picker(drop_design(), {}, {ends});
        picker.setFilter("angle");
        QVERIFY(picker.shownPaths().contains(angle));
        QVERIFY(!picker.shownPaths().contains(ends));
        picker.setFilter("WEFT twist");
        QCOMPARE(picker.shownPaths().first(), QString("fabrics[0].weft.twist_per_m"));
        picker.setFilter("");
        picker.select({angle, ends});
        QCOMPARE(picker.chosen().size(), std::size_t{1});
        QCOMPARE(picker.chosen()[0].path, std::string(angle));
    }

    void aFactorIsShownAndTypedInTheReadersUnit()
    {
        Factor factor;
        factor.path = ends;
        factor.distribution.low = 20;
        factor.distribution.high = 60 / 2.54;
        factor.step = 1 / 2.54;
        const UserUnit per_inch{"/in", 2.54};
        FactorForm form;
        form.setFactor(factor, per_inch);
        QCOMPARE(form.field("low")->text(), QString("50.8"));
        QCOMPARE(form.field("high")->text(), QString("60"));
        QCOMPARE(form.field("step")->text(), QString("1"));
        form.field("high")->setText("70");
        const DraftFactor draft = form.factor();
        QVERIFY(draft.complaint.isEmpty());
        QVERIFY(qAbs(*draft.factor.distribution.low - 20) < 1e-9 && qAbs(*draft.factor.distribution.high - 70 / 2.54) < 1e-9);
        QVERIFY(qAbs(*draft.factor.step - 1 / 2.54) < 1e-9);
        QCOMPARE(spreadText(factor, per_inch), QString("50.8 to 60, step 1"));
        // A temperature has another zero; a width of temperatures has none.
        factor.step.reset();
        factor.distribution.type = FactorDistribution::Type::normal;
        factor.distribution.mean = 20;
        factor.distribution.sd = 5;
        factor.distribution.low.reset();
        factor.distribution.high.reset();
        QCOMPARE(spreadText(factor, {"°F", 1.8, 32}), QString::fromUtf8("normal, 68 ± 9"));
        form.setFactor(factor, {"°F", 1.8, 32});
        QCOMPARE(form.field("mean")->text(), QString("68"));
        QCOMPARE(form.field("sd")->text(), QString("9"));
        QCOMPARE(form.factor().factor.distribution.mean, 20.0);
        QCOMPARE(form.factor().factor.distribution.sd, 5.0);
    }

    void whatTheStudyDoesNotRunCannotBePicked()
    {
        Design design = drop_design();
        design.fabrics.push_back(design.fabrics[0]);
        design.fabrics[1].name = "other";
        Study study;
        study.fabrics = {"other"};
        FieldPicker picker(design, study, {});
        picker.select({ends, "fabrics[1].ends_per_cm"});
        QCOMPARE(picker.chosen().size(), std::size_t{1});
        QCOMPARE(picker.chosen()[0].path, std::string("fabrics[1].ends_per_cm"));
    }

    void levelsHaveMeansAndTheirIntervals()
    {
        StudyAxis factor, metric;
        factor.numbers = {1, 1, 2, 2, NAN};
        metric.numbers = {3, 5, 10, NAN, 8};
        factor.words = {"none", "one", "two"};
        const EffectCurve curve = effectCurve(factor, metric);
        QVERIFY(!curve.smooth);
        QCOMPARE(curve.points.size(), std::size_t{2});
        QCOMPARE(curve.points[0].mean, 4.0);
        QVERIFY(qAbs(curve.points[0].off - 6.3138) < 1e-3); // 90 % by Student of 1: 6.3138 x sqrt(2) / sqrt(2)
        QCOMPARE(curve.points[1].mean, 10.0);
        QVERIFY(std::isnan(curve.points[1].off)); // of one row nothing is known
        QCOMPARE(curve.points[1].rows, std::size_t{1});
    }

    void everyWordOfAnAxisHasItsLabel()
    {
        StudyAxis factor;
        factor.words = {"Poplin shirting, mercerized and finished", "Denim", "Sheeting, as it comes from the loom"};
        factor.high = 2;
        factor.empty = false;
        const QRectF area(66, 0, 200, 100);
        double from = 0;
        const std::vector<TickLabel> labels = tickLabels(area, factor, QFontMetricsF(QFont()));
        QCOMPARE(labels.size(), factor.words.size());
        for (const TickLabel& label : labels) {
            QVERIFY(!label.text.isEmpty() && label.left >= from);
            from = label.left + label.width;
        }
        QVERIFY(from <= area.right() + 16);
    }

    void singleRowsOverARangeAreNotJoined()
    {
        // A line with noise that turns from row to row: what was joined before was a zigzag.
        StudyAxis factor, metric;
        for (int row = 0; row < 64; ++row) {
            factor.numbers.push_back(row / 63.0);
            metric.numbers.push_back(2 + 3 * row / 63.0 + (row % 2 ? 0.5 : -0.5));
        }
        const EffectCurve curve = effectCurve(factor, metric);
        QVERIFY(curve.smooth);
        for (const EffectPoint& point : curve.points) {
            QVERIFY2(qAbs(point.mean - (2 + 3 * point.at)) < 0.15, qPrintable(QString::number(point.mean)));
            QVERIFY(point.off > 0.05 && point.off < 0.6);
        }
        for (std::size_t k = 1; k < curve.points.size(); ++k) { QVERIFY(curve.points[k].mean > curve.points[k - 1].mean); }
        // A line without noise is that line, and its interval nothing.
        for (int row = 0; row < 64; ++row) { metric.numbers[static_cast<std::size_t>(row)] = 2 + 3 * row / 63.0; }
        for (const EffectPoint& point : effectCurve(factor, metric).points) {
            QVERIFY(qAbs(point.mean - (2 + 3 * point.at)) < 1e-9 && point.off < 1e-9);
        }
        // Few rows get no curve.
        factor.numbers.resize(6);
        metric.numbers.resize(6);
        QVERIFY(effectCurve(factor, metric).points.empty());
    }

    void manyRowsGiveTheSameCurve()
    {
        StudyAxis factor, metric;
        for (int row = 0; row < 50000; ++row) {
            const double x = (row * 7919 % 50000) / 50000.0;
            factor.numbers.push_back(x);
            metric.numbers.push_back(x * x);
        }
        QElapsedTimer clock;
        clock.start();
        const EffectCurve curve = effectCurve(factor, metric);
        QVERIFY2(clock.elapsed() < 2000, qPrintable(QString::number(clock.elapsed())));
        for (const EffectPoint& point : curve.points) { QVERIFY(qAbs(point.mean - point.at * point.at) < 0.01); }
    }
};

QTEST_MAIN(TestStudyFields)
#include "tst_study_fields.moc"
