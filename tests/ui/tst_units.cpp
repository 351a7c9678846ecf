// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers in the units that the user prefers, and in three digits.
#include "core/design/validate.h"
#include "tests/support/drop_design.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/number_label.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity_edit.h"
#include "ui/document/document.h"
#include "ui/panels/experiment_panel.h"

#include <QListWidget>
#include <QRegularExpression>
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

    void messagesOfCoreAreInTheReadersUnits()
    {
        const Stored mm = Stored::mm, per_cm = Stored::per_cm, tex = Stored::tex;
        const struct {
            Message message;
            const char *metric, *inches; ///< with Ne
        } known[] = {{say("{:.4g} {}{} do not fit: a yarn of {:.3g} ({:.3g}) has {:.2g} x {:.2g} of room.", Bare{118.1, per_cm},
                          say("ends"), UnitAlone{per_cm}, Amount{0.2, mm}, Amount{24.3, tex}, Bare{0.083, mm}, Amount{0.083, mm}),
                      "118.1 ends/cm do not fit: a yarn of 0.2 mm (24.3 tex) has 0.083 x 0.083 mm of room.",
                      "300 ends/in do not fit: a yarn of 0.00787 in (24.3 Ne) has 0.00327 x 0.00327 in of room."},
                     {say("{} ends and {} picks per {}", Bare{40, per_cm}, Bare{30, per_cm}, UnitAlone{per_cm, false}),
                      "40 ends and 30 picks per cm", "102 ends and 76.2 picks per in"},
                     {say("The {} must be from {}; given is {}.", say("sample's size"), Between{0.1, 2000, mm}, Bare{3000, mm}),
                      "The sample's size must be from 0.1 to 2000 mm; given is 3000.",
                      "The sample's size must be from 0.00394 to 78.7 in; given is 118."},
                     {say("The {} must be from {}; given is {}.", Title{"number of ends per cm", "Ends", per_cm}, Between{0.5, 500, per_cm},
                          Bare{600, per_cm}),
                      "The number of ends per cm must be from 0.5 to 500; given is 600.",
                      "The number of ends per in must be from 1.27 to 1270; given is 1524."},
                     {say("The {} must be from {}; given is {}.", say("count"), Between{0.05, 50000, tex}, Bare{60000, tex}),
                      "The count must be from 0.05 to 50000 tex; given is 60000.",
                      "The count must be from 0.0118 to 11810 Ne; given is 0.00984."},
                     {say("{} falls through \"{}\"", Amount{2.7, mm}, "Net, 5 mm {}"), "2.7 mm falls through \"Net, 5 mm {}\"",
                      "0.106 in falls through \"Net, 5 mm {}\""},
                     {say("{:.0f} kg/m3, {} and {}", 1540.4, Amount{8, Stored::um}, Amount{20, Stored::celsius}),
                      "1540 kg/m3, 8 µm and 20 C", "1540 kg/m3, 8 µm and 20 C"}};
        for (const auto& each : known) {
            QCOMPARE(english(each.message), std::string(each.metric));
            QCOMPARE(messageText(each.message), QString(each.metric));
        }
        prefer(&Preferences::length, static_cast<int>(LengthUnit::inch));
        prefer(&Preferences::sett, static_cast<int>(SettUnit::per_inch));
        prefer(&Preferences::yarn, static_cast<int>(YarnUnit::ne));
        for (const auto& each : known) { QCOMPARE(messageText(each.message), QString(each.inches)); }
    }
    void noIssueOfACrowdedClothIsInMillimetres()
    {
        prefer(&Preferences::length, static_cast<int>(LengthUnit::inch));
        prefer(&Preferences::sett, static_cast<int>(SettUnit::per_inch));
        prefer(&Preferences::yarn, static_cast<int>(YarnUnit::ne));
        Design design = drop_design();
        Fabric& fabric = design.fabrics[0];
        fabric.ends_per_cm = 118;
        fabric.warp.linear_density_tex = 24;
        fabric.warp.diameter_mm = 0.01;
        fabric.thickness_mm = 90;
        design.experiments[0].sample_mm = {5000, 0.01};
        design.experiments[0].droplets[0].at_mm = {70, 0};
        const std::vector<Issue> issues = validate(design);
        QVERIFY(issues.size() > 3);
        static const QRegularExpression metric("\\d (mm|tex)\\b|/cm|per cm");
        for (const Issue& issue : issues) { QVERIFY2(!issueText(issue).contains(metric), qPrintable(issueText(issue))); }
    }

    void dropsAreListedInTheReadersUnit()
    {
        Document document;
        Design design = drop_design();
        design.experiments[0].droplets[0].at_mm = {2.54, 0};
        document.take(design, "drops");
        const ExperimentPanel panel(document);
        const auto listed = [&panel] {
            QStringList lines;
            for (const QListWidget* list : panel.findChildren<QListWidget*>()) {
                for (int row = 0; row < list->count(); ++row) { lines << list->item(row)->text(); }
            }
            return lines.join('\n');
        };
        QVERIFY2(listed().contains("at (2.54, 0) mm"), qPrintable(listed()));
        prefer(&Preferences::length, static_cast<int>(LengthUnit::inch));
        QVERIFY2(listed().contains("at (0.1, 0) in"), qPrintable(listed()));
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
