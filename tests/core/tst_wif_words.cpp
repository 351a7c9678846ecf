// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a WIF file may say beside its numbers: comments, unclear truths, numbers from 0, sections that contradict each other, setts of
// drawings.
#include "core/base/error.h"
#include "core/design/jam.h"
#include "core/project/draft_import.h"
#include "tests/support/drawn.h"

#include <QTest>

using namespace hygroloom;

namespace tst_wif_words {
namespace {

/// Parts of a draft, each of which a test may write otherwise. The weave is a 2/2 twill.
struct Parts {
    std::string contents = "WEAVING=yes\nWARP=yes\nWEFT=yes\nTHREADING=yes\nTIEUP=yes\nTREADLING=yes\n";
    std::string weaving = "Shafts=4\nTreadles=4\nRising Shed=yes\n";
    std::string warp = "Threads=4\nUnits=Centimeters\nSpacing=0.05\nThickness=0.03\n";
    std::string weft = "Threads=4\nUnits=Centimeters\nSpacing=0.05\nThickness=0.03\n";
    std::string threading = "1=1\n2=2\n3=3\n4=4\n";
    std::string tie_up = "1=1,4\n2=1,2\n3=2,3\n4=3,4\n";
    std::string treadling = "1=1\n2=2\n3=3\n4=4\n";
    std::string more = {};

