// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Counts as the trade writes them, and numbers with units, wherever they are given.
#include "core/base/trade_units.h"
#include "core/design/yarn_count.h"
#include "core/project/project_file.h"
#include "core/project/project_value.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace tst_yarn_count {
namespace {

std::string refusal(const std::function<void()>& work)
{
    try {
        work();
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

std::string project(const std::string& warp)
{
    return R"({ "format": "hygroloom-project", "version": 1, "fabrics": [ { "name": "cloth", "ends_per_cm": 24, "picks_per_cm": 24,
        "weave": { "pattern": "plain" }, "warp": { "material": "cotton", )" +
           warp + R"( }, "weft": { "material": "cotton", "diameter_mm": 0.2, "plies": 3 } } ] })";
}

} // namespace

class TestYarnCount : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theTradesFormsAreRead_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("tex"); // of the whole yarn
        QTest::addColumn<int>("plies");
        QTest::addColumn<int>("filaments"); // of a single yarn; 0: not named
        // Ne: 590.5 g/km over the count; Nm 1000; denier g per 9 km.
        const auto row = [](const char* text, double tex, int plies, int filaments) {
            QTest::newRow(text) << QString::fromUtf8(text) << tex << plies << filaments;
        };
        row("60/2", 2 * 590.5 / 60, 2, 0);
        row("Ne 60/2", 2 * 590.5 / 60, 2, 0);
        row("ne60/2", 2 * 590.5 / 60, 2, 0);
        row("2/60 NE", 2 * 590.5 / 60, 2, 0);
        row("NeC 30", 590.5 / 30, 1, 0);
        row("30s", 590.5 / 30, 1, 0);
        row("2/60s", 2 * 590.5 / 60, 2, 0);
        row("30/1", 590.5 / 30, 1, 0);
        row("Ne 7,5", 590.5 / 7.5, 1, 0);
        row("Ne 60 x 2", 2 * 590.5 / 60, 2, 0);
        row("3 x Ne 2", 3 * 590.5 / 2, 3, 0);
        row("Nm 2/100", 20, 2, 0);
        row("2/60 Nm", 2 * 1000.0 / 60, 2, 0);
        row("nm 100/2", 20, 2, 0);
        row("Nm 40", 25, 1, 0);
        row("150/48 den", 150 / 9.0, 1, 48);
        row("75D/36F", 75 / 9.0, 1, 36);
        row("150 denier", 150 / 9.0, 1, 0);
        row("20/5 den", 20 / 9.0, 1, 5);
        row("150/48/2 den", 300 / 9.0, 2, 48);
        row("150/48 den × 2", 300 / 9.0, 2, 48);
        row("2 x 150/48 den", 300 / 9.0, 2, 48);
        row("167 dtex f48", 16.7, 1, 48);
        row("167dtex f 48 x 2", 33.4, 2, 48);
        row("167/48 dtex", 16.7, 1, 48);
        row("14.8 tex × 2", 29.6, 2, 0);
        row("14.8tex x2", 29.6, 2, 0);
        row("14,8 TEX * 2", 29.6, 2, 0);
        row("2 x 14.8 tex", 29.6, 2, 0);
        row("14.8 x 2 tex", 29.6, 2, 0);
        row("5 tex x 6", 30, 6, 0);
        row("6 x 5 tex", 30, 6, 0);
        row("16.7 tex f48", 16.7, 1, 48);
        row("tex 20", 20, 1, 0);
    }
    void theTradesFormsAreRead()
    {
        QFETCH(QString, text);
        QFETCH(double, tex);
        QFETCH(int, plies);
        QFETCH(int, filaments);
        const YarnCount count = read_yarn_count(text.toStdString());
        QVERIFY2(std::abs(count.tex() / tex - 1) < 1e-12, qPrintable(QString::number(count.tex())));
        QCOMPARE(count.plies, plies);
        QCOMPARE(count.filaments.value_or(0), filaments);
        const QString blankless = QString(text).remove(' ');
        QCOMPARE(read_yarn_count(blankless.toStdString()).tex(), count.tex());
        QCOMPARE(read_yarn_count(text.toUpper().toStdString()).plies, plies);
    }

