// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/project_file.h"
#include "ui/basics/quantity_edit.h"
#include "ui/document/document.h"
#include "ui/panels/candidates_panel.h"
#include "ui/panels/droplet_section.h"
#include "ui/panels/experiment_panel.h"
#include "ui/panels/fabric_panel.h"
#include "ui/panels/issues_panel.h"
#include "ui/weave/point_paper.h"
#include "ui/weave/weave_editor.h"
#include "ui/window/examples.h"

#include <QComboBox>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestDocument : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        document_ = std::make_unique<Document>();
        QVERIFY(document_->openExample(shippedExample()));
        QVERIFY(document_->fabric());
        QVERIFY(document_->experiment());
    }

    void cleanup() { document_.reset(); }

    void aProjectWithoutAFileIsOpenedWithoutAWarning()
    {
        QTest::failOnWarning(QRegularExpression("."));
        QVERIFY(document_->openExample(shippedExample()));
        QVERIFY(document_->path().isEmpty() && !document_->changedOnDisk());
    }

    void everyFieldOfThePanelsIsOneStepOfTheHistory()
    {
        document_->edit("prices", {}, [](Design& d) {
            for (Fabric& each : d.fabrics) each.warp.price = 6.5; // the weft has none
        });
        FabricPanel fabric(*document_);
        ExperimentPanel experiment(*document_);
        int stepped = 0;
        QStringList seen;
        for (QWidget* panel : {static_cast<QWidget*>(&fabric), static_cast<QWidget*>(&experiment)}) {
            for (QuantityEdit* edit : panel->findChildren<QuantityEdit*>()) {
                if (!edit->isEnabled() || !edit->isVisibleTo(panel)) { continue; }
                const QString stands_in = edit->placeholderText();
                if (!edit->value() && (stands_in.startsWith("auto") || stands_in == "no price")) { continue; }
                const std::string before = text();
                QTest::keyClick(edit, Qt::Key_Up);
                if (text() == before) { QTest::keyClick(edit, Qt::Key_Down); }
                QVERIFY2(text() != before, qPrintable(edit->accessibleName()));
                document_->endStroke();
                checkUndoAndRedo(before);
                seen << edit->objectName();
                ++stepped;
            }
        }
        QVERIFY(stepped > 20);
        QVERIFY2(seen.contains("warp price") && !seen.contains("weft price"), qPrintable(seen.join(", ")));
    }

    void aYarnOfTheStripesHasTheFieldsOfAYarn()
    {
        FabricPanel panel(*document_);
        auto* choice = named<QComboBox>(panel, "Yarn of the stripes");
        QVERIFY(choice);
        QVERIFY(!choice->isVisibleTo(&panel));
        document_->edit("stripes", {}, [](Design& d) {
            d.fabrics[0].extra_yarns = {d.fabrics[0].warp, d.fabrics[0].warp};
            d.fabrics[0].weft_order = {{0, 4}, {2, 2}};
        });
        QVERIFY(choice->isVisibleTo(&panel));
        QCOMPARE(choice->count(), 2);
        panel.showYarn(2);
        QCOMPARE(choice->currentIndex(), 1);
        const std::string before = text();
        auto* diameter = panel.findChild<QuantityEdit*>("stripe yarn diameter");
        QVERIFY(diameter);
        diameter->setText("0.3 mm");
        diameter->setModified(true);
        QTest::keyClick(diameter, Qt::Key_Return);
        QCOMPARE(document_->fabric()->extra_yarns[1].diameter_mm, std::optional(0.3));
        QVERIFY(document_->fabric()->extra_yarns[0] == document_->fabric()->warp);
        QCOMPARE(document_->history()->undoText(), QString("stripe yarn diameter"));
        checkUndoAndRedo(before);
        for (const char* field : {"stripe yarn twist", "stripe yarn plies", "stripe yarn fibres drawn"}) {
            const Yarn was = document_->fabric()->extra_yarns[1];
            QTest::keyClick(panel.findChild<QuantityEdit*>(field), Qt::Key_Up);
            QVERIFY2(document_->fabric()->extra_yarns[1] != was, field);
        }
        // With fewer yarns, the last one is shown.
        document_->edit("remove yarn", {}, [](Design& d) {
            d.fabrics[0].extra_yarns.resize(1);
            d.fabrics[0].weft_order.clear();
        });
        QCOMPARE(choice->currentIndex(), 0);
        QCOMPARE(diameter->value(), document_->fabric()->extra_yarns[0].diameter_mm);
    }

    void issuesSayWhatTheyAreAboutAndErrorsComeFirst()
    {
        document_->edit("wrong", {}, [](Design& d) {
            d.fabrics.resize(1);
            d.fabrics[0].name = "Denim";
            d.fabrics[0].contact_angle_deg.reset();
            d.fabrics[0].warp.material = {{"polyester", 1}};
            d.fabrics[0].weft = d.fabrics[0].warp;
            d.fabrics[0].warp.twist_per_m = d.fabrics[0].weft.twist_per_m = -1;
            d.fabrics[0].extra_yarns = {Yarn{}};
            d.fabrics[0].extra_yarns[0].diameter_mm = -1;
            d.fabrics[0].weave = Weave(2, 1, {1, 0}); // ends that never change sides: a warning
        });
        QStringList sentences;
        Severity last = Severity::error;
        for (const Issue* issue : shownIssues(*document_)) {
            QVERIFY(issue->severity <= last);
            last = issue->severity;
            sentences << issueInWords(*document_->design(), *issue);
        }
        QCOMPARE(last, Severity::warning);
        QCOMPARE(sentences.filter("Denim, warp: ").size(), 1);
        QCOMPARE(sentences.filter("Denim, weft: ").size(), 0); // the same as the warp
        QCOMPARE(sentences.filter("Denim, yarn B (extra yarn 1): ").size(), 1);
        document_->edit("apart", {}, [](Design& d) { d.fabrics[0].weft.twist_per_m = -2; });
        sentences.clear();
        for (const Issue* issue : shownIssues(*document_)) { sentences << issueInWords(*document_->design(), *issue); }
        QCOMPARE(sentences.filter("Denim, weft: ").size(), 1);
    }

    void issuesNameLiquidsAndRowsOfTheClimate()
    {
        document_->edit("wrong", {}, [](Design& d) {
            d.liquids = {{"soap", -1}, {"", 30}};
            d.experiments[0].name = "drop";
            d.experiments[0].climate.temperature_c = 99;
            d.experiments[0].climates = {{-5, {}}};
        });
        QStringList sentences;
        for (const Issue* issue : shownIssues(*document_)) { sentences << issueInWords(*document_->design(), *issue); }
        QCOMPARE(sentences.filter("soap: The surface tension").size(), 1);
        QCOMPARE(sentences.filter("Liquid 2: The name is empty").size(), 1);
        QCOMPARE(sentences.filter("drop, initial climate: ").size(), 1);
        QCOMPARE(sentences.filter("drop, climate, row 1: ").size(), 1);
    }

    void editsOfThePanelsCanBeUndone_data()
    {
        QTest::addColumn<QString>("edit");
        for (const char* edit : {"weave pattern", "weave crossing", "repeat size", "add fabric", "duplicate fabric", "delete fabric",
                                 "add droplet", "remove droplet", "add experiment", "finish", "fibre", "weft apart"}) {
            QTest::newRow(edit) << QString(edit);
        }
    }

    void editsOfThePanelsCanBeUndone()
    {
        QFETCH(QString, edit);
        FabricPanel fabric(*document_);
        ExperimentPanel experiment(*document_);
        WeaveEditor weave(*document_);
        CandidatesPanel candidates(*document_);
        const std::string before = text();

        if (edit == "weave pattern") {
            auto* box = weave.findChild<QComboBox*>();
            box->setEditText("twill 2/1 Z");
            QTest::keyClick(box, Qt::Key_Return);
        } else if (edit == "weave crossing") {
            QTest::keyClick(weave.paper(), Qt::Key_Space);
        } else if (edit == "repeat size") {
            weave.findChild<QSpinBox*>()->stepUp();
        } else if (edit == "add fabric") {
            candidates.addFabric();
        } else if (edit == "duplicate fabric") {
            candidates.duplicateFabric();
        } else if (edit == "delete fabric") {
            candidates.deleteFabric();
        } else if (edit == "add droplet") {
            experiment.droplets().addDroplet();
        } else if (edit == "remove droplet") {
            experiment.droplets().removeDroplet();
        } else if (edit == "add experiment") {
            experiment.addExperiment();
        } else if (edit == "finish") {
            choose(fabric, "Finish", 2);
        } else if (edit == "fibre") {
            choose(fabric, "Fibre", 3);
        } else if (edit == "weft apart") {
            document_->edit("weft twist", "fabrics[0].weft.twist_per_m", [](Design& d) { d.fabrics[0].weft.twist_per_m = 321; });
        }

        QVERIFY(text() != before);
        QCOMPARE(document_->history()->count(), 1);
        QVERIFY(!document_->history()->undoText().isEmpty());
        checkUndoAndRedo(before);
    }

    void stepsOfOneStrokeAreUndoneAtOnce()
    {
        FabricPanel fabric(*document_);
        QuantityEdit* ends = field(fabric, "Ends");
        const std::string before = text();

        for (int i = 0; i < 5; ++i) { QTest::keyClick(ends, Qt::Key_Up); }

        QCOMPARE(document_->history()->count(), 1);
        QCOMPARE(document_->history()->undoText(), QString("ends"));
        document_->history()->undo();
        QCOMPARE(text(), before);
        QCOMPARE(*ends->value(), document_->fabric()->ends_per_cm);
    }

    void typedValuesAreStepsOfTheirOwn()
    {
        FabricPanel fabric(*document_);
        QuantityEdit* ends = field(fabric, "Ends");
        for (const char* typed : {"30", "31"}) {
            ends->selectAll();
            QTest::keyClicks(ends, typed);
            QTest::keyClick(ends, Qt::Key_Return);
        }
        QCOMPARE(document_->history()->count(), 2);
        QCOMPARE(document_->fabric()->ends_per_cm, 31.0);
    }

    void drawingAStrokeOnPointPaperIsOneStep()
    {
        document_->edit("weave", {}, [](Design& d) { d.fabrics[0].weave = weave_from_pattern("twill 2/2 Z"); });
        WeaveEditor weave(*document_);
        weave.resize(240, 320);
        const std::string before = text();
        const int steps = document_->history()->count();

        Q_EMIT weave.paper()->painted({QPoint(0, 0)}, false);
        Q_EMIT weave.paper()->painted({QPoint(1, 1)}, false);
        Q_EMIT weave.paper()->strokeEnded();

        QCOMPARE(document_->history()->count(), steps + 1);
        document_->history()->undo();
        QCOMPARE(text(), before);
    }

    void theWeftFollowsTheWarpUntilItIsTakenApart()
    {
        document_->edit("weft", {}, [](Design& d) { d.fabrics[0].weft = d.fabrics[0].warp; });
        FabricPanel fabric(*document_);
        QuantityEdit* twist = field(fabric, "Twist");

        QTest::keyClick(twist, Qt::Key_Up);

        QCOMPARE(document_->fabric()->weft.twist_per_m, document_->fabric()->warp.twist_per_m);
    }

    void whatIsSavedIsWhatIsOpened()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("saved.hygro");
        document_->edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 33.25; });
        QVERIFY(document_->modified());
        QVERIFY(document_->saveAs(path));
        QVERIFY(!document_->modified());
        QCOMPARE(document_->title(), QString("saved.hygro"));

        Document other;
        QVERIFY(other.open(path));
        QCOMPARE(format_project(*other.design()), text());
        QCOMPARE(other.fabric()->ends_per_cm, 33.25);
    }

    void undoingPastASaveMarksTheDocumentModified()
    {
        QTemporaryDir folder;
        document_->edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 33; });
        QVERIFY(document_->saveAs(folder.filePath("saved.hygro")));
        document_->history()->undo();
        QVERIFY(document_->modified());
        document_->history()->redo();
        QVERIFY(!document_->modified());
    }

    void anExampleIsNeverWrittenOver() { QVERIFY(document_->path().isEmpty()); }

    void aBrokenFileIsReportedAndChangesNothing()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("broken.hygro");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{ \"format\": \"something else\" }");
        file.close();
        QSignalSpy failed(document_.get(), &Document::failed);
        const std::string before = text();

        QVERIFY(!document_->open(path));

        QCOMPARE(failed.count(), 1);
        QVERIFY(failed.first().first().toString().contains("broken.hygro"));
        QCOMPARE(text(), before);
    }

    void aProjectWithoutFabricsShowsNoNumbersOfOne()
    {
        FabricPanel panel(*document_);
        WeaveEditor weave(*document_);
        document_->edit("weave", {}, [](Design& d) { d.fabrics[0].weave = weave_from_pattern("satin 5/2"); });
        const auto numbers = [&panel] {
            QStringList found;
            for (const QuantityEdit* edit : panel.findChildren<QuantityEdit*>()) {
                if ((edit->text() + edit->placeholderText()).contains(QRegularExpression("[0-9]"))) { found << edit->accessibleName(); }
            }
            return found;
        };
        QVERIFY(!numbers().isEmpty());
        document_->edit("delete", {}, [](Design& d) { d.fabrics.clear(); });
        QCOMPARE(numbers(), QStringList());
        QCOMPARE(weave.findChild<QSpinBox*>()->value(), 2); // the plain weave's
        QCOMPARE(weave.findChild<QComboBox*>()->currentText(), QString());
    }

    void aFirstFabricHasAnExperimentToBeTriedWith()
    {
        CandidatesPanel candidates(*document_);
        document_->take(Design{}, {});
        candidates.addFabric();
        QCOMPARE(document_->design()->experiments.size(), std::size_t{1});
        QVERIFY(!document_->hasError());
        document_->history()->undo();
        QVERIFY(document_->design()->experiments.empty());
    }

    void garmentsKeepAFabricThatIsRenamed()
    {
        CandidatesPanel candidates(*document_);
        document_->edit("garment", {}, [](Design& design) {
            Garment tee;
            tee.name = "tee";
            tee.panels["*"].fabric = design.fabrics[0].name;
            design.garments.push_back(tee);
        });
        candidates.findChild<QListWidget*>()->item(0)->setText("other");
        QCOMPARE(document_->design()->fabrics[0].name, std::string("other"));
        QCOMPARE(document_->design()->garments[0].panels.at("*").fabric, std::string("other"));
        QVERIFY(!document_->hasError());
    }

    void noPanelCutsItsFieldsOff()
    {
        FabricPanel fabric(*document_);
        ExperimentPanel experiment(*document_);
        for (QScrollArea* panel : {static_cast<QScrollArea*>(&fabric), static_cast<QScrollArea*>(&experiment)}) {
            panel->show();
            panel->resize(panel->minimumSizeHint().expandedTo(panel->minimumSize()).width(), 300);
            QTRY_VERIFY(panel->widget()->width() > 0);
            QVERIFY(panel->widget()->width() <= panel->viewport()->width());
            QVERIFY(panel->widget()->minimumSizeHint().width() <= panel->viewport()->width());
        }
    }

    void anErrorIsFoundAtItsField()
    {
        document_->edit("ends", "fabrics[0].ends_per_cm", [](Design& d) { d.fabrics[0].ends_per_cm = -3; });
        QVERIFY(document_->hasError());
        QVERIFY(document_->fabricHasError());
        QVERIFY(!document_->quantities());
        QVERIFY(!document_->issuesAt("fabrics[0].ends_per_cm").empty());
    }