    DraftImport read() const
    {
        return import_wif("[WIF]\nVersion=1.1\nDate=April 20, 1997\nDevelopers=a\nSource Program=b\n[CONTENTS]\n" + contents +
                              "[WEAVING]\n" + weaving + "[WARP]\n" + warp + "[WEFT]\n" + weft + "[THREADING]\n" + threading + "[TIEUP]\n" +
                              tie_up + "[TREADLING]\n" + treadling + more,
                          "test.wif");
    }
    std::string refusal() const
    {
        try {
            read();
        } catch (const FileError& error) {
            return error.what();
        }
        return "accepted";
    }
};

const std::string twill = "0011 0110 1100 1001";

std::string reported(const DraftImport& draft, const std::string& words, Severity severity = Severity::warning)
{
    for (const ImportLine& line : draft.report)
        if (line.severity == severity && line.text.find(words) != std::string::npos) return line.text;
    return {};
}

/// All warnings, for a test that expects none or others.
std::string warnings(const DraftImport& draft)
{
    std::string all;
    for (const ImportLine& line : draft.report)
        if (line.severity == Severity::warning) all += line.text + "\n";
    return all;
}

} // namespace

class TestWifWords : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void commentsFollowNumbersListsAndTruths_data()
    {
        QTest::addColumn<QString>("comment");
        for (const char* comment : {" left selvage", " ; x", ";x", "\tabout, 4 of 5", " (of 8)", " - as drawn"})
            QTest::newRow(comment) << comment;
    }
    void commentsFollowNumbersListsAndTruths()
    {
        QFETCH(QString, comment);
        const std::string after = comment.toStdString() + "\n";
        Parts parts;
        parts.contents = "WEAVING=yes" + after + "WARP=yes" + after + "WEFT=true\nTHREADING=on\nTIEUP=1" + after + "TREADLING=y\n";
        parts.weaving = "Shafts=4" + after + "Treadles=4" + after + "Rising Shed=yes" + after;
        parts.warp =
            "Threads=4" + after + "Units=Centimeters" + after + "Spacing=0.05" + after + "Thickness=0.03" + after + "Color=1" + after;
        parts.threading = "1=1" + after + "2=2" + after + "3=3\n4=4" + after;
        parts.tie_up = "1=1,4" + after + "2=1, 2" + after + "3=2,3\n4=3,4" + after;
        parts.treadling = "1=1" + after + "2=2" + after + "3=3\n4=4" + after;
        parts.more = "[COLOR PALETTE]\nRange=0,255" + after + "[COLOR TABLE]\n1=200,30,31" + after + "[WARP COLORS]\n2=1" + after;
        const DraftImport draft = parts.read();
        QCOMPARE(warnings(draft), std::string());
        QCOMPARE(drawn(draft.fabric.weave), twill);
        QVERIFY(draft.fabric.warp.color == (Color{200, 30, 31}));
        QVERIFY(std::abs(*draft.ends_per_cm.value - 20) < 1e-9 && std::abs(*draft.warp_diameter_mm.value - 0.3) < 1e-9);
    }
    void numbersWithoutCommasAreTold()
    {
        Parts parts;
        parts.tie_up = "1=1 4\n2=1,2\n3=2,3\n4=3,4\n";
        QVERIFY(!reported(parts.read(), "1 value of [TIEUP] left out, where whole numbers parted by commas are meant; the first is \"1 4\"")
                     .empty());
    }
    void decimalsAreRefusedWithTheirFirstValue()
    {
        Parts parts;
        parts.threading = "1=1.0\n2=2.0\n3=3.0\n4=4.0\n";
        const std::string message = parts.refusal();
        QVERIFY2(message.find("its first line is \"1=1.0\"") != std::string::npos, message.c_str());
        parts.threading = "";
        QVERIFY(parts.refusal().find("[THREADING] is missing or empty") != std::string::npos);
    }
    void unclearTruthsAreTold()
    {
        Parts parts;
        parts.weaving = "Shafts=4\nTreadles=4\nRising Shed=sinking\n";
        QVERIFY(!reported(parts.read(), "Rising Shed is \"sinking\", which is neither true nor false; a rising shed was taken").empty());
        QCOMPARE(drawn(parts.read().fabric.weave), twill);
        parts.weaving = "Shafts=4\nTreadles=4\n";
        QVERIFY(!reported(parts.read(), "does not say Rising Shed").empty());
        QCOMPARE(drawn(parts.read().fabric.weave), twill);
        parts = {};
        parts.contents = "WEAVING=perhaps\n" + parts.contents;
        QVERIFY(!reported(parts.read(), "says neither true nor false of [WEAVING]").empty());
        QCOMPARE(warnings(Parts().read()), std::string());
    }
    void eachQuantityIsCountedFromItsOwnFirstNumber_data()
    {
        QTest::addColumn<int>("ends");
        QTest::addColumn<int>("picks");
        QTest::addColumn<int>("shafts");
        QTest::addColumn<int>("treadles");
        for (int all = 0; all < 16; ++all)
            QTest::addRow("from %d %d %d %d", all & 1, all >> 1 & 1, all >> 2 & 1, all >> 3)
                << (all & 1) << (all >> 1 & 1) << (all >> 2 & 1) << (all >> 3);
    }
    void eachQuantityIsCountedFromItsOwnFirstNumber()
    {
        QFETCH(int, ends);
        QFETCH(int, picks);
        QFETCH(int, shafts);
        QFETCH(int, treadles);
        Parts parts;
        parts.threading = parts.tie_up = parts.treadling = "";
        for (int i = 0; i < 4; ++i) {
            parts.threading += std::to_string(i + ends) + "=" + std::to_string(i + shafts) + "\n";
            parts.tie_up +=
                std::to_string(i + treadles) + "=" + std::to_string(i + shafts) + "," + std::to_string((i + 3) % 4 + shafts) + "\n";
            parts.treadling += std::to_string(i + picks) + "=" + std::to_string(i + treadles) + "\n";
        }
        const DraftImport draft = parts.read();
        QCOMPARE(drawn(draft.fabric.weave), twill);
        const std::string told = reported(draft, "from 0, where the format counts from 1");
        for (const auto& [first, name] : {std::pair(ends, "ends"), {picks, "picks"}, {shafts, "shafts"}, {treadles, "treadles"}})
            QCOMPARE(told.find(name) != std::string::npos, first == 0);
        QVERIFY(reported(draft, "left out").empty());
    }
    void aZeroThatIsNoNumberOfItsOwnStandsForNone()
    {
        Parts parts;
        parts.threading = "1=1\n2=2\n3=3\n4=4\n5=0\n";
        parts.tie_up = "0=1,2\n1=1,4\n2=1,2\n3=2,3\n4=3,4,0\n";
        const DraftImport draft = parts.read();
        QVERIFY(reported(draft, "from 0, where the format").empty());
        QVERIFY(!reported(draft, "1 entry of [TIEUP] with a number below 1, the first, was left out").empty());
    }
    void whatContentsDeclareCounts()
    {
        const std::string all_up = "[LIFTPLAN]\n1=1,2,3,4\n2=1,2,3,4\n3=1,2,3,4\n4=1,2,3,4\n";
        Parts parts;
        parts.more = all_up;
        for (const char* lifts : {"", "LIFTPLAN=no\n"}) {
            parts.contents = Parts().contents + lifts;
            QCOMPARE(drawn(parts.read().fabric.weave), twill);
            QVERIFY(!reported(parts.read(), "declares the tie-up and the treadling only", Severity::note).empty());
        }
        for (const char* contents : {"LIFTPLAN=yes\nTIEUP=yes\nTREADLING=yes\n", "LIFTPLAN=yes\n", "WARP=yes\n", "TIEUP=yes\n"}) {
            parts.contents = contents;
            QCOMPARE(drawn(parts.read().fabric.weave), std::string("1"));
        }
        parts.contents = Parts().contents;
        parts.treadling = ""; // declared and empty: what is there is read
        QCOMPARE(drawn(parts.read().fabric.weave), std::string("1"));
    }
    void settsOfADrawingAreNotTaken_data()
    {
        QTest::addColumn<QString>("numbers");
        QTest::addColumn<bool>("sett");
        QTest::addColumn<bool>("diameter");
        QTest::newRow("thicker than the spacing") << "Spacing=0.0185\nThickness=0.0213\n" << false << false;
        QTest::newRow("one number twice") << "Spacing=0.04\nThickness=0.04\n" << false << false;
        QTest::newRow("no room") << "Spacing=0.02\nThickness=0.019\n" << false << false;
        QTest::newRow("sett alone") << "Spacing=0.0185\n" << true << false;
        QTest::newRow("thickness alone") << "Thickness=0.1\n" << false << true;
        QTest::newRow("a poplin") << "Spacing=0.0191\nThickness=0.0125\n" << true << true;
        QTest::newRow("an everyday cloth") << "Spacing=0.05\nThickness=0.03\n" << true << true;
    }
    void settsOfADrawingAreNotTaken()
    {
        QFETCH(QString, numbers);
        QFETCH(bool, sett);
        QFETCH(bool, diameter);
        Parts parts;
        parts.warp = parts.weft = "Threads=4\nUnits=Centimeters\n" + numbers.toStdString();
        DraftImport draft = parts.read();
        for (const Suggestion* one : {&draft.ends_per_cm, &draft.picks_per_cm}) QCOMPARE(one->plausible, sett);
        for (const Suggestion* one : {&draft.warp_diameter_mm, &draft.weft_diameter_mm}) QCOMPARE(one->plausible, diameter);
        take_suggestions(draft);
        const Fabric& fabric = draft.fabric;
        QCOMPARE(draft.ends_per_cm.value && fabric.ends_per_cm == *draft.ends_per_cm.value, sett);
        const JamGauge jam =
            jam_gauge(fabric.weave, fabric.ends_per_cm, fabric.picks_per_cm, *fabric.warp.diameter_mm, *fabric.weft.diameter_mm);
        QVERIFY2(jam.warp.peirce_percent <= 100 && jam.weft.peirce_percent <= 100, QByteArray::number(jam.warp.peirce_percent));
        if (!sett || !diameter) QVERIFY2(jam.warp.ashenhurst_percent <= 100, QByteArray::number(jam.warp.ashenhurst_percent));
    }
    void yarnsOfOtherColoursAreAsThickAsTheirSystem()
    {
        Parts parts;
        parts.warp += "Color=1\n";
        parts.weft = "Threads=4\nUnits=Centimeters\nSpacing=0.05\nThickness=0.04\nColor=2\n";
        parts.more =
            "[COLOR PALETTE]\nRange=0,255\n[COLOR TABLE]\n1=1,1,1\n2=2,2,2\n3=3,3,3\n4=4,4,4\n[WARP COLORS]\n2=3\n[WEFT COLORS]\n3=4\n";
        DraftImport draft = parts.read();
        take_suggestions(draft);
        QCOMPARE(draft.fabric.extra_yarns.size(), std::size_t(2));
        QVERIFY(std::abs(*draft.fabric.extra_yarns[0].diameter_mm - 0.3) < 1e-9 &&
                std::abs(*draft.fabric.extra_yarns[1].diameter_mm - 0.4) < 1e-9);
    }
};

} // namespace tst_wif_words

QTEST_APPLESS_MAIN(tst_wif_words::TestWifWords)
#include "tst_wif_words.moc"
