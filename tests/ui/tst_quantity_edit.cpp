// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/quantity_edit.h"

#include <QSignalSpy>
#include <QTest>

using namespace hygroloom;

class TestQuantityEdit : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void timesOfARunHaveEqualDecimals()
    {
        const auto text = [](double seconds, double duration) { return momentText(seconds, duration).replace(QChar(0x00a0), ' '); };
        QCOMPARE(text(3600, 3600), QString("3600 s"));
        QCOMPARE(text(36, 3600), QString("36 s"));
        QCOMPARE(text(2.5, 600), QString("2.5 s"));
        QCOMPARE(text(3.2, 10), QString("3.20 s"));
        QCOMPARE(text(0.02, 0.4), QString("0.020 s"));
    }

    void readsTypedUnits_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("stored");
        QTest::newRow("plain number") << "length"
                                      << "0.2" << 0.2;
        QTest::newRow("unit without space") << "length"
                                            << "0.2mm" << 0.2;
        QTest::newRow("decimal comma") << "length"
                                       << "0,2 mm" << 0.2;
        QTest::newRow("micrometres") << "length"
                                     << "200 um" << 0.2;
        QTest::newRow("micro sign") << "length" << QString::fromUtf8("200 µm") << 0.2;
        QTest::newRow("Greek mu") << "length" << QString::fromUtf8("200 μm") << 0.2;
        QTest::newRow("cotton count") << "tex"
                                      << "30 Ne" << 590.5 / 30;
        QTest::newRow("metric count") << "tex"
                                      << "50 Nm" << 20.0;
        QTest::newRow("denier") << "tex"
                                << "90 den" << 10.0;
        QTest::newRow("tex") << "tex"
                             << "26 tex" << 26.0;
        QTest::newRow("ends per inch") << "sett"
                                       << "100 epi" << 100 / 2.54;
        QTest::newRow("picks per inch") << "sett"
                                        << "100 ppi" << 100 / 2.54;
        QTest::newRow("per cent is a fraction") << "humidity"
                                                << "65 %" << 0.65;
        QTest::newRow("per cent without unit") << "humidity"
                                               << "65" << 0.65;
        QTest::newRow("kelvin") << "temperature"
                                << "298.15 K" << 25.0;
        QTest::newRow("fahrenheit") << "temperature"
                                    << "77 F" << 25.0;
        QTest::newRow("minutes") << "time"
                                 << "2 min" << 120.0;
        QTest::newRow("millilitres") << "volume"
                                     << "0.015 ml" << 15.0;
    }

    void readsTypedUnits()
    {
        QFETCH(QString, field);
        QFETCH(QString, typed);
        QFETCH(double, stored);
        QuantityEdit edit(quantity(field));
        QSignalSpy edited(&edit, &QuantityEdit::edited);

        type(edit, typed);
        QTest::keyClick(&edit, Qt::Key_Return);

        QCOMPARE(edited.count(), 1);
        QVERIFY(qAbs(*edit.value() - stored) < 1e-9 * qMax(1.0, stored));
    }

    void showsNumberAndUnit()
    {
        QuantityEdit edit(Quantity::sett(1, 200));
        edit.setValue(35.0);
        QCOMPARE(edit.text(), QString("35") + QChar(0x00a0) + "/cm");
    }

    void escapeTakesBackWhatWasTyped()
    {
        QuantityEdit edit(Quantity::length(0.01, 5));
        edit.setValue(0.2);
        QSignalSpy edited(&edit, &QuantityEdit::edited);

        type(edit, "0.9");
        QTest::keyClick(&edit, Qt::Key_Escape);

        QCOMPARE(edited.count(), 0);
        QCOMPARE(*edit.value(), 0.2);
        QVERIFY(edit.text().startsWith("0.2"));
    }

    void refusesAForeignUnitAndKeepsTheValue()
    {
        QuantityEdit edit(Quantity::length(0.01, 5));
        edit.setValue(0.2);
        QSignalSpy edited(&edit, &QuantityEdit::edited);

        type(edit, "3 tex");
        QTest::keyClick(&edit, Qt::Key_Return);

        QCOMPARE(edited.count(), 0);
        QCOMPARE(*edit.value(), 0.2);
        QVERIFY(edit.toolTip().contains("not a unit of this field"));
        QTest::keyClick(&edit, Qt::Key_Escape);
        QVERIFY(edit.text().startsWith("0.2"));
    }

    void aCountTakesNoFraction()
    {
        QuantityEdit edit(Quantity::count(1, 10));
        edit.setValue(2);
        QSignalSpy edited(&edit, &QuantityEdit::edited);
        type(edit, "2.5");
        QTest::keyClick(&edit, Qt::Key_Return);
        QCOMPARE(edited.count(), 0);
        QCOMPARE(edit.value(), std::optional<double>(2));
        QVERIFY(edit.toolTip().contains("“2.5” is not a whole number."));
        type(edit, "3.0");
        QTest::keyClick(&edit, Qt::Key_Return);
        QCOMPARE(edit.value(), std::optional<double>(3));
    }

    void typedTextIsQuotedAsItIs()
    {
        QuantityEdit edit(Quantity::length(0.01, 5));
        edit.setValue(0.2);
        type(edit, "<i>thick");
        QTest::keyClick(&edit, Qt::Key_Return);
        QVERIFY2(edit.toolTip().contains("“&lt;i&gt;thick”"), qPrintable(edit.toolTip()));
        QVERIFY(edit.accessibleDescription().contains("“<i>thick”"));
    }

    void arrowKeysStepSensibly()
    {
        QuantityEdit sett(Quantity::sett(1, 200));
        sett.setValue(35.4);
        QTest::keyClick(&sett, Qt::Key_Up);
        QCOMPARE(*sett.value(), 36.0);
        QTest::keyClick(&sett, Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(*sett.value(), 26.0);

        QuantityEdit diameter(Quantity::length(0.01, 5));
        diameter.setValue(0.2);
        QTest::keyClick(&diameter, Qt::Key_Up);
        QVERIFY(qAbs(*diameter.value() - 0.21) < 1e-12);
    }

    void stepsStopAtTheRange()
    {
        QuantityEdit edit(Quantity::percent(0, 1));
        edit.setValue(0.98);
        QTest::keyClick(&edit, Qt::Key_Up);
        QTest::keyClick(&edit, Qt::Key_Up);
        QCOMPARE(*edit.value(), 1.0);
    }

    void anOptionalFieldMayBeEmptied()
    {
        QuantityEdit edit(Quantity::length(0.01, 5));
        edit.setOptional(true);
        edit.setDerived(0.41);
        edit.setValue(0.5);

        type(edit, "");
        QTest::keyClick(&edit, Qt::Key_Return);

        QVERIFY(!edit.value());
        QVERIFY(edit.placeholderText().contains("0.41"));
    }

    void anIssueIsShownWithTheRange()
    {
        QuantityEdit edit(Quantity::length(0.01, 5));
        const Issue issue{Severity::error, "range", "thickness_mm", say("The thickness is too small.")};
        edit.setIssues({&issue});
        QVERIFY(edit.toolTip().contains("The thickness is too small."));
        QVERIFY(edit.toolTip().contains("Allowed: 0.01 to 5"));
        QVERIFY(edit.accessibleDescription().contains("The thickness is too small."));
    }

private:
    static Quantity quantity(const QString& field)
    {
        return field == "length"        ? Quantity::length(0.001, 100)
               : field == "tex"         ? Quantity::linearDensity(0.5, 5000)
               : field == "sett"        ? Quantity::sett(0.5, 500)
               : field == "humidity"    ? Quantity::percent(0, 1)
               : field == "temperature" ? Quantity::temperature(-10, 60)
               : field == "time"        ? Quantity::time(0, 86400)
                                        : Quantity::volume(0.001, 5000);
    }

    static void type(QuantityEdit& edit, const QString& text)
    {
        edit.selectAll();
        if (text.isEmpty()) {
            QTest::keyClick(&edit, Qt::Key_Delete);
        } else {
            QTest::keyClick(&edit, Qt::Key_Delete);
            edit.insert(text);
            edit.setModified(true);
        }
    }
};

QTEST_MAIN(TestQuantityEdit)
#include "tst_quantity_edit.moc"
