// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// WIF drafts as drafting programs really write them.
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/design/drawdown.h"
#include "core/project/draft_import.h"
#include "core/project/project_file.h"
#include "tests/support/drawn.h"

#include <QTest>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace hygroloom;

namespace tst_wif {
namespace {

std::string path_of(const char* file) { return std::string(HYGROLOOM_SOURCE_DIR "/tests/data/wif/") + file; }

std::string reported(const DraftImport& draft, const std::string& words)
{
    for (const ImportLine& line : draft.report)
        if (line.text.find(words) != std::string::npos) return line.text;
    return {};
}

/// A straight draw on four shafts with a 2/2 twill; more sections follow.
std::string twill(const std::string& more = {}, const std::string& warp = "Threads=4\nUnits=centimeters\nSpacing=0.05\n")
{
    return "[WIF]\nVersion=1.1\nDate=April 20, 1997\nDevelopers=wif@mhsoft.com\nSource Program=Test\n"
           "[CONTENTS]\nWEAVING=true\nWARP=true\nWEFT=true\nTHREADING=true\nTIEUP=true\nTREADLING=true\n"
           "[WEAVING]\nShafts=4\nTreadles=4\nRising Shed=true\n[WARP]\n" +
           warp + "[WEFT]\nThreads=4\nUnits=centimeters\nSpacing=0.04\n" +
           "[THREADING]\n1=1\n2=2\n3=3\n4=4\n[TIEUP]\n1=1,4\n2=1,2\n3=2,3\n4=3,4\n[TREADLING]\n1=1\n2=2\n3=3\n4=4\n" + more;
}

DraftImport import_text(const std::string& text) { return import_wif(text, "test.wif"); }

std::string refusal(const std::string& text)
{
    try {
        import_text(text);
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

const std::string twill_rows = "0011 0110 1100 1001";

Fabric sample_fabric()
{
    Fabric fabric;
    fabric.name = "Karo \"blau\" 1";
    fabric.warp.linear_density_tex = 20;
    fabric.weft.diameter_mm = 0.25;
    fabric.weft.material = {{"wool", 0.6}, {"polyester", 0.4}};
    fabric.warp.color = Color{10, 20, 30};
    Yarn blue = fabric.warp;
    blue.color = Color{0, 0, 200};
    Yarn thick = fabric.weft;
    thick.diameter_mm = 0.4;
    fabric.extra_yarns = {blue, thick};
    fabric.warp_order = {{0, 6}, {1, 2}, {0, 1}, {1, 3}};
    fabric.weft_order = {{0, 5}, {2, 2}};
    fabric.ends_per_cm = 23.5;
    fabric.picks_per_cm = 19;
    fabric.thickness_mm = 0.7;
    return fabric;
}

} // namespace

class TestWif : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aTieUpWithATreadlingDrawsTheWeave()
    {
        const DraftImport draft = import_text(twill());
        QCOMPARE(drawn(draft.fabric.weave), twill_rows);
        QVERIFY(draft.fabric.weave.draft() && draft.fabric.weave.draft()->shafts == 4);
        QCOMPARE(reported(draft, "Read "), std::string("Read 4 ends on 4 shafts and 4 picks with 4 treadles."));
    }
    void aSinkingShedIsTheComplement()
    {
        std::string text = twill();
        text.replace(text.find("Shed=true"), 9, "Shed=No");
        QCOMPARE(drawn(import_text(text).fabric.weave), std::string("1100 1001 0011 0110"));
    }
    void sampleFilesOfDraftingPrograms_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("rows");
        QTest::addColumn<QString>("sentence");
        // 1=1,2,4 2=1,3 3=1,2,4 4=1,3,4 5=2,3,4 6=1,2,3; ends on 2 3 4 1.
        QTest::newRow("liftplan") << "desired_basic_wif__two_color_liftplan.wif"
                                  << "1101 1110 0111 1011 0101 1011"
                                  << "with a liftplan";
        QTest::newRow("liftplan of 1200 threads") << "basic_wpo__level2__two_color_liftplan.wpo.wif"
                                                  << "1101 1110 0111 1011 0101 1011"
                                                  << "[WARP] declares 1200 threads, but no more than the first 4 are threaded";
        // Ends on shafts 3 and 2; picks lift 1 2 4, nothing, nothing, 3 4.
        QTest::newRow("missing lift lines") << "basic_wif__liftplan_with_defaults.wif"
                                            << "10 00 00 01"
                                            << "Among the picks, 2 lift no shaft, the first of them number 2.";
        // Ends 3 and 5 on shafts 4 and 1. Treadle 1 lifts shaft 1, treadle 2 shafts 2 and 4; picks press 1 6, 5, 2 5.
        QTest::newRow("missing threading lines") << "basic_wif__treadles_with_defaults.wif"
                                                 << "00100 00000 00001"
                                                 << "Among the ends, 3 are on no shaft and stay down, the first of them number 1.";
        // Ends on 2 3 4 2 1; picks lift 1 3 4, 3, 1 2 4, 1 2 3, 3 4, 1.
        QTest::newRow("stray text and headers with words") << "basic_wpo__many_color_liftplan_and_zeros.wpo.wif"
                                                           << "00001 01100 11011 10111 01000 01101"
                                                           << "Words after the section's name [WARP COLORS] were left out";
        // Ends on 2 3 4 1; picks press 6 5 4 3 2 1, tied to 2 4, 1 3, 1 2 4, 1 3 4, 2 3 4, 1 2 3.
        QTest::newRow("tie-up shorter than treadles") << "basic_wpo__many_color_single_treadles.wpo.wif"
                                                      << "1101 1110 0111 1011 0101 1010"
                                                      << "[WEAVING] says 11 treadles, but only the first 6 have a tie-up";
        QTest::newRow("colour beyond the table") << "bad_wif__default_warp_color_too_big.wif"
                                                 << "1101 1110 0111 1011 0101 1010"
                                                 << "[WARP] Color is 11, which the colour table does not have";
        QTest::newRow("no colour table") << "bad_wif__missing_color_table_warp.wif"
                                         << "1101 1110 0111 1011 0101 1010"
                                         << "1 colour of [WARP COLORS] not in the colour table";
        // Treadles 1 to 4 lift shafts 1 to 4, 5 lifts 1 3, 6 lifts 2 4; picks 1,6,(7) 5 1,2,4 1,3,4 2,3,4 1,2,3.
        QTest::newRow("treadle beyond the tie-up") << "bad_wif__too_many_treadles_in_treadline.wif"
                                                   << "1101 1110 0111 1011 0101 1011"
                                                   << "1 treadle in [TREADLING] left out: there is no treadle beyond number 6.";
    }
    void sampleFilesOfDraftingPrograms()
    {
        QFETCH(QString, file);
        QFETCH(QString, rows);
        QFETCH(QString, sentence);
        const DraftImport draft = import_draft(path_of(qPrintable(file)));
        QCOMPARE(QString::fromStdString(drawn(draft.fabric.weave)), rows);
        QVERIFY(!reported(draft, sentence.toStdString()).empty());
        Design design;
        design.fabrics.push_back(draft.fabric);
        QVERIFY(!has_error(validate(design)));
        QVERIFY(parse_project(format_project(design), "p") == design);
    }
    void incompleteSampleFilesAreRefused()
    {
        const auto refused = [](const char* file) {
            try {
                import_draft(path_of(file));
            } catch (const FileError& error) {
                return QString(error.what());
            }
            return QString();
        };
        QVERIFY(refused("bad_wif__missing_liftplan.wif").contains("neither a liftplan ([LIFTPLAN]) nor a tie-up"));
        QVERIFY(refused("bad_wif__missing_tieup.wif").contains("a treadling but no tie-up ([TIEUP])"));
        QVERIFY(refused("bad_wif__missing_treadling.wif").contains("a tie-up but no treadling ([TREADLING])"));
    }
    void coloursOfASampleFileBecomeYarnsAndOrders()
    {
        const Fabric fabric = import_draft(path_of("basic_wpo__many_color_single_treadles.wpo.wif")).fabric;
        // Ends 1 to 4 have colours 1 to 4 of the table: white, red, green, blue.
        QVERIFY(fabric.warp.color == (Color{255, 255, 255}));
        QVERIFY((fabric.warp_order == std::vector<YarnRun>{{0, 1}, {1, 1}, {2, 1}, {3, 1}}));
        QVERIFY(fabric.extra_yarns.at(0).color == (Color{255, 0, 0}));
        QVERIFY(fabric.extra_yarns.at(2).color == (Color{0, 0, 255}));
    }

