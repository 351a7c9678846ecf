// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a study may change, as people read it and pick it, and what its charts are drawn from.
#include "study_test.h"
#include "tests/support/drop_design.h"
#include "ui/basics/preferences.h"
#include "ui/study/factor_form.h"
#include "ui/study/field_picker.h"
#include "ui/study/study_data.h"
#include "ui/study/study_table.h"

#include <QFile>
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
                QVERIFY2(!QString::fromStdString(issue.where).endsWith("path") || issue.text.find("There is no") == std::string::npos,
                         (field.path + ": " + issue.text).c_str());
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
        FieldPicker picker(drop_design(), {ends});
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

    void effectsAreMeansOverBins()
    {
        StudyAxis factor, metric;
        factor.numbers = {1, 1, 2, 2, NAN};
        metric.numbers = {3, 5, 10, NAN, 8};
        const std::vector<EffectBin> bins = effectBins(factor, metric);
        QCOMPARE(bins.size(), std::size_t{2});
        QCOMPARE(bins[0].mean, 4.0);
        QCOMPARE(bins[0].sd, 1.0);
        QCOMPARE(bins[1].mean, 10.0);
        QCOMPARE(bins[1].count, std::size_t{1});
    }
};

QTEST_MAIN(TestStudyFields)
#include "tst_study_fields.moc"
