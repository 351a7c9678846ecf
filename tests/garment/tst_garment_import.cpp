// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments' patterns: files in both dialects, built-in garments, the body and its sweat.
#include "core/base/random.h"
#include "core/base/units.h"
#include "core/design/validate.h"
#include "core/garment/body.h"
#include "core/garment/fill.h"
#include "core/garment/sweat_table.h"
#include "tests/garment/folded.h"

#include <QTemporaryDir>
#include <QTest>

#include <functional>

using namespace hygroloom;

namespace {

/// A pattern of one square of 200 mm and one beside it, 300 mm behind. more: keys of the first's first edge, last: of the file.
std::string squares(const std::string& more = {},
                    const std::string& stitches = "[[{\"panel\": \"a\", \"edge\": 1}, {\"panel\": \"b\", \"edge\": 3}]]",
                    const std::string& last = {})
{
    const std::string corners = "\"vertices\": [[0, 0], [20, 0], [20, 20], [0, 20]]";
    const std::string edges = "{\"endpoints\": [1, 2]}, {\"endpoints\": [2, 3]}, {\"endpoints\": [3, 0]}]";
    return "{\"pattern\": {\"panels\": {\"a\": {\"translation\": [0, 100, 15], \"rotation\": [0, 0, 0], " + corners +
           ", \"edges\": [{\"endpoints\": [0, 1]" + more + "}, " + edges +
           "}, \"b\": {\"translation\": [20, 100, -15], \"rotation\": [0, 180, 0], " + corners + ", \"edges\": [{\"endpoints\": [0, 1]}, " +
           edges + "}}, \"stitches\": " + stitches + "}, \"properties\": {\"units_in_meter\": 100}" + last + "}";
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const auto at = text.find(from);
    if (at == std::string::npos) qFatal("no %s", from.c_str());
    return text.replace(at, from.size(), to);
}

GarmentPattern read(const std::string& text) { return pattern_from_json(text, "test.json"); }

GarmentPattern built_in(const std::string& kind)
{
    Garment garment;
    garment.built_in = standard_garment(kind);
    return read_pattern(garment, {});
}

double signed_area(const PatternPanel& panel)
{
    double twice = 0;
    for (const PanelEdge& edge : panel.edges)
        for (std::size_t i = 1; i < edge.places.size(); ++i)
            twice += edge.places[i - 1][0] * edge.places[i][1] - edge.places[i - 1][1] * edge.places[i][0];
    return 0.5 * twice;
}

/// Which zones a panel's places lie on, in the table's order.
std::string zones_of(const GarmentPattern& pattern, const std::string& name)
{
    std::vector<int> counts(body_zones().size());
    for (std::size_t t = 0; t < pattern.shape.triangles.size(); ++t) {
        const int panel = pattern.shape.panel[t];
        if (pattern.panels[static_cast<std::size_t>(panel)].name != name) continue;
        ++counts[static_cast<std::size_t>(
            zone_at(pattern, panel, pattern.shape.places[static_cast<std::size_t>(pattern.shape.triangles[t][0])]))];
    }
    std::string zones;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 20) zones += (zones.empty() ? "" : ", ") + body_zones()[i];
    return zones;
}

Design dressed()
{
    Design design;
    Fabric fabric;
    fabric.name = "cloth";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    design.fabrics.push_back(fabric);
    Garment garment;
    garment.name = "tee";
    garment.panels["*"].fabric = "cloth";
    design.garments.push_back(garment);
    return design;
}

using Change = std::function<void(Garment&)>;

} // namespace

Q_DECLARE_METATYPE(Change)

