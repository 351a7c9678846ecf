// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Zones of the wearer's own, drawn on flat panels: which cells they hold, how these sweat, what the files of it say, what is refused.
#include "core/base/error.h"
#include "core/garment/check_garment.h"
#include "core/project/project_file.h"
#include "core/wear/wear_map.h"
#include "core/wear/wear_outcomes.h"
#include "core/wear/wear_recording.h"
#include "tests/wear/flat_garment.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace hygroloom;

namespace tst_own_zones {
namespace {

constexpr double duration = 30, side = 20e-3; // s, m
const std::size_t of_body = body_zones().size();

/// A rectangle of the tee's front, by shares of its box.
OwnZone patch(const Tee& tee, const std::string& name, double rate, double left, double low, double right, double high)
{
    const auto& panels = tee.parts.pattern.panels;
    const auto front = std::find_if(panels.begin(), panels.end(), [](const PatternPanel& panel) { return panel.name == "front"; });
    WearPanel panel;
    for (const PanelEdge& edge : front->edges) panel.outline.insert(panel.outline.end(), edge.places.begin(), edge.places.end());
    const FlatBox box = panel.box();
    const auto at = [&](double x, double y) -> std::array<double, 2> {
        return {1e3 * (box.left + x * box.width()), 1e3 * (box.low + y * box.height())};
    };
    return {name, "front", {at(left, low), at(right, low), at(right, high), at(left, high)}, rate};
}

bool holds(const OwnZone& rectangle, const GarmentCell& cell)
{
    const auto &low = rectangle.outline_mm[0], &high = rectangle.outline_mm[2];
    const double x = 1e3 * cell.flat[0], y = 1e3 * cell.flat[1];
    return x > low[0] && x < high[0] && y > low[1] && y < high[1];
}

struct Ran {
    WearLayout layout;
    std::vector<WearFrame> frames;
    double delivered() const { return frames.back().ledger.water_delivered; }
};

Ran run(const Tee& tee, const GarmentScene& garment)
{
    Ran ran{wear_layout(tee.parts, garment), {}};
    const std::unique_ptr<Backend> cpu = make_cpu_backend();
    RunControl control;
    run_wear(garment, tee.wear, *cpu, control, {[&](const std::shared_ptr<const WearFrame>& frame) { ran.frames.push_back(*frame); }, {}});
    return ran;
}

std::string refusal_of(const std::function<void()>& act)
{
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

} // namespace

class TestOwnZones : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

private Q_SLOTS:
    void cells_in_the_outline_sweat_at_its_rate()
    {
        Tee tee(duration);
        const GarmentScene plain = tee.scene(side, true, true);
        tee.garment.wearer.own_zones = {patch(tee, "belt", 3000, 0.31, 0.29, 0.69, 0.61)};
        const GarmentScene zoned = tee.scene(side, true, true);
        const int front = plain.cells.front().panel;
        QCOMPARE(zoned.cells.size(), plain.cells.size());
        int inside = 0;
        for (std::size_t i = 0; i < zoned.cells.size(); ++i) {
            const GarmentCell &before = plain.cells[i], &cell = zoned.cells[i];
            const auto crossing = static_cast<std::size_t>(cell.crossing);
            const double rate = zoned.scene.supply.skin.rate[crossing], was = plain.scene.supply.skin.rate[crossing];
            const bool in = tee.parts.pattern.panels[static_cast<std::size_t>(cell.panel)].name == "front" &&
                            holds(tee.garment.wearer.own_zones[0], cell);
            inside += in ? 1 : 0;
            QCOMPARE(cell.zone, in ? static_cast<int>(of_body) : before.zone);
            QCOMPARE(cell.skin_contact, before.skin_contact); // the gap stays
            const double per_hour = 1e3 * 3600 * zoned.scene.climate.density * rate;
            if (in)
                QVERIFY(std::abs(per_hour - 3000) < 1e-6);
            else
                QCOMPARE(rate, was);
        }
        QVERIFY(front >= 0 && inside > 20 && inside < static_cast<int>(zoned.cells.size()) / 4);
    }

