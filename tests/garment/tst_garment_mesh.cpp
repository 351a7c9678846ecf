// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Meshes with flat coordinates as garments: drapes of patterns, and what CLO, Blender and others write.
#include "core/garment/fill.h"
#include "tests/garment/folded.h"

#include <QTemporaryDir>
#include <QTest>

#include <assimp/Exporter.hpp>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <array>
#include <functional>

using namespace hygroloom;
namespace fs = std::filesystem;

namespace {

using SheetOf = std::function<FlatPlace(int panel, const FlatPlace& flat)>;

/// The drape of a pattern as GarmentCode writes it: places in cm on a tube, flat coordinates as the sheet has them.
void write_drape(const GarmentPattern& pattern, const fs::path& folder, const SheetOf& sheet)
{
    std::string obj, names;
    for (std::size_t i = 0; i < pattern.shape.flat.size(); ++i) {
        int panel = 0;
        for (std::size_t t = 0; t < pattern.shape.triangles.size(); ++t)
            for (const int corner : pattern.shape.triangles[t])
                if (corner == static_cast<int>(i)) panel = pattern.shape.panel[t];
        const FlatPlace& flat = pattern.shape.flat[i];
        const Vec3d place = 100.0 * (folded(flat, 0.12 + 0.03 * panel, panel % 2 == 1) + Vec3d{0, 0.02 * panel, 0});
        const FlatPlace uv = sheet(panel, flat);
        obj += fmt::format("v {:.9g} {:.9g} {:.9g}\nvt {:.12g} {:.12g}\n", place.x, place.y, place.z, uv[0], uv[1]);
        names += i % 5 == 0 ? fmt::format("stitch_{},x\n", i) : pattern.panels[static_cast<std::size_t>(panel)].name + "\n";
    }
    for (const auto& [a, b, c] : pattern.shape.triangles) obj += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", a + 1, b + 1, c + 1);
    write_bytes(folder / "tee_sim.obj", obj);
    write_bytes(folder / "tee_sim_segmentation.txt", names);
}

GarmentPattern small_tee()
{
    GarmentPattern pattern = pattern_from_json(bytes_of(garments + "tee.json"), "tee.json");
    make_shape(pattern, [](int, const FlatPlace&) { return Vec3d{}; });
    return pattern;
}

constexpr double radius = 0.15, height = 0.5;
constexpr int around = 24, up = 20;

/// Two halves of a tube, sewn to each other at both sides. unit: flat coordinates per metre.
struct Tube {
    double unit = 1000, size = 100; ///< of flat coordinates and of space, per m
    bool welded = false, mirror_back = false, on_each_other = false;
    std::vector<std::string> labels{"front", "back"};
    std::array<std::array<double, 2>, 2> own_scales{{{1, 1}, {1, 1}}}; ///< of each panel's flat coordinates, across and along

    Vec3d place(int panel, int i, int k) const
    {
        const double turn = pi_ * i / around - 0.5 * pi_, side = panel == 0 ? 1 : -1;
        return size * Vec3d{side * radius * std::sin(turn), 1 + height * k / up, side * radius * std::cos(turn)};
    }
    FlatPlace uv(int panel, int i, int k) const
    {
        const double x = pi_ * radius * i / around, side = panel == 1 && mirror_back ? -1 : 1;
        const std::array<double, 2>& own = own_scales[static_cast<std::size_t>(panel)];
        return {own[0] * unit * (side * x + (on_each_other ? 0 : 0.6 * panel)), own[1] * unit * height * k / up};
    }
    static constexpr double pi_ = 3.14159265358979323846;

