// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Panels of several layers: how they lie, and what passes from one to the next.
#include "core/base/units.h"
#include "core/physics/air.h"
#include "core/physics/heat_moisture.h"
#include "core/project/project_file.h"
#include "core/wear/wear_layout.h"
#include "core/wear/wear_run.h"
#include "tests/wear/flat_garment.h"

#include <QTest>

using namespace hygroloom;

namespace tst_layers {
namespace {

/// A square of two layers, 30 mm wide.
struct Lined : Worn {
    explicit Lined(const std::string& lining = {}, int layers = 2, const std::string& fabric = "Textile F") : Worn(fabric)
    {
        if (!lining.empty())
            for (const Preset& preset : shipped_presets())
                if (preset.fabric().name == lining) add_preset(design, preset);
        garment.panels["*"].layers = layers;
        garment.panels["*"].lining = lining;
        garment.wearer.gap_mm["default"] = 1;
        add_rectangle(parts.pattern, "piece", {0, 0}, 30e-3, 30e-3);
        add_layers(parts.pattern, garment);
    }
};

/// Mean over the cells of a panel of what frames show.
template <typename Value> double mean_of(const GarmentScene& garment, int panel, const Value& value)
{
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < garment.cells.size(); ++i)
        if (garment.cells[i].panel == panel) sum += value(i), ++count;
    return sum / count;
}

double water_of(const GarmentScene& garment, const Frame& frame, int panel)
{
    const std::vector<double> water = water_in_cells(frame);
    return mean_of(garment, panel, [&](std::size_t i) { return water[i]; });
}

void keep_liquid_apart(Scene& scene)
{
    for (LayerJoint& joint : scene.cloth.layers.joints) joint.yarns = joint.rooms = joint.a_room_to = joint.b_room_to = 0;
}

} // namespace

class TestLayers : public QObject {
    Q_OBJECT

    void fillUp(const GarmentScene& garment, const Climate& climate, double skin_c)
    {
        const ClimateParameters& air = garment.fabrics.front().tile.climate;
        const double wet_bulb = -wet_bulb_depression(air.heat_transfer, air.mass_transfer, air.temperature, climate.relative_humidity);
        const auto backend = make_cpu_backend();
        backend->load(garment.scene);
        for (double time = 60; time <= 900; time += 60) {
            while (backend->advance(time) < time) {}
            const Frame frame = backend->frame();
            QVERIFY(std::abs(frame.ledger.water_imbalance()) < 1e-12 * frame.ledger.water_delivered);
            for (const CellSums& cell : frame.cells)
                QVERIFY2(cell.warmth > wet_bulb - 1 && cell.warmth < skin_c - climate.temperature_c,
                         qPrintable(QString("%1 K at %2 s; the wet bulb has %3").arg(cell.warmth).arg(time).arg(wet_bulb)));
        }
    }

private Q_SLOTS:
    void layersArePanelsSewnAsTheFirst()
    {
        GarmentPattern pattern;
        add_rectangle(pattern, "left", {0, 0}, 0.1, 0.2);
        add_rectangle(pattern, "right", {0.1, 0}, 0.1, 0.2);
        pattern.seams.push_back({0, 1, 1, 3, true});
        Garment garment;
        garment.panels["left"] = {"a"};
        garment.panels["left"].layers = 3;
        garment.panels["right"] = {"b"};
        garment.panels["right"].layers = 2;
        add_layers(pattern, garment);
        QCOMPARE(pattern.panels.size(), 5U);
        QCOMPARE(pattern.panels[3].name, std::string("left, layer 3"));
        QCOMPARE(pattern.panels[3].over, 2);
        QCOMPARE(pattern.panels[4].cut(), std::string("right"));
        QCOMPARE(pattern.seams.size(), 3U);
        QCOMPARE(pattern.seams[1].panel_a, 2);
        QCOMPARE(pattern.seams[1].panel_b, 4);
        QCOMPARE(pattern.seams[2].panel_a, 3);
        QCOMPARE(pattern.seams[2].panel_b, 4); // the third layer is sewn to the last that the other has
        QCOMPARE(pattern.shape.triangles.size(), 10U);
        QCOMPARE(pattern.shape.places[static_cast<std::size_t>(pattern.shape.triangles[6][0])].z, -2e-3); // the third layer's
    }