    void a_zone_that_sweats_as_the_body_changes_nothing()
    {
        Tee tee(duration);
        tee.parts.sweat.g_m2_h.assign(of_body, 700);
        const Ran plain = run(tee, tee.scene(side, true, true));
        tee.garment.wearer.own_zones = {patch(tee, "as the body", 700, 0.2, 0.2, 0.8, 0.8)};
        const Ran zoned = run(tee, tee.scene(side, true, true));
        for (std::size_t k = 0; k < plain.frames.size(); ++k) {
            QVERIFY(plain.frames[k].inside == zoned.frames[k].inside && plain.frames[k].on_skin == zoned.frames[k].on_skin);
            QVERIFY(plain.frames[k].evaporated == zoned.frames[k].evaporated);
        }
        tee.garment.wearer.own_zones[0].sweat_g_m2_h = 1400;
        const Ran wetter = run(tee, tee.scene(side, true, true));
        double area = 0;
        for (const GarmentCell& cell : wetter.layout.cells)
            if (cell.zone == static_cast<int>(of_body)) area += cell.area;
        const double more = 1e-3 * 700 / 3600 * duration * area; // kg
        QVERIFY(std::abs(wetter.delivered() - plain.delivered() - more) < 1e-6 * more);
    }

    void tables_name_it_and_add_up_to_the_garment()
    {
        Tee tee(duration);
        tee.wear.activity = {{0, 4}};
        tee.garment.wearer.own_zones = {patch(tee, "belt, left", 3000, 0.31, 0.29, 0.69, 0.61)};
        const Ran ran = run(tee, tee.scene(side, true, true));
        WearMetrics metrics(ran.layout);
        for (const WearFrame& frame : ran.frames) metrics.add(frame);
        double area = 0, water = 0;
        for (const WearPart& zone : metrics.zones()) {
            area += zone.area;
            water += zone.course.back().water;
        }
        QCOMPARE(metrics.zones().back().name, std::string("belt, left"));
        QVERIFY(metrics.zones().back().course.back().water > 0);
        QVERIFY(std::abs(area - metrics.all().area) < 1e-9 * area);
        QVERIFY(std::abs(water - metrics.all().course.back().water) < 1e-9 * water);
        QVERIFY(table_of_parts(metrics).find("belt, left") != std::string::npos);
        QVERIFY(wear_csv(ran.layout, ran.frames.back()).find(",\"belt, left\",") != std::string::npos);
    }

    void recordings_keep_its_name()
    {
        Tee tee(duration);
        tee.garment.wearer.own_zones = {patch(tee, "belt", 3000, 0.31, 0.29, 0.69, 0.61)};
        const Ran ran = run(tee, tee.scene(side, true, true));
        const std::string path = folder_.filePath("zones.hygrorec").toStdString();
        {
            WearWriter writer(path, {tee.design, ran.layout, "draft", "cpu", "a CPU", "2026-01-01T00:00:00Z"});
            for (const WearFrame& frame : ran.frames) writer.append(frame);
            writer.finish(1);
        }
        const WearRecording recording{path};
        const WearLayout& layout = recording.record().layout;
        QCOMPARE(layout.own_zones, std::vector<std::string>{"belt"});
        QCOMPARE(layout.zone_names().back(), std::string("belt"));
        for (std::size_t i = 0; i < layout.cells.size(); ++i) QCOMPARE(layout.cells[i].zone, ran.layout.cells[i].zone);
        WearLayout nameless = ran.layout; // its cells name a zone that the file does not
        nameless.own_zones.clear();
        const std::string damaged = folder_.filePath("damaged.hygrorec").toStdString();
        {
            WearWriter writer(damaged, {tee.design, nameless, "draft", "cpu", "a CPU", "2026-01-01T00:00:00Z"});
            for (const WearFrame& frame : ran.frames) writer.append(frame);
            writer.finish(1);
        }
        QVERIFY(refusal_of([&] { WearRecording{damaged}; }).find("no zone") != std::string::npos);
    }