    std::string obj() const
    {
        std::string text;
        for (int panel = 0; panel < 2; ++panel)
            for (int k = 0; k <= up; ++k)
                for (int i = 0; i <= around; ++i) {
                    const Vec3d p = place(panel, i, k);
                    const FlatPlace flat = uv(panel, i, k);
                    text += fmt::format("v {:.9g} {:.9g} {:.9g}\nvt {:.9g} {:.9g}\n", p.x, p.y, p.z, flat[0], flat[1]);
                }
        for (int panel = 0; panel < 2; ++panel) {
            if (!labels.empty()) text += "g " + labels[static_cast<std::size_t>(panel)] + "\n";
            const auto number = [&](int i, int k) { return 1 + (panel * (up + 1) + k) * (around + 1) + i; };
            const auto vertex = [&](int i, int k) { // the back's sides are the front's where they are welded
                return welded && panel == 1 && (i == 0 || i == around) ? 1 + k * (around + 1) + (around - i) : number(i, k);
            };
            for (int k = 0; k < up; ++k)
                for (int i = 0; i < around; ++i)
                    text += fmt::format("f {}/{} {}/{} {}/{} {}/{}\n", vertex(i, k), number(i, k), vertex(i + 1, k), number(i + 1, k),
                                        vertex(i + 1, k + 1), number(i + 1, k + 1), vertex(i, k + 1), number(i, k + 1));
        }
        return text;
    }
    GarmentPattern read(UvUnit given = UvUnit::from_lengths) const { return pattern_from_obj(obj(), "tube.obj", given); }
};

/// A mesh per panel, written by Assimp.
void write_scene(const Tube& tube, const fs::path& path, const char* format)
{
    aiScene scene;
    scene.mRootNode = new aiNode("garment");
    scene.mNumMaterials = 1;
    scene.mMaterials = new aiMaterial* [1] { new aiMaterial };
    scene.mNumMeshes = 2;
    scene.mMeshes = new aiMesh*[2];
    scene.mRootNode->mNumChildren = 2;
    scene.mRootNode->mChildren = new aiNode*[2];
    for (unsigned panel = 0; panel < 2; ++panel) {
        auto* mesh = scene.mMeshes[panel] = new aiMesh;
        mesh->mName = tube.labels[panel] + " mesh";
        mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
        mesh->mNumVertices = (up + 1) * (around + 1);
        mesh->mVertices = new aiVector3D[mesh->mNumVertices];
        mesh->mNormals = new aiVector3D[mesh->mNumVertices];
        mesh->mTextureCoords[0] = new aiVector3D[mesh->mNumVertices];
        mesh->mNumUVComponents[0] = 2;
        mesh->mNumFaces = 2 * up * around;
        mesh->mFaces = new aiFace[mesh->mNumFaces];
        unsigned face = 0;
        for (int k = 0; k <= up; ++k)
            for (int i = 0; i <= around; ++i) {
                const auto at = static_cast<unsigned>(k * (around + 1) + i), next = at + around + 1;
                const Vec3d p = tube.place(static_cast<int>(panel), i, k);
                const FlatPlace uv = tube.uv(static_cast<int>(panel), i, k);
                mesh->mVertices[at] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
                mesh->mNormals[at] = {0, 0, 1};
                mesh->mTextureCoords[0][at] = {static_cast<float>(uv[0]), static_cast<float>(uv[1]), 0};
                if (i == around || k == up) continue;
                for (const auto& corners : {std::array{at, at + 1, next + 1}, std::array{at, next + 1, next}}) {
                    aiFace& triangle = mesh->mFaces[face++];
                    triangle.mNumIndices = 3;
                    triangle.mIndices = new unsigned[3]{corners[0], corners[1], corners[2]};
                }
            }
        auto* node = scene.mRootNode->mChildren[panel] = new aiNode(tube.labels[panel]);
        node->mParent = scene.mRootNode;
        node->mNumMeshes = 1;
        node->mMeshes = new unsigned[1]{panel};
    }
    Assimp::Exporter exporter;
    if (exporter.Export(&scene, format, path.string()) != aiReturn_SUCCESS) qFatal("%s", exporter.GetErrorString());
}

const double half_tube = Tube::pi_ * radius * height; // m2

} // namespace

class TestGarmentMesh : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    fs::path at(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }

