// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Written meshes are read back with Assimp, as other programs would.
#include "core/base/error.h"
#include "core/project/mesh_file.h"

#include <QTemporaryDir>
#include <QTest>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>

using namespace hygroloom;
namespace fs = std::filesystem;

namespace tst_mesh_file {
namespace {

Fabric fabric()
{
    Fabric fabric;
    fabric.name = "cloth";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    fabric.warp.color = Color{200, 40, 30};
    fabric.weave = weave_from_pattern("twill 2/1 Z");
    fabric.flyaway = {0.5, 2, 0.1, 0.5};
    return fabric;
}

Textile cloth() { return build_textile({}, fabric(), {0, 0, 4, 3}); }

ExportOptions with(MeshDetail detail, bool capped = true)
{
    ExportOptions options;
    options.mesh = {detail, 8, detail == MeshDetail::fibre ? 5 : 12, true, capped, 1};
    return options;
}

struct Content {
    std::size_t faces = 0, vertices = 0;
    aiVector3D low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
    double volume = 0; ///< more than 0 when triangles run anticlockwise seen from outside
    std::set<std::string> names;
    std::map<std::string, aiColor3D> colors; ///< of the materials of meshes
    bool vertex_colors = false, uvs = true, normals = true;
};

void collect(const aiScene& scene, const aiNode& node, const aiMatrix4x4& above, Content& content)
{
    const aiMatrix4x4 here = above * node.mTransformation;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
        content.faces += mesh.mNumFaces;
        content.vertices += mesh.mNumVertices;
        content.names.insert(node.mName.C_Str());
        content.vertex_colors = mesh.HasVertexColors(0);
        content.uvs = content.uvs && mesh.HasTextureCoords(0);
        content.normals = content.normals && mesh.HasNormals();
        if (mesh.mMaterialIndex < scene.mNumMaterials) {
            aiColor3D color;
            const aiMaterial& material = *scene.mMaterials[mesh.mMaterialIndex];
            if (material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS) content.colors[node.mName.C_Str()] = color;
        }
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D p = here * mesh.mVertices[v];
            for (unsigned axis = 0; axis < 3; ++axis) {
                content.low[axis] = std::min(content.low[axis], p[axis]);
                content.high[axis] = std::max(content.high[axis], p[axis]);
            }
        }
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            if (mesh.mFaces[f].mNumIndices != 3) continue;
            const aiVector3D a = here * mesh.mVertices[mesh.mFaces[f].mIndices[0]], b = here * mesh.mVertices[mesh.mFaces[f].mIndices[1]],
                             c = here * mesh.mVertices[mesh.mFaces[f].mIndices[2]];
            content.volume += static_cast<double>(a * (b ^ c)) / 6;
        }
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) collect(scene, *node.mChildren[c], here, content);
}

Content read_back(const fs::path& path)
{
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path.string(), 0);
    Content content;
    if (scene)
        collect(*scene, *scene->mRootNode, aiMatrix4x4(), content);
    else
        qWarning("%s", importer.GetErrorString());
    return content;
}

std::string text_of(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The textile's own mesh: extremes and volume, in m.
Content truth(const Textile& textile, const ExportOptions& options)
{
    Content content;
    stream_mesh(textile, options.mesh, [&](const YarnMesh& piece) {
        const auto at = [&](std::size_t v) {
            return aiVector3D(piece.positions[3 * v], piece.positions[3 * v + 1], piece.positions[3 * v + 2]);
        };
        for (std::size_t v = 0; v < piece.segment_of_vertex.size(); ++v)
            for (unsigned axis = 0; axis < 3; ++axis) {
                content.low[axis] = std::min(content.low[axis], at(v)[axis]);
                content.high[axis] = std::max(content.high[axis], at(v)[axis]);
            }
        for (std::size_t i = 0; i < piece.indices.size(); i += 3)
            content.volume += static_cast<double>(at(piece.indices[i]) * (at(piece.indices[i + 1]) ^ at(piece.indices[i + 2]))) / 6;
        return true;
    });
    return content;
}

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

} // namespace

class TestMeshFile : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    fs::path path(const std::string& name) const { return fs::path(folder_.path().toStdString()) / name; }
    void clear() const
    {
        for (const auto& file : fs::directory_iterator(folder_.path().toStdString())) fs::remove(file);
    }