class TestGarmentImport : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void publishedPatternsHaveTheirAreas()
    {
        const GarmentPattern shirt = read_pattern(from_file(garments + "shirt_mean.json"), {}),
                             tee = read_pattern(from_file("tee.json"), garments);
        QVERIFY(std::abs(area_of(shirt) / 0.63962 - 1) < 1e-3);
        QVERIFY(std::abs(area_of(tee) / 0.57750 - 1) < 1e-3);
        QCOMPARE(shirt.panels.size(), std::size_t(8));
        QCOMPARE(shirt.seams.size(), std::size_t(18));
        QCOMPARE(tee.panels.size(), std::size_t(6));
        QCOMPARE(tee.seams.size(), std::size_t(12));
        for (const GarmentPattern* pattern : {&shirt, &tee}) {
            QVERIFY2(pattern->issues.empty(), all_issues(*pattern).c_str());
            for (const PatternPanel& panel : pattern->panels) QVERIFY2(signed_area(panel) > 0, panel.name.c_str());
            for (const PatternSeam& seam : pattern->seams) QVERIFY(seam.reversed); // all face outwards
        }
        QCOMPARE(QString::fromStdString(zones_of(shirt, "left_ftorso")), QString("chest, abdomen"));
        QCOMPARE(QString::fromStdString(zones_of(shirt, "right_btorso")), QString("back, buttocks"));
        QCOMPARE(QString::fromStdString(zones_of(shirt, "left_sleeve_b")), QString("upper arm, forearm"));
        QCOMPARE(QString::fromStdString(zones_of(tee, "rfsleeve")), QString("upper arm"));
        QCOMPARE(QString::fromStdString(zones_of(tee, "back")), QString("back, buttocks"));
    }
    void curvesAreThoseOfBothDialects_data()
    {
        QTest::addColumn<QString>("curvature");
        QTest::addColumn<double>("more"); // m2 than the square of 0.2 m
        const double r = 0.1;
        QTest::newRow("older") << "[0.5, -0.3]" << 2.0 / 3 * 0.5 * 0.2 * 0.06; // of a parabola, to the right
        QTest::newRow("quadratic") << "{\"type\": \"quadratic\", \"params\": [[0.5, -0.3]]}" << 2.0 / 3 * 0.5 * 0.2 * 0.06;
        QTest::newRow("inwards") << "[0.5, 0.3]" << -2.0 / 3 * 0.5 * 0.2 * 0.06;
        QTest::newRow("cubic") << "{\"type\": \"cubic\", \"params\": [[0.25, -0.3], [0.75, -0.3]]}"
                               << 0.04 * 0.1575; // 0.675 t(1-t) (1 + 2 t(1-t)) from 0 to 1
        QTest::newRow("half circle") << "{\"type\": \"circle\", \"params\": [10, 0, 1]}" << 0.5 * pi * r * r;
        QTest::newRow("to the left") << "{\"type\": \"circle\", \"params\": [20, 0, 0]}" << -0.04 * (pi / 3 - std::sin(pi / 3)) / 2;
        QTest::newRow("larger arc") << "{\"type\": \"circle\", \"params\": [20, 1, 1]}" << 0.04 * (2 * pi - pi / 3 + std::sin(pi / 3)) / 2;
    }
    void curvesAreThoseOfBothDialects()
    {
        QFETCH(QString, curvature);
        QFETCH(double, more);
        const GarmentPattern pattern = read(squares(", \"curvature\": " + curvature.toStdString()));
        const double found = area_of(pattern.panels[0]) - 0.04;
        QVERIFY2(std::abs(found - more) < 1e-4 * std::abs(more) + 2e-5 * 0.3, QByteArray::number(found - more));
    }
    void absoluteControlPointsAreTheSameCurve()
    {
        const std::string absolute = replaced(squares(", \"curvature\": [10, -6]"), "100}", "100, \"curvature_coords\": \"absolute\"}");
        QVERIFY(std::abs(area_of(read(absolute).panels[0]) - area_of(read(squares(", \"curvature\": [0.5, -0.3]")).panels[0])) < 1e-12);
    }
    void clockwisePanelsAreSeenFromOutside()
    {
        std::string text = squares(", \"curvature\": [0.3, 0.2]");
        const std::string corners = "[[0, 0], [20, 0], [20, 20], [0, 20]]";
        text = replaced(text, corners, "[[0, 0], [0, 20], [20, 20], [20, 0]]"); // the first panel goes round the other way
        const PatternPanel panel = read(text).panels[0];
        QVERIFY(signed_area(panel) > 0);
        const FlatPlace& corner = panel.edges[1].places.back();
        const Vec3d at = panel.placed[0] + corner[0] * panel.placed[1] + corner[1] * panel.placed[2];
        QVERIFY(length(at - Vec3d{0.2, 1.2, 0.15}) < 1e-12);
        QVERIFY(cross(panel.placed[1], panel.placed[2]).z < 0); // it faces backwards
    }
    void turnsAreAboutTheRoomsAxesInTheirOrder()
    {
        const PatternPanel panel = read(replaced(squares(), "[0, 0, 0], \"vertices\"", "[90, 0, 90], \"vertices\"")).panels[0];
        QVERIFY(length(panel.placed[1] - Vec3d{0, 1, 0}) < 1e-12); // x goes to y
        QVERIFY(length(panel.placed[2] - Vec3d{0, 0, 1}) < 1e-12); // y goes to z, which the last turn leaves
    }
    void seamsRunAsTheirPlacesSay()
    {
        const GarmentPattern sewn = read(squares());
        QCOMPARE(sewn.seams.size(), std::size_t(1));
        QVERIFY(sewn.seams[0].reversed);
        const auto turned = [](const std::string& stitches, bool placed) {
            std::string text = squares({}, stitches);
            for (const char* place : {"\"translation\": [0, 100, 15], ", "\"translation\": [20, 100, -15], "})
                if (!placed) text = replaced(text, place, "");
            return read(text).seams;
        };
        const std::string pair = "{\"panel\": \"a\", \"edge\": 1}, {\"panel\": \"b\", \"edge\": 3}";
        QVERIFY(turned("[[" + pair + "]]", false).at(0).reversed);
        QVERIFY(!turned("[[" + pair + ", \"right_wrong\"]]", false).at(0).reversed);
        QVERIFY(turned("[[" + pair + ", \"right_wrong\"]]", true).at(0).reversed); // it lies so
        const auto lists =
            turned("[[[{\"panel\": \"a\", \"edge\": 1}, {\"panel\": \"a\", \"edge\": 0}], [{\"panel\": \"b\", \"edge\": 3}, {\"panel\": "
                   "\"b\", \"edge\": 0}]]]",
                   true);
        QCOMPARE(lists.size(), std::size_t(2));
        QCOMPARE(lists[1].edge_a, 0);
        QCOMPARE(lists[1].edge_b, 0);
    }
    void odditiesAreTold_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const std::string& text, const char* says) {
            QTest::newRow(name) << QString::fromStdString(text) << QString(says);
        };
        const std::string good = squares();
        row("open", replaced(good, ", {\"endpoints\": [2, 3]}", ""), "\"a\" is open by 200 mm");
        row("turned edge", replaced(good, "{\"endpoints\": [1, 2]}", "{\"endpoints\": [2, 1]}"), "runs against the others");
        row("crossing", replaced(good, "[[0, 0], [20, 0], [20, 20], [0, 20]]", "[[0, 0], [20, 20], [20, 0], [0, 25]]"),
            "\"a\" crosses itself");
        row("edge that crosses itself", squares(", \"curvature\": {\"type\": \"cubic\", \"params\": [[2, -1], [-1, -1]]}"),
            "\"a\" crosses itself");
        row("no length", replaced(good, "{\"endpoints\": [0, 1]}", "{\"endpoints\": [0, 0]}, {\"endpoints\": [0, 1]}"), "has no length");
        row("no area", replaced(good, "[[0, 0], [20, 0], [20, 20], [0, 20]]", "[[0, 0], [20, 0], [30, 0], [5, 0]]"), "\"a\" has no area");
        row("unknown key", squares(", \"colour\": 3"), "The key \"colour\" of an edge");
        row("unknown key of the file", squares({}, "[]", ", \"zip\": 3"), "The key \"zip\" of the file");
        row("no such panel", squares({}, "[[{\"panel\": \"c\", \"edge\": 1}, {\"panel\": \"b\", \"edge\": 3}]]"),
            "goes to the panel \"c\"");
        row("no such edge", squares({}, "[[{\"panel\": \"a\", \"edge\": 4}, {\"panel\": \"b\", \"edge\": 3}]]"),
            "edge 4 of the panel \"a\", which has 4");
        row("one side", squares({}, "[[{\"panel\": \"a\", \"edge\": 1}]]"), "has 1 sides");
        row("to itself", squares({}, "[[{\"panel\": \"a\", \"edge\": 1}, {\"panel\": \"a\", \"edge\": 1}]]"), "an edge to itself");
        row("other lengths", squares(", \"curvature\": [0.5, -3]", "[[{\"panel\": \"a\", \"edge\": 0}, {\"panel\": \"b\", \"edge\": 3}]]"),
            "edges of different length");
        row("no unit", replaced(good, "\"units_in_meter\": 100", ""), "centimetres were taken");
        row("no stitches", replaced(good, "\"stitches\"", "\"sewn\""), "nothing is sewn");
    }
    void odditiesAreTold()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const GarmentPattern pattern = read(text.toStdString());
        QVERIFY2(tells(pattern, says.toStdString()), all_issues(pattern).c_str());
        GarmentPattern shaped = pattern;
        make_flat_shape(shaped); // whatever the outline
        QVERIFY(read(squares()).issues.empty());
    }
    void whatIsNoPatternIsRefusedWithItsPlace_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const std::string& text, const char* says) {
            QTest::newRow(name) << QString::fromStdString(text) << QString(says);
        };
        const std::string good = squares();
        row("empty", "{}", "test.json: This is no sewing pattern: it has no \"pattern\"; it is empty.");
        row("a list", "[]", "This is no sewing pattern");
        row("no panels", "{\"pattern\": {\"panels\": {}}}", "no panel with an area");
        row("a wrong end", replaced(good, "[1, 2]", "[1, 4]"),
            "pattern.panels.a.edges[1].endpoints[1]: This must be a whole number from 0 to 3; given is 4");
        row("a wrong unit", replaced(good, "\"units_in_meter\": 100", "\"units_in_meter\": 0"), "from 1 to 100000; given is 0");
        row("too large", replaced(good, "[20, 20]", "[20, 2e9]"), "vertices[2][1]: This must be from -2000 to 2000");
        row("no number", replaced(good, "[20, 20]", "[20, \"20\"]"), "vertices[2][1]: This must be a number");
        row("a wrong curve", squares(", \"curvature\": {\"type\": \"spline\", \"params\": [1]}"), "\"quadratic\", \"cubic\" or \"circle\"");
        row("too few", squares(", \"curvature\": {\"type\": \"cubic\", \"params\": [[0.5, 0.5]]}"),
            "A cubic edge has 2 of them; given are 1");
        row("no radius", squares(", \"curvature\": {\"type\": \"circle\", \"params\": [0, 0, 0]}"), "The radius must be more than 0");
    }
    void whatIsNoPatternIsRefusedWithItsPlace()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const std::string message = refusal_of([&] { read(text.toStdString()); });
        QVERIFY2(message.find(says.toStdString()) != std::string::npos, message.c_str());
    }
    void changedBytesAreReadOrRefused()
    {
        const std::string good = bytes_of(garments + "tee.json");
        std::uint64_t drawn = 0;
        const auto random = [&drawn] { return random_bits(7, 0, drawn++); };
        int refused = 0;
        for (int i = 0; i < 300; ++i) {
            std::string text = good;
            for (int k = 0; k < 3; ++k) text[static_cast<std::size_t>(random() % text.size())] = "0123456789.-e,[]{}\"x"[random() % 20];
            refused += !refusal_of([&] { read(text); }).empty();
        }
        QVERIFY(refused > 20 && refused < 300);
    }
    void trianglesCoverThePanels()
    {
        for (const GarmentPattern& pattern :
             {read_pattern(from_file(garments + "shirt_mean.json"), {}), built_in("tee"), built_in("leggings")}) {
            std::vector<double> covered(pattern.panels.size());
            for (std::size_t t = 0; t < pattern.shape.triangles.size(); ++t) {
                const auto at = [&](std::size_t k) { return pattern.shape.flat[static_cast<std::size_t>(pattern.shape.triangles[t][k])]; };
                const FlatPlace a = at(0), b = at(1), c = at(2);
                const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
                QVERIFY(area > 0);
                covered[static_cast<std::size_t>(pattern.shape.panel[t])] += area;
            }
            for (std::size_t p = 0; p < covered.size(); ++p) QVERIFY(std::abs(covered[p] / area_of(pattern.panels[p]) - 1) < 1e-9);
        }
    }
    void builtInGarmentsUnrollToClosedForms()
    {
        const GarmentPattern tee = built_in("tee"), singlet = built_in("singlet"), leggings = built_in("leggings");
        const double w = 0.54, l = 0.7, a = 0.09, e = 0.05, d = 0.2; // half girth, length, armhole: width, round, depth
        const double bodice = w * l - 2 * (pi * a * e / 4 + a * (d - e)),
                     armhole = a * std::comp_ellint_2(std::sqrt(1 - e * e / (a * a))) + d - e;
        QVERIFY(std::abs(area_of(tee.panels[0]) / (bodice - pi * 0.09 * 0.09 / 2) - 1) < 1e-4);
        QVERIFY(std::abs(area_of(tee.panels[1]) / (bodice - pi * 0.09 * 0.02 / 2) - 1) < 1e-4);
        QVERIFY(std::abs(area_of(tee.panels[2]) / (0.5 * (1 + 0.85) * 2 * armhole * 0.22) - 1) < 1e-4);
        QCOMPARE(tee.seams.size(), std::size_t(10));
        const double girth = 1.02, rise = body::waist - body::crotch;
        QVERIFY(std::abs(area_of(leggings) / (girth * rise + (0.5 * girth + 0.24) * (1 - rise)) - 1) < 1e-4);
        QCOMPARE(singlet.panels.size(), std::size_t(2));
        for (const GarmentPattern* pattern : {&tee, &singlet, &leggings}) {
            QVERIFY(pattern->is_draped && pattern->issues.empty());
            for (const PatternSeam& seam : pattern->seams) {
                const auto length = [&](int panel, int edge) {
                    return perimeter_of(
                        {"", {pattern->panels[static_cast<std::size_t>(panel)].edges[static_cast<std::size_t>(edge)]}, {}, false});
                };
                QVERIFY(std::abs(length(seam.panel_a, seam.edge_a) - length(seam.panel_b, seam.edge_b)) < 1e-4);
            }
        }
    }
    void builtInGarmentsAreNotStretched()
    {
        for (const char* kind : {"tee", "singlet", "leggings"}) {
            const GarmentPattern pattern = built_in(kind);
            const GarmentShape& shape = pattern.shape;
            for (const auto& triangle : shape.triangles)
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto a = static_cast<std::size_t>(triangle[k]), b = static_cast<std::size_t>(triangle[(k + 1) % 3]);
                    const double flat = std::hypot(shape.flat[a][0] - shape.flat[b][0], shape.flat[a][1] - shape.flat[b][1]);
                    const double chord = length(shape.places[a] - shape.places[b]);
                    // A chord of a curve of radius r is shorter by s^2 / 24 r^2; ankles are the narrowest, with 38 mm.
                    QVERIFY(chord <= flat * (1 + 1e-9) && chord > flat * (1 - flat * flat / (23 * 0.038 * 0.038)));
                }
        }
    }
    void builtInNumbersMoveTheGarment()
    {
        const auto area = [](auto change) {
            Garment garment;
            change(garment.built_in);
            return area_of(read_pattern(garment, {}));
        };
        const double usual = area([](BuiltInGarment&) {});
        for (double BuiltInGarment::*number :
             {&BuiltInGarment::chest_mm, &BuiltInGarment::length_mm, &BuiltInGarment::ease_mm, &BuiltInGarment::sleeve_mm})
            QVERIFY(area([&](BuiltInGarment& garment) { garment.*number *= 1.1; }) > 1.001 * usual);
        for (const auto& [chest, length, ease, sleeve] :
             {std::array{500.0, 300.0, 0.0, 50.0}, std::array{2000.0, 300.0, 800.0, 50.0}, std::array{500.0, 1200.0, 800.0, 700.0}})
            for (const char* kind : {"tee", "singlet"}) {
                Garment garment;
                garment.built_in = {kind, chest, length, ease, sleeve};
                const GarmentPattern pattern = read_pattern(garment, {});
                QVERIFY(pattern.issues.empty());
                for (const Vec3d& place : pattern.shape.places) QVERIFY(std::isfinite(place.x + place.y + place.z));
            }
    }
    void zonesFollowTheBody()
    {
        const GarmentPattern tee = built_in("tee"), leggings = built_in("leggings");
        QVERIFY(zones_of(tee, "front").starts_with("chest, abdomen"));
        QVERIFY(zones_of(tee, "back").starts_with("back, buttocks"));
        QCOMPARE(QString::fromStdString(zones_of(tee, "left sleeve")), QString("upper arm"));
        QCOMPARE(QString::fromStdString(zones_of(leggings, "left leg")), QString("thigh, shin"));
        QCOMPARE(QString::fromStdString(zones_of(leggings, "back")), QString("buttocks"));
        Garment garment;
        garment.wearer.gap_mm = {{"default", 5}, {"chest", 4}, {"shoulder", 0}};
        QCOMPARE(gap_at(garment, tee, 0, {0.1, 1.42, 0.05}), 0.0);
        QCOMPARE(gap_at(garment, tee, 0, {0.1, 1.25, 0.05}), 4.0);
        QCOMPARE(gap_at(garment, tee, 1, {0.1, 1.25, -0.05}), 5.0);
    }
    void namesGiveZonesWhereNothingIsPlaced()
    {
        std::string text = squares();
        for (const char* place : {"\"translation\": [0, 100, 15], ", "\"translation\": [20, 100, -15], "}) text = replaced(text, place, "");
        for (const auto& [name, zone] : {std::pair("left_sleeve", "upper arm"), std::pair("Back", "back"), std::pair("front", "chest"),
                                         std::pair("left leg", "thigh")}) {
            GarmentPattern pattern = read(replaced(text, "\"a\": {", "\"" + std::string(name) + "\": {"));
            make_flat_shape(pattern);
            find_body(pattern);
            QCOMPARE(body_zones()[static_cast<std::size_t>(zone_at(pattern, 0, {}))], std::string(zone));
        }
    }
    void sweatTablesAreShippedOrRead()
    {
        const SweatTable exercise = sweat_table("taylor-2013 exercise", {}), rest = sweat_table("taylor-2013 rest", {});
        QCOMPARE(exercise.g_m2_h, (std::vector<double>{1470, 842, 632, 995, 332, 364, 556, 877, 1111, 424, 532, 278, 559}));
        QCOMPARE(rest.g_m2_h, (std::vector<double>{293, 236, 208, 338, 240, 150, 222, 187, 297, 107, 113, 144, 223}));
        QVERIFY(exercise.measured && exercise.source.find("10.1186/2046-7648-2-4") != std::string::npos);
        QTemporaryDir folder;
        const std::filesystem::path base = folder.path().toStdString();
        const auto table = [&](const std::string& rows) {
            write_bytes(base / "own.csv", "zone,g_m2_h\n" + rows);
            return sweat_table("own.csv", base);
        };
        const SweatTable own = table("chest,500\ndefault,80.5\n");
        QCOMPARE(own.g_m2_h[1], 500.0);
        QCOMPARE(own.g_m2_h[3], 80.5);
        QVERIFY(!own.measured);
        for (const auto& [rows, says] :
             {std::pair("chest,500\n", "Zones are missing: head, abdomen"), std::pair("chest,500\nchest,1\ndefault,1\n", "stands twice"),
              std::pair("chst,500\n", "did you mean \"chest\""),
              std::pair("chest,-1\n", "line 2: g_m2_h must be from 0 to 100000; given is -1"),
              std::pair("chest,x\n", "must be a number")}) {
            const std::string message = refusal_of([&, rows = rows] { table(rows); });
            QVERIFY2(message.find(says) != std::string::npos, message.c_str());
        }
        QVERIFY(!refusal_of([&] { sweat_table("none.csv", base); }).empty());
    }
    void cutsSeamsAndGapsAreFoundByTheirNames()
    {
        Garment garment;
        QVERIFY(!garment.cut_of("front"));
        garment.panels = {{"front", {"a", 0, false}}, {"*", {"b", 0, false}}};
        garment.seams = {{"front|back", 0}, {"default", 0.5}};
        QCOMPARE(garment.cut_of("front")->fabric, std::string("a"));
        QCOMPARE(garment.cut_of("sleeve")->fabric, std::string("b"));
        QCOMPARE(garment.seam_between("back", "front"), 0.0);
        QCOMPARE(garment.seam_between("front", "sleeve"), 0.5);
        QCOMPARE(Garment().seam_between("front", "back"), 1.0);
        QCOMPARE(garment.gap_of("chest"), 3.0);
        garment.wearer.gap_mm = {};
        QCOMPARE(garment.gap_of("chest"), 3.0);
    }
    void wrongGarmentsAreRefused_data()
    {
        QTest::addColumn<QString>("where");
        QTest::addColumn<QString>("says");
        QTest::addColumn<Change>("change");
        const auto row = [](const char* where, const char* says, Change change) {
            QTest::newRow(where) << QString(where) << QString(says) << change;
        };
        row("name", "empty", [](Garment& g) { g.name.clear(); });
        row("source.chest_mm", "from 500 to 2000 mm; given is 400", [](Garment& g) { g.built_in.chest_mm = 400; });
        row("source.length_mm", "from 300 to 1200 mm", [](Garment& g) { g.built_in.length_mm = NAN; });
        row("source.ease_mm", "from 0 to 800 mm", [](Garment& g) { g.built_in.ease_mm = -1; });
        row("source.sleeve_mm", "from 50 to 700 mm", [](Garment& g) { g.built_in.sleeve_mm = 10; });
        row("source.built_in", "no built-in garment \"coat\"", [](Garment& g) { g.built_in.kind = "coat"; });
        row("uv_unit", "leave uv_unit out of a built-in garment", [](Garment& g) { g.uv_unit = UvUnit::metre; });
        row("panels", "needs a fabric", [](Garment& g) { g.panels.clear(); });
        row("panels.*.fabric", "no fabric \"clot\"; did you mean \"cloth\"", [](Garment& g) { g.panels["*"].fabric = "clot"; });
        row("panels.*.grain_deg", "from -360 to 360", [](Garment& g) { g.panels["*"].grain_deg = 400; });
        row("seams.front", "\"panel|panel\"", [](Garment& g) { g.seams["front"] = 1; });
        row("seams.a|b", "from 0 to 1; given is 2", [](Garment& g) { g.seams["a|b"] = 2; });
        row("wearer.skin_temperature_c", "from 10 to 45 C", [](Garment& g) { g.wearer.skin_temperature_c = 50; });
        row("wearer.gap_mm.chst", "did you mean \"chest\"", [](Garment& g) { g.wearer.gap_mm["chst"] = 1; });
        row("wearer.gap_mm.chest", "from 0 to 100 mm", [](Garment& g) { g.wearer.gap_mm["chest"] = 101; });
        row("wearer.zones", "no table of sweat rates \"taylor\"", [](Garment& g) { g.wearer.zones = "taylor"; });
    }
    void wrongGarmentsAreRefused()
    {
        QFETCH(QString, where);
        QFETCH(QString, says);
        QFETCH(Change, change);
        Design design = dressed();
        QVERIFY(validate(design).empty());
        change(design.garments[0]);
        std::string found;
        for (const Issue& issue : validate(design))
            if (issue.severity == Severity::error) found += issue.where.text() + ": " + issue.text() + "\n";
        QVERIFY2(found.find("garments[0]." + where.toStdString() + ": ") != std::string::npos, found.c_str());
        QVERIFY2(found.find(says.toStdString()) != std::string::npos, found.c_str());
    }
};

QTEST_APPLESS_MAIN(TestGarmentImport)
#include "tst_garment_import.moc"