    void whatIsShownReadsBack_data()
    {
        QTest::addColumn<int>("plies");
        QTest::addColumn<int>("filaments");
        QTest::addColumn<int>("system");
        QTest::addColumn<QString>("shown");
        QTest::newRow("tex") << 2 << 0 << int(CountSystem::tex) << QString::fromUtf8("14.8 tex × 2");
        QTest::newRow("ne") << 2 << 0 << int(CountSystem::ne) << "Ne 39.9/2";
        QTest::newRow("nm") << 1 << 0 << int(CountSystem::nm) << "Nm 33.78";
        QTest::newRow("den") << 1 << 48 << int(CountSystem::denier) << "266.4/48 den";
        QTest::newRow("tex of filaments") << 2 << 96 << int(CountSystem::tex) << QString::fromUtf8("14.8 tex f48 × 2");
        QTest::newRow("dtex of filaments") << 2 << 96 << int(CountSystem::dtex) << QString::fromUtf8("148/48 dtex × 2");
    }
    void whatIsShownReadsBack()
    {
        QFETCH(int, plies);
        QFETCH(int, filaments);
        QFETCH(int, system);
        QFETCH(QString, shown);
        const std::string text =
            count_text(29.6, plies, filaments ? std::optional(filaments) : std::nullopt, static_cast<CountSystem>(system));
        QCOMPARE(QString::fromStdString(text), shown);
        const YarnCount read = read_yarn_count(text);
        QVERIFY(std::abs(read.tex() / 29.6 - 1) < 2e-4);
        QCOMPARE(read.plies, plies);
        QCOMPARE(read.filaments.value_or(0) * plies, filaments);
        // The finest and the coarsest that there are.
        for (const double tex : {least_tex, most_tex}) {
            const double back = read_yarn_count(count_text(tex, 1, {}, static_cast<CountSystem>(system))).tex();
            QVERIFY2(std::abs(back / tex - 1) < 1e-3, qPrintable(QString::number(back)));
        }
    }

