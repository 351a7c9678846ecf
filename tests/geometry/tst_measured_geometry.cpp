// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/geometry/measured_geometry.h"
#include "core/project/project_file.h"

#include <QElapsedTimer>
#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace tst_measured_geometry {
namespace {

Design example(const QString& file)
{
    return read_project((QString(HYGROLOOM_SOURCE_DIR "/resources/examples/") + file + ".hygro").toStdString());
}

} // namespace

#define AGREES_WITHIN(bound, measured, formula)                                                                                            \
    QVERIFY2(std::abs((measured) / (formula)-1) < (bound), qPrintable(QString("%1 against %2").arg(measured).arg(formula)))
#define AGREES(measured, formula) AGREES_WITHIN(0.02, measured, formula)

class TestMeasuredGeometry : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void formulasAndGeometryAgree_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<double>("sett"); // 0: the example's
        for (const char* letter : {"A", "B", "C", "D", "E", "F", "G"})
            QTest::newRow(letter) << QString("textile-%1").arg(letter) << "plain" << 0.0;
        for (const char* pattern : {"plain", "twill 2/1 Z", "satin 5/2", "basket 2/2"})
            QTest::newRow(pattern) << "textile-F" << pattern << 22.0;
    }
    void formulasAndGeometryAgree()
    {
        QFETCH(QString, file);
        QFETCH(QString, pattern);
        QFETCH(double, sett);
        Design design = example(file);
        Fabric& fabric = design.fabrics[0];
        fabric.weave = weave_from_pattern(pattern.toStdString());
        if (sett > 0) fabric.ends_per_cm = fabric.picks_per_cm = sett;
        const FabricQuantities q = derive_quantities(design, fabric);
        const MeasuredGeometry m = measure_geometry(design, fabric);
        QVERIFY2(std::abs(m.warp.crimp_percent - q.warp.crimp_percent) < 0.02 * q.warp.crimp_percent + 0.1,
                 qPrintable(QString::number(m.warp.crimp_percent)));
        QVERIFY2(std::abs(m.weft.crimp_percent - q.weft.crimp_percent) < 0.02 * q.weft.crimp_percent + 0.1,
                 qPrintable(QString::number(m.weft.crimp_percent)));
        // Fibres of yarns that spread between crossings run in and out by more than the formula knows.
        const double mass = file == "textile-A" || file == "textile-B" || file == "textile-E" ? 0.05 : 0.02;
        AGREES_WITHIN(mass, m.areal_density_g_m2, q.areal_density_g_m2);
        AGREES(m.yarn_layer_thickness_mm, q.yarn_layer_thickness_mm);
        AGREES_WITHIN(mass, 1 - m.porosity, 1 - q.porosity);
        AGREES_WITHIN(mass, m.fibre_volume_fraction, q.fibre_volume_fraction);
        AGREES(m.smoothness, q.smoothness);
        AGREES(m.warp.cover, q.warp.cover);
        AGREES(m.weft.cover, q.weft.cover);
        AGREES(m.cover_factor, q.cover_factor);
    }
    void formulasAndGeometryAgreeOnStripesOpenClothsAndHardTwist()
    {
        Design design = example("textile-G");
        Fabric& fabric = design.fabrics[0];
        fabric.thickness_mm.reset();
        const auto agree = [&] {
            const FabricQuantities q = derive_quantities(design, fabric);
            const MeasuredGeometry m = measure_geometry(design, fabric);
            AGREES(m.areal_density_g_m2, q.areal_density_g_m2);
            AGREES(m.cover_factor, q.cover_factor);
            AGREES(m.warp.cover, q.warp.cover);
        };
        fabric.ends_per_cm = fabric.picks_per_cm = 2;
        agree();
        fabric.ends_per_cm = fabric.picks_per_cm = 4;
        fabric.warp.diameter_mm = fabric.weft.diameter_mm = 1.0;
        fabric.warp.twist_per_m = 3000;
        agree();
        fabric = example("textile-G").fabrics[0];
        fabric.thickness_mm.reset();
        fabric.ends_per_cm = fabric.picks_per_cm = 16;
        fabric.extra_yarns = {fabric.warp};
        fabric.extra_yarns[0].diameter_mm = 0.3;
        fabric.warp_order = {{0, 60}, {1, 40}};
        agree();
    }
    void moreLoopsThanCanBeMeasuredAreSampled()
    {
        Design design = example("textile-F");
        Fabric& fabric = design.fabrics[0];
        fabric.flyaway = {20, 0, 1, 0};
        const MeasuredGeometry all = measure_geometry(design, fabric);
        fabric.flyaway.loop_density_per_mm = 2000;
        QElapsedTimer timer;
        timer.start();
        const MeasuredGeometry sample = measure_geometry(design, fabric);
        QVERIFY2(timer.elapsed() < 5000, qPrintable(QString::number(timer.elapsed())));
        QCOMPARE(all.flyaways_seen, 1.0);
        QVERIFY2(sample.flyaways_seen < 0.2, qPrintable(QString::number(sample.flyaways_seen)));
        AGREES(sample.thickness_mm, all.thickness_mm);
        AGREES(sample.areal_density_g_m2, all.areal_density_g_m2);
    }
    void eq2GivesTheAngleBetweenTheChords()
    {
        // tan(angle/2) = 2 pitches / (2 x rise): a rise of one pitch from side to side is a right angle.
        QVERIFY(std::abs(braiding_angle_deg(1, 1) - 90) < 1e-12);
        const Design design = example("textile-G");
        const MeasuredGeometry m = measure_geometry(design, design.fabrics[0]);
        // Square cloth of 0.2 mm yarns, 28 per cm: pitch 0.3571 mm, rise 0.2 mm.
        AGREES(m.warp.braiding_angle_deg, 2 * std::atan(0.35714 / 0.2) * 180 / 3.14159265);
    }
    void poresAreSpreadRoundTheFormulasMean()
    {
        const Design design = example("textile-G");
        const FabricQuantities q = derive_quantities(design, design.fabrics[0]);
        const MeasuredGeometry m = measure_geometry(design, design.fabrics[0]);
        QVERIFY(m.warp.pores.tenth_um < q.warp.pore_radius_um && m.warp.pores.nine_tenths_um > q.warp.pore_radius_um);
        AGREES(m.holes.median_um, q.inter_yarn_pore_radius_um); // plain: all holes are alike
    }
    void permeabilitiesAgreeWhereAllHolesAreAlike()
    {
        const Design design = example("textile-G");
        const FabricQuantities q = derive_quantities(design, design.fabrics[0]);
        const Permeability formula = permeability_of(q), measured = measure_geometry(design, design.fabrics[0]).permeability;
        AGREES(measured.through, formula.through);
        AGREES(measured.along_warp, formula.along_warp);
        AGREES(measured.along_weft, formula.along_weft);
    }
    void floatsThatMoveTogetherWidenTheHolesBeside()
    {
        Design design = example("textile-G");
        design.fabrics[0].weave = weave_from_pattern("basket 2/2");
        const FabricQuantities q = derive_quantities(design, design.fabrics[0]);
        const MeasuredGeometry m = measure_geometry(design, design.fabrics[0]);
        QVERIFY(m.holes.median_um > 1.2 * q.inter_yarn_pore_radius_um);
        AGREES(m.cover_factor, q.cover_factor);
    }
};

} // namespace tst_measured_geometry

QTEST_APPLESS_MAIN(tst_measured_geometry::TestMeasuredGeometry)
#include "tst_measured_geometry.moc"