    void the_later_of_two_holds()
    {
        Tee tee(duration);
        tee.garment.wearer.own_zones = {patch(tee, "wide", 100, 0.2, 0.2, 0.8, 0.6), patch(tee, "small", 200, 0.4, 0.3, 0.6, 0.5)};
        int wide = 0, small = 0;
        for (const GarmentCell& cell : tee.scene(side, true, true).cells) {
            wide += cell.zone == static_cast<int>(of_body) ? 1 : 0;
            small += cell.zone == static_cast<int>(of_body) + 1 ? 1 : 0;
            if (cell.zone == static_cast<int>(of_body)) QVERIFY(!holds(tee.garment.wearer.own_zones[1], cell));
        }
        QVERIFY(small > 4 && wide > small);
        std::swap(tee.garment.wearer.own_zones[0], tee.garment.wearer.own_zones[1]); // the wide one lies over all of the other
        QVERIFY2(refusal_of([&] { tee.scene(side, true, true); }).find("\"small\"") != std::string::npos, "it was not refused");
    }

    void a_zone_without_a_cell_is_refused()
    {
        Tee tee(duration);
        OwnZone speck = patch(tee, "speck", 100, 0.513, 0.513, 0.5131, 0.5131);
        tee.garment.wearer.own_zones = {speck};
        const std::string why = refusal_of([&] { tee.scene(side, true, true); });
        QVERIFY2(why.find("\"speck\"") != std::string::npos && why.find("smaller cells") != std::string::npos, why.c_str());
    }

