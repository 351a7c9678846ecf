// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A yarn's count as it is typed in the panel of the fabric; and what fields refuse never enters the design.
#include "core/base/units.h"
#include "ui/basics/count_edit.h"
#include "ui/basics/preferences.h"
#include "ui/document/document.h"
#include "ui/panels/candidates_panel.h"
#include "ui/panels/fabric_panel.h"

#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestCountField : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName("hygroloom-test");
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
    }

    void init()
    {
        setPreferences({});
        document_ = std::make_unique<Document>();
        CandidatesPanel candidates(*document_);
        candidates.addFabric();
        panel_ = std::make_unique<FabricPanel>(*document_);
        panel_->resize(400, 3000);
        panel_->setVisible(true);
        QApplication::setActiveWindow(panel_.get());
    }

    void cleanup()
    {
        panel_.reset();
        document_.reset();
    }

    void aNewFabricHasCountsAndNoWarning()
    {
        QVERIFY(warp().linear_density_tex && !warp().diameter_mm);
        for (const Issue& issue : document_->issues()) { QVERIFY2(issue.severity == Severity::note, issue.text().c_str()); }
        QCOMPARE(count()->text(), shown("19.68 tex"));
        QCOMPARE(noteOf(count()), QString("Ne 30"));
        QCOMPARE(noteOf(field("Diameter")), QString("from the count"));
    }

    void theTradesFormsSetPliesAndFilaments()
    {
        type(count(), "Ne 60/2");
        QVERIFY(qAbs(*warp().linear_density_tex - 2 * 590.5 / 60) < 1e-12);
        QCOMPARE(warp().plies, 2);
        QCOMPARE(count()->text(), shown("9.842 tex × 2"));
        QCOMPARE(document_->history()->count(), 2); // the new fabric, and this
        type(count(), "150/48 den");
        QCOMPARE(warp().plies, 1);
        QCOMPARE(warp().filament_count, std::optional(48));
        QCOMPARE(count()->text(), shown("16.67 tex f48"));
        document_->history()->undo();
        QCOMPARE(warp().plies, 2);
        QVERIFY(!warp().filament_count);
        QCOMPARE(count()->text(), shown("9.842 tex × 2"));
    }

    void theSameTexInOtherPliesIsAnotherCount()
    {
        type(count(), "Ne 30");
        QCOMPARE(warp().plies, 1);
        type(count(), "60/2");
        QCOMPARE(warp().plies, 2);
        type(count(), "Ne 30");
        QCOMPARE(warp().plies, 1);
    }

    void itIsShownInThePreferredSystem()
    {
        type(count(), "Ne 60/2");
        Preferences preferred;
        preferred.yarn = static_cast<int>(YarnUnit::ne);
        setPreferences(preferred);
        QCOMPARE(count()->text(), shown("Ne 60/2"));
        type(count(), "40"); // a number alone is in the shown system
        QVERIFY(qAbs(*warp().linear_density_tex - 590.5 / 40) < 1e-12);
    }

    void countAndDiameterTakeEachOthersPlace()
    {
        type(field("Diameter"), "0.25");
        QCOMPARE(warp().diameter_mm, std::optional(0.25));
        QVERIFY(!warp().linear_density_tex);
        QVERIFY(count()->text().isEmpty() && count()->placeholderText().contains("tex"));
        type(count(), "Ne 30");
        QVERIFY(!warp().diameter_mm);
        QVERIFY(field("Diameter")->text().isEmpty());
        // Emptied, it leaves the yarn its size.
        const double diameter = document_->fitted()->derived.warp.diameter_mm;
        type(count(), "");
        QVERIFY(warp().diameter_mm && qAbs(*warp().diameter_mm - diameter) < 1e-9);
        QVERIFY(!document_->hasError());
    }

    void arrowKeysStepTheSingleYarn()
    {
        type(count(), "10 tex x 2");
        count()->setFocus();
        QTest::keyClick(count(), Qt::Key_Up);
        QCOMPARE(*warp().linear_density_tex, 22.0);
        QCOMPARE(warp().plies, 2);
    }

    void whatCannotBeReadStaysTypedWithTheReasonUnderIt()
    {
        const int steps = document_->history()->count();
        const Yarn before = warp();
        type(count(), "60/2 Ne combed");
        QVERIFY(warp() == before);
        QCOMPARE(document_->history()->count(), steps);
        const QLabel* reason = reasonUnder(count());
        QVERIFY(reason && reason->text().contains("no yarn count") && reason->text().contains("Ne 60/2, Nm 2/100"));
        // Another field, another edit: it is still there.
        type(field("Twist"), "800");
        QCOMPARE(count()->text(), QString("60/2 Ne combed"));
        QVERIFY(reasonUnder(count()));
        type(count(), "60/2 Ne");
        QCOMPARE(warp().plies, 2);
        QVERIFY(!reasonUnder(count()));
    }

    void whatIsTypedForOneFabricIsNotShownForAnother()
    {
        CandidatesPanel candidates(*document_);
        candidates.addFabric();
        document_->setFabricIndex(0);
        type(count(), "rubbish");
        QVERIFY(reasonUnder(count()));
        document_->setFabricIndex(1);
        QVERIFY(!reasonUnder(count()));
        QCOMPARE(count()->text(), shown("19.68 tex"));
    }

    void aValueOutOfRangeNeverEntersTheDesign()
    {
        Preferences inches;
        inches.sett = static_cast<int>(SettUnit::per_inch);
        setPreferences(inches);
        QuantityEdit* ends = field("Ends");
        const double before = document_->fabric()->ends_per_cm;
        const int steps = document_->history()->count();
        for (const char* wrong : {"-5", "1e9", "nan", "0", "abc"}) {
            type(ends, wrong);
            QCOMPARE(document_->fabric()->ends_per_cm, before);
            QCOMPARE(document_->history()->count(), steps);
            QVERIFY2(reasonUnder(ends), wrong);
        }
        type(ends, "-5");
        QCOMPARE(reasonUnder(ends)->text(), QString("-5 is out of range. Allowed: 1.27 to 1270") + QChar(0x00a0) + "/in.");
        type(ends, "70");
        QVERIFY(qAbs(document_->fabric()->ends_per_cm - 70 / 2.54) < 1e-12);
        document_->history()->undo();
        QCOMPARE(document_->fabric()->ends_per_cm, before);
        QVERIFY(!document_->hasError());
    }