    // The fourteen oddities met in real files, in the order of the list they were gathered in.
    void oddity1_threadsThatAreNotThreadedAtTheEndAreLeftOut()
    {
        const DraftImport draft = import_text(twill({}, "Threads=1200\n"));
        QCOMPARE(draft.fabric.weave.ends(), 4);
        QVERIFY(!reported(draft, "declares 1200 threads").empty());
    }
    void oddity2_missingLinesHaveDefaults()
    {
        std::string text = twill("[COLOR TABLE]\n1=255,0,0\n2=0,0,255\n[COLOR PALETTE]\nRange=0,255\n[WARP COLORS]\n2=2\n",
                                 "Threads=4\nColor=1\nUnits=centimeters\nSpacing=0.05\n");
        text.replace(text.find("[THREADING]\n1=1\n2=2\n"), 20, "[THREADING]\n1=1\n"); // end 2 has no line
        const DraftImport draft = import_text(text);
        QCOMPARE(drawn(draft.fabric.weave), std::string("0011 0010 1000 1001"));
        QVERIFY((draft.fabric.warp_order == std::vector<YarnRun>{{0, 1}, {1, 1}, {0, 2}}));
        QVERIFY(draft.fabric.warp.color == (Color{255, 0, 0}));
        QVERIFY(!draft.fabric.weft.color);
    }
    void oddity3_aTieUpLongerThanTreadlesIsTaken()
    {
        std::string text = twill();
        text.replace(text.find("Treadles=4"), 10, "Treadles=2");
        const DraftImport draft = import_text(text);
        QCOMPARE(drawn(draft.fabric.weave), twill_rows);
        QVERIFY(!reported(draft, "says 2 treadles, but [TIEUP] has 4").empty());
    }
    void oddity4_aLiftplanWinsOverATieUp()
    {
        const DraftImport draft = import_text("[CONTENTS]\nLIFTPLAN=true\n" + twill("[LIFTPLAN]\n1=1,3\n2=2,4\n"));
        QCOMPARE(drawn(draft.fabric.weave), std::string("01 10"));
        QVERIFY(!reported(draft, "the liftplan counts").empty());
        QCOMPARE(draft.fabric.weave.draft()->treadles, 0);
    }
    void oddity5_zeroAndNothingInListsMeanNone()
    {
        std::string text = twill();
        text.replace(text.find("1=1,4\n2=1,2"), 11, "1=0,1,4\n2=1,,2");
        QCOMPARE(drawn(import_text(text).fabric.weave), twill_rows);
    }
    void oddity6_emptyAndUndeclaredSectionsAreReported()
    {
        std::string text = twill("[WARP SPACING]\n[NOTES]\n1=Wash before use\n");
        text.insert(text.find("WEAVING=true"), "WARP SPACING=true\n");
        const DraftImport draft = import_text(text);
        QCOMPARE(reported(draft, "declares"), std::string("[CONTENTS] declares sections that are missing or empty: [WARP SPACING]."));
        QVERIFY(!reported(draft, "were read: [NOTES]").empty());
        QVERIFY(!reported(draft, "Wash before use").empty());
    }
    void oddity7_strayTextAndWordsAfterHeadersDoNoHarm()
    {
        std::string text = twill();
        text.replace(text.find("[TIEUP]"), 7, "[TIEUP] (as on my loom)\nwritten by hand");
        const DraftImport draft = import_text(text);
        QCOMPARE(drawn(draft.fabric.weave), twill_rows);
        QVERIFY(!reported(draft, "\"(as on my loom)\"").empty());
        QVERIFY(!reported(draft, "1 line of [TIEUP] left out").empty());
    }
    void oddity8_privateSectionsWithAndWithoutTheirPrefixAreKept()
    {
        const DraftImport draft = import_text(twill("[TW PROJECT]\nSett=40\nName=a=b; c\n\n[PRIVATE WEAVEIT WARP REPEATS1]\n1=x\n"));
        const std::vector<std::string> lines{"[TW PROJECT]", "Sett=40", "Name=a=b; c", "[PRIVATE WEAVEIT WARP REPEATS1]", "1=x"};
        QVERIFY(draft.fabric.weave.draft()->private_lines == lines);
        Design design;
        design.fabrics.push_back(draft.fabric);
        const std::string written = format_wif(design, draft.fabric);
        QVERIFY(QString::fromStdString(written).contains("[TW PROJECT]\r\nSett=40\r\nName=a=b; c\r\n"));
        QVERIFY(QString::fromStdString(written).contains("TW PROJECT=true\r\n"));
        QVERIFY(import_text(written).fabric.weave.draft()->private_lines == lines);
    }
    void oddity9_coloursInThePaletteAreFound()
    {
        const DraftImport draft =
            import_text(twill("[COLOR PALETTE]\nEntries=2\nRange=0,255\n1=255,255,0\n2=1,2,3\n", "Threads=4\nColor=2\n"));
        QVERIFY(draft.fabric.warp.color == (Color{1, 2, 3}));
        QVERIFY(!reported(draft, "in [COLOR PALETTE] in place of [COLOR TABLE]").empty());
    }
    void oddity10_blanksCommentsAndNumbersWithoutAZeroAreUnderstood()
    {
        std::string text = twill({}, "Threads = 4 ; on the loom\nUnits=Inches \nSpacing=.05\n");
        text.replace(text.find("Shed=true"), 9, "Shed=1");
        text.replace(text.find("[THREADING]\n"), 12, "[threading]\n[12]Border\n; a comment\n");
        const DraftImport draft = import_text(text);
        QCOMPARE(drawn(draft.fabric.weave), twill_rows);
        QVERIFY(std::abs(*draft.ends_per_cm.value - 20 / 2.54) < 1e-9);
        QVERIFY(draft.ends_per_cm.plausible);
    }
    void oddity11_countingFromZeroIsSetRight()
    {
        const std::string text =
            "[WIF]\nVersion=1.0\nSource Program=Glassner's loom\n[WEAVING]\nShafts=4\nTreadles=4\nRising Shed=true\n"
            "[WARP]\nThreads=4\n[WEFT]\nThreads=4\n[THREADING]\n0=0\n1=1\n2=2\n3=3\n[TIEUP]\n0=0,3\n1=0,1\n2=1,2\n3=2,3\n"
            "[TREADLING]\n0=0\n1=1\n2=2\n3=3\n";
        const DraftImport draft = import_text(text);
        QCOMPARE(drawn(draft.fabric.weave), twill_rows);
        QVERIFY(!reported(draft, "counts ends, picks, shafts and treadles from 0").empty());
    }
    void oddity12_otherDatesAndVersionsAreNoted()
    {
        std::string text = twill();
        text.replace(text.find("April 20, 1997"), 14, "Wednesday, June 18, 2025");
        text.replace(text.find("Version=1.1"), 11, "Version=1.2");
        QVERIFY(!reported(import_text(text), "\"Wednesday, June 18, 2025\"").empty());
        QVERIFY(!reported(import_text(text), "says that it is WIF 1.2").empty());
        text.replace(text.find("Version=1.2"), 11, "[Version=1.1]");
        QVERIFY(!reported(import_text(text), "an entry in brackets").empty());
        QCOMPARE(drawn(import_text(text).fabric.weave), twill_rows);
    }
    void oddity13_lineEndsAndEncodingsAreUnderstood()
    {
        const std::string utf8 = "K\xC3\xB6per \xE2\x82\xAC", windows = "K\xF6per \x80";
        const std::string lf = twill("[TEXT]\nTitle=" + utf8 + "\n");
        QCOMPARE(import_text(lf).fabric.name, utf8);
        QCOMPARE(import_text("\xEF\xBB\xBF" + lf).fabric.name, utf8);
        QCOMPARE(import_text(twill("[TEXT]\nTitle=" + windows + "\n")).fabric.name, utf8);
        for (const char* ending : {"\r\n", "\r"}) {
            std::string text;
            for (char c : lf) text += c == '\n' ? std::string(ending) : std::string(1, c);
            QCOMPARE(drawn(import_text(text).fabric.weave), twill_rows);
            QCOMPARE(import_text(text).fabric.name, utf8);
        }
        QVERIFY(QString::fromStdString(refusal(std::string("\xFF\xFE[\0W\0", 6))).contains("UTF-16"));
    }
    void aFilesNameIsNoText()
    {
        QCOMPARE(import_wif(twill(), "\xFF\xFEown.wif").fabric.name, std::string("\xC3\xBF\xC3\xBEown")); // as Windows-1252
    }
    void oddity14_numbersNobodySetAreNotTakenForReal()
    {
        DraftImport draft = import_text(twill({}, "Threads=4\nUnits=Centimeters\nSpacing=0.212\nThickness=0.212\n"));
        QVERIFY(!draft.ends_per_cm.plausible && !draft.warp_diameter_mm.plausible);
        QVERIFY(draft.picks_per_cm.plausible); // 0.04 cm
        take_suggestions(draft);
        QCOMPARE(draft.fabric.ends_per_cm, 20.0);
        QCOMPARE(draft.fabric.picks_per_cm, 25.0);
        QVERIFY(std::any_of(draft.report.begin(), draft.report.end(), [](const ImportLine& line) {
            return line.text.starts_with("Taken from the file: picks per cm 25") &&
                   line.text.find("Assumed: ends per cm 20") != std::string::npos;
        }));
        // Inches for the spacing, the untouched centimetres for the thickness.
        const DraftImport mixed = import_text(twill({}, "Threads=4\nUnits=Inches\nSpacing=0.083\nThickness=.212\n"));
        QVERIFY(!mixed.ends_per_cm.plausible && !mixed.warp_diameter_mm.plausible);
        const DraftImport sound = import_text(twill({}, "Threads=4\nUnits=Decipoints\nSpacing=18\nThickness=9\n"));
        QVERIFY(sound.ends_per_cm.plausible && std::abs(*sound.ends_per_cm.value - 40 / 2.54) < 1e-9);
        QVERIFY(sound.warp_diameter_mm.plausible && std::abs(*sound.warp_diameter_mm.value - 0.3175) < 1e-9);
    }

