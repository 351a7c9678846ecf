// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The user's yarns in the window: kept, taken, and replaced in all fabrics in one step.
#include "ui/panels/fabric_panel.h"
#include "ui/panels/yarn_panel.h"
#include "ui/window/examples.h"

#include <QDir>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <algorithm>

using namespace hygroloom;

class TestYarnLibrary : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aYarnIsKeptTakenAndReplacedEverywhere()
    {
        Document document;
        QVERIFY(document.openExample(QDir(examplesFolder()).filePath("three-candidates.hygro")));
        Yarn common = document.design()->fabrics[0].warp;
        common.color = Color{9, 9, 9};
        document.edit("the same yarn everywhere", {}, [&](Design& design) {
            for (Fabric& fabric : design.fabrics) { fabric.warp = common; }
            design.fabrics[1].warp.color.reset();
        });
        const Design before = *document.design();
        DesignForm form(document);
        form.addSection("Fabric");
        YarnPanel warp(form, YarnUse::warp, nullptr);
        form.refresh();

        const QTemporaryDir folder;
        const QString library = folder.filePath("own.hygrolib");
        warp.keep("as it was", library);
        QCOMPARE(document.design()->fabrics[0].warp.library_yarn, std::string("as it was"));
        document.history()->undo();
        LibraryYarn finer = read_yarns(library.toStdString()).at(0);
        QCOMPARE(finer.yarn(), before.fabrics[0].warp);
        finer.design.fabrics[0].warp.twist_per_m += 100;
        finer.design.fabrics[0].warp.color.reset();
        const int steps = document.history()->index();
        const int all = static_cast<int>(before.fabrics.size());
        QCOMPARE(warp.replaceEverywhere(finer), all);
        QCOMPARE(document.history()->index(), steps + 1);
        for (const Fabric& fabric : document.design()->fabrics) { QCOMPARE(fabric.warp.twist_per_m, common.twist_per_m + 100); }
        QVERIFY(document.design()->fabrics[0].warp.color == (Color{9, 9, 9}) && !document.design()->fabrics[1].warp.color);
        document.history()->undo();
        QCOMPARE(*document.design(), before);

        warp.take(finer, Color{1, 2, 3}); // this fabric's alone
        QCOMPARE(document.design()->fabrics[0].warp.twist_per_m, common.twist_per_m + 100);
        QVERIFY(document.design()->fabrics[0].warp.color == (Color{1, 2, 3}));
        QCOMPARE(document.design()->fabrics[1], before.fabrics[1]);
    }
    void yarnsAreBroughtUpToDateInOneStep()
    {
        Document document;
        QVERIFY(document.openExample(QDir(examplesFolder()).filePath("three-candidates.hygro")));
        DesignForm form(document);
        form.addSection("Fabric");
        YarnPanel warp(form, YarnUse::warp, nullptr);
        form.refresh();
        const QTemporaryDir folder;
        const QString library = folder.filePath("own.hygrolib");
        warp.keep("fine", library);
        const auto buttons = form.findChildren<QToolButton*>();
        QVERIFY(std::any_of(buttons.begin(), buttons.end(), [](const QToolButton* each) { return each->text() == "fine"; }));
        document.edit("another fabric has it, too", {}, [](Design& design) { design.fabrics[1].weft = design.fabrics[0].warp; });
        document.endStroke();
        const int steps = document.history()->count();
        QVERIFY(warp.updateFrom(library).empty()); // as they are there
        QCOMPARE(document.history()->count(), steps);
        LibraryYarn finer = read_yarns(library.toStdString()).at(0);
        finer.design.fabrics[0].warp.twist_per_m += 100;
        write_yarns({finer}, library.toStdString());
        const Design before = *document.design();
        const std::vector<YarnUpdate> updates = warp.updateFrom(library);
        QCOMPARE(document.history()->count(), steps + 1);
        QCOMPARE(document.design()->fabrics[0].warp.twist_per_m, before.fabrics[0].warp.twist_per_m + 100);
        QCOMPARE(document.design()->fabrics[1].weft.twist_per_m, before.fabrics[0].warp.twist_per_m + 100);
        const QString said = YarnPanel::saidOf(updates);
        QVERIFY2(said.contains("Twist: ") && said.contains(QString::fromStdString(before.fabrics[1].name) + ", weft: fine"),
                 qPrintable(said));
        document.history()->undo();
        QCOMPARE(*document.design(), before);
    }
    void loomAndPriceHaveFields()
    {
        Document document;
        QVERIFY(document.openExample(QDir(examplesFolder()).filePath("three-candidates.hygro")));
        FabricPanel panel(document);
        panel.resize(330, 700);
        panel.show();
        const Place fabric = Place("fabrics") / static_cast<std::size_t>(document.fabricIndex());
        for (const Place& where : {fabric / "loom" / "reed_width_cm", fabric / "loom" / "ends_per_cm", fabric / "loom" / "ends_per_dent",
                                   fabric / "loom" / "picks_per_cm", fabric / "warp" / "price"}) {
            QVERIFY2(panel.showField(where), where.text().c_str());
        }
        const auto says = [&panel](const QString& text) {
            const auto labels = panel.findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) { return label->text().startsWith(text); });
        };
        QVERIFY(!says("6 %") && !says(QString("6") + QChar(0x00a0) + "%"));
        document.edit("reed", {}, [&](Design& design) {
            design.fabrics[static_cast<std::size_t>(document.fabricIndex())].loom.reed_width_cm =
                159; // of 150 cm, when nothing else is said
        });
        QVERIFY(says("6 %") || says(QString("6") + QChar(0x00a0) + "%"));
    }
};

QTEST_MAIN(TestYarnLibrary)
#include "tst_yarn_library.moc"
