// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/error.h"
#include "core/project/draft_import.h"

#include <QTemporaryDir>
#include <QTest>

#include <png.h>

#include <fstream>

using namespace hygroloom;

namespace tst_weave_picture {
namespace {

std::string refusal(const std::string& bytes, bool picture = false)
{
    try {
        picture ? import_picture(bytes, "w.png") : import_grid(bytes, "w.txt");
    } catch (const FileError& error) {
        return error.what();
    }
    return "accepted";
}

std::string png_of(int width, int height, const std::vector<std::uint8_t>& grey)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_GRAY;
    png_alloc_size_t size = 0;
    png_image_write_to_memory(&image, nullptr, &size, 0, grey.data(), 0, nullptr);
    std::string bytes(size, '\0');
    png_image_write_to_memory(&image, bytes.data(), &size, 0, grey.data(), 0, nullptr);
    bytes.resize(size);
    return bytes;
}

void put(std::string& bytes, std::uint32_t value, int length)
{
    for (int i = 0; i < length; ++i) bytes += static_cast<char>((value >> (8 * i)) & 255);
}

/// Three pixels by two, the top row black white white, the lower white white black.
std::string bmp_of(unsigned bits, bool top_first)
{
    std::string palette, data;
    const auto row = [&](const std::vector<int>& black) {
        std::string line;
        if (bits == 1) {
            line += static_cast<char>((black[0] ? 0 : 128) | (black[1] ? 0 : 64) | (black[2] ? 0 : 32));
        } else if (bits == 8) {
            for (int b : black) line += static_cast<char>(b ? 0 : 1);
        } else {
            for (int b : black) line += std::string(bits / 8, b ? '\0' : '\xFF');
        }
        while (line.size() % 4 != 0) line += '\0';
        return line;
    };
    if (bits <= 8) palette = std::string("\0\0\0\0\xFF\xFF\xFF\0", 8);
    data = top_first ? row({1, 0, 0}) + row({0, 0, 1}) : row({0, 0, 1}) + row({1, 0, 0});
    std::string bytes = "BM";
    put(bytes, static_cast<std::uint32_t>(54 + palette.size() + data.size()), 4);
    put(bytes, 0, 4);
    put(bytes, static_cast<std::uint32_t>(54 + palette.size()), 4);
    put(bytes, 40, 4);
    put(bytes, 3, 4);
    put(bytes, static_cast<std::uint32_t>(top_first ? -2 : 2), 4);
    put(bytes, 1, 2);
    put(bytes, bits, 2);
    for (int i = 0; i < 6; ++i) put(bytes, 0, 4);
    return bytes + palette + data;
}

} // namespace

class TestWeavePicture : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void threeWaysOfDrawingGiveTheSameWeave()
    {
        const Weave expected = weave_from_pattern("twill 2/1 Z"); // from the top: 011 110 101
        for (const char* text :
             {"011\n110\n101\n", "011\r\n110\r\n101", "011\r110\r101\r", "\n.##\n##.\n#.#\n\n", " xx\nxx\nx x\n", " XX\nXX \nX X"}) {
            const DraftImport draft = import_grid(text, "folder/my twill.txt");
            QVERIFY(draft.fabric.weave.same_matrix(expected));
            QCOMPARE(draft.fabric.name, std::string("my twill"));
        }
    }
    void namesAreCutBetweenCharacters()
    {
        std::string name;
        for (int i = 0; i < 150; ++i) name += "ü";
        QCOMPARE(import_grid("10\n01\n", name.substr(0, 200) + ".txt").fabric.name, name.substr(0, 200));
        QCOMPARE(import_grid("10\n01\n", "x" + name + ".txt").fabric.name, "x" + name.substr(0, 198));
        QCOMPARE(import_grid("10\n01\n", "\xFC.txt").fabric.name, std::string("ü")); // a name in Windows-1252
    }
    void aDrawingIsReducedToItsRepeat()
    {
        const DraftImport draft = import_grid("1010\n0101\n1010\n0101\n", "w.txt");
        QCOMPARE(draft.fabric.weave.ends(), 2);
        QCOMPARE(draft.report.at(1).text, std::string("The weave repeats after 2 ends and 2 picks; one repeat was kept."));
    }
    void wrongDrawingsAreRefusedWithTheirPlace()
    {
        QCOMPARE(refusal("10\n1\n"), std::string("w.txt: line 2: All rows need 2 crossings as the longest; this one has 1."));
        QCOMPARE(refusal("10\n1a\n"),
                 std::string("w.txt: line 2, column 2: A drawing is made of 0 and 1, of . and #, or of blanks and x (warp up)."));
        QVERIFY(refusal("\n\n10\n1\n").find("line 4: ") != std::string::npos); // empty lines count
        QVERIFY(refusal("x \n x\nx.\n").find("w.txt: line 3: The drawing mixes x with other marks") != std::string::npos);
        QVERIFY(refusal("\n10\n0x\n").find("w.txt: line 3: The drawing mixes x") != std::string::npos);
        QVERIFY(refusal("\n\n").find("a weave has from 1 to 2000") != std::string::npos);
        QVERIFY(refusal(std::string(2001, '1')).find("2001 ends") != std::string::npos);
        QVERIFY(refusal(std::string("1\0", 2)).find("no text file") != std::string::npos);
    }
    void darkPixelsOfAPngAreWarpUp()
    {
        const DraftImport draft = import_picture(png_of(3, 3, {255, 0, 0, 0, 0, 255, 0, 255, 0}), "w.png");
        QVERIFY(draft.fabric.weave.same_matrix(weave_from_pattern("twill 2/1 Z")));
        QCOMPARE(draft.report.size(), std::size_t(2));
        QCOMPARE(import_picture(png_of(2, 1, {100, 255}), "w.png").report.back().severity, Severity::warning);
    }
    void allKindsOfBmpAreRead()
    {
        for (unsigned bits : {1u, 8u, 24u, 32u})
            for (bool top_first : {false, true}) {
                const Weave weave = import_picture(bmp_of(bits, top_first), "w.bmp").fabric.weave;
                QVERIFY(weave.same_matrix(Weave(3, 2, {0, 0, 1, 1, 0, 0}))); // the lower row is the first pick
            }
    }
    void brokenAndLargePicturesAreRefused()
    {
        const std::string bmp = bmp_of(24, false), png = png_of(3, 3, std::vector<std::uint8_t>(9));
        for (std::size_t size = 2; size < bmp.size(); ++size) QVERIFY(refusal(bmp.substr(0, size), true) != "accepted");
        QVERIFY(refusal(png.substr(0, png.size() / 2), true) != "accepted");
        QVERIFY(refusal(png_of(2001, 1, std::vector<std::uint8_t>(2001)), true).find("2001 ends") != std::string::npos);
    }
    void otherPicturesAreRefusedAsPictures()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("weave").toStdString();
        for (const std::string& begin : {std::string("\xFF\xD8\xFF\xE0"), std::string("GIF89a"), std::string("RIFF\1\2\3\4WEBP"),
                                         std::string("II*\0[", 5), std::string("MM\0*[", 5)}) {
            std::ofstream(path, std::ios::binary) << begin;
            try {
                import_draft(path);
                QFAIL("accepted");
            } catch (const FileError& error) {
                QCOMPARE(error.what(), path + ": Of pictures only PNG and BMP are read; save it as one of them and import it again.");
            }
        }
    }
};

} // namespace tst_weave_picture

QTEST_APPLESS_MAIN(tst_weave_picture::TestWeavePicture)
#include "tst_weave_picture.moc"
