// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Meshes as programs write them, and as they should not: each panel keeps the area that it is known to have, or is told.
#include "core/garment/check_garment.h"
#include "tests/garment/folded.h"
#include "tests/garment/sheets.h"

#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;
namespace fs = std::filesystem;

namespace {

enum class Format { obj, glb };

class Files {
public:
    fs::path at(const std::string& name) const { return fs::path(folder_.path().toStdString()) / name; }
    GarmentPattern read(const std::string& bytes, const std::string& name, UvUnit unit = UvUnit::from_lengths) const
    {
        write_bytes(at(name), bytes);
        Garment garment = from_file(at(name).string());
        garment.uv_unit = unit;
        return read_pattern(garment, {});
    }
    GarmentPattern read(const std::vector<Sheet>& sheets, Format format, UvUnit unit = UvUnit::from_lengths) const
    {
        return format == Format::obj ? read(obj_of(sheets), "x.obj", unit) : read(glb_of(sheets), "x.glb", unit);
    }
    std::string refusal(const std::string& bytes, const std::string& name) const
    {
        return refusal_of([&] { read(bytes, name); });
    }

private:
    QTemporaryDir folder_;
};

/// What is wrong with areas that should be so large; empty: all are within 1 %.
std::string wrong_areas(const GarmentPattern& pattern, const std::vector<double>& areas)
{
    if (pattern.panels.size() != areas.size()) return fmt::format("{} panels", pattern.panels.size());
    std::string wrong;
    for (std::size_t p = 0; p < areas.size(); ++p)
        if (std::abs(area_of(pattern.panels[p]) / areas[p] - 1) > 0.01)
            wrong += fmt::format("{}: {:.4f} m2 for {:.4f}. ", pattern.panels[p].name, area_of(pattern.panels[p]), areas[p]);
    return wrong;
}

/// Draws a place of a sheet to one beside it, up to what is left between them.
void pinch(Sheet& one, int place, double left)
{
    const int beside = place % (one.across + 1) == one.across ? place - 1 : place + 1;
    Vec3d& moved = one.places[static_cast<std::size_t>(place)];
    const Vec3d way = moved - one.places[static_cast<std::size_t>(beside)];
    moved = one.places[static_cast<std::size_t>(beside)] + (left / length(way)) * way;
}

/// Each sheet's flat coordinates fill a texture.
void fill_texture(std::vector<Sheet>& sheets)
{
    for (Sheet& one : sheets) {
        const FlatPlace first = one.uv.front(), last = one.uv.back();
        for (FlatPlace& uv : one.uv)
            for (std::size_t axis = 0; axis < 2; ++axis) uv[axis] = 0.05 + 0.9 * (uv[axis] - first[axis]) / (last[axis] - first[axis]);
    }
}

const std::string l_shape = "v 0 1 0.1\nv 0.4 1 0.1\nv 0.4 1.2 0.1\nv 0.2 1.2 0.1\nv 0.2 1.5 0.1\nv 0 1.5 0.1\n"
                            "vt 0 0\nvt 0.4 0\nvt 0.4 0.2\nvt 0.2 0.2\nvt 0.2 0.5\nvt 0 0.5\n";

} // namespace

