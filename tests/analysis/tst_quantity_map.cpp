// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Maps of temperature and humidity from made-up frames, and what is said of runs without them.
#include "core/analysis/map_picture.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/physics/water.h"
#include "tests/support/drop_design.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

/// Four ends and four picks of plain weave; the ends are warmer by a kelvin for each that comes before them, the picks have 20 °C.
struct WarmCloth {
    RunRecord run;
    Frame frame;

    WarmCloth()
    {
        run.design = drop_design();
        run.fabric = "cloth";
        run.experiment = run.design.experiments[0].name;
        run.textile = build_textile(run.design, run.design.fabrics[0], {0, 0, 4, 4});
        run.plan.parts = {{"heat", true, false, "the drop evaporates."}, {"vapour", false, false, "the air is humid."}};
        frame.resize_fields(static_cast<std::size_t>(run.textile.segments()));
        std::fill(frame.temperature.begin(), frame.temperature.end(), 293.15F);
        for (int end = 0; end < 4; ++end)
            for (int pick = 0; pick < 4; ++pick)
                frame.temperature[static_cast<std::size_t>(run.textile.segment(YarnKind::warp, end, pick))] += static_cast<float>(end);
    }
};

} // namespace

class TestQuantityMap : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aFaceShowsTheYarnsThatLieOnIt()
    {
        const WarmCloth cloth;
        for (const MapSide side : {MapSide::top, MapSide::bottom}) {
            const CellMap map = quantity_map(cloth.run.textile, cloth.frame, ShownQuantity::temperature, side, 1);
            QCOMPARE(map.quantity, ShownQuantity::temperature);
            for (int end = 0; end < 4; ++end)
                for (int pick = 0; pick < 4; ++pick) {
                    const bool warp = cloth.run.textile.warp_up(end, pick) == (side == MapSide::top);
                    QVERIFY(std::abs(map.at(end, pick) - (293.15 + (warp ? end : 0))) < 1e-4);
                }
        }
    }
    void aCellIsTheMeanOfItsYarns() // ends and picks have equal lengths in a balanced plain weave
    {
        WarmCloth cloth;
        Fabric& fabric = cloth.run.design.fabrics[0];
        QCOMPARE(fabric.ends_per_cm, fabric.picks_per_cm);
        const CellMap map = quantity_map(cloth.run.textile, cloth.frame, ShownQuantity::temperature, MapSide::total, 2);
        QVERIFY(std::abs(map.at(0, 0) - (293.15 + 0.5 * 0.5)) < 1e-3);
        QVERIFY(std::abs(map.at(1, 1) - (293.15 + 0.5 * 2.5)) < 1e-3);
    }
    void humidityIsOfSaturatedAirAtTheYarnsTemperature()
    {
        WarmCloth cloth;
        // Air of 20 °C holds 17.3 g/m3, of 30 °C 30.4 g/m3 (tables of humid air).
        std::fill(cloth.frame.temperature.begin(), cloth.frame.temperature.end(), 293.15F);
        std::fill(cloth.frame.vapour.begin(), cloth.frame.vapour.end(), 0.5F * 17.3e-3F);
        QVERIFY(std::abs(segment_values(cloth.frame, ShownQuantity::humidity)[0] - 0.5F) < 0.003F);
        std::fill(cloth.frame.temperature.begin(), cloth.frame.temperature.end(), 303.15F);
        QVERIFY(std::abs(segment_values(cloth.frame, ShownQuantity::humidity)[3] - 0.5F * 17.3F / 30.4F) < 0.003F);
        QCOMPARE(range_of_values(cloth.frame, ShownQuantity::humidity), (ValueRange{0, 1}));
    }
    void aScaleOfTemperaturesIsNotNarrowerThanHalfAKelvin()
    {
        WarmCloth cloth;
        const ValueRange wide = range_of_values(cloth.frame, ShownQuantity::temperature);
        QVERIFY(std::abs(wide.low - 293.15) < 1e-4 && std::abs(wide.high - 296.15) < 1e-4);
        std::fill(cloth.frame.temperature.begin(), cloth.frame.temperature.end(), 300.0F);
        QCOMPARE(range_of_values(cloth.frame, ShownQuantity::temperature), (ValueRange{299.75, 300.25}));
        QCOMPARE(united({299, 300}, {298, 299.5}), (ValueRange{298, 300}));
    }
    void whatARunDoesNotModelIsNamedWithItsReason()
    {
        const WarmCloth cloth;
        QCOMPARE(why_not_shown(cloth.run.plan, ShownQuantity::water), std::string());
        QCOMPARE(why_not_shown(cloth.run.plan, ShownQuantity::temperature), std::string());
        QCOMPARE(why_not_shown(cloth.run.plan, ShownQuantity::humidity), std::string("This run does not model vapour: the air is humid."));
        QVERIFY_EXCEPTION_THROWN(quantity_picture(cloth.run, cloth.frame, ShownQuantity::humidity, MapSide::top, 1), Error);
        QVERIFY_EXCEPTION_THROWN(shown_quantity_from_name("heat"), Error);
        for (const ShownQuantity each : {ShownQuantity::water, ShownQuantity::temperature, ShownQuantity::humidity})
            QCOMPARE(shown_quantity_from_name(name_of(each)), each);
    }
    void filesNameTheQuantityAndItsUnit()
    {
        const WarmCloth cloth;
        QTemporaryDir folder;
        const MapPicture picture = quantity_picture(cloth.run, cloth.frame, ShownQuantity::temperature, MapSide::top, 2);
        QVERIFY(QString::fromStdString(picture.image.captions[1]).startsWith("top face, temperature after 0 s"));
        write_cell_map_csv(picture.map, cloth.run, 0, MapSide::top, folder.filePath("map.csv").toStdString());
        QFile file(folder.filePath("map.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArrayList lines = file.readAll().trimmed().split('\n');
        QVERIFY(lines.contains("column,row,x_mm,y_mm,temperature_c"));
        const double first = lines[lines.indexOf("column,row,x_mm,y_mm,temperature_c") + 1].split(',').last().toDouble();
        QVERIFY(first >= 20 && first <= 21);
        QVERIFY(std::abs(first - celsius_from_kelvin(picture.map.at(0, 0))) < 1e-3);
        // The warmest cell is red, not blue as water is.
        const Image image = draw_map(picture.map, picture.width, picture.height, picture.image);
        int red = 0, blue = 0;
        for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
            red += image.rgb[i] > image.rgb[i + 2] + 60;
            blue += image.rgb[i + 2] > image.rgb[i] + 60;
        }
        QVERIFY(red > 1000 && blue == 0);
    }
};

QTEST_APPLESS_MAIN(TestQuantityMap)
#include "tst_quantity_map.moc"
