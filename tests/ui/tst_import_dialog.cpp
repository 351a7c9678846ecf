// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The page that says what was understood of an imported draft.
#include "core/base/error.h"
#include "ui/weave/import_dialog.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTest>

using namespace hygroloom;

class TestImportDialog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyDraftThatCanBeReadHasAPage()
    {
        const QDir folder(QString(HYGROLOOM_SOURCE_DIR) + "/tests/data/wif");
        int shown = 0;
        for (const QString& file : folder.entryList({"*.wif"})) {
            std::optional<DraftImport> draft;
            try {
                draft = import_draft(folder.filePath(file).toStdString());
            } catch (const Error&) {
                continue;
            }
            ImportDialog dialog(*draft);
            auto* report = dialog.findChild<QListWidget*>();
            QCOMPARE(report->count(), static_cast<int>(draft->report.size()));
            for (int row = 0; row < report->count(); ++row) {
                const bool repaired = draft->report[static_cast<std::size_t>(row)].severity == Severity::warning;
                QVERIFY2(report->item(row)->text().startsWith(repaired ? "Repaired: " : "Understood: "),
                         qPrintable(report->item(row)->text()));
                QVERIFY(!report->item(row)->icon().isNull());
            }
            QCOMPARE(dialog.fabric().name, draft->fabric.name);
            QVERIFY(!dialog.grab().isNull());
            ++shown;
        }
        QVERIFY(shown > 3);
    }

    void onlyChosenNumbersAreTaken()
    {
        DraftImport draft = import_grid("10\n01\n", "grid");
        draft.ends_per_cm = {31, true, {}};
        draft.picks_per_cm = {47.17, false, "That is what its program writes when nobody set it."};
        const double picks = draft.fabric.picks_per_cm;
        ImportDialog dialog(draft);
        const auto boxes = dialog.findChildren<QCheckBox*>();
        QCOMPARE(boxes.size(), 2);
        QVERIFY(boxes[0]->isChecked());
        QVERIFY(!boxes[1]->isChecked());
        QVERIFY(boxes[1]->text().contains("doubtful"));
        QCOMPARE(dialog.fabric().ends_per_cm, 31.0);
        QCOMPARE(dialog.fabric().picks_per_cm, picks);
        boxes[0]->setChecked(false);
        boxes[1]->setChecked(true);
        QVERIFY(dialog.fabric().ends_per_cm != 31.0);
        QCOMPARE(dialog.fabric().picks_per_cm, 47.17);
    }

    void aFabricNeedsAName()
    {
        ImportDialog dialog(import_grid("10\n01\n", "grid"));
        auto* name = dialog.findChild<QLineEdit*>();
        auto* add = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        name->setText("  ");
        QVERIFY(!add->isEnabled());
        name->setText(" shirting ");
        QVERIFY(add->isEnabled());
        QCOMPARE(dialog.fabric().name, std::string("shirting"));
    }
};

QTEST_MAIN(TestImportDialog)
#include "tst_import_dialog.moc"