class TestGarmentShapes : public QObject {
    Q_OBJECT
    Files files_;

private Q_SLOTS:
    void noPinchedCornerChangesAnArea_data()
    {
        QTest::addColumn<bool>("fills");
        QTest::addColumn<int>("squares");
        for (const int squares : {4, 7})
            for (const bool fills : {false, true}) QTest::addRow("%d squares%s", squares, fills ? ", textures" : "") << fills << squares;
    }
    /// Cloth that bunches up in one place is as large as it was.
    void noPinchedCornerChangesAnArea()
    {
        QFETCH(bool, fills);
        QFETCH(int, squares);
        for (const Format format : squares == 4 ? std::vector{Format::obj, Format::glb} : std::vector{Format::obj})
            for (int place = 0; place < (squares + 1) * (squares + 1); ++place)
                for (const double left : {0.01, 1e-4}) {
                    std::vector<Sheet> sheets{sheet("small", -0.5, 0.4, 0.5, squares, squares),
                                              sheet("large", 0.1, fills ? 0.8 : 0.4, fills ? 1 : 0.5, squares, squares)};
                    if (fills) fill_texture(sheets);
                    pinch(sheets[1], place, left);
                    const GarmentPattern pattern = files_.read(sheets, format);
                    const std::string wrong = wrong_areas(pattern, {0.2, fills ? 0.8 : 0.2});
                    QVERIFY2(wrong.empty(), fmt::format("place {}, {} m left: {}", place, left, wrong).c_str());
                    QCOMPARE(tells(pattern, "from panel to panel"), fills);
                }
    }
    void anAreaThatIsNotThatInSpaceIsTold()
    {
        std::vector<Sheet> sheets = two_sheets();
        sheets.push_back(sheet("third", 0.7, 0.4, 0.5, 8, 8));
        for (FlatPlace& uv : sheets[1].uv) uv[1] *= 1.3; // less than where panels take scales of their own
        const GarmentPattern pattern = files_.read(sheets, Format::obj);
        QVERIFY(!tells(pattern, "from panel to panel"));
        QVERIFY2(tells(pattern, "a panel in flat coordinates differs from that in space by more than 25 %: \"right\" 0.26 and 0.2 m2"),
                 all_issues(pattern).c_str());
        QVERIFY(!tells(files_.read(two_sheets(), Format::obj), "differs from that in space"));
    }
    void panelsOfOneTextureSizeTakeScalesThatDifferLittle()
    {
        std::vector<Sheet> sheets{sheet("a", -0.5, 0.4, 0.5, 6, 6), sheet("b", 0.1, 0.36, 0.45, 6, 6)};
        fill_texture(sheets);
        const std::string wrong = wrong_areas(files_.read(sheets, Format::glb), {0.2, 0.162});
        QVERIFY2(wrong.empty(), wrong.c_str());
    }
    /// A row of the flat coordinates lies folded; the outline does not.
    void foldedTrianglesLeaveTheOutline()
    {
        for (const UvUnit unit : {UvUnit::from_lengths, UvUnit::metre})
            for (int row = 1; row < 8; ++row)
                for (const bool along : {false, true}) {
                    std::vector<Sheet> sheets{sheet("front", 0, 0.4, 0.5, 8, 8)};
                    for (int i = 1; i < 8; ++i)
                        sheets[0].uv[static_cast<std::size_t>(along ? sheets[0].at(row, i) : sheets[0].at(i, row))][along ? 0 : 1] +=
                            along ? 0.06 : 0.07;
                    const GarmentPattern pattern = files_.read(sheets, Format::obj, unit);
                    QCOMPARE(wrong_areas(pattern, {0.2}), std::string());
                    QCOMPARE(pattern.panels[0].edges.size(), std::size_t(4));
                    QVERIFY(tells(pattern, "14 triangles that lie folded over"));
                    QVERIFY(!tells(pattern, "holes"));
                }
    }
    void trianglesThatFaceTheOtherWayAreTurned()
    {
        std::vector<Sheet> sheets = two_sheets();
        for (const std::size_t t : {std::size_t(0), std::size_t(40), std::size_t(41)})
            std::swap(sheets[0].triangles[t][0], sheets[0].triangles[t][1]);
        const GarmentPattern pattern = files_.read(sheets, Format::obj);
        QCOMPARE(wrong_areas(pattern, {0.2, 0.2}), std::string());
        QVERIFY2(tells(pattern, "3 triangles faced the other way") && !tells(pattern, "folded") && !tells(pattern, "holes"),
                 all_issues(pattern).c_str());
    }
    /// A band whose ends are joined the wrong way round has one face only.
    void aMoebiusStripIsPartedSomewhere()
    {
        std::string obj;
        for (int i = 0; i < 12; ++i)
            for (int k = 0; k < 2; ++k) {
                const double turn = 2 * 3.14159265 * i / 12, out = 0.3 + 0.1 * (k - 0.5) * std::cos(0.5 * turn);
                obj += fmt::format("v {} {} {}\nvt {} {}\n", out * std::cos(turn), 1 + 0.1 * (k - 0.5) * std::sin(0.5 * turn),
                                   out * std::sin(turn), 0.02 * i, 0.1 * k);
            }
        for (int i = 0; i < 12; ++i) {
            const int a = 2 * i + 1, b = 2 * i + 2, c = i < 11 ? a + 2 : 2, d = i < 11 ? b + 2 : 1;
            obj += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\nf {1}/{1} {3}/{3} {2}/{2}\n", a, b, c, d);
        }
        QCOMPARE(files_.read(obj, "x.obj").panels.size(), std::size_t(1));
    }
    void aHoleIsToldAndAMeshOfTwoFacesReadOnce()
    {
        std::vector<Sheet> sheets = two_sheets();
        const auto hole = sheets[0].triangles.begin() + 2 * (3 * 8 + 4);
        sheets[0].triangles.erase(hole, hole + 2);
        const GarmentPattern pattern = files_.read(sheets, Format::obj);
        QCOMPARE(wrong_areas(pattern, {0.2, 0.2}), std::string());
        QVERIFY(tells(pattern, "\"left\" has 1 holes"));
        sheets = two_sheets();
        const auto one_face = sheets[0].triangles;
        for (const auto& [a, b, c] : one_face) sheets[0].triangles.push_back({a, c, b});
        const GarmentPattern both = files_.read(sheets, Format::obj);
        QCOMPARE(wrong_areas(both, {0.2, 0.2}), std::string());
        QVERIFY2(tells(both, "128 triangles lie on others"), all_issues(both).c_str());
    }
    void panelsThatTouchInACornerAreApart()
    {
        std::vector<Sheet> sheets = two_sheets();
        for (std::size_t i = 0; i < sheets[1].places.size(); ++i) { // its corner is the other's, in space and flat
            sheets[1].places[i] = sheets[1].places[i] + Vec3d{-0.2, 0.5, 0};
            sheets[1].uv[i] = {-sheets[1].uv[i][0] - 0.1 + 0.1, sheets[1].uv[i][1] + 0.5}; // mirrored
        }
        for (FlatPlace& uv : sheets[1].uv) uv[0] -= -0.1 + 0.1;
        const GarmentPattern pattern = files_.read(sheets, Format::obj);
        QCOMPARE(wrong_areas(pattern, {0.2, 0.2}), std::string());
        QVERIFY(tells(pattern, "1 of 2 panels had mirrored"));
    }
    void concaveFacesAreCutByTheirEars()
    {
        for (int first = 0; first < 6; ++first)
            for (const bool mirrored : {false, true}) {
                std::string face = "f";
                for (int i = 0; i < 6; ++i) {
                    const int corner = 1 + (mirrored ? first + 6 - i : first + i) % 6;
                    face += fmt::format(" {0}/{0}", corner);
                }
                const GarmentPattern pattern = files_.read(l_shape + face + "\n", "l.obj");
                QCOMPARE(wrong_areas(pattern, {0.14}), std::string());
                QCOMPARE(pattern.panels[0].edges.size(), std::size_t(6));
                QVERIFY(!tells(pattern, "holes") && !tells(pattern, "folded"));
                QCOMPARE(tells(pattern, "mirrored"), mirrored);
            }
    }
    void aFaceWithCornersOnItsSidesIsWhole()
    {
        // The long side of a comb has a corner opposite each tooth.
        std::string places, flats, face = "f";
        std::vector<FlatPlace> corners;
        for (int i = 0; i <= 6; ++i) corners.push_back({0.1 * i, 0});
        for (int i = 6; i >= 0; --i) corners.push_back({0.1 * i, i % 2 == 0 ? 0.5 : 0.2});
        double twice = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const FlatPlace &p = corners[i], &q = corners[(i + 1) % corners.size()];
            twice += p[0] * q[1] - p[1] * q[0];
            places += fmt::format("v {} {} 0\n", p[0], 1 + p[1]);
            flats += fmt::format("vt {} {}\n", p[0], p[1]);
        }
        for (std::size_t first = 0; first < corners.size(); ++first) {
            face = "f";
            for (std::size_t i = 0; i < corners.size(); ++i) face += fmt::format(" {0}/{0}", 1 + (first + i) % corners.size());
            const GarmentPattern pattern = files_.read(places + flats + face + "\n", "comb.obj", UvUnit::metre);
            QCOMPARE(wrong_areas(pattern, {0.5 * twice}), std::string());
            QVERIFY(!tells(pattern, "cross themselves") && !tells(pattern, "holes"));
        }
        const GarmentPattern crossed = files_.read(
            "v 0 1 0\nv 1 1 0\nv 0 2 0\nv 1 2 0.5\nvt 0 0\nvt 1 0\nvt 0.2 1\nvt 1 1\nf 1/1 2/2 3/3 4/4\n", "crossed.obj", UvUnit::metre);
        QVERIFY2(tells(crossed, "1 faces cross themselves"), all_issues(crossed).c_str());
    }
    void linesOfObjGoOnAfterABackslash()
    {
        std::string text = obj_of(two_sheets());
        const std::string whole = text;
        for (std::size_t at = 0; (at = text.find("/1 ", at)) != std::string::npos;) text.replace(at += 3, 0, "\\\n  ");
        text = "# not \\\n" + text;
        QVERIFY(text.size() > whole.size() + 8);
        QCOMPARE(wrong_areas(files_.read(text, "x.obj"), {0.2, 0.2}), std::string());
        std::string of_a_mac;
        for (const char c : whole) of_a_mac += c == '\n' ? '\r' : c;
        QCOMPARE(wrong_areas(files_.read(of_a_mac, "x.obj"), {0.2, 0.2}), std::string());
        std::string broken = whole + "f 1/1 2/2 \\\n 99999/3\n";
        QVERIFY(files_.refusal(broken, "x.obj").find("given is \"99999\"") != std::string::npos);
    }
    void aNodeThatMirrorsTurnsItsFaces()
    {
        std::vector<Sheet> once{sheet("front", -0.2, 0.4, 0.5, 4, 4)};
        for (const char* mirrored : {R"("translation":[-0.3,0,0],"scale":[-1,1,1])", R"("matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,-0.3,0,0,1])"}) {
            GlbForm form;
            form.nodes = {R"({"mesh":0,"name":"left","translation":[0.3,0,0]})",
                          fmt::format(R"({{"mesh":0,"name":"right",{}}})", mirrored)};
            const GarmentPattern pattern = files_.read(glb_of(once, form), "x.glb");
            QCOMPARE(wrong_areas(pattern, {0.2, 0.2}), std::string());
            QVERIFY2(tells(pattern, "1 of 2 panels had mirrored"), all_issues(pattern).c_str());
            for (std::size_t t = 0; t < pattern.shape.triangles.size(); ++t) {
                const auto place = [&](std::size_t k) {
                    return pattern.shape.places[static_cast<std::size_t>(pattern.shape.triangles[t][k])];
                };
                QVERIFY(cross(place(1) - place(0), place(2) - place(0)).z > 0);
            }
        }
    }
    void integersOfGlbAreSharesOfOne_data()
    {
        QTest::addColumn<int>("type");
        for (const int type : {5120, 5121, 5122, 5123, 5126}) QTest::addRow("%d", type) << type;
    }
    void integersOfGlbAreSharesOfOne()
    {
        QFETCH(int, type);
        const std::vector<Sheet> sheets{sheet("front", 0, 0.4, 0.5, 4, 4)};
        GlbForm form;
        form.uv_type = type;
        const GarmentPattern pattern = files_.read(glb_of(sheets, form), "x.glb", UvUnit::metre);
        const double off = std::abs(area_of(pattern) / 0.2 - 1);
        QVERIFY2(off < (type == 5120 || type == 5121 ? 0.01 : 1e-4), QByteArray::number(off)); // rounded to 1/127 of a metre
        QCOMPARE(pattern.panels[0].edges.size(), std::size_t(4));
    }
    void quantizedPlacesAreReadAndOtherRequiredExtensionsRefused()
    {
        GlbForm form;
        form.quantized = true;
        form.extra = R"(,"extensionsUsed":["KHR_mesh_quantization"],"extensionsRequired":["KHR_mesh_quantization"])";
        const GarmentPattern pattern = files_.read(glb_of(two_sheets(), form), "x.glb");
        QCOMPARE(wrong_areas(pattern, {0.2, 0.2}), std::string());
        QCOMPARE(pattern.panels[0].edges.size(), std::size_t(4));
        for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_texture_transform", "X_y"}) {
            form.extra = fmt::format(R"(,"extensionsRequired":["KHR_mesh_quantization","{}"])", name);
            const std::string message = files_.refusal(glb_of(two_sheets(), form), "x.glb");
            QVERIFY2(message.find(fmt::format("requires the extension {}, which is not read", name)) != std::string::npos, message.c_str());
        }
    }
    void sizesThatNoGarmentHasAreTold()
    {
        for (const double times : {100.0, 5.5, 0.05, 0.01}) {
            std::vector<Sheet> sheets = two_sheets();
            for (Sheet& one : sheets)
                for (Vec3d& place : one.places) place = times * place;
            const std::string glb = glb_of(sheets);
            const GarmentPattern pattern = files_.read(glb, "x.glb");
            const double high = 0.5 * times;
            QVERIFY2(tells(pattern, fmt::format("The garment is {:.3g} m high", high)), all_issues(pattern).c_str());
            Design design;
            design.garments.push_back(from_file("x.glb"));
            const GarmentCheck check = check_garments(design, files_.at(""), {});
            QVERIFY(std::any_of(check.issues.begin(), check.issues.end(), [](const Issue& issue) {
                return issue.severity == Severity::warning && issue.code == "garment_shape" && issue.where.text() == "garments[0].source";
            }));
        }
        QVERIFY(files_.read(glb_of(two_sheets()), "x.glb").doubts.empty());
    }
    void clothThatLiesOnItselfIsTold()
    {
        for (const double thick : {0.0005, 0.003}) {
            std::vector<Sheet> sheets = two_sheets();
            Sheet inner = sheets[0];
            inner.name = "left inside";
            for (Vec3d& place : inner.places) place.z -= thick;
            for (FlatPlace& uv : inner.uv) uv[0] += 2;
            for (auto& triangle : inner.triangles) std::swap(triangle[0], triangle[1]); // it faces inwards
            sheets.push_back(inner);
            const GarmentPattern pattern = files_.read(sheets, Format::glb);
            QVERIFY2(tells(pattern, "\"left\" and \"left inside\" lie on each other within 5 mm"), all_issues(pattern).c_str());
            QCOMPARE(pattern.doubts.size(), std::size_t(1));
        }
        std::vector<Sheet> sheets = two_sheets();
        Sheet pocket = sheet("pocket", -0.4, 0.15, 0.15, 4, 4);
        for (Vec3d& place : pocket.places) place.z += 0.002;
        for (FlatPlace& uv : pocket.uv) uv[0] += 2;
        sheets.push_back(pocket);
        const GarmentPattern pattern = files_.read(sheets, Format::glb);
        QVERIFY2(pattern.doubts.empty(), all_issues(pattern).c_str());
    }
    void plyIsReadInItsThreeForms()
    {
        for (const PlyForm form : {PlyForm::text, PlyForm::little, PlyForm::big}) {
            const std::string good = ply_of(two_sheets(4, 4), form);
            QCOMPARE(wrong_areas(files_.read(good, "x.ply"), {0.2, 0.2}), std::string());
            const std::size_t header = good.find("end_header");
            for (const std::size_t cut : {std::size_t(20), header - 3, header + 11, good.size() - 5}) {
                const std::string message = files_.refusal(good.substr(0, cut), "x.ply");
                QVERIFY2(message.find("cut short") != std::string::npos || message.find("which PLY has not") != std::string::npos,
                         message.c_str());
            }
            std::string beyond = good;
            beyond.replace(
                beyond.rfind(form == PlyForm::text ? "49" : std::string(form == PlyForm::little ? "\x31\0\0\0" : "\0\0\0\x31", 4)), 2,
                form == PlyForm::text     ? "50"
                : form == PlyForm::little ? std::string("\x32\0", 2)
                                          : std::string("\x01\0", 2));
            const std::string message = files_.refusal(beyond, "x.ply");
            QVERIFY2(message.find("which is not there; the last is 49") != std::string::npos, message.c_str());
        }
        const std::string many = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n";
        QVERIFY(files_.refusal(many, "x.ply").find("its header says 4000000000 rows") != std::string::npos);
        const std::string corners =
            "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n"
            "element face 1\r\nproperty list uchar int vertex_index\r\nproperty list uchar float texcoord\r\nend_header\r\n"
            "0 1 0\r\n0.4 1 0\r\n0.4 1.5 0\r\n0 1.5 0\r\n4 0 1 2 3 8 0 0 0.4 0 0.4 0.5 0 0.5\r\n";
        QCOMPARE(wrong_areas(files_.read(corners, "x.ply"), {0.2}), std::string());
    }
};

QTEST_APPLESS_MAIN(TestGarmentShapes)
#include "tst_garment_shapes.moc"
