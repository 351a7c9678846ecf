// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Written files are read back with Assimp, as other programs would.
#include "core/base/error.h"
#include "core/project/mesh_file.h"

#include <QTemporaryDir>
#include <QTest>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <cmath>
#include <set>

using namespace hygroloom;
namespace fs = std::filesystem;

namespace {

Textile cloth()
{
    Fabric fabric;
    fabric.name = "cloth";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    fabric.weave = weave_from_pattern("twill 2/1 Z");
    return build_textile({}, fabric, {0, 0, 4, 3});
}

struct Content {
    unsigned faces = 0;
    aiVector3D low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
    std::set<std::string> names;
};

void collect(const aiScene& scene, const aiNode& node, const aiMatrix4x4& above, Content& content)
{
    const aiMatrix4x4 here = above * node.mTransformation;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
        content.faces += mesh.mNumFaces;
        content.names.insert(node.mName.C_Str());
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D p = here * mesh.mVertices[v];
            for (unsigned axis = 0; axis < 3; ++axis) {
                content.low[axis] = std::min(content.low[axis], p[axis]);
                content.high[axis] = std::max(content.high[axis], p[axis]);
            }
        }
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) collect(scene, *node.mChildren[c], here, content);
}

Content read_back(const fs::path& path)
{
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path.string(), 0);
    Content content;
    if (scene) collect(*scene, *scene->mRootNode, aiMatrix4x4(), content);
    return content;
}

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

} // namespace

class TestMeshFile : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }

private Q_SLOTS:
    void writtenMeshesReadBackWhole_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("named");
        QTest::newRow("obj") << "cloth.obj" << true;
        QTest::newRow("ply") << "cloth.ply" << false;
        QTest::newRow("stl") << "cloth.stl" << false;
        QTest::newRow("glb") << "cloth.glb" << true;
    }
    void writtenMeshesReadBackWhole()
    {
        QFETCH(QString, name);
        QFETCH(bool, named);
        const Textile textile = cloth();
        const fs::path file = path(qPrintable(name));
        write_mesh(textile, {MeshDetail::yarn, 8, 12}, file);
        const Content content = read_back(file);
        const MeshFileSize size = mesh_file_size(textile, mesh_format_of(file), {MeshDetail::yarn, 8, 12});
        QCOMPARE(std::size_t(content.faces), size.triangles);
        const bool glb = name.endsWith("glb");
        const double unit = glb ? 1 : 1000; // per metre
        const unsigned up = glb ? 1 : 2;
        QVERIFY(near(content.high[up], unit * textile.half_thickness(), unit * 1e-6));
        QVERIFY(near(content.low[up], -unit * textile.half_thickness(), unit * 1e-6));
        QVERIFY(near(content.high[0] - content.low[0], unit * 4 * textile.warp.pitch, unit * 0.1e-3));
        QVERIFY(near(content.high[glb ? 2 : 1] - content.low[glb ? 2 : 1], unit * 3 * textile.weft.pitch, unit * 0.1e-3));
        if (named)
            for (const char* yarn : {"warp_000", "warp_003", "weft_000", "weft_002"}) QVERIFY2(content.names.count(yarn), yarn);
        if (named) QCOMPARE(content.names.size(), std::size_t(7));
        const double ratio = static_cast<double>(fs::file_size(file)) / size.bytes;
        QVERIFY2(ratio > 1 / 1.5 && ratio < 1.5, qPrintable(QString::number(ratio)));
        QCOMPARE(std::distance(fs::directory_iterator(file.parent_path()), fs::directory_iterator()), std::ptrdiff_t(1));
        fs::remove(file);
    }
    void centrelinesReadBackAsLines()
    {
        for (const char* name : {"lines.obj", "lines.glb"}) {
            const Textile textile = cloth();
            write_mesh(textile, {MeshDetail::centreline, 8, 12}, path(name));
            const Content content = read_back(path(name));
            QVERIFY2(content.faces > 0, name);
            const double unit = std::string(name) == "lines.glb" ? 1 : 1000;
            QVERIFY(near(content.high[0] - content.low[0], unit * 4 * textile.warp.pitch, unit * 1e-6));
            fs::remove(path(name));
        }
    }
    void whatCannotBeWrittenIsRefused()
    {
        QVERIFY_EXCEPTION_THROWN(write_mesh(cloth(), {}, path("cloth.fbx")), Error);
        QVERIFY_EXCEPTION_THROWN(write_mesh(cloth(), {MeshDetail::centreline, 8, 12}, path("cloth.stl")), Error);
        QVERIFY_EXCEPTION_THROWN(write_mesh(cloth(), {}, path("nowhere/cloth.obj")), FileError);
        Textile large = cloth();
        large.warp.count = large.weft.count = 5000;
        QVERIFY_EXCEPTION_THROWN(write_mesh(large, {}, path("large.obj")), Error);
        QVERIFY(fs::is_empty(folder_.path().toStdString()));
    }
};

QTEST_APPLESS_MAIN(TestMeshFile)
#include "tst_mesh_file.moc"