    void whatIsNoCountIsRefusedWithTheFormsThatAreAllowed_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("why");
        const auto row = [](const char* text, const char* why) { QTest::newRow(text) << QString::fromUtf8(text) << QString(why); };
        row("", "cannot be read");
        row("cotton", "cannot be read");
        row("Ne 60/2 carded", "cannot be read");
        row("60//2", "cannot be read");
        row("/2", "cannot be read");
        row("Ne", "cannot be read");
        row("1.2.3 tex", "cannot be read");
        row("-5 tex", "cannot be read");
        row("1e400 tex", "cannot be read");
        row("30", "needs a unit");
        row("150/48", "needs a unit");
        row("Ne 60/7", "1 to 6 plies");
        row("60/2.5", "needs a unit");
        row("14.8 tex x 7", "1 to 6 plies");
        row("Ne 60/2 x 2", "plies twice");
        row("60/2/2", "plies twice");
        row("Ne 60 tex", "two units");
        row("Ne 60 f20", "filaments go with");
        row("20/2 tex", "× 2 or f2");
        row("150/1 den", "2 to 100000");
        row("150/1.5 den", "2 to 100000");
        row("0 tex", "0.05 to 50000 tex");
        row("Ne 100000", "0.05 to 50000 tex");
        row("60000 tex", "0.05 to 50000 tex");
    }
    void whatIsNoCountIsRefusedWithTheFormsThatAreAllowed()
    {
        QFETCH(QString, text);
        QFETCH(QString, why);
        const QString sentence = QString::fromStdString(refusal([&] { read_yarn_count(text.toStdString()); }));
        QVERIFY2(sentence.contains(why), qPrintable(sentence));
        QVERIFY2(sentence.startsWith("\"" + text + "\"") && sentence.contains("Ne 60/2, Nm 2/100, 150/48 den"), qPrintable(sentence));
    }
    void aBareNumberIsReadWhereItsUnitIsKnown()
    {
        QCOMPARE(read_yarn_count("20", CountSystem::tex).tex(), 20.0);
        QCOMPARE(read_yarn_count("40", CountSystem::nm).tex(), 25.0);
        QCOMPARE(read_yarn_count("60/2", CountSystem::tex).plies, 2); // that of cotton all the same
    }

    void aFileTakesACount()
    {
        const Yarn plied = parse_project(project(R"("count": "Ne 60/2", "packing_factor": 0.6)"), "f").fabrics[0].warp;
        QVERIFY(std::abs(*plied.linear_density_tex - 2 * 590.5 / 60) < 1e-12);
        QCOMPARE(plied.plies, 2);
        QVERIFY(!plied.diameter_mm && !plied.filament_count);
        const Yarn filaments = parse_project(project(R"("count": "150/48 den x 2")"), "f").fabrics[0].warp;
        QCOMPARE(*filaments.filament_count, 96);
        QCOMPARE(*parse_project(project(R"("count": "150 den", "filament_count": 30)"), "f").fabrics[0].warp.filament_count, 30);
        // What is written says the same.
        const Design design = parse_project(project(R"("count": "150/48 den x 2")"), "f");
        QVERIFY(parse_project(format_project(design), "g").fabrics[0].warp == design.fabrics[0].warp);
    }
    void aFileMaySayEachThingOnce()
    {
        for (const char* other : {R"("linear_density_tex": 20)", R"("plies": 2)", R"("filament_count": 48)"}) {
            const QString sentence =
                QString::fromStdString(refusal([&] { parse_project(project(std::string(R"("count": "150/48 den", )") + other), "f"); }));
            QVERIFY2(sentence.startsWith("f: fabrics[0].warp.") && sentence.contains("says this already"), qPrintable(sentence));
        }
        QVERIFY(
            refusal([&] { parse_project(project(R"("count": 30)"), "f"); }).starts_with("f: fabrics[0].warp.count: This must be a text"));
        QVERIFY(refusal([&] { parse_project(project(R"("count": "60/2/2")"), "f"); }).starts_with("f: fabrics[0].warp.count: \"60/2/2\""));
    }
    void setTakesACount()
    {
        const Design design = parse_project(project(R"("diameter_mm": 0.2, "plies": 3, "filament_count": 7)"), "f");
        const Yarn yarn = with_value(design, "fabrics[0].warp.count", "Ne 60/2").fabrics[0].warp;
        QVERIFY(std::abs(*yarn.linear_density_tex - 2 * 590.5 / 60) < 1e-12 && !yarn.diameter_mm);
        QCOMPARE(yarn.plies, 2);
        QCOMPARE(*yarn.filament_count, 7); // the count names none
        QCOMPARE(*with_value(design, "fabrics[0].warp.count", "150/48 den").fabrics[0].warp.filament_count, 48);
        QCOMPARE(with_value(design, "fabrics[0].weft.count", "\"20 tex\"").fabrics[0].weft.plies, 1); // a single yarn
        // One after the other, in either order.
        const Yarn threefold = with_values(design, {{"fabrics[0].warp.count", "60/2"}, {"fabrics[0].warp.plies", "3"}}).fabrics[0].warp;
        QCOMPARE(threefold.plies, 3);
        const std::string refused = refusal([&] { with_value(design, "fabrics[0].warp.count", "60/2/2"); });
        QVERIFY2(refused.starts_with("fabrics[0].warp.count: \"60/2/2\" is no yarn count"), refused.c_str());
        QVERIFY(refusal([&] { with_value(design, "fabrics[0].warp.count", "30"); }).find("text with its unit") != std::string::npos);
        const Design set = with_value(design, "fabrics[0].weft.count", "14.8 tex x 2");
        QVERIFY(value_at(set, "fabrics[0].weft.count") == ProjectJson("14.8 tex × 2"));
        QVERIFY(value_at(design, "fabrics[0].weft.count").is_null()); // it has a diameter
        QVERIFY(same_place(design, {"fabrics[0].warp.count", "fabrics[0].warp.linear_density_tex"}));
    }
    void theLengthOfAStripeIsNoYarnsCount()
    {
        Design design = parse_project(project(R"("diameter_mm": 0.2)"), "f");
        design.fabrics[0].extra_yarns.push_back(design.fabrics[0].warp);
        design.fabrics[0].warp_order = {{0, 2}, {1, 2}};
        QCOMPARE(with_value(design, "fabrics[0].warp_order[1].count", "5").fabrics[0].warp_order[1].count, 5);
    }

    void setTakesTheUnitOfItsKey_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("value");
        QTest::addColumn<double>("stored");
        QTest::newRow("deg") << "fabrics[0].contact_angle_deg"
                             << "60deg" << 60.0;
        QTest::newRow("degrees") << "fabrics[0].contact_angle_deg"
                                 << "60 degrees" << 60.0;
        QTest::newRow("epi") << "fabrics[0].ends_per_cm"
                             << "60 epi" << 60 / 2.54;
        QTest::newRow("per cm") << "fabrics[0].ends_per_cm"
                                << "60/cm" << 60.0;
        QTest::newRow("micrometres") << "fabrics[0].thickness_mm"
                                     << "450 um" << 0.45;
        QTest::newRow("inches") << "fabrics[0].thickness_mm"
                                << "0.02in" << 0.508;
        QTest::newRow("denier") << "fabrics[0].warp.linear_density_tex"
                                << "90 den" << 10.0;
        QTest::newRow("percent") << "fabrics[0].warp.packing_factor"
                                 << "60 %" << 0.6;
        QTest::newRow("crimp") << "fabrics[0].warp_crimp_percent"
                               << "12 %" << 12.0;
        QTest::newRow("finish") << "fabrics[0].finish_face"
                                << "105°" << 105.0;
        QTest::newRow("depth of a finish") << "fabrics[0].finish_depth"
                                           << "15 %" << 0.15;
        QTest::newRow("gsm") << "fabrics[0].areal_density_g_m2"
                             << "120 gsm" << 120.0;
    }
    void setTakesTheUnitOfItsKey()
    {
        QFETCH(QString, path);
        QFETCH(QString, value);
        QFETCH(double, stored);
        const Design design = parse_project(project(R"("diameter_mm": 0.2)"), "f");
        const Design changed = with_value(design, path.toStdString(), value.toStdString());
        QVERIFY(std::abs(value_at(changed, path.toStdString()).get<double>() / stored - 1) < 1e-12);
    }
    void aForeignUnitIsAnsweredWithTheKeysOwn()
    {
        const Design design = parse_project(project(R"("diameter_mm": 0.2)"), "f");
        const auto said = [&](const char* path, const char* value) {
            return QString::fromStdString(refusal([&] { with_value(design, path, value); }));
        };
        QCOMPARE(said("fabrics[0].ends_per_cm", "60 mm"),
                 QString("fabrics[0].ends_per_cm: This must be a number in /cm; given is \"60 mm\"."));
        QCOMPARE(said("fabrics[0].thickness_mm", "thin"),
                 QString("fabrics[0].thickness_mm: This must be a number in mm; given is \"thin\"."));
        QVERIFY(said("fabrics[0].warp.linear_density_tex", "Ne 30").endsWith("Set count for a count such as Ne 60/2."));
        // The path stands there once, whoever refuses.
        QCOMPARE(said("fabrics[0].ends_per_cmm", "60").count("ends_per_cmm"), 1);
        QCOMPARE(said("fabrics[0].ends_per_cm", "[1]").count("ends_per_cm"), 1);
    }
    void everyUnitGoesBothWays()
    {
        for (int kind = 0; kind <= static_cast<int>(Stored::kg_per_m3); ++kind) {
            const auto& units = trade_units(static_cast<Stored>(kind));
            QCOMPARE(units.front().stored(7.25), 7.25);
            for (const TradeUnit& unit : units) QVERIFY(std::abs(unit.typed(unit.stored(7.25)) - 7.25) < 1e-12);
        }
        QCOMPARE(stored_kind("fibre_diffusivity_m2_s"), Stored::m2_per_second);
        QCOMPARE(stored_kind("rate_g_m2_h"), Stored::g_per_m2_hour);
        QCOMPARE(stored_kind("loop_density_per_mm"), Stored::per_mm);
    }
};

} // namespace tst_yarn_count

QTEST_APPLESS_MAIN(tst_yarn_count::TestYarnCount)
#include "tst_yarn_count.moc"