    /// Whatever the gauge of the lining, layers touch over the area that they share.
    void joinedByTheAreaThatTheyShare_data()
    {
        QTest::addColumn<QString>("lining");
        QTest::newRow("the same fabric") << QString();
        QTest::newRow("a finer one") << QStringLiteral("Poplin shirting");
    }
    void joinedByTheAreaThatTheyShare()
    {
        QFETCH(QString, lining);
        Lined lined(lining.toStdString());
        const GarmentScene garment = lined.scene(1e-3);
        const ClothLayers& layers = garment.scene.cloth.layers;
        double heat = 0, vapour = 0, area = 0;
        for (const LayerJoint& joint : layers.joints) {
            QVERIFY(joint.yarns > 0);
            heat += joint.heat;
            vapour += joint.vapour;
        }
        for (const GarmentCell& cell : garment.cells)
            if (cell.panel == 0) area += cell.area;
        QVERIFY(std::abs(heat / (area * air_conductivity / contact_gap) - 1) < 0.05); // rims of cells stand over
        QVERIFY(std::abs(vapour / heat * air_conductivity / vapour_diffusivity(garment.scene.climate.temperature) - 1) < 1e-12);
        QCOMPARE(wear_layout(lined.parts, garment).panels[1].fabric, lining.isEmpty() ? std::string("Textile F") : lining.toStdString());
    }