    void colourRangesAreScaled()
    {
        const auto color = [](const char* palette, const char* value) {
            const DraftImport draft = import_text(
                twill("[COLOR PALETTE]\n" + std::string(palette) + "\n[COLOR TABLE]\n1=" + value + "\n", "Threads=4\nColor=1\n"));
            return *draft.fabric.warp.color;
        };
        QVERIFY(color("Range=0,999", "999,500,0") == (Color{255, 128, 0}));     // 500/999 x 255 = 127.6
        QVERIFY(color("Range=20,1200", "1200,20,610") == (Color{255, 0, 128})); // 590/1180 = 0.5, 127.5 rounds up
        QVERIFY(color("Range=999", "999,0,0") == (Color{255, 0, 0}));
        QVERIFY(color("Entries=1", "999,0,0") == (Color{255, 0, 0}));
        QVERIFY(color("Entries=1", "255,0,0") == (Color{255, 0, 0}));
    }
    void theRepeatIsFoundAlsoWhenTheLastOneIsNotWhole()
    {
        const DraftImport draft = import_draft(path_of("desired_basic_wif__multi-byte_multi_treadled.wif"));
        QCOMPARE(draft.fabric.weave.ends(), 32); // a point of 17 shafts
        QCOMPARE(draft.fabric.weave.draft()->threading.at(17).at(0), 15);
        QVERIFY(!reported(draft, "641 ends are 20 repeats of 32 and 1 more").empty());
        QVERIFY(!draft.warp_diameter_mm.plausible);
    }
    void aDraftLargerThanAnyRepeatIsRefused()
    {
        std::string text = "[WEAVING]\nShafts=2\nRising Shed=yes\n[THREADING]\n", lifts = "[LIFTPLAN]\n1=1\n2=2\n";
        for (int end = 1; end <= 5000; ++end)
            text += std::to_string(end) + "=" + std::to_string(1 + (random_bits(1, 0, static_cast<std::uint64_t>(end)) & 1)) + "\n";
        QVERIFY(QString::fromStdString(refusal(text + lifts)).contains("a repeat may have up to 2000"));
        QVERIFY(QString::fromStdString(refusal("hello")).contains("no WIF file"));
        QVERIFY(QString::fromStdString(refusal("[THREADING]\n[WEAVING]\n")).contains("[THREADING] is missing or empty"));
    }
    void aLongPeriodicDraftIsReducedQuickly()
    {
        std::string text = "[WIF]\nVersion=1.1\n[WEAVING]\nShafts=32\nRising Shed=yes\n[THREADING]\n";
        for (int end = 0; end < 100000; ++end) text += std::to_string(end + 1) + "=" + std::to_string(1 + end % 32) + "\n";
        text += "[LIFTPLAN]\n";
        for (int pick = 0; pick < 100000; ++pick)
            text += std::to_string(pick + 1) + "=" + std::to_string(1 + pick % 32) + "," + std::to_string(1 + (pick + 5) % 32) + "\n";
        QBENCHMARK_ONCE
        {
            const Weave weave = import_text(text).fabric.weave;
            QCOMPARE(weave.ends(), 32);
            QCOMPARE(weave.picks(), 32);
        }
    }

