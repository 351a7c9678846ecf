// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/map_image.h"
#include "core/base/error.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace hygroloom;

namespace {

/// 10 x 5 cells of 1 mm; water only in the lower left one.
CellMap drop_in_a_corner()
{
    CellMap map;
    map.columns = 10;
    map.rows = 5;
    map.cell_width = map.cell_height = 1e-3;
    map.water.assign(50, 0.0);
    map.water[0] = 0.2;
    map.water[12] = 0.1;
    return map;
}

struct Pixel {
    int r, g, b;
};

Pixel pixel(const Image& image, int x, int y)
{
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

bool reddish(const Pixel& p) { return p.r > p.b + 60 && p.r > p.g + 60; }

} // namespace

class TestMapImage : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void wetCellsAreBlueAndDryOnesAreNot()
    {
        const Image image = draw_map(drop_in_a_corner(), 10e-3, 5e-3, {});
        QCOMPARE(image.rgb.size(), std::size_t(3) * image.width * image.height);
        // 480 pixels across the map: 48 a cell, after a margin of 16; the first row lies at the bottom.
        const Pixel wettest = pixel(image, 16 + 24, 16 + 240 - 24), wet = pixel(image, 16 + 2 * 48 + 24, 16 + 240 - 48 - 24),
                    dry = pixel(image, 16 + 5 * 48, 16 + 24);
        QVERIFY(wettest.b > wettest.r + 60);
        QVERIFY(wet.b > wet.r + 60 && wet.r > wettest.r);
        QVERIFY(dry.r > dry.b && dry.b > 200);
    }
    void theWettedCircleIsDrawnAtItsPlace()
    {
        MapImageOptions options;
        options.circle = Circle{-2e-3, 1e-3, 1e-3};
        const Image image = draw_map(drop_in_a_corner(), 10e-3, 5e-3, options);
        const int x = 16 + 48 * 3, y = 16 + 72; // 3 mm from the left, 1.5 mm from the top
        QVERIFY(reddish(pixel(image, x + 48, y)));
        QVERIFY(reddish(pixel(image, x, y - 48)));
        QVERIFY(!reddish(pixel(image, x, y)));
    }
    void captionsMakeRoom()
    {
        MapImageOptions options;
        options.captions = {"Textile F, one drop", "top face after 10 s, cells of 2 x 2 which is a long line that needs much room indeed"};
        const Image without = draw_map(drop_in_a_corner(), 10e-3, 5e-3, {}), with = draw_map(drop_in_a_corner(), 10e-3, 5e-3, options);
        QVERIFY(with.height > without.height && with.width > without.width);
    }
    void theScaleBarIsInTheReadersUnit()
    {
        // 480 pixels for 10 mm: of a third of the width the largest round length is 2 mm, or 0.1 in.
        const auto bar_of = [](const ReaderUnits& units) {
            MapImageOptions options;
            options.units = units;
            const Image image = draw_map(drop_in_a_corner(), 10e-3, 5e-3, options);
            int length = 0;
            while (pixel(image, 16 + length, 16 + 240 + 16 + 1).r < 100) ++length;
            return length;
        };
        QCOMPARE(bar_of({}), 96);
        const ReaderUnits inches = [](const std::string& unit) { return unit == "mm" ? ReaderUnit{"in", 1 / 25.4} : ReaderUnit{unit}; };
        QCOMPARE(bar_of(inches), 122); // 2.54 mm
    }
    void dryMapsAreDrawnToo()
    {
        CellMap map = drop_in_a_corner();
        map.water.assign(50, 0.0);
        const Pixel p = pixel(draw_map(map, 10e-3, 5e-3, {}), 30, 30);
        QVERIFY(p.r > p.b);
    }
    void captionsAreWrittenInAnyScript()
    {
        const auto drawn = [](const char* words) {
            MapImageOptions options;
            options.captions = {words};
            return draw_map(drop_in_a_corner(), 10e-3, 5e-3, options).rgb;
        };
        QVERIFY(drawn("cells of 2 × 2") != drawn("cells of 2 x 2"));
        QVERIFY(drawn("Röhre") != drawn("Rohre") && drawn("a") != drawn(" "));
        QVERIFY(!drawn("broken \xff\xfe").empty());
    }
    void picturesAreWrittenAsPng()
    {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("map.png").toStdString();
        write_png(draw_map(drop_in_a_corner(), 10e-3, 5e-3, {}), path);
        std::ifstream file(path, std::ios::binary);
        char head[8] = {};
        file.read(head, 8);
        QCOMPARE(QByteArray(head, 8), QByteArray("\x89PNG\r\n\x1a\n", 8));
        QVERIFY_EXCEPTION_THROWN(write_png(draw_map(drop_in_a_corner(), 10e-3, 5e-3, {}), "/nowhere/map.png"), FileError);
    }
};

QTEST_APPLESS_MAIN(TestMapImage)
#include "tst_map_image.moc"