private Q_SLOTS:
    void cleanup() { clear(); }

    void writtenMeshesReadBackWhole_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<double>("unit"); // per metre
        QTest::addColumn<bool>("y_up");
        QTest::addColumn<bool>("named");
        QTest::addColumn<bool>("colored");
        QTest::addColumn<double>("tolerance"); // of the bytes
        QTest::newRow("obj") << "obj" << 1000.0 << false << true << true << 0.25;
        QTest::newRow("ply") << "ply" << 1000.0 << false << false << false << 0.0;
        QTest::newRow("stl") << "stl" << 1000.0 << false << false << false << 0.0;
        QTest::newRow("glb") << "glb" << 1.0 << true << true << true << 0.0;
        QTest::newRow("gltf") << "gltf" << 1.0 << true << true << true << 0.001;
        QTest::newRow("fbx") << "fbx" << 100.0 << true << true << true << 0.25;
        QTest::newRow("dae") << "dae" << 1.0 << true << true << true << 0.25;
    }
    void writtenMeshesReadBackWhole()
    {
        QFETCH(QString, ending);
        QFETCH(double, unit);
        QFETCH(bool, y_up);
        QFETCH(bool, named);
        QFETCH(bool, colored);
        QFETCH(double, tolerance);
        const Textile textile = cloth();
        for (const ExportOptions& options : {with(MeshDetail::yarn), with(MeshDetail::yarn, false), with(MeshDetail::fibre)}) {
            clear();
            const fs::path file = path("some cloth." + ending.toStdString());
            const ExportEstimate size = export_estimate(textile, fabric(), options, mesh_format_of(file));
            QCOMPARE(QString::fromStdString(size.refusal), QString());
            const Exported exported = export_textile(textile, fabric(), options, file);
            QCOMPARE(exported.files.front(), file);
            QCOMPARE(std::distance(fs::directory_iterator(file.parent_path()), fs::directory_iterator()),
                     std::ptrdiff_t(exported.files.size()));
            const double ratio = static_cast<double>(exported.bytes) / size.bytes;
            QVERIFY2(near(ratio, 1, tolerance + 1e-9), qPrintable(QString::number(ratio)));

            const Content content = read_back(file), own = truth(textile, options);
            QCOMPARE(content.faces, size.triangles);
            if (ending == "glb" || ending == "gltf" || ending == "ply") QCOMPARE(content.vertices, size.vertices);
            for (unsigned axis = 0; axis < 3; ++axis) {
                const unsigned there = y_up && axis > 0 ? 3 - axis : axis;
                const bool turned = y_up && axis == 1; // y of the textile is -z
                const double low = static_cast<double>(turned ? -own.high[axis] : own.low[axis]);
                const double high = static_cast<double>(turned ? -own.low[axis] : own.high[axis]);
                QVERIFY2(near(content.low[there], unit * low, unit * 2e-7),
                         qPrintable(QString("%1 %2").arg(content.low[there]).arg(unit * low)));
                QVERIFY2(near(content.high[there], unit * high, unit * 2e-7),
                         qPrintable(QString("%1 %2").arg(content.high[there]).arg(unit * high)));
            }
            QVERIFY(own.volume > 0);
            QVERIFY2(near(content.volume / (unit * unit * unit * own.volume), 1, 0.02),
                     qPrintable(QString::number(content.volume / (unit * unit * unit * own.volume))));
            if (ending != "stl") QVERIFY(content.uvs && content.normals);
            if (named) {
                for (const char* yarn : {"warp_000", "warp_003", "weft_000", "weft_002"}) QVERIFY2(content.names.count(yarn), yarn);
                QCOMPARE(content.names.size(), std::size_t(7));
            }
            if (colored) {
                const bool linear = ending.startsWith("gl"); // 200 is 0.5776, 40 is 0.0212 and 233 is 0.8148 of linear light
                const aiColor3D warp = content.colors.at("warp_001"), weft = content.colors.at("weft_001");
                QVERIFY(near(warp.r, linear ? 0.5776 : 200 / 255.0, 2e-4) && near(warp.g, linear ? 0.0212 : 40 / 255.0, 2e-4));
                QVERIFY(near(weft.r, linear ? 0.8148 : 233 / 255.0, 2e-4));
            }
        }
    }
    void fbxIsInCentimetresAndColladaInMetresWithYUp()
    {
        export_textile(cloth(), fabric(), with(MeshDetail::yarn), path("cloth.fbx"));
        Assimp::Importer importer;
        const aiScene* scene = importer.ReadFile(path("cloth.fbx").string(), 0);
        QVERIFY(scene && scene->mMetaData);
        double factor = 0;
        int up = -1;
        float single = 0;
        if (scene->mMetaData->Get("UnitScaleFactor", single))
            factor = static_cast<double>(single);
        else
            scene->mMetaData->Get("UnitScaleFactor", factor);
        QVERIFY(scene->mMetaData->Get("UpAxis", up));
        QCOMPARE(up, 1);
        QCOMPARE(factor, 1.0); // in centimetres
        export_textile(cloth(), fabric(), with(MeshDetail::yarn), path("cloth.dae"));
        const std::string text = text_of(path("cloth.dae"));
        QVERIFY(text.find("<unit name=\"meter\" meter=\"1\"") != std::string::npos);
        QVERIFY(text.find("<up_axis>Y_UP</up_axis>") != std::string::npos);
    }
    void centrelinesReadBackAsLines()
    {
        const Textile textile = cloth();
        for (const char* name : {"lines.obj", "lines.glb", "lines.gltf"}) {
            const Exported exported = export_textile(textile, fabric(), with(MeshDetail::centreline), path(name));
            const Content content = read_back(path(name));
            QVERIFY2(content.faces > 0, name);
            const double unit = std::string(name) == "lines.obj" ? 1000 : 1;
            QVERIFY(near(content.high[0] - content.low[0], unit * 4 * textile.warp.pitch, unit * 1e-6));
        }
        export_textile(textile, fabric(), with(MeshDetail::centreline), path("lines.ply"));
        const std::string ply = text_of(path("lines.ply"));
        const std::size_t points = 4 * 25 + 3 * 33;
        QVERIFY(ply.find("element vertex " + std::to_string(points) + "\n") != std::string::npos);
        QVERIFY(ply.find("element edge " + std::to_string(points - 7) + "\n") != std::string::npos);
        QCOMPARE(ply.size(), ply.find("end_header\n") + 11 + 15 * points + 8 * (points - 7));
        QCOMPARE(export_estimate(textile, fabric(), with(MeshDetail::centreline), MeshFormat::ply).bytes, double(ply.size()));
    }
    void waterColoursTheVertices()
    {
        const Textile textile = cloth();
        ExportOptions options = with(MeshDetail::yarn);
        options.saturation.assign(static_cast<std::size_t>(textile.segments()), 0.0f);
        options.saturation[0] = 1.0f; // the first end's first crossing
        for (const char* name : {"wet.ply", "wet.obj", "wet.glb", "wet.gltf", "wet.fbx", "wet.dae"}) {
            const ExportEstimate size = export_estimate(textile, fabric(), options, mesh_format_of(path(name)));
            const Exported exported = export_textile(textile, fabric(), options, path(name));
            QVERIFY2(near(static_cast<double>(exported.bytes) / size.bytes, 1, 0.25),
                     qPrintable(QString("%1 %2").arg(name).arg(static_cast<double>(exported.bytes) / size.bytes)));
            Assimp::Importer importer;
            const aiScene* scene = importer.ReadFile(path(name).string(), 0);
            QVERIFY2(scene && scene->mNumMeshes > 0 && scene->mMeshes[0]->HasVertexColors(0), name);
            const aiColor4D wet = scene->mMeshes[0]->mColors[0][0],
                            dry =
                                scene->mMeshes[scene->mNumMeshes - 1]->mColors[0][scene->mMeshes[scene->mNumMeshes - 1]->mNumVertices - 1];
            const bool linear = std::string(name).starts_with("wet.gl"); // 108 is 0.1500 and 218 0.7011 of linear light
            QVERIFY2(near(wet.b, linear ? 0.1500 : 108 / 255.0, 2e-3), qPrintable(QString("%1 %2").arg(name).arg(wet.b)));
            QVERIFY2(near(dry.b, linear ? 0.7011 : 218 / 255.0, 2e-3), qPrintable(QString("%1 %2").arg(name).arg(dry.b)));
        }
        const std::string ply = text_of(path("wet.ply"));
        const std::size_t begin = ply.find("end_header\n") + 11;
        QVERIFY(ply.find("property float saturation\n") < begin);
        float first = 0, last = 1;
        std::memcpy(&first, &ply[begin + 35], 4);
        std::memcpy(&last, &ply[begin + 39 * (stream_size(textile, options.mesh).vertices - 1) + 35], 4);
        QCOMPARE(first, 1.0f);
        QCOMPARE(last, 0.0f);
    }
    void glbSaysTheExtremesExactly()
    {
        const Textile textile = cloth();
        export_textile(textile, fabric(), with(MeshDetail::fibre), path("cloth.glb"));
        const std::string glb = text_of(path("cloth.glb"));
        std::uint32_t total = 0, json = 0, bin = 0;
        std::memcpy(&total, &glb[8], 4);
        std::memcpy(&json, &glb[12], 4);
        std::memcpy(&bin, &glb[20 + json], 4);
        QCOMPARE(std::size_t(total), glb.size());
        QCOMPARE(std::size_t(json + bin + 28), glb.size());
        QCOMPARE(json % 4, 0u);
        const std::string text = glb.substr(20, json);
        const std::size_t at = text.find("\"min\":[") + 7;
        float least = 1e9f;
        const MeshSize first = stream_size(textile, with(MeshDetail::fibre).mesh, YarnKind::warp, 0);
        for (std::size_t v = 0; v < first.vertices; ++v) {
            float x = 0;
            std::memcpy(&x, &glb[28 + json + 32 * v], 4);
            least = std::min(least, x);
        }
        QCOMPARE(std::stof(text.substr(at)), least);
    }
    void cancellingLeavesNothingBehind()
    {
        const Textile textile = build_textile({}, fabric(), {0, 0, 30, 30});
        for (const char* ending : {"obj", "ply", "stl", "glb", "gltf", "fbx", "dae", "bcc", "usda"})
            for (double at : {0.0, 0.5, 1.0}) {
                const bool curves = mesh_format_of(std::string("x.") + ending) >= MeshFormat::bcc;
                QVERIFY_EXCEPTION_THROWN(export_textile(textile, fabric(), with(curves ? MeshDetail::fibre : MeshDetail::yarn),
                                                        path(std::string("x.") + ending), [&](double share) { return share < at; }),
                                         Cancelled);
                QVERIFY2(fs::is_empty(folder_.path().toStdString()), ending);
            }
    }
    void whatCannotBeWrittenIsRefusedWithASentence()
    {
        const Textile textile = cloth();
        const auto refused = [&](const Textile& what, const ExportOptions& options, MeshFormat format) {
            return export_estimate(what, fabric(), options, format).refusal;
        };
        for (MeshFormat format : {MeshFormat::stl, MeshFormat::fbx, MeshFormat::collada})
            QVERIFY(refused(textile, with(MeshDetail::centreline), format).find("write centrelines as .obj") != std::string::npos);
        for (MeshFormat format : {MeshFormat::bcc, MeshFormat::usda})
            QVERIFY(refused(textile, with(MeshDetail::yarn), format).find("hold curves") != std::string::npos);
        ExportOptions wet = with(MeshDetail::yarn);
        wet.saturation.assign(static_cast<std::size_t>(textile.segments()), 0.5f);
        QVERIFY(refused(textile, wet, MeshFormat::stl).find("without colours") != std::string::npos);
        for (const char* other : {"x.x3d", "x.3mf"}) QVERIFY_EXCEPTION_THROWN(mesh_format_of(other), Error);
        wet.saturation.pop_back();
        QVERIFY_EXCEPTION_THROWN(export_estimate(textile, fabric(), wet, MeshFormat::ply), Error);

        const Textile large = build_textile({}, fabric(), {0, 0, 1500, 1500}); // 0.5 thousand million vertices of fibres per 1000 x 1000
        QVERIFY(refused(large, with(MeshDetail::yarn), MeshFormat::glb).find("4 GiB") != std::string::npos);
        QCOMPARE(refused(large, with(MeshDetail::yarn), MeshFormat::gltf), std::string());
        for (MeshFormat format : {MeshFormat::fbx, MeshFormat::collada})
            QVERIFY(refused(large, with(MeshDetail::yarn), format).find("or take fewer samples or sides") != std::string::npos);
        for (MeshFormat format : {MeshFormat::ply, MeshFormat::obj})
            QVERIFY(refused(large, with(MeshDetail::fibre), format).find("thousand million vertices") != std::string::npos);
        QVERIFY(refused(large, with(MeshDetail::fibre), MeshFormat::stl).find("thousand million triangles") != std::string::npos);
        Textile long_yarns = cloth();
        long_yarns.weft.count = 100000;
        ExportOptions fine = with(MeshDetail::fibre);
        fine.mesh.samples_per_crossing = 20;
        fine.mesh.flyaways = false;
        QVERIFY(refused(long_yarns, fine, MeshFormat::gltf).find("One yarn alone") != std::string::npos);

        QVERIFY_EXCEPTION_THROWN(export_textile(textile, fabric(), with(MeshDetail::centreline), path("cloth.stl")), Error);
        QVERIFY_EXCEPTION_THROWN(export_textile(textile, fabric(), {}, path("cloth.dwg")), Error);
        QVERIFY_EXCEPTION_THROWN(export_textile(textile, fabric(), {}, path("nowhere/cloth.obj")), FileError);
        QVERIFY(fs::is_empty(folder_.path().toStdString()));
    }
    void repeatsTileTheFabric()
    {
        Fabric striped = fabric(); // 3 x 3
        striped.extra_yarns.push_back(striped.warp);
        striped.warp_order = {{0, 3}, {1, 1}};
        const TextileRegion region = region_of_repeats(striped, 2, 3);
        QCOMPARE(region.ends, 2 * 12); // of 3 and 4 ends
        QCOMPARE(region.picks, 3 * 3);
        QVERIFY_EXCEPTION_THROWN(region_of_repeats(striped, 90000, 1), Error);
        const ExportOptions options = with(MeshDetail::yarn);
        const Textile textile = build_textile({}, striped, {0, 0, 4, 3});
        const Exported exported = export_textile(textile, striped, options, path("striped.obj"));
        QVERIFY(text_of(exported.files[1]).find("newmtl extra_1") != std::string::npos);
    }
    void longYarnsAreMadeFewAtATime()
    {
        Textile long_yarns = cloth();
        long_yarns.weft.count = 30000; // an end has 240 001 rings of 13 vertices
        const ExportEstimate size = export_estimate(long_yarns, fabric(), with(MeshDetail::yarn), MeshFormat::ply);
        QCOMPARE(size.refusal, std::string());
        QVERIFY(size.memory > 100e6 && size.memory <= largest_stream_memory);
    }
    void namesThatDifferInBlanksKeepTheirOwnMaterials()
    {
        const Textile textile = cloth();
        std::set<fs::path> materials;
        for (const char* name : {"a b.obj", "a_b.obj", "a  b.obj"}) {
            const Exported exported = export_textile(textile, fabric(), with(MeshDetail::yarn), path(name));
            materials.insert(exported.files[1]);
            QVERIFY(text_of(exported.files[0]).find("mtllib " + exported.files[1].filename().string() + "\n") != std::string::npos);
            QCOMPARE(exported.files[1].string().substr(folder_.path().size()).find(' '), std::string::npos);
        }
        QCOMPARE(materials.size(), std::size_t(3));
    }
    void longNamesHaveShorterOnesBesideThem()
    {
        const Textile textile = cloth();
        std::string name;
        while (name.size() < 245) name += "\xC3\xA4 "; // as long as a disk takes it, and odd
        std::set<fs::path> materials;
        for (const char* end : {"1", "2"}) {
            const Exported exported = export_textile(textile, fabric(), with(MeshDetail::yarn), path(name + end + ".obj"));
            QVERIFY(exported.files[1].filename().string().size() < 220);
            QVERIFY(QString::fromStdString(exported.files[1].filename().string()).toUtf8().toStdString() == exported.files[1].filename());
            materials.insert(exported.files[1]);
        }
        QCOMPARE(materials.size(), std::size_t(2));
    }
    void theFilesAreListedBeforehand()
    {
        const Textile textile = cloth();
        ExportOptions wet = with(MeshDetail::yarn);
        wet.saturation.assign(static_cast<std::size_t>(textile.segments()), 0.5f);
        for (const char* name : {"cloth.obj", "a b.gltf", "cloth.ply", "cloth.dae"})
            for (const ExportOptions& options : {with(MeshDetail::yarn), wet}) {
                const ExportEstimate size = export_estimate(textile, fabric(), options, mesh_format_of(name));
                const Exported exported = export_textile(textile, fabric(), options, path(name));
                QCOMPARE(files_of_export(path(name), size), exported.files);
                QVERIFY(static_cast<double>(exported.bytes) <= size.most_bytes + 100); // a glTF names its buffers
                clear();
            }
    }
    void glTFBuffersAreNumbered()
    {
        // A buffer ends at 2 GiB: computed beforehand, not written.
        const Textile large = build_textile({}, fabric(), {0, 0, 1500, 1500});
        const ExportEstimate size = export_estimate(large, fabric(), with(MeshDetail::yarn), MeshFormat::gltf);
        QVERIFY(size.bytes > 4294967296.0);
        QCOMPARE(size.refusal, std::string());
        const std::vector<fs::path> files = files_of_export("x/large.gltf", size);
        QCOMPARE(files.size(), size.files);
        QVERIFY(files.size() > 2);
        QCOMPARE(files[1], fs::path("x/large.bin"));
        QCOMPARE(files[2], fs::path("x/large-2.bin"));
    }
    void glTFInManyBuffersReadsBackAsInOne_data()
    {
        QTest::addColumn<MeshDetail>("detail");
        QTest::newRow("centreline") << MeshDetail::centreline;
        QTest::newRow("yarn") << MeshDetail::yarn;
        QTest::newRow("fibre") << MeshDetail::fibre;
    }
    void glTFInManyBuffersReadsBackAsInOne()
    {
        QFETCH(MeshDetail, detail);
        const Textile textile = cloth();
        ExportOptions options = with(detail);
        options.saturation.assign(static_cast<std::size_t>(textile.segments()), 0.0f);
        options.saturation[0] = 1.0f;
        const Exported one = export_textile(textile, fabric(), options, path("one.gltf"));
        QCOMPARE(one.files.size(), std::size_t(2));
        const std::uintmax_t all = fs::file_size(one.files[1]);

        options.largest_buffer = all * 2 / 5; // of the 7 yarns two or three fit
        const ExportEstimate size = export_estimate(textile, fabric(), options, MeshFormat::gltf);
        QVERIFY(size.files > 3);
        const Exported many = export_textile(textile, fabric(), options, path("many parts.gltf"));
        QCOMPARE(many.files, files_of_export(path("many parts.gltf"), size));
        std::uintmax_t parts = 0;
        for (std::size_t i = 1; i < many.files.size(); ++i) {
            QVERIFY(fs::file_size(many.files[i]) > 0 && fs::file_size(many.files[i]) <= options.largest_buffer);
            parts += fs::file_size(many.files[i]);
        }
        QCOMPARE(parts, all);
        Assimp::Importer first, second;
        const aiScene* a = first.ReadFile(one.files[0].string(), 0);
        const aiScene* b = second.ReadFile(many.files[0].string(), 0);
        QVERIFY(a && b);
        QCOMPARE(b->mNumMeshes, 7u);
        for (unsigned m = 0; m < b->mNumMeshes; ++m) {
            const aiMesh &x = *a->mMeshes[m], &y = *b->mMeshes[m];
            QCOMPARE(y.mNumVertices, x.mNumVertices);
            QCOMPARE(y.mNumFaces, x.mNumFaces);
            for (unsigned v = 0; v < y.mNumVertices; ++v) {
                QVERIFY(y.mVertices[v] == x.mVertices[v]);
                QVERIFY(y.mColors[0][v] == x.mColors[0][v]);
            }
            for (unsigned f = 0; f < y.mNumFaces; ++f)
                QVERIFY(std::equal(y.mFaces[f].mIndices, y.mFaces[f].mIndices + y.mFaces[f].mNumIndices, x.mFaces[f].mIndices));
        }

        options.largest_buffer = all / 7 - 1; // the longest yarn does not fit
        QVERIFY(export_estimate(textile, fabric(), options, MeshFormat::gltf).refusal.find("One yarn alone") == 0);
    }
};

} // namespace tst_mesh_file

QTEST_APPLESS_MAIN(tst_mesh_file::TestMeshFile)
#include "tst_mesh_file.moc"