    /// From a warm skin through the gap, the layers and the air between them to the air outside: resistances in series.
    void heatPassesInSeries()
    {
        Lined lined({}, 3);
        lined.garment.wearer.skin_temperature_c = 34;
        lined.wear.climate.temperature_c = 20;
        GarmentScene garment = lined.scene(3e-3, false, true);
        const Frame frame = frame_at(garment.scene, 20'000); // by then fibres have given off what they do not hold when warm
        const double outside = garment.fabrics.front().tile.climate.heat_transfer, between = air_conductivity / contact_gap,
                     to_skin = garment.cells.back().skin_contact;
        const double flow = 14 / (1 / to_skin + 2 / between + 1 / outside);                                   // W/m2
        const double expected[3] = {flow / outside, flow * (1 / outside + 1 / between), 14 - flow / to_skin}; // K over the air's
        QVERIFY(to_skin > 0);
        for (int layer = 0; layer < 3; ++layer) {
            const double found = mean_of(garment, layer, [&](std::size_t i) { return frame.cells[i].warmth; });
            QVERIFY2(std::abs(found - expected[layer]) < 1e-3,
                     qPrintable(QString("layer %1: %2 K, %3 expected").arg(layer + 1).arg(found).arg(expected[layer])));
        }
        QVERIFY(std::abs(frame.ledger.energy_imbalance()) < 1e-9 * std::abs(frame.ledger.energy_delivered + frame.ledger.energy_lost));
    }

    /// From wet yarns of the inner layer through the air between and the other layers to the air outside.
    void vapourPassesInSeries_data()
    {
        QTest::addColumn<QString>("lining");
        QTest::addColumn<int>("layers");
        QTest::newRow("three layers") << QString() << 3;
        QTest::newRow("a finer lining") << QStringLiteral("Poplin shirting") << 2;
    }
    void vapourPassesInSeries()
    {
        QFETCH(QString, lining);
        QFETCH(int, layers);
        Lined lined(lining.toStdString(), layers);
        lined.parts.sweat.g_m2_h.assign(body_zones().size(), 300);
        GarmentScene garment = lined.scene(3e-3, false, true);
        Scene& scene = garment.scene;
        scene.rules.heat = false;
        keep_liquid_apart(scene);           // the inner layer alone is wet
        scene.rules.calm_network_step = 10; // s; as long as errors allow, 1.7 % less passes a finer lining
        scene.rules.step_error *= 0.1;
        double area = 0;
        for (const GarmentCell& cell : garment.cells)
            if (cell.panel == 0) area += cell.area;
        const ClimateParameters& air = garment.fabrics.front().tile.climate;
        const double between = vapour_diffusivity(scene.climate.temperature) / contact_gap;
        const double expected = area * (saturation_concentration(scene.climate.temperature) - scene.climate.vapour) /
                                ((layers - 1) / between + 1 / air.mass_transfer); // kg/s
        const auto backend = make_cpu_backend();
        backend->load(scene);
        const auto evaporated = [&](double time) {
            while (backend->advance(time) < time) {}
            return backend->frame().ledger.water_evaporated;
        };
        const double first = evaporated(3500), found = (evaporated(3800) - first) / 300;
        QVERIFY2(std::abs(found / expected - 1) < 0.01, qPrintable(QString("%1 of %2 kg/s").arg(found).arg(expected)));
    }

    /// Layers take their turn among the yarns' flows: a draft's outer layer holds 6 % more than a standard run's.
    void liquidPassesAlikeInLongAndShortSteps()
    {
        double outer[2];
        for (const bool is_draft : {false, true}) {
            Lined lined("Sports micro-twill", 2, "Poplin shirting");
            lined.fidelity = is_draft ? Fidelity::draft : Fidelity::standard;
            lined.room_voxels = 16; // of the same rooms
            lined.parts.sweat.g_m2_h.assign(body_zones().size(), 1000);
            const GarmentScene garment = lined.scene(3e-3, false, true);
            outer[is_draft] = water_of(garment, frame_at(garment.scene, 180), 0);
        }
        QVERIFY2(std::abs(outer[1] / outer[0] - 1) < 0.07, qPrintable(QString("%1 and %2 kg in a cell").arg(outer[0]).arg(outer[1])));
        QVERIFY(outer[1] != outer[0]);
    }

    /// Full yarns have hardly any air of their own whose vapour could be told, and neither cool below the wet bulb nor warm over the skin.
    void layersThatFillUpStayBetweenWetBulbAndSkin_data()
    {
        QTest::addColumn<QString>("lining");
        QTest::addColumn<int>("layers");
        QTest::addColumn<int>("fidelity");
        for (const Fidelity fidelity : {Fidelity::live, Fidelity::draft}) {
            const char* name = name_of(fidelity);
            QTest::addRow("two alike, %s", name) << QString() << 2 << static_cast<int>(fidelity);
            QTest::addRow("three alike, %s", name) << QString() << 3 << static_cast<int>(fidelity);
            QTest::addRow("a lining, %s", name) << QStringLiteral("Sports micro-twill") << 2 << static_cast<int>(fidelity);
        }
    }
    void layersThatFillUpStayBetweenWetBulbAndSkin()
    {
        QFETCH(QString, lining);
        QFETCH(int, layers);
        QFETCH(int, fidelity);
        Lined lined(lining.toStdString(), layers, "Poplin shirting");
        lined.fidelity = static_cast<Fidelity>(fidelity);
        lined.garment.wearer.skin_temperature_c = 34;
        lined.parts.sweat.g_m2_h.assign(body_zones().size(), 1500);
        fillUp(lined.scene(6e-3, false, true), lined.wear.climate, 34);
    }
    void theShippedLinedSingletFillsUp()
    {
        const std::string folder = HYGROLOOM_SOURCE_DIR "/resources/examples";
        const Design design = read_project(folder + "/lined-singlet.hygro");
        const WearExperiment& wear = *find_wear(design, "wear");
        RunOptions options;
        options.fidelity = Fidelity::live;
        fillUp(garment_scene(garment_parts(design, wear, folder), resolution_of(options)), wear.climate,
               design.garments[0].wearer.skin_temperature_c);
    }

    /// Once its yarns are full, a lining hands on what the rooms between them hold: two alike layers end alike, below and above that.
    void alikeLayersEndAlike_data()
    {
        QTest::addColumn<double>("sweat"); // g/(m2 h), in a quarter of an hour
        QTest::newRow("less than the yarns of both hold") << 320.0;
        QTest::newRow("more") << 900.0;
    }
    void alikeLayersEndAlike()
    {
        QFETCH(double, sweat);
        Lined lined({}, 2, "Poplin shirting");
        lined.wear.climate.relative_humidity = 0.99;
        lined.parts.sweat.g_m2_h.assign(body_zones().size(), sweat);
        lined.wear.activity = {{0, 1}, {900, 0}};
        const GarmentScene garment = lined.scene(3e-3, false, true);
        const Frame frame = frame_at(garment.scene, 2400);
        const double outer = water_of(garment, frame, 0), inner = water_of(garment, frame, 1);
        constexpr double hysteresis = 0.75; // what has drained holds on to more than what is filling takes
        QVERIFY2(outer > hysteresis * inner, qPrintable(QString("%1 and %2 kg in a cell").arg(outer).arg(inner)));
        QVERIFY(std::abs(frame.ledger.water_imbalance()) < 1e-12 * frame.ledger.water_delivered);
    }

    /// Fine pores hold on to what coarse ones would take: a fine lining gives its coarse outer layer nothing until it is full itself, then
    /// what its rooms hold.
    void aFineLiningFillsBeforeACoarseLayer_data()
    {
        QTest::addColumn<double>("sweat"); // g/(m2 h), in a quarter of an hour
        QTest::addColumn<bool>("fills");
        QTest::newRow("half of what its yarns hold") << 120.0 << false;
        QTest::newRow("twice") << 900.0 << true;
    }
    void aFineLiningFillsBeforeACoarseLayer()
    {
        QFETCH(double, sweat);
        QFETCH(bool, fills);
        Lined lined("Sports micro-twill", 2, "Polyester taffeta");
        Fabric& coarse = lined.design.fabrics[0];
        Fabric& fine = lined.design.fabrics[1];
        const std::string name = coarse.name;
        coarse = fine; // the same cloth of fewer and thicker filaments
        coarse.name = name;
        for (Yarn* yarn : {&coarse.warp, &coarse.weft}) yarn->filament_count = 36;
        for (Yarn* yarn : {&fine.warp, &fine.weft}) yarn->filament_count = 288;
        lined.wear.climate.relative_humidity = 0.99;
        lined.parts.sweat.g_m2_h.assign(body_zones().size(), sweat);
        lined.wear.activity = {{0, 1}, {900, 0}};
        const GarmentScene garment = lined.scene(3e-3, false, true);
        const Frame frame = frame_at(garment.scene, 2400);
        const double outer = water_of(garment, frame, 0), inner = water_of(garment, frame, 1);
        const QByteArray said = QString("%1 and %2 kg in a cell").arg(outer).arg(inner).toLatin1();
        if (fills)
            QVERIFY2(outer > 0.2 * inner, said.constData());
        else
            QVERIFY2(outer < 0.05 * inner, said.constData());
        QVERIFY(std::abs(frame.ledger.water_imbalance()) < 1e-12 * frame.ledger.water_delivered);
    }

    /// Sweat comes to the outer layer through the inner one, and nothing is lost on the way.
    void sweatComesThroughTheInnerLayer()
    {
        Lined lined;
        lined.parts.sweat.g_m2_h.assign(body_zones().size(), 2000);
        GarmentScene garment = lined.scene(3e-3, false, true);
        const Frame frame = frame_at(garment.scene, 300);
        QVERIFY(std::abs(frame.ledger.water_imbalance()) < 1e-12 * frame.ledger.water_delivered);
        const double outer = water_of(garment, frame, 0), inner = water_of(garment, frame, 1);
        QVERIFY2(outer > 0 && inner > outer, qPrintable(QString("%1 and %2 kg in a cell").arg(outer).arg(inner)));
        keep_liquid_apart(garment.scene);
        const Frame apart = frame_at(garment.scene, 300);
        QVERIFY(water_of(garment, apart, 0) < 0.5 * outer); // by vapour alone
        QVERIFY(water_of(garment, apart, 0) > 0);
        for (LayerJoint& joint : garment.scene.cloth.layers.joints) joint.vapour = 0;
        QVERIFY(water_of(garment, frame_at(garment.scene, 300), 0) < 0.1 * water_of(garment, apart, 0));
    }
};

} // namespace tst_layers

QTEST_GUILESS_MAIN(tst_layers::TestLayers)
#include "tst_layers.moc"
