// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers in the units that the user prefers, and in three digits.
#include "ui/basics/number_label.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity_edit.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

namespace {

void prefer(int Preferences::*value, int choice)
{
    Preferences chosen = preferences();
    chosen.*value = choice;
    setPreferences(chosen);
}

QString plain(QString text) { return text.replace(QChar(0x00a0), ' '); }

} // namespace

class TestUnits : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName("hygroloom-test");
        QCoreApplication::setApplicationName("hygroloom-test");
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        QLocale::setDefault(QLocale::c());
    }

    void init() { setPreferences({}); }

    void lengthsAreShownInThePreferredUnit()
    {
        QuantityEdit edit(Quantity::length(0.01, 508));
        edit.setValue(25.4);
        QCOMPARE(plain(edit.text()), QString("25.4 mm"));
        prefer(&Preferences::length, 1);
        QCOMPARE(plain(edit.text()), QString("2.54 cm"));
        prefer(&Preferences::length, 2);
        QCOMPARE(plain(edit.text()), QString("1 in"));
        QVERIFY2(plain(edit.toolTip()).contains("to 20 in"), qPrintable(edit.toolTip()));
        edit.setText("2"); // without a unit: the one that is shown
        QCOMPARE(*edit.typed(nullptr), 50.8);
        edit.setText("3 mm");
        QCOMPARE(*edit.typed(nullptr), 3.0);
    }

    void thinYarnsKeepTheirDigitsInInches()
    {
        prefer(&Preferences::length, 2);
        const Quantity diameter = Quantity::length(0.01, 10);
        QVERIFY(std::abs(*diameter.parse(diameter.text(0.2123)) - 0.2123) < 1e-4);
    }

    void convertedLengthsHaveThreeDigitsAndAllWhenPointedAt()
    {
        QuantityEdit edit(Quantity::length(0.01, 508));
        edit.setValue(20);
        QVERIFY2(!edit.toolTip().contains("In full"), qPrintable(edit.toolTip()));
        prefer(&Preferences::length, 2);
        QCOMPARE(plain(edit.text()), QString("0.787 in"));
        QVERIFY2(plain(edit.toolTip()).contains("In full: 0.787401574"), qPrintable(edit.toolTip()));
        QCOMPARE(edit.typed(nullptr), std::optional(20.0)); // what is shown short is not lost
        edit.setModified(true);                             // typed over and back
        QTest::keyClick(&edit, Qt::Key_Return);
        QCOMPARE(edit.value(), std::optional(20.0));
        edit.setText("0.7875"); // as it was typed
        edit.setModified(true);
        QTest::keyClick(&edit, Qt::Key_Return);
        QCOMPARE(plain(edit.text()), QString("0.7875 in"));
        QVERIFY2(!edit.toolTip().contains("In full"), qPrintable(edit.toolTip()));
        QCOMPARE(plain(Quantity::length(0.01, 10).text(0.2123)), QString("0.00836 in"));
        QVERIFY2(plain(edit.toolTip()).contains("Allowed: 0.000394 to 20 in."), qPrintable(edit.toolTip()));
        prefer(&Preferences::length, 1);
        QCOMPARE(plain(Quantity::length(0.01, 508).text(12.345)), QString("1.2345 cm"));
    }

    void calculatedNumbersTakeThePreferredUnit()
    {
        QCOMPARE(userUnit("°C").of(20), 20.0);
        prefer(&Preferences::degrees, 1);
        QCOMPARE(userUnit("°C").of(20), 68.0);
        QCOMPARE(userUnit("°C").unit, QString("°F"));
        prefer(&Preferences::yarn, 1);
        QVERIFY(std::abs(userUnit("tex").of(29.525) - 20) < 0.01);
        prefer(&Preferences::yarn, 3);
        QCOMPARE(userUnit("tex").of(10), 90.0);
        prefer(&Preferences::sett, 1);
        QCOMPARE(userUnit("/cm").of(10), 25.4);
        QCOMPARE(userUnit("g/m²").of(10), 10.0);
    }

    void yarnsAreShownByThePreferredCount_data()
    {
        QTest::addColumn<int>("choice");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("beside");
        QTest::newRow("tex") << 0 << "29.53 tex"
                             << "Ne 20";
        QTest::newRow("Ne") << 1 << "20 Ne"
                            << "29.5 tex";
        QTest::newRow("Nm") << 2 << "33.87 Nm"
                            << "29.5 tex";
        QTest::newRow("denier") << 3 << "265.73 den"
                                << "29.5 tex";
    }

    void yarnsAreShownByThePreferredCount()
    {
        QFETCH(int, choice);
        QFETCH(QString, text);
        QFETCH(QString, beside);
        prefer(&Preferences::yarn, choice);
        const Quantity count = Quantity::linearDensity(0.5, 5000);
        QCOMPARE(plain(count.text(29.526)), text);
        QCOMPARE(plain(count.besideText(29.526)), beside);
        QVERIFY(std::abs(*count.parse(QString::number(count.number(29.526).toDouble())) - 29.526) < 0.01);
        const QString range = plain(count.range());
        QVERIFY2(choice != 1 || range == "Allowed: 0.12 to 1181 Ne.", qPrintable(range));
    }

    void arrowsStepInTheUnitThatIsShown()
    {
        prefer(&Preferences::yarn, 1);
        const Quantity count = Quantity::linearDensity(0.5, 5000);
        QCOMPARE(plain(count.text(count.stepped(590.5 / 20, 1))), QString("21 Ne"));
        QVERIFY(count.stepped(5000, -1) <= 5000);
        prefer(&Preferences::sett, 1);
        const Quantity sett = Quantity::sett(0.5, 500);
        QCOMPARE(plain(sett.text(sett.stepped(100 / 2.54, 1))), QString("101 /in"));
    }

    void settsAndTemperaturesFollow()
    {
        const Quantity sett = Quantity::sett(0.5, 500), warmth = Quantity::temperature(-50, 100);
        QCOMPARE(plain(sett.besideText(35)), QString("89 /in"));
        QCOMPARE(plain(warmth.text(25)), QString::fromUtf8("25 °C"));
        prefer(&Preferences::sett, 1);
        prefer(&Preferences::degrees, 1);
        QCOMPARE(plain(sett.text(35)), QString("88.9 /in"));
        QCOMPARE(plain(sett.besideText(35)), QString("35 /cm"));
        QCOMPARE(plain(warmth.text(25)), QString::fromUtf8("77 °F"));
        QCOMPARE(*warmth.parse("32"), 0.0);
    }

    void aFieldOfMicrometresStaysAsItIs()
    {
        prefer(&Preferences::length, 2);
        Quantity radius = Quantity::length(0.05, 1000);
        radius.unit = "µm";
        radius.units = trade_units(Stored::um);
        QCOMPARE(plain(radius.text(4.5)), QString::fromUtf8("4.5 µm"));
    }

    void calculatedNumbersHaveThreeDigitsAndAllWhenPointedAt()
    {
        QCOMPARE(significant(0.27624), QString("0.276"));
        QCOMPARE(significant(4.6151), QString("4.62"));
        QCOMPARE(significant(1234.4), QString("1234"));
        QCOMPARE(significant(0), QString("0"));
        QLabel label;
        label.setToolTip("<p>Gap.</p>");
        showNumbers(label, {0.27624, 0.5}, "mm");
        QCOMPARE(plain(label.text()), QString::fromUtf8("0.276 × 0.5 mm"));
        QVERIFY2(plain(label.toolTip()).contains(QString::fromUtf8("<p>Gap.</p><p>0.27624 × 0.5 mm")), qPrintable(label.toolTip()));
        showNumbers(label, {1}, "mm"); // the tip does not grow
        QCOMPARE(label.toolTip().count("<p>"), 2);
        QuantityEdit edit(Quantity::length(0.01, 10));
        edit.setOptional(true);
        edit.setDerived(0.27624);
        QCOMPARE(plain(edit.placeholderText()), QString("auto 0.276 mm"));
        QVERIFY2(plain(edit.toolTip()).contains("0.27624 mm"), qPrintable(edit.toolTip()));
    }

    void resultsInMillimetresFollow()
    {
        QCOMPARE(plain(valueText(22.1234, "mm")), QString("22.1 mm"));
        QCOMPARE(plain(valueText(22.1234, "mm", true)), QString("22.1234 mm"));
        prefer(&Preferences::length, 1);
        QCOMPARE(plain(valueText(22.1234, "mm")), QString("2.21 cm"));
        QCOMPARE(plain(valueText(5, "mm/s")), QString("0.5 cm/s"));
        QCOMPARE(plain(valueText(5, "g/m²")), QString::fromUtf8("5 g/m²"));
    }

private:
    QTemporaryDir folder_;
};

QTEST_MAIN(TestUnits)
#include "tst_units.moc"
