// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Yarn paths and sections: smooth, within the thickness, and out of each other's way.
#include "core/base/units.h"
#include "core/design/validate.h"
#include "core/geometry/mesh.h"
#include "core/geometry/textile.h"
#include "core/project/library.h"
#include "core/project/project_file.h"
#include "tests/geometry/overlap.h"

#include <QTest>

#include <set>

using namespace hygroloom;

namespace {

Design example(const QString& name)
{
    return read_project((QString(HYGROLOOM_SOURCE_DIR "/resources/examples/") + name + ".hygro").toStdString());
}

} // namespace

class TestTextile : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatActsInTheClosurePoresReachesTheYarns()
    {
        Design design = example("textile-F");
        Fabric& fabric = design.fabrics[0];
        Material fibre = *find_library_material("polyester");
        fibre.name = "channels";
        fibre.based_on = "polyester";
        fibre.cross_section = {1.25, {}};
        design.materials.push_back(fibre);
        fabric.warp.material = {{"channels", 1.0}};
        fabric.warp.irregularity_cv = 0.14;
        fabric.warp.diameter_mm = 0.2;
        fabric.warp.linear_density_tex.reset();
        fabric.warp.twist_per_m = 800;
        fabric.contact_angle_deg = 50;
        fabric.finish_back = 110;
        fabric.measured.tortuosity.reset();
        const Textile derived = build_textile(design, fabric, {0, 0, 4, 4});
        const YarnType& warp = derived.warp.types[0];
        QCOMPARE(warp.contact_angle, radian_from_degree(50));
        QCOMPARE(warp.receding_angle, radian_from_degree(30));
        QCOMPARE(derived.weft.types[0].receding_angle, 0.0); // cotton
        QCOMPARE(warp.perimeter_factor, 1.25);
        QCOMPARE(warp.unevenness.cv, 0.14);
        QVERIFY(derived.weft.types[0].unevenness.cv > 0.1); // as is usual of cotton
        QVERIFY(std::abs(warp.helix_tortuosity - 1.1263) < 5e-5);
        QCOMPARE(warp.tortuosity, 1.2); // of the closure paper
        QVERIFY(!derived.face_angle);
        QCOMPARE(*derived.back_angle, radian_from_degree(110));
        fabric.measured.tortuosity = 1.7;
        QCOMPARE(build_textile(design, fabric, {0, 0, 4, 4}).warp.types[0].helix_tortuosity, 1.7);
    }
    void countedFilamentsSayHowThickTheyAre()
    {
        Design design = example("textile-F");
        Fabric& fabric = design.fabrics[0];
        Material fibre = *find_library_material("polyester");
        fibre.name = "of 1380 kg/m3";
        fibre.based_on = "polyester";
        fibre.density_kg_m3 = 1380;
        design.materials.push_back(fibre);
        fabric.warp.material = {{fibre.name, 1.0}};
        fabric.warp.diameter_mm.reset();
        fabric.warp.linear_density_tex = tex_from_denier(150);
        fabric.warp.filament_count = 48;
        const YarnType warp = build_textile(design, fabric, {0, 0, 4, 4}).warp.types[0];
        // The trade's formula for round filaments: diameter in um = 11.89 (denier over g/cm3)^1/2, to its last digit.
        QVERIFY(std::abs(2 * warp.fibre.fibre_radius_um / std::sqrt(150.0 / 48 / 1.38) - 11.89) < 5e-3);
        QCOMPARE(warp.pore_radius, metre_from_um(warp.fibre.fibre_radius_um) * (1 - warp.packing) / warp.packing);
        fabric.warp.filament_count = 192; // four times as many: half as thick
        QCOMPARE(build_textile(design, fabric, {0, 0, 4, 4}).warp.types[0].pore_radius, 0.5 * warp.pore_radius);
        const std::vector<Issue> issues = validate(design);
        const auto found = std::find_if(issues.begin(), issues.end(), [](const Issue& issue) { return issue.code == "filaments"; });
        QVERIFY(found != issues.end() && found->severity == Severity::note);
        QCOMPARE(found->where.text(), std::string("fabrics[0].warp.filament_count"));
        QVERIFY2(found->text().find("16.67 tex of 192 filaments") == 0 && found->text().find("4.47 µm") != std::string::npos,
                 found->text().c_str());
    }
    void roundYarnsKeepPeircesLimit() // plain square cloth jams at pitch / D = 0.866, D the sum of the diameters
    {
        QVERIFY(!interlace(0.867 * 2, {1, 1}, {1, 1}).jammed);
        QVERIFY(interlace(0.865 * 2, {1, 1}, {1, 1}).jammed);
        const Interlacing limit = interlace(std::sqrt(3.0), {1, 1}, {1, 1});
        QVERIFY(std::abs(limit.length / limit.pitch - 1.209) < 2e-3); // Peirce: 20.9 % crimp
    }
    void pathIsSmoothFromFaceToFace()
    {
        for (double pitch : {1.2, 1.5, 2.0, 4.0}) {
            const Interlacing path = interlace(pitch, {1.1, 0.9}, {1.0, 0.8});
            QVERIFY(std::abs(path.height_at(0) - path.amplitude) < 1e-12);
            QVERIFY(std::abs(path.height_at(pitch) + path.amplitude) < 1e-12);
            double length = 0;
            constexpr int n = 20000;
            for (int i = 0; i < n; ++i) {
                const double x = (i + 0.5) / n * pitch, h = pitch / n;
                const double slope = (path.height_at(x + 0.5 * h) - path.height_at(x - 0.5 * h)) / h;
                QVERIFY(std::abs(slope - path.slope_at(x)) < 1e-2 * (1 + std::abs(slope)));
                length += std::sqrt(1 + slope * slope) * h;
            }
            QVERIFY2(std::abs(length - path.length) < 2e-3 * length, qPrintable(QString::number(length / path.length)));
        }
    }
    void flatteningKeepsTheArea()
    {
        for (double height : {1.0, 0.8, 0.5, 0.2}) QVERIFY(std::abs(section_area(flattened_section(1.0, height)) - pi / 4) < 1e-12);
        QVERIFY(std::abs(flattened_section(1.0, 1.0).width - 1.0) < 1e-12);
    }
    void yarnsDoNotInterpenetrate_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("pattern");
        for (const char* letter : {"A", "B", "C", "D", "E", "F", "G"})
            QTest::newRow(letter) << QString("textile-%1").arg(letter) << QString();
        for (const char* pattern : {"twill 2/1 Z", "twill 2/2 S", "satin 5/2", "basket 2/2"})
            QTest::newRow(pattern) << "textile-F" << pattern;
    }
    void yarnsDoNotInterpenetrate()
    {
        QFETCH(QString, file);
        QFETCH(QString, pattern);
        Design design = example(file);
        if (!pattern.isEmpty()) design.fabrics[0].weave = weave_from_pattern(pattern.toStdString());
        const Textile t = build_textile(design, design.fabrics[0], {0, 0, 8, 8});
        const double overlap = worst_overlap(t);
        qInfo("worst overlap %.2f %% of a yarn's height", 100 * overlap);
        QVERIFY(overlap < 0.01);
    }
    void yarnsStayWithinTheThickness()
    {
        for (const char* letter : {"A", "B", "C", "D", "E", "F", "G"}) {
            const Design design = example(QString("textile-%1").arg(letter));
            const Textile t = build_textile(design, design.fabrics[0], {0, 0, 6, 6});
            QVERIFY(mm_from_metre(2 * t.half_thickness()) <= *design.fabrics[0].thickness_mm + 1e-9);
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
                for (int yarn = 0; yarn < 6; ++yarn)
                    for (int at = 0; at < 6; ++at)
                        for (double offset : {-0.5, -0.3, 0.0, 0.2, 0.5}) {
                            const YarnPoint p = yarn_point(t, kind, yarn, at, offset);
                            QVERIFY(std::abs(p.centre.z) + p.half_height <= t.half_thickness() * 1.0001);
                        }
        }
    }
    void yarnsMeetWhereTheyCross()
    {
        const Design design = example("textile-G");
        const Textile t = build_textile(design, design.fabrics[0], {0, 0, 4, 4});
        const double gap = std::abs(t.height_at_crossing(YarnKind::warp, 1, 2) - t.height_at_crossing(YarnKind::weft, 1, 2));
        QVERIFY(std::abs(gap - 0.5 * (t.warp.types[0].section.height + t.weft.types[0].section.height)) < 1e-12);
        QVERIFY((t.height_at_crossing(YarnKind::warp, 1, 2) > 0) == t.warp_up(1, 2));
    }
    void crimpGoesToTheYarnOfTheLongerSpan()
    {
        Design design = example("textile-G");
        Fabric& fabric = design.fabrics[0];
        fabric.thickness_mm.reset();
        fabric.ends_per_cm = 16;
        fabric.picks_per_cm = 8;
        const Textile t = build_textile(design, fabric, {0, 0, 4, 4});
        QVERIFY(std::abs(t.warp.types[0].rise[0] / t.weft.types[0].rise[0] - std::pow(2, 1.5)) < 1e-9);
    }
    void setCrimpIsTheCrimp()
    {
        Design design = example("textile-G");
        Fabric& fabric = design.fabrics[0];
        fabric.thickness_mm.reset();
        fabric.ends_per_cm = fabric.picks_per_cm = 22;
        for (const char* pattern : {"plain", "twill 2/1 Z"}) {
            fabric.weave = weave_from_pattern(pattern);
            fabric.warp_crimp_percent = 5;
            fabric.weft_crimp_percent = 2;
            const Textile t = build_textile(design, fabric, {0, 0, 6, 6});
            double warp = 0, weft = 0;
            for (int i = 0; i < 6; ++i) {
                warp += t.segment_length(YarnKind::warp, 1, i) / (6 * t.weft.pitch);
                weft += t.segment_length(YarnKind::weft, i, 1) / (6 * t.warp.pitch);
            }
            QVERIFY2(std::abs(warp - 1.05) < 1e-3 && std::abs(weft - 1.02) < 1e-3, qPrintable(QString("%1 %2").arg(warp).arg(weft)));
            QVERIFY(worst_overlap(t) < 0.01);
            fabric.weft_crimp_percent.reset(); // the weft then takes what is left
            const Textile one = build_textile(design, fabric, {0, 0, 6, 6});
            QVERIFY(std::abs(one.warp.types[0].rise[0] + one.weft.types[0].rise[0] - 0.2e-3) < 1e-9);
        }
    }
    void anyCrimpThatMayBeSetMakesAContinuousCloth()
    {
        for (double sett : {5.0, 28.0, 48.0})
            for (double warp : {0.0, 3.0, 100.0})
                for (double weft : {-1.0, 0.0, 100.0}) {
                    Design design = example("textile-G");
                    Fabric& fabric = design.fabrics[0];
                    fabric.thickness_mm.reset();
                    fabric.ends_per_cm = fabric.picks_per_cm = sett;
                    fabric.warp_crimp_percent = warp;
                    if (weft >= 0) fabric.weft_crimp_percent = weft;
                    if (has_error(validate(design))) continue;
                    const Textile t = build_textile(design, fabric, {0, 0, 4, 4});
                    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
                        YarnPoint before = yarn_point(t, kind, 1, 1, 0);
                        for (int i = 1; i <= 256; ++i) {
                            const YarnPoint here = yarn_point(t, kind, 1, i <= 128 ? 1 : 2, i <= 128 ? i / 256.0 : i / 256.0 - 1);
                            QVERIFY(std::isfinite(here.centre.z) && here.half_height > 0);
                            QVERIFY2(std::abs(here.centre.z - before.centre.z) < 0.1 * t.thickness,
                                     qPrintable(QString("%1 %2 %3").arg(sett).arg(warp).arg(weft)));
                            before = here;
                        }
                    }
                }
    }
    void yarnsThatWouldJamAreFlattenedWhenNoThicknessIsGiven()
    {
        Design design = example("textile-G");
        Fabric& fabric = design.fabrics[0];
        fabric.thickness_mm.reset();
        fabric.ends_per_cm = fabric.picks_per_cm = 30; // Peirce's limit of round yarns is 28.9
        const Textile t = build_textile(design, fabric, {0, 0, 6, 6});
        QVERIFY(t.warp.types[0].section.height < 0.2e-3 && t.warp.types[0].section.width > 0.2e-3);
        QVERIFY(std::abs(section_area(t.warp.types[0].section) / (0.25 * pi * 0.04e-6) - 1) < 1e-9);
        const double mean = t.warp.types[0].area / (0.25 * pi * 0.04e-6); // neighbours touch before its arcs fit
        QVERIFY2(mean > 0.8 && mean < 1, qPrintable(QString::number(mean)));
        QVERIFY(worst_overlap(t) < 0.01);
    }
    void stripesFollowTheOrderWhereverTheRegionBegins()
    {
        Design design = example("textile-G");
        Fabric& fabric = design.fabrics[0];
        fabric.thickness_mm.reset();
        Yarn thick = fabric.warp;
        thick.diameter_mm = 0.28;
        thick.color = Color{200, 30, 30};
        Yarn dyed = fabric.warp;
        dyed.color = Color{30, 30, 200};
        fabric.extra_yarns = {thick, dyed};
        fabric.warp_order = {{0, 3}, {1, 2}, {2, 1}};
        fabric.weft_order = {{0, 4}, {1, 1}};
        fabric.ends_per_cm = fabric.picks_per_cm = 20;
        const Textile t = build_textile(design, fabric, {-7, 4, 20, 20});
        QCOMPARE(t.warp.types.size(), std::size_t(2)); // dyed apart, they are alike
        const int numbers[] = {0, 0, 0, 1, 1, 2};
        for (int end = 0; end < 20; ++end) {
            const int number = numbers[(end - 7 + 12) % 6];
            QCOMPARE(t.yarn_number(YarnKind::warp, end), number);
            QVERIFY(std::abs(t.type(YarnKind::warp, end).section.width - (number == 1 ? 0.28e-3 : 0.2e-3)) < 1e-9);
        }
        QVERIFY2(worst_overlap(t) < 0.01, qPrintable(QString::number(worst_overlap(t))));
        // Where two yarns cross, their skins touch.
        for (int end = 0; end < 12; ++end)
            for (int pick = 0; pick < 12; ++pick) {
                const double apart =
                    std::abs(t.height_at_crossing(YarnKind::warp, end, pick) - t.height_at_crossing(YarnKind::weft, end, pick));
                QVERIFY(std::abs(apart - 0.5 * (t.type(YarnKind::warp, end).section.height + t.type(YarnKind::weft, pick).section.height)) <
                        1e-12);
            }
        // Paths join at the crossings.
        for (int pick = 1; pick < 19; ++pick)
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
                const YarnPoint a = yarn_point(t, kind, 5, pick, 0.5), b = yarn_point(t, kind, 5, pick + 1, -0.5);
                QVERIFY(length(a.centre - b.centre) < 1e-12 && length(a.tangent - b.tangent) < 1e-9);
                const YarnPoint c = yarn_point(t, kind, 5, pick, -1e-9), d = yarn_point(t, kind, 5, pick, 1e-9);
                QVERIFY(length(c.centre - d.centre) < 1e-8 && std::abs(c.half_height - d.half_height) < 1e-9);
            }
    }
    void floatsMoveTogetherAndNeverIntoEachOther()
    {
        Design design = example("textile-G");
        Fabric& fabric = design.fabrics[0];
        fabric.weave = weave_from_pattern("basket 2/2");
        const Textile t = build_textile(design, fabric, {0, 0, 16, 16});
        // In a hopsack two ends weave alike with nothing between them: they close up; pairs stay apart.
        QVERIFY(t.shift_at_crossing(YarnKind::warp, 4, 4) > 0 && t.shift_at_crossing(YarnKind::warp, 5, 4) < 0);
        QVERIFY(t.shift_at_crossing(YarnKind::warp, 4, 4) == -t.shift_at_crossing(YarnKind::warp, 5, 4));
        for (const char* pattern : {"plain", "basket 2/2", "twill 2/2 Z", "satin 8/3", "rib 2/2 warp"}) {
            fabric.weave = weave_from_pattern(pattern);
            const Textile cloth = build_textile(design, fabric, {0, 0, 16, 16});
            for (int end = 0; end < 15; ++end)
                for (int pick = 0; pick < 16; ++pick)
                    for (double offset : {-0.5, -0.2, 0.0, 0.3}) {
                        const YarnPoint a = yarn_point(cloth, YarnKind::warp, end, pick, offset),
                                        b = yarn_point(cloth, YarnKind::warp, end + 1, pick, offset);
                        QVERIFY(b.centre.x - a.centre.x >= a.half_width + b.half_width - 1e-9);
                    }
            if (fabric.weave.pattern() == "plain") QCOMPARE(cloth.shift_at_crossing(YarnKind::warp, 4, 4), 0.0);
        }
    }
    void everySegmentHasItsOwnNumber()
    {
        const Design design = example("textile-F");
        const Textile t = build_textile(design, design.fabrics[0], {0, 0, 5, 7});
        std::set<int> numbers;
        for (int end = 0; end < 5; ++end)
            for (int pick = 0; pick < 7; ++pick)
                for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) numbers.insert(t.segment(kind, end, pick));
        QCOMPARE(int(numbers.size()), t.segments());
        QCOMPARE(*numbers.rbegin(), t.segments() - 1);
    }
    void segmentsAddUpToTheYarnsLength()
    {
        const Design design = example("textile-F");
        const Textile t = build_textile(design, design.fabrics[0], {0, 0, 4, 40});
        double length = 0;
        for (int pick = 0; pick < 40; ++pick) length += t.segment_length(YarnKind::warp, 1, pick);
        QVERIFY(std::abs(length - 40 * t.warp.paths[1].length) < 1e-9); // plain weave: it changes sides at every pick
    }
    void sampleHasItsThreads()
    {
        const Design design = example("textile-F");
        const TextileRegion region = region_of_sample(design.fabrics[0], 20, 10);
        QCOMPARE(region.ends, 70);
        QCOMPARE(region.picks, 35);
        QCOMPARE(region_of_sample(design.fabrics[0], 0.01, 0.01).ends, 1);
    }
    void aFittedFabricGivesARunTheSameTextileAsItsDesign()
    {
        Design design = example("textile-F");
        Fabric& fabric = design.fabrics[0];
        fabric.contact_angle_deg.reset();
        fabric.warp.material = {{"polyester", 1.0}};
        for (Closure closure : {Closure::paper, Closure::pores}) {
            design.experiments[0].closure = closure;
            const FittedFabric fitted = fit_fabric(design, fabric);
            const Textile anew = textile_of_run(design, fabric, design.experiments[0]),
                          given = textile_of_run(design, fabric, design.experiments[0], &fitted);
            QCOMPARE(given.warp.types[0].contact_angle == given.weft.types[0].contact_angle, closure == Closure::paper); // cotton's
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
                const YarnType &a = anew.system(kind).types[0], &b = given.system(kind).types[0];
                QCOMPARE(b.contact_angle, a.contact_angle);
                QCOMPARE(b.receding_angle, a.receding_angle);
                QCOMPARE(b.pore_radius, a.pore_radius);
                QCOMPARE(b.rise, a.rise);
            }
            QCOMPARE(given.quantities.warp.receding_angle_deg, anew.quantities.warp.receding_angle_deg);
            QCOMPARE(given.quantities.weft.contact_angle_deg, anew.quantities.weft.contact_angle_deg);
            QCOMPARE(given.thickness, anew.thickness);
        }
    }
    void aSampleOfNoSizeOrAnImpossibleOneStillHasCountableThreads()
    {
        const Fabric fabric = example("textile-F").fabrics[0];
        QCOMPARE(region_of_sample(fabric, 1e12, -5).ends, largest_yarn_order);
        QCOMPARE(region_of_sample(fabric, 1e12, -5).picks, 1);
        QCOMPARE(region_of_sample(fabric, std::nan(""), 10).ends, 1);
    }
};

QTEST_APPLESS_MAIN(TestTextile)
#include "tst_textile.moc"