    void rates_over_time_may_name_it()
    {
        QFile file(folder_.filePath("rates.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("time_s,zone,g_m2_h,skin_temperature_c\n0,default,0,34\n0,belt,3600,30\n");
        file.close();
        Tee tee(duration);
        tee.garment.wearer.own_zones = {patch(tee, "belt", 500, 0.31, 0.29, 0.69, 0.61), patch(tee, "other", 720, 0.3, 0.7, 0.7, 0.8)};
        tee.wear.activity_file = "rates.csv";
        const std::filesystem::path base = folder_.path().toStdString();
        tee.parts.course = sweat_course("rates.csv", base, tee.garment.wearer.own_zones);
        QCOMPARE(tee.parts.course->rows, std::size_t{2});
        QCOMPARE(tee.parts.course->named, (std::vector<std::string>{"default", "belt"}));
        const Ran ran = run(tee, tee.scene(side, true, true));
        double belt = 0, other = 0;
        for (const GarmentCell& cell : ran.layout.cells) {
            if (cell.zone == static_cast<int>(of_body)) belt += cell.area;
            if (cell.zone == static_cast<int>(of_body) + 1) other += cell.area;
        }
        const double kg = 1e-3 / 3600 * duration * (3600 * belt + 720 * other); // "default" stands for the body's zones alone
        QVERIFY2(std::abs(ran.delivered() - kg) < 1e-6 * kg, qPrintable(QString("%1 %2").arg(ran.delivered()).arg(kg)));
        QVERIFY(std::abs(ran.layout.skin_temperature_at(static_cast<int>(of_body), 1) - 303.15) < 1e-9);
        QVERIFY(refusal_of([&] { sweat_course("rates.csv", base); }).find("There is no zone \"belt\"") != std::string::npos);
    }

    void projects_hold_it()
    {
        Tee tee(duration);
        Design design = tee.design;
        tee.garment.wearer.own_zones = {{"belt", "front", {{0, 0}, {100.5, 0}, {50, 80}}, 420}};
        design.garments.push_back(tee.garment);
        design.wears.push_back(tee.wear);
        QVERIFY(!has_error(validate(design)));
        const std::string text = format_project(design);
        QVERIFY(parse_project(text, "a test") == design);
        const auto refused = [&](const std::string& from, const std::string& to) {
            std::string wrong = text;
            const std::size_t at = wrong.find(from);
            if (at == std::string::npos) return std::string("not there");
            return refusal_of([&] { parse_project(wrong.replace(at, from.size(), to), "a test"); });
        };
        QVERIFY2(refused("\"sweat_g_m2_h\"", "\"sweat_g_m2\"").find("garments[0].wearer.own_zones[0]") != std::string::npos,
                 refused("\"sweat_g_m2_h\"", "\"sweat_g_m2\"").c_str());
        QVERIFY2(refused("420.0", "\"much\"").find("sweat_g_m2_h") != std::string::npos, refused("420.0", "\"much\"").c_str());
        QVERIFY2(refused("100.5", "\"x\"").find("outline_mm") != std::string::npos, refused("100.5", "\"x\"").c_str());
        QVERIFY2(refused("\"own_zones\"", "\"own_zone\"").find("own_zone") != std::string::npos, "it was read");
    }

    void mistakes_are_named_with_their_place_data()
    {
        QTest::addColumn<int>("what");
        QTest::addColumn<QString>("where");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("no name") << 0 << "own_zones[0].name"
                                 << "The name of a zone is empty; give one.";
        QTest::newRow("of the body") << 1 << "own_zones[0].name"
                                     << "\"chest\" is a zone of the body";
        QTest::newRow("twice") << 2 << "own_zones[1].name"
                               << "There are two own zones \"belt\"";
        QTest::newRow("no panel") << 3 << "own_zones[0].panel"
                                  << "name one of the garment's";
        QTest::newRow("rate") << 4 << "own_zones[0].sweat_g_m2_h"
                              << "must be from 0 to 100000 g/(m2 h); given is -1";
        QTest::newRow("places") << 5 << "own_zones[0].outline_mm"
                                << "from 3 to 1000 places; given are 2";
        QTest::newRow("far") << 6 << "own_zones[0].outline_mm[2][1]"
                             << "must be from -100000 to 100000 mm; given is 200000";
        QTest::newRow("many") << 7 << "own_zones"
                              << "at most 100 own zones; given are 101";
    }
    void mistakes_are_named_with_their_place()
    {
        QFETCH(int, what);
        QFETCH(QString, where);
        QFETCH(QString, sentence);
        Tee tee(duration);
        const OwnZone good{"belt", "front", {{0, 0}, {100, 0}, {50, 80}}, 420};
        std::vector<OwnZone>& zones = tee.garment.wearer.own_zones = {good};
        switch (what) {
        case 0: zones[0].name.clear(); break;
        case 1: zones[0].name = "chest"; break;
        case 2: zones.push_back(good); break;
        case 3: zones[0].panel.clear(); break;
        case 4: zones[0].sweat_g_m2_h = -1; break;
        case 5: zones[0].outline_mm.pop_back(); break;
        case 6: zones[0].outline_mm[2][1] = 2e5; break;
        default:
            for (int k = 0; k < 100; ++k) {
                zones.push_back(good);
                zones.back().name = "zone " + std::to_string(k);
            }
        }
        Design design = tee.design;
        design.garments.push_back(tee.garment);
        const std::vector<Issue> issues = validate(design);
        const std::string at = "garments[0].wearer." + where.toStdString();
        QVERIFY(std::any_of(issues.begin(), issues.end(), [&](const Issue& issue) {
            return issue.severity == Severity::error && issue.where.text() == at &&
                   issue.text().find(sentence.toStdString()) != std::string::npos;
        }));
    }

    void what_the_pattern_lacks_is_told()
    {
        Tee tee(duration);
        const auto told = [&](const OwnZone& zone) {
            Garment garment = tee.garment;
            garment.wearer.own_zones = {zone};
            const std::vector<Issue> issues = misnamed_in(garment, tee.parts.pattern, Place("garments") / std::size_t{0});
            return issues.size() == 1 ? issues[0].where.text() + ": " + issues[0].text() : std::to_string(issues.size());
        };
        const OwnZone good = patch(tee, "belt", 420, 0.31, 0.29, 0.69, 0.61);
        QCOMPARE(told(good), std::string("0"));
        OwnZone zone = good;
        zone.panel = "frotn";
        QVERIFY2(told(zone).starts_with("garments[0].wearer.own_zones[0].panel: The pattern has no panel \"frotn\""), told(zone).c_str());
        zone = patch(tee, "beside", 420, 1.2, 0.3, 1.4, 0.6);
        QVERIFY2(told(zone).find("outline_mm: The zone \"beside\" lies beside the panel \"front\"") != std::string::npos,
                 told(zone).c_str());
        zone = good;
        std::swap(zone.outline_mm[0], zone.outline_mm[1]);
        QVERIFY2(told(zone).find("crosses itself") != std::string::npos, told(zone).c_str());
    }
};

} // namespace tst_own_zones

QTEST_GUILESS_MAIN(tst_own_zones::TestOwnZones)
#include "tst_own_zones.moc"