    void whatIsWrittenIsPlainWif()
    {
        Design design;
        Fabric fabric = sample_fabric();
        fabric.weave = weave_from_pattern("twill 2/2 Z");
        design.fabrics.push_back(fabric);
        const QString text = QString::fromStdString(format_wif(design, fabric));
        QVERIFY(
            text.startsWith("[WIF]\r\nVersion=1.1\r\nDate=April 20, 1997\r\nDevelopers=wif@mhsoft.com\r\nSource Program=Hygroloom\r\n"));
        QVERIFY(!QString(text).remove("\r\n").contains('\n'));
        QVERIFY(text.contains("[WARP]\r\nThreads=12\r\nColor=1\r\nUnits=Centimeters\r\nSpacing=0.0425532\r\n")); // 1 / 23.5 cm
        QVERIFY(text.contains("[WEFT]\r\nThreads=28\r\n") && text.contains("Thickness=0.025\r\n"));              // 7 picks of colour x 4
        QVERIFY(text.contains("[TIEUP]\r\n1=1,4\r\n2=1,2\r\n3=2,3\r\n4=3,4\r\n"));
        QVERIFY(text.contains("PRIVATE HYGROLOOM FABRIC=true\r\n"));
        QVERIFY(!text.contains("LIFTPLAN"));
        fabric.weave = weave_from_pattern("satin 37/5");
        QVERIFY(QString::fromStdString(format_wif(design, fabric)).contains("[LIFTPLAN]\r\n"));
    }
    void whatIsWrittenComesBack()
    {
        Draft lifted = with_liftplan(smallest_draft(weave_from_pattern("broken twill 3/1 Z")));
        lifted.rising_shed = false;
        std::vector<Weave> weaves{Weave(),
                                  Weave(4, 4, {1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1}), // not the smallest repeat
                                  weave_from_draft(lifted),
                                  weave_from_draft(smallest_draft(weave_from_pattern("waffle 8"))),
                                  weave_from_pattern("satin 37/5"),
                                  weave_from_pattern("crepe 50 seed 2")};
        for (const std::string& pattern : common_weave_patterns()) weaves.push_back(weave_from_pattern(pattern));
        for (const Weave& weave : weaves) {
            Design design;
            Fabric fabric = sample_fabric();
            fabric.weave = weave;
            design.fabrics.push_back(fabric);
            QVERIFY(!has_error(validate(design)));
            const DraftImport again = import_wif(format_wif(design, fabric), "again.wif", design);
            QVERIFY(again.numbers_are_ours);
            QVERIFY(again.fabric.weave == weave);
            QVERIFY(again.fabric == fabric);
        }
    }
    void threadsThatDoNothingComeBackToo()
    {
        for (const char* pattern : {"twill 2/2 Z", "satin 37/5"}) { // with a tie-up, and with a liftplan
            Draft draft = with_liftplan(smallest_draft(weave_from_pattern(pattern)));
            draft.threading.resize(draft.threading.size() + 2); // on no shaft
            draft.liftplan.resize(draft.liftplan.size() + 3);   // lift none
            Design design;
            design.fabrics.push_back(Fabric());
            Fabric& fabric = design.fabrics.front();
            fabric.weave = weave_from_draft(draft);
            const DraftImport again = import_text(format_wif(design, fabric));
            QVERIFY2(again.fabric.weave.same_matrix(fabric.weave), pattern);
        }
    }
    void withoutOurOwnSectionWeaveAndColoursStillComeBack()
    {
        Design design;
        Fabric fabric = sample_fabric();
        fabric.weave = weave_from_pattern("herringbone 2/2 Z 8");
        fabric.extra_yarns[1].color = Color{9, 9, 9};
        fabric.weft.color = Color{200, 0, 0};
        design.fabrics.push_back(fabric);
        std::string text = format_wif(design, fabric);
        text.resize(text.rfind("[PRIVATE HYGROLOOM FABRIC]"));
        const Fabric again = import_text(text).fabric;
        QVERIFY(again.weave.same_matrix(fabric.weave));
        QVERIFY(again.warp_order == fabric.warp_order);
        QVERIFY(again.weft_order == fabric.weft_order);
        QCOMPARE(again.extra_yarns.size(), std::size_t(2));
        QVERIFY(again.extra_yarns[0].color == fabric.extra_yarns[0].color && again.extra_yarns[1].color == fabric.extra_yarns[1].color);
        QVERIFY(again.warp.color == fabric.warp.color && again.weft.color == fabric.weft.color);
    }
    void colourChangedElsewhereWinsOverOurOwnSection()
    {
        Design design;
        Fabric fabric = sample_fabric();
        design.fabrics.push_back(fabric);
        QString text = QString::fromStdString(format_wif(design, fabric));
        text.replace("10,20,30", "11,20,30");
        const Fabric again = import_text(text.toStdString()).fabric;
        QVERIFY(again.warp.color == (Color{11, 20, 30}));
        QCOMPARE(again.ends_per_cm, 23.5);
    }
};

} // namespace tst_wif

QTEST_APPLESS_MAIN(tst_wif::TestWif)
#include "tst_wif.moc"