private Q_SLOTS:
    void drapesTakeTheirScaleFromThePattern_data()
    {
        QTest::addColumn<double>("scale"); // m of one unit of the sheet
        QTest::addColumn<bool>("turned");
        QTest::newRow("sheet of 1.3 m") << 1.3 << false;
        QTest::newRow("turned") << 0.77 << true;
        QTest::newRow("millimetres") << 0.001 << false;
    }
    void drapesTakeTheirScaleFromThePattern()
    {
        QFETCH(double, scale);
        QFETCH(bool, turned);
        const GarmentPattern pattern = small_tee();
        write_bytes(at("tee_specification.json"), bytes_of(garments + "tee.json"));
        write_drape(pattern, at(""), [&](int panel, const FlatPlace& flat) {
            const FlatPlace p = turned && panel % 2 ? FlatPlace{-flat[1], flat[0]} : flat;
            return FlatPlace{(p[0] + 0.7 * panel) / scale, (p[1] + 0.4) / scale};
        });
        for (const char* source : {"tee_specification.json", "tee_sim.obj"}) {
            const GarmentPattern read = read_pattern(from_file(source), at(""));
            QVERIFY(read.is_draped);
            QVERIFY2(std::abs(read.uv_scale / scale - 1) < 0.005, QByteArray::number(read.uv_scale));
            QCOMPARE(read.shape.flat.size(), pattern.shape.flat.size());
            QCOMPARE(read.shape.triangles.size(), pattern.shape.triangles.size());
            QCOMPARE(read.seams.size(), pattern.seams.size());
            for (std::size_t t = 0; t < read.shape.triangles.size(); ++t) {
                const auto corner = static_cast<std::size_t>(read.shape.triangles[t][0]);
                const auto panel = static_cast<std::size_t>(read.shape.panel[t]);
                const Vec3d expected = folded(read.shape.flat[corner], 0.12 + 0.03 * static_cast<double>(panel), panel % 2 == 1) +
                                       Vec3d{0, 0.02 * static_cast<double>(panel), 0};
                QVERIFY2(length(read.shape.places[corner] - expected) < 1e-4,
                         read.panels[panel].name.c_str()); // m: metres, and the pattern's own places
            }
        }
    }
    void drapesThatAreScaledUnevenlyAreRefused()
    {
        write_bytes(at("tee.json"), bytes_of(garments + "tee.json"));
        fs::remove(at("tee_specification.json"));
        const auto uneven = [&](double by) {
            write_drape(small_tee(), at(""), [&](int panel, const FlatPlace& flat) { return FlatPlace{flat[0] + panel, by * flat[1]}; });
            return refusal_of([&] { read_pattern(from_file("tee.json"), at("")); });
        };
        const std::string message = uneven(1 / 1.05);
        QVERIFY2(message.find("1 m of cloth across and 1.05 m along") != std::string::npos, message.c_str());
        QCOMPARE(uneven(1 / 1.01), std::string());
        write_bytes(at("tee_sim_segmentation.txt"), "front\nback\n");
        const std::string short_text = refusal_of([&] { read_pattern(from_file("tee.json"), at("")); });
        QVERIFY2(short_text.find("the text beside it names 2") != std::string::npos, short_text.c_str());
    }
    void panelsThatEachFillATextureTakeTheirOwnScales()
    {
        Tube tube;
        tube.unit = 1;
        const auto areas = [](const GarmentPattern& pattern) {
            std::array<double, 2> of_half{};
            for (std::size_t k = 0; k < 2; ++k) of_half[k] = area_of(pattern.panels[k]) / half_tube;
            return of_half;
        };
        tube.own_scales = {{{0.7, 1.4}, {2, 0.5}}};
        const GarmentPattern filled = tube.read();
        QVERIFY(std::abs(areas(filled)[0] - 1) < 0.01 && std::abs(areas(filled)[1] - 1) < 0.01);
        QCOMPARE(filled.uv_scale, 0.0);
        const auto tells = [](const GarmentPattern& pattern) {
            return std::any_of(pattern.issues.begin(), pattern.issues.end(),
                               [](const std::string& issue) { return issue.find("from panel to panel") != std::string::npos; });
        };
        QVERIFY(tells(filled));
        QCOMPARE(filled.seams.size(), std::size_t(2));
        tube.own_scales = {{{1, 1}, {1.1, 1}}}; // a panel that is worn stretched
        const GarmentPattern stretched = tube.read();
        QVERIFY(stretched.uv_scale > 0 && !tells(stretched));
        QVERIFY(areas(stretched)[1] / areas(stretched)[0] > 1.09);
        tube.own_scales = {{{0.7, 1.4}, {2, 0.5}}};
        QVERIFY(tube.read(UvUnit::metre).uv_scale == 1); // as it was given
    }
    void islandsArePanelsAndMeetingSidesAreSewn_data()
    {
        QTest::addColumn<bool>("welded");
        QTest::addColumn<double>("unit");
        QTest::addColumn<double>("size");
        QTest::newRow("mm, cm") << false << 1000.0 << 100.0;
        QTest::newRow("welded, 0 to 1") << true << 0.8 << 1.0;
        QTest::newRow("cm, mm") << true << 100.0 << 1000.0;
    }
    void islandsArePanelsAndMeetingSidesAreSewn()
    {
        QFETCH(bool, welded);
        QFETCH(double, unit);
        QFETCH(double, size);
        Tube tube;
        tube.welded = welded;
        tube.unit = unit;
        tube.size = size;
        const GarmentPattern pattern = tube.read();
        QCOMPARE(pattern.panels.size(), std::size_t(2));
        QCOMPARE(pattern.panels[0].name, std::string("front"));
        QCOMPARE(pattern.panels[1].name, std::string("back"));
        QVERIFY(std::abs(pattern.uv_scale * unit - 1) < 0.005); // chords are shorter than arcs
        QVERIFY(pattern.uv_scale_spread < 0.005);
        for (const PatternPanel& panel : pattern.panels) {
            QCOMPARE(panel.edges.size(), std::size_t(4));
            QVERIFY(std::abs(area_of(panel) / half_tube - 1) < 0.01);
            QVERIFY(cross(panel.placed[1], panel.placed[2]).z * (panel.name == "front" ? 1 : -1) > 0); // it faces outwards
        }
        QCOMPARE(pattern.seams.size(), std::size_t(2));
        for (const PatternSeam& seam : pattern.seams) {
            QVERIFY(seam.reversed && seam.panel_a == 0 && seam.panel_b == 1);
            const auto long_as = [&](int p, int e) {
                return perimeter_of({"", {pattern.panels[static_cast<std::size_t>(p)].edges[static_cast<std::size_t>(e)]}, {}, false});
            };
            QVERIFY(std::abs(long_as(seam.panel_a, seam.edge_a) - height) < 0.005 &&
                    std::abs(long_as(seam.panel_b, seam.edge_b) - height) < 0.005);
        }
        QCOMPARE(body_zones()[static_cast<std::size_t>(zone_at(pattern, 1, {0, 1.3, -radius}))], std::string("back"));
        double highest = 0;
        for (const Vec3d& place : pattern.shape.places) highest = std::max(highest, place.y);
        QVERIFY(std::abs(highest - 1.5) < 1e-6); // m
    }
    void aGivenUnitIsUsed()
    {
        Tube tube;
        const GarmentPattern pattern = tube.read(UvUnit::millimetre);
        QCOMPARE(pattern.uv_scale, 0.001);
        QCOMPARE(pattern.uv_scale_spread, 0.0);
        QVERIFY(std::abs(area_of(pattern) / (2 * half_tube) - 1) < 1e-6);
        tube.unit = 800;
        QVERIFY(tells(tube.read(UvUnit::millimetre), "uv_unit is used"));
    }
    void whatLooksWrongIsTold()
    {
        Tube tube;
        tube.mirror_back = true;
        const GarmentPattern mirrored = tube.read();
        QVERIFY(tells(mirrored, "1 of 2 panels had mirrored"));
        QVERIFY(cross(mirrored.panels[1].placed[1], mirrored.panels[1].placed[2]).z < 0);
        tube = {};
        tube.on_each_other = true;
        QVERIFY(tells(tube.read(), "overlap"));
        tube = {};
        tube.labels = {};
        QCOMPARE(tube.read().panels[1].name, std::string("panel_2"));
        QVERIFY(tells(pattern_from_obj(Tube().obj() + "f 27/27 28/28 60/60\n", "x", UvUnit::from_lengths), "more than two triangles"));
        QVERIFY(!tells(Tube().read(), "panel"));
    }
    void otherFormatsGiveTheSamePanels_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("format");
        QTest::addColumn<double>("size");
        QTest::newRow("glb") << "tube.glb"
                             << "glb2" << 1.0;
        QTest::newRow("gltf") << "tube.gltf"
                              << "gltf2" << 1.0;
        QTest::newRow("collada") << "tube.dae"
                                 << "collada" << 1.0;
        QTest::newRow("ply") << "tube.ply"
                             << "plyb" << 100.0;
        QTest::newRow("fbx") << "tube.fbx"
                             << "fbxa" << 100.0;
    }
    void otherFormatsGiveTheSamePanels()
    {
        QFETCH(QString, file);
        QFETCH(QString, format);
        QFETCH(double, size);
        Tube tube;
        tube.size = size;
        tube.unit = 0.7;
        const fs::path path = at(file.toUtf8());
        write_scene(tube, path, format.toUtf8());
        const GarmentPattern pattern = read_pattern(from_file(path.string()), {});
        QCOMPARE(pattern.panels.size(), std::size_t(2));
        QCOMPARE(pattern.seams.size(), std::size_t(2));
        QVERIFY2(std::abs(pattern.uv_scale * 0.7 - 1) < 0.005, QByteArray::number(pattern.uv_scale));
        QVERIFY(std::abs(area_of(pattern) / (2 * half_tube) - 1) < 0.01);
        const bool nameless = format == "plyb";
        QCOMPARE(pattern.panels[0].name, std::string(nameless ? "panel_1" : "front"));
        QVERIFY2(!tells(pattern, "mirrored"), all_issues(pattern).c_str());
    }
    void whatIsNoMeshIsRefused()
    {
        const auto refused = [](const std::string& text) {
            return refusal_of([&] { pattern_from_obj(text, "x.obj", UvUnit::from_lengths); });
        };
        const std::string two = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        for (const auto& [text, says] :
             {std::pair(std::string(), "x.obj: The file has no faces"), std::pair(two + "f 1 2 3\n", "no flat coordinates"),
              std::pair(two + "vt 0 0\nf 1/1 2/1 4/1\n", "line 5: This must be a number from 1 to 3; given is \"4\""),
              std::pair(two + "v 0 x 0\n", "line 4: This must be a number; given is \"x\""),
              std::pair(two + "vt 0 0\nf 1/1 2/1 3/1\n", "no size"), std::pair(two + "v 1e300 0 0\n", "line 4")})
            QVERIFY2(refused(text).find(says) != std::string::npos, refused(text).c_str());
        write_bytes(at("x.stl"), "solid");
        QVERIFY(refusal_of([&] { read_pattern(from_file("x.stl"), at("")); }).find(".obj, .glb") != std::string::npos);
        for (const char* name : {"x.glb", "x.fbx", "x.ply", "x.dae", "x.gltf"}) {
            write_bytes(at(name), "glTF\1\0\0\0 no mesh at all");
            QVERIFY2(!refusal_of([&] { read_pattern(from_file(name), at("")); }).empty(), name);
        }
        QVERIFY(!refusal_of([&] { read_pattern(from_file("none.glb"), at("")); }).empty());
    }
    /// A file of a stranger may name others, anywhere.
    void buffersOutsideOfTheFolderAreNotOpened()
    {
        fs::create_directories(at("in"));
        const std::array<float, 15> numbers{0, 0, 0, 0.3f, 0, 0, 0, 0.2f, 0, 0, 0, 1, 0, 0, 1};
        const std::string bytes(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
        write_bytes(at("in/own.bin"), bytes);
        write_bytes(at("outside.bin"), bytes);
        fs::create_symlink(at("outside.bin"), at("in/link.bin"));
        const auto refusal = [&](const std::string& uri) {
            write_bytes(at("in/one.gltf"), fmt::format(R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
                "nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"TEXCOORD_0":1}}}}]}}],
                "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}},
                {{"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}}],
                "bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":36}},{{"buffer":0,"byteOffset":36,"byteLength":24}}],
                "buffers":[{{"byteLength":60,"uri":"{}"}}]}})",
                                                       uri));
            return refusal_of([&] { read_pattern(from_file(at("in/one.gltf").string()), {}); });
        };
        QCOMPARE(refusal("own.bin"), std::string());
        for (const char* uri : {"../outside.bin", "link.bin", "%2e%2e/outside.bin", "../in/../outside.bin"})
            QVERIFY2(!refusal(uri).empty(), uri);
    }
    void changedBytesAreReadOrRefused()
    {
        const std::string good = Tube().obj();
        unsigned seed = 5;
        const auto random = [&seed] { return (seed = seed * 1664525u + 1013904223u) >> 8; };
        int refused = 0;
        for (int i = 0; i < 60; ++i) {
            std::string text = good;
            for (int k = 0; k < 4; ++k) text[random() % text.size()] = "0123456789.-e/ \nvtfg"[random() % 20];
            refused += !refusal_of([&] { pattern_from_obj(text, "x", UvUnit::from_lengths); }).empty();
        }
        QVERIFY(refused > 2 && refused < 60);
    }
};

QTEST_APPLESS_MAIN(TestGarmentMesh)
#include "tst_garment_mesh.moc"
