// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How wide and high yarns lie in cloth: by their kind, in floats, between crossings.
#include "core/base/units.h"
#include "core/geometry/textile.h"
#include "core/project/library.h"
#include "tests/geometry/overlap.h"

#include <QTest>

using namespace hygroloom;

namespace tst_sections {
namespace {

const Fabric& find_preset(const std::string& name)
{
    const auto& presets = shipped_presets();
    return std::find_if(presets.begin(), presets.end(), [&](const Preset& p) { return p.fabric().name == name; })->fabric();
}

} // namespace

class TestSections : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void yarnsOfTheLibraryDoNotInterpenetrate_data()
    {
        QTest::addColumn<int>("preset");
        for (std::size_t i = 0; i < shipped_presets().size(); ++i)
            QTest::newRow(shipped_presets()[i].fabric().name.c_str()) << static_cast<int>(i);
    }
    void yarnsOfTheLibraryDoNotInterpenetrate()
    {
        QFETCH(int, preset);
        Fabric fabric = shipped_presets()[static_cast<std::size_t>(preset)].fabric();
        const TextileRegion region{0, 0, 6, 6};
        for (bool set : {true, false}) {
            if (!set) {
                fabric.warp_crimp_percent.reset();
                fabric.weft_crimp_percent.reset();
            }
            const double overlap = worst_overlap(build_textile({}, fabric, region));
            QVERIFY2(overlap < 0.01, qPrintable(QString("%1 %2").arg(set).arg(overlap)));
        }
    }
    void yarnsKeepTheirAreaBetweenCrossings()
    {
        const auto least_area = [](const Textile& t, YarnKind kind) {
            double least = 1e9;
            for (int at = 0; at < 4; ++at)
                for (int i = -32; i <= 32; ++i) {
                    const YarnPoint p = yarn_point(t, kind, 0, at, i / 64.0);
                    least = std::min(least, p.half_height * (pi * p.half_height + 4 * (p.half_width - p.half_height)));
                }
            return least / section_area(t.system(kind).types[0].section);
        };
        // Of crimps that are not set, yarns have room for all of their area.
        for (const char* name : {"Sheeting", "Voile", "Tropical worsted", "Linen cloth", "Polyester taffeta", "Viscose challis"}) {
            Fabric fabric = find_preset(name);
            fabric.warp_crimp_percent.reset();
            fabric.weft_crimp_percent.reset();
            const Textile t = build_textile({}, fabric, {0, 0, 4, 4});
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
                QVERIFY2(least_area(t, kind) > 0.99, qPrintable(QString("%1 %2").arg(name).arg(least_area(t, kind))));
        }
        // Where it has not, yarns spread as far as the holes let them.
        const Textile squeezed = build_textile({}, find_preset("Textile E"), {0, 0, 4, 4});
        QVERIFY(squeezed.warp.types[0].widest > 1.05 * squeezed.warp.types[0].section.width);
        QVERIFY(std::abs(squeezed.warp.types[0].widest / squeezed.weft.types[0].widest - 1) < 1e-9); // alike on both ways of a square cloth
        QVERIFY2(least_area(squeezed, YarnKind::warp) > 0.42,
                 qPrintable(QString::number(least_area(squeezed, YarnKind::warp)))); // flats kept: 0.41
    }
    void setCrimpsGiveWayBeforeYarnsArePackedTooClose()
    {
        Fabric fabric = find_preset("Nylon taslan");
        fabric.warp_crimp_percent = fabric.weft_crimp_percent = 4;
        const Textile t = build_textile({}, fabric, {0, 0, 4, 4});
        for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) QVERIFY(t.system(kind).types[0].packing <= densest_squeezed + 1e-9);
        QVERIFY(t.quantities.warp.crimp_percent > 5);
        const auto& notes = t.quantities.notes;
        QVERIFY(std::any_of(notes.begin(), notes.end(),
                            [](const Message& note) { return english(note).find("is set to 4 %") != std::string::npos; }));
    }
    void yarnsLieAsFlatAsTheirKindAndTwistMakeThem()
    {
        const auto shape = [](const Yarn& yarn) { return usual_shape({}, yarn, free_yarn({}, yarn)); };
        Yarn yarn;
        yarn.linear_density_tex = 16;
        const struct {
            double twist_factor, shape;
        } spun[] = {{0, .35}, {1000, .601}, {2000, .736}, {3000, .808}, {3500, .830}, {4600, .86}};
        for (const auto& known : spun) {
            yarn.twist_per_m = known.twist_factor / 4;
            QVERIFY2(std::abs(shape(yarn) - known.shape) < 2e-3, qPrintable(QString::number(shape(yarn))));
        }
        yarn.plies = 2;
        QCOMPARE(shape(yarn), 0.8);
        yarn.filament_count = 72;
        for (const auto& [packing, flat] : {std::pair(0.7, 0.3), std::pair(0.6, 0.3), std::pair(0.5, 0.4)}) {
            yarn.packing_factor = packing;
            QVERIFY(std::abs(shape(yarn) - flat) < 1e-12);
        }
        yarn.diameter_mm = 0.2;
        QCOMPARE(shape(yarn), 1.0);
    }
    void yarnsSpreadInFloats()
    {
        QCOMPARE(widening_by_floats(weave_from_pattern("plain"), true), 1.0);
        QVERIFY(std::abs(widening_by_floats(weave_from_pattern("twill 3/1 Z"), true) - (3 * 1.2 + 1) / 4) < 1e-12);
        QVERIFY(std::abs(widening_by_floats(weave_from_pattern("satin 8/3"), false) - (7 * 1.3 + 1) / 8) < 1e-12); // 1.3 at most
        QVERIFY(std::abs(widening_by_floats(weave_from_pattern("rib 2/2 warp"), true) - 1.1) < 1e-12);
        QCOMPARE(widening_by_floats(weave_from_pattern("rib 2/2 warp"), false), 1.0);
        Fabric fabric = find_preset("Voile");
        const Section plain = build_textile({}, fabric, {0, 0, 4, 4}).warp.types[0].section;
        fabric.weave = weave_from_pattern("twill 3/1 Z");
        const Textile twill = build_textile({}, fabric, {0, 0, 4, 4});
        const Section wide = twill.warp.types[0].section;
        QVERIFY2(std::abs(wide.width / plain.width - 1.15) < 1e-9, qPrintable(QString::number(wide.width / plain.width)));
        QVERIFY(std::abs(section_area(wide) / section_area(plain) - 1) < 1e-9 && wide.height < 0.92 * plain.height);
        fabric.ends_per_cm = 10 / mm_from_metre(1.05 * plain.width / widest_share_of_pitch); // neighbours leave it a twentieth
        QVERIFY(std::abs(build_textile({}, fabric, {0, 0, 4, 4}).warp.types[0].section.width / plain.width - 1.05) < 1e-9);
    }
    void aTaffetaIsThin() // sold ones are 0.08 to 0.11 mm thick
    {
        Fabric fabric = find_preset("Polyester taffeta");
        const Textile as_shipped = build_textile({}, fabric, {0, 0, 4, 4});
        fabric.warp_crimp_percent.reset();
        fabric.weft_crimp_percent.reset();
        const Textile unset = build_textile({}, fabric, {0, 0, 4, 4});
        for (const Textile* t : {&as_shipped, &unset})
            QVERIFY2(t->thickness > 0.09e-3 && t->thickness < 0.13e-3, qPrintable(QString::number(t->thickness)));
        QVERIFY(worst_overlap(unset) < 0.01);
    }
};

} // namespace tst_sections

QTEST_APPLESS_MAIN(tst_sections::TestSections)
#include "tst_sections.moc"