private:
    const Yarn& warp() const { return document_->fabric()->warp; }
    static QString shown(const char* text) { return QString::fromUtf8(text).replace(' ', QChar(0x00a0)); }

    /// The first: the warp's.
    QuantityEdit* field(const QString& name) const
    {
        for (QuantityEdit* edit : panel_->findChildren<QuantityEdit*>()) {
            if (edit->accessibleName() == name) { return edit; }
        }
        return nullptr;
    }
    QuantityEdit* count() const { return field("Count"); }

    /// A label to the right of the field, on its line.
    QString noteOf(const QWidget* edit) const
    {
        QCoreApplication::processEvents();
        for (const QLabel* label : edit->parentWidget()->findChildren<QLabel*>()) {
            if (label->isVisible() && label->x() > edit->x() && qAbs(label->geometry().center().y() - edit->geometry().center().y()) < 6) {
                return label->text();
            }
        }
        return {};
    }

    /// A label that is seen below the field, before the next one; nullptr: none.
    const QLabel* reasonUnder(const QWidget* edit) const
    {
        QCoreApplication::processEvents();
        for (const QLabel* label : edit->parentWidget()->findChildren<QLabel*>()) {
            const int below = label->y() - edit->geometry().bottom();
            if (label->isVisible() && below >= 0 && below < 12 && label->x() <= edit->x() && label->wordWrap()) { return label; }
        }
        return nullptr;
    }

    static void type(QuantityEdit* edit, const QString& text)
    {
        edit->setFocus();
        edit->selectAll();
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }

    QTemporaryDir folder_;
    std::unique_ptr<Document> document_;
    std::unique_ptr<FabricPanel> panel_;
};

QTEST_MAIN(TestCountField)
#include "tst_count_field.moc"
