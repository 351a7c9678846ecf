// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// File, Technical Card: the numbers come in the background, follow the fabric, are run and cancelled, and what is saved is the core's.
#include "tests/ui/answer_questions.h"
#include "ui/basics/core_words.h"
#include "ui/basics/preferences.h"
#include "ui/export/card_dialog.h"
#include "ui/window/examples.h"

#include <QFile>
#include <QLabel>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

namespace {

/// The row of a number; -1: it has none.
int rowOf(CardDialog& dialog, const char* title)
{
    for (int row = 0; row < dialog.table()->rowCount(); ++row) {
        if (dialog.table()->item(row, 0)->text() == coreWord(title)) { return row; }
    }
    return -1;
}

QString textOf(CardDialog& dialog, const char* title, int column)
{
    const int row = rowOf(dialog, title);
    return row < 0 ? QString() : dialog.table()->item(row, column)->text();
}

} // namespace

class TestCardDialog : public QObject {
    Q_OBJECT

    /// The shipped example's first fabric, and its dialog on screen with all numbers that need no run.
    struct Shown {
        Document document;
        WindowQueue queue;
        std::unique_ptr<CardDialog> dialog;
        Shown()
        {
            if (!document.openExample(shippedExample())) { return; }
            dialog = std::make_unique<CardDialog>(document, queue);
            dialog->show();
        }
        bool ready() const
        {
            return QTest::qWaitFor([this] { return dialog->numbers().card() != nullptr; }, 60000);
        }
    };

private Q_SLOTS:
    void numbersThatAreNotReadyAreGrey()
    {
        Shown shown;
        CardDialog& dialog = *shown.dialog;
        QVERIFY(!textOf(dialog, "Mass", 1).isEmpty() && textOf(dialog, "Mass", 1) != "…"); // at once
        QVERIFY(rowOf(dialog, "Water-vapour resistance Ret") < 0 || textOf(dialog, "Water-vapour resistance Ret", 1) == "…");
        QVERIFY(shown.ready());
        QVERIFY(textOf(dialog, "Water-vapour resistance Ret", 1).toDouble() > 0);
        QCOMPARE(textOf(dialog, "Drying time", 1), "…");
        const QColor grey = dialog.palette().color(QPalette::Disabled, QPalette::Text);
        QCOMPARE(dialog.table()->item(rowOf(dialog, "Drying time"), 0)->foreground().color(), grey);
    }
    void anEditMakesThemAnew()
    {
        Shown shown;
        QVERIFY(shown.ready());
        const QString before = textOf(*shown.dialog, "Mass", 1);
        shown.document.edit("sett", {}, [&](Design& design) {
            design.fabrics[static_cast<std::size_t>(shown.document.fabricIndex())].picks_per_cm *= 0.8;
        });
        QVERIFY(!shown.dialog->numbers().card());
        QVERIFY(textOf(*shown.dialog, "Mass", 1) != before);
        QCOMPARE(textOf(*shown.dialog, "Water-vapour resistance Ret", 1), "…");
        QVERIFY(shown.ready());
        QVERIFY(textOf(*shown.dialog, "Water-vapour resistance Ret", 1) != "…");
        const auto card = shown.dialog->numbers().card();
        shown.document.edit("experiment", {}, [](Design& design) { design.experiments.front().name = "another"; });
        QCOMPARE(shown.dialog->numbers().card(), card); // nothing of the cloth has changed
    }
    void aLabelStopsNoTestsAndIsOnTheCard()
    {
        Shown shown;
        QVERIFY(shown.ready());
        QSignalSpy failed(&shown.dialog->numbers(), &CardNumbers::failed);
        shown.dialog->startOrCancel();
        QTRY_COMPARE(shown.queue.list().size(), std::size_t{1});
        shown.document.edit("price", {}, [&](Design& design) {
            for (Yarn* yarn : yarns_of(design.fabrics[static_cast<std::size_t>(shown.document.fabricIndex())])) {
                yarn->price = 6.5;
                yarn->library_yarn = "Ne 40 of the mill";
            }
        });
        QVERIFY(shown.dialog->numbers().running() && shown.dialog->numbers().card());
        QVERIFY(shown.dialog->numbers().card()->technical.yarn_cost_per_metre);
        QTRY_VERIFY_WITH_TIMEOUT(textOf(*shown.dialog, "Area of the stain after 1 min", 1) != "…", 120000); // of the same cloth
        QVERIFY(shown.dialog->numbers().card()->technical.yarn_cost_per_metre && failed.isEmpty());
        shown.dialog->startOrCancel();
        QTRY_VERIFY_WITH_TIMEOUT(!shown.dialog->numbers().running(), 20000);
    }
    void testsOfAClothThatChangesWhileTheDialogIsHiddenStopAndSaySo()
    {
        Shown shown;
        QVERIFY(shown.ready());
        QSignalSpy failed(&shown.dialog->numbers(), &CardNumbers::failed);
        shown.dialog->startOrCancel();
        QTRY_COMPARE(shown.queue.list().size(), std::size_t{1});
        shown.dialog->hide();
        shown.document.edit("experiment", {}, [](Design& design) { design.experiments.front().name = "another"; });
        QVERIFY(failed.isEmpty());
        shown.document.edit("sett", {}, [&](Design& design) {
            design.fabrics[static_cast<std::size_t>(shown.document.fabricIndex())].picks_per_cm *= 0.8;
        });
        QCOMPARE(failed.count(), 1);
        QVERIFY(failed.first().first().toString().contains(QString::fromStdString(shown.document.fabric()->name)));
        QTRY_VERIFY_WITH_TIMEOUT(!shown.dialog->numbers().running(), 20000);
        QTRY_VERIFY(shown.queue.list().empty());
        shown.dialog->show();
        QVERIFY(shown.ready());
        QVERIFY(shown.dialog->numbers().canRun());
        QCOMPARE(failed.count(), 1);
    }
    void runsCanBeCancelled()
    {
        Shown shown;
        QVERIFY(shown.ready());
        QVERIFY(shown.dialog->numbers().canRun());
        shown.dialog->startOrCancel();
        QVERIFY(shown.dialog->numbers().running());
        shown.dialog->startOrCancel();
        QTRY_VERIFY_WITH_TIMEOUT(!shown.dialog->numbers().running(), 20000);
        QVERIFY(shown.dialog->numbers().canRun());
        QCOMPARE(textOf(*shown.dialog, "Regain at 65 % humidity", 1), "…");
    }
    void testsGoOnWhileTheDialogIsHiddenAndAreAskedAbout()
    {
        Shown shown;
        QVERIFY(shown.ready());
        QVERIFY(shown.dialog->agreesToStopTests(nullptr)); // there are none
        shown.dialog->startOrCancel();
        QTRY_COMPARE(shown.queue.list().size(), std::size_t{1});
        shown.dialog->hide();
        QTest::qWait(300);
        QVERIFY(shown.dialog->numbers().running() && shown.queue.list().size() == 1);
        shown.queue.runs().set_paused(shown.queue.list().front().id, true);
        shown.dialog->show();
        QTRY_VERIFY(shown.dialog->message().contains("paused"));
        QVERIFY(shown.dialog->numbers().running());
        {
            const auto no = answerQuestions("Cancel");
            QVERIFY(!shown.dialog->agreesToStopTests(shown.dialog.get()));
        }
        shown.dialog->startOrCancel();
        QTRY_VERIFY_WITH_TIMEOUT(!shown.dialog->numbers().running(), 20000);
    }
    void constructionAndNotesStandOnIt()
    {
        Shown shown;
        QVERIFY(shown.ready());
        QVERIFY(textOf(*shown.dialog, "Ends, finished", 1).toDouble() > 0);
        QVERIFY(textOf(*shown.dialog, "Warp: crimp", 1).toDouble() > 0);
        shown.document.edit("reed", {}, [&](Design& design) {
            design.fabrics[static_cast<std::size_t>(shown.document.fabricIndex())].loom.reed_width_cm = 159;
        });
        QVERIFY(shown.ready());
        const auto labels = shown.dialog->findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->isVisible() && label->text().contains("The finished width is not given") &&
                   label->text().contains("was compared with 16 sold cloths");
        }));
    }
    void whatHasEndedStaysWhenTheRestIsCancelled()
    {
        Shown shown;
        QVERIFY(shown.ready());
        shown.dialog->startOrCancel();
        QTRY_VERIFY_WITH_TIMEOUT(textOf(*shown.dialog, "Area of the stain after 1 min", 1) != "…", 120000);
        shown.dialog->startOrCancel();
        QTRY_VERIFY_WITH_TIMEOUT(!shown.dialog->numbers().running(), 20000);
        QVERIFY(textOf(*shown.dialog, "Area of the stain after 1 min", 1).toDouble() > 0);
        QVERIFY(textOf(*shown.dialog, "Area of the stain after 1 min", 5).startsWith("live"));
        QCOMPARE(textOf(*shown.dialog, "Regain at 65 % humidity", 1), "…");
        QVERIFY(shown.dialog->numbers().canRun());
    }
    void itSpeaksTheReadersUnits()
    {
        Shown shown;
        QVERIFY(shown.ready());
        QCOMPARE(textOf(*shown.dialog, "Thickness at 1 kPa", 3), "mm");
        const double mm = textOf(*shown.dialog, "Thickness at 1 kPa", 1).toDouble();
        const Preferences before = preferences();
        Preferences inches = before;
        inches.length = static_cast<int>(LengthUnit::inch);
        setPreferences(inches);
        QCOMPARE(textOf(*shown.dialog, "Thickness at 1 kPa", 3), "in");
        const double in = textOf(*shown.dialog, "Thickness at 1 kPa", 1).toDouble();
        setPreferences(before);
        QVERIFY2(qAbs(in * 25.4 / mm - 1) < 0.02, qPrintable(QString::number(in)));
    }
    void whatIsSavedIsTheCores()
    {
        QTemporaryDir folder;
        Shown shown;
        QVERIFY(shown.ready());
        CardExport& file = shown.dialog->file();
        QSignalSpy making(&file, &CardExport::making), written(&file, &CardExport::written), failed(&file, &CardExport::failed);
        file.write(folder.filePath("card.html"), shown.dialog->numbers().card());
        QCOMPARE(making.count(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(written.count(), 1, 60000);
        QFile saved(folder.filePath("card.html"));
        QVERIFY(saved.open(QIODevice::ReadOnly));
        const QByteArray page = saved.readAll();
        const Card own = card_of(*shown.document.design(), *shown.document.fabric(), *shown.document.fitted());
        for (const LaboratoryNumber& number : own.numbers.found) QVERIFY2(page.contains(number.title.c_str()), number.title.c_str());
        QVERIFY(page.contains("data:image/png"));
        file.write(folder.filePath("no such folder/card.html"), shown.dialog->numbers().card());
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, 60000);
    }
};

QTEST_MAIN(TestCardDialog)
#include "tst_card_dialog.moc"