private:
    std::string text() const { return format_project(*document_->design()); }

    template <typename Widget> static Widget* named(const QWidget& panel, const QString& name)
    {
        for (Widget* widget : panel.findChildren<Widget*>()) {
            if (widget->accessibleName() == name) { return widget; }
        }
        return nullptr;
    }
    void checkUndoAndRedo(const std::string& before)
    {
        const std::string after = text();
        document_->history()->undo();
        QCOMPARE(text(), before);
        document_->history()->redo();
        QCOMPARE(text(), after);
        document_->history()->undo();
        QCOMPARE(text(), before);
    }

    static QuantityEdit* field(QWidget& panel, const QString& name)
    {
        for (QuantityEdit* edit : panel.findChildren<QuantityEdit*>()) {
            if (edit->accessibleName() == name) { return edit; }
        }
        return nullptr;
    }

    static void choose(QWidget& panel, const QString& name, int index)
    {
        for (QComboBox* box : panel.findChildren<QComboBox*>()) {
            if (box->accessibleName() == name) {
                box->setCurrentIndex(index);
                Q_EMIT box->activated(index);
                Q_EMIT box->textActivated(box->itemText(index));
                return;
            }
        }
    }

    std::unique_ptr<Document> document_;
};

QTEST_MAIN(TestDocument)
#include "tst_document.moc"
