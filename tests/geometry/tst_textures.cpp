// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Pictures of a fabric's repeat: they go on in themselves, are as open as the geometry is, and load elsewhere.
#include "core/base/error.h"
#include "core/geometry/measured_geometry.h"
#include "core/geometry/top_view.h"
#include "core/project/library.h"
#include "core/project/mesh_file.h"
#include "core/project/project_file.h"
#include "core/project/texture_files.h"
#include "core/project/wet_look.h"

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <cmath>

using namespace hygroloom;

namespace {

struct Cloth {
    Design design;
    Textile textile;

    explicit Cloth(const std::string& name)
    {
        for (const Preset& preset : shipped_presets())
            if (preset.fabric().name == name) add_preset(design, preset);
        design.fabrics.at(0).measured = {}; // as measure_geometry() takes it
        textile = build_textile(design, fabric(), region_of_repeats(fabric(), 1, 1));
    }
    const Fabric& fabric() const { return design.fabrics.at(0); }
    TexturePixels pixels(double dpi, double wet_share = 1) const
    {
        return texture_pixels(textile, fabric(), texture_size(textile, dpi), wet_share);
    }
};

/// Mean difference of neighbours: between each column and the next, the last of which is the first again.
std::vector<double> steps_of_columns(const TexturePixels& of, const std::vector<std::uint8_t>& bytes, int channels)
{
    std::vector<double> steps;
    for (int column = 0; column < of.columns; ++column) {
        double sum = 0;
        for (int row = 0; row < of.rows; ++row)
            for (int k = 0; k < channels; ++k) {
                const auto at = [&](int c) { return bytes[static_cast<std::size_t>((row * of.columns + c) * channels + k)]; };
                sum += std::abs(int(at(column)) - int(at((column + 1) % of.columns)));
            }
        steps.push_back(sum / (of.rows * channels));
    }
    return steps;
}
std::vector<double> steps_of_rows(const TexturePixels& of, const std::vector<std::uint8_t>& bytes, int channels)
{
    std::vector<double> steps;
    for (int row = 0; row < of.rows; ++row) {
        double sum = 0;
        for (int i = 0; i < of.columns * channels; ++i) {
            const auto at = [&](int r) { return bytes[static_cast<std::size_t>(r * of.columns * channels + i)]; };
            sum += std::abs(int(at(row)) - int(at((row + 1) % of.rows)));
        }
        steps.push_back(sum / (of.columns * channels));
    }
    return steps;
}

/// The step over the seam is none that does not occur within the picture, too.
bool goes_on(const std::vector<double>& steps) { return steps.back() <= *std::max_element(steps.begin(), steps.end() - 1) + 1e-9; }

} // namespace

class TestTextures : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void they_go_on_in_themselves_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"Textile F", "Denim", "Voile", "Poplin shirting"}) QTest::newRow(name) << QString(name);
    }
    void they_go_on_in_themselves()
    {
        QFETCH(QString, name);
        const Cloth cloth(name.toStdString());
        const TexturePixels pixels = cloth.pixels(1200);
        for (const auto& [bytes, channels] : {std::pair{&pixels.colour, 4}, {&pixels.wet, 4}, {&pixels.normal, 3}, {&pixels.opacity, 1}}) {
            QVERIFY(goes_on(steps_of_columns(pixels, *bytes, channels)));
            QVERIFY(goes_on(steps_of_rows(pixels, *bytes, channels)));
        }
        // The same place in two repeats side by side is the same pixel.
        const Textile twice = build_textile(cloth.design, cloth.fabric(), region_of_repeats(cloth.fabric(), 2, 1));
        const TextureSize one = texture_size(cloth.textile, 1200), two{2 * one.columns, one.rows, 2 * one.width_mm, one.height_mm};
        const TexturePixels wide = texture_pixels(twice, cloth.fabric(), two, 1);
        const auto apart = [&](int shift) { // columns by which the wide picture is moved
            int most = 0;
            for (int row = 0; row < one.rows; ++row)
                for (int column = 0; column < 2 * one.columns; ++column)
                    for (int k = 0; k < 3; ++k) {
                        const int in_one = (column + shift) % one.columns;
                        most =
                            std::max(most, std::abs(int(wide.normal[static_cast<std::size_t>(3 * (row * 2 * one.columns + column) + k)]) -
                                                    int(pixels.normal[static_cast<std::size_t>(3 * (row * one.columns + in_one) + k)])));
                    }
            return most;
        };
        QVERIFY2(apart(0) <= 1, qPrintable(QString::number(apart(0))));
        QVERIFY(apart(one.columns / 3) > 20); // or anything would be alike
    }

    void normals_have_unit_length_and_face_up()
    {
        const Cloth cloth("Denim");
        const TexturePixels pixels = cloth.pixels(1200);
        double sideways = 0;
        for (std::size_t i = 0; i < pixels.normal.size(); i += 3) {
            const auto at = [&](std::size_t k) { return pixels.normal[i + k] / 127.5 - 1; };
            QVERIFY(std::abs(std::hypot(at(0), at(1), at(2)) - 1) < 0.01);
            QVERIFY(at(2) > -0.01);
            sideways = std::max(sideways, std::hypot(at(0), at(1)));
        }
        QVERIFY(sideways > 0.5); // yarns are round
    }

    void they_are_as_open_as_the_geometry_data() { they_go_on_in_themselves_data(); }
    void they_are_as_open_as_the_geometry()
    {
        QFETCH(QString, name);
        const Cloth cloth(name.toStdString());
        const MeasuredGeometry geometry = measure_geometry(cloth.design, cloth.fabric());
        const TexturePixels pixels = cloth.pixels(2400);
        double opacity = 0;
        for (const std::uint8_t value : pixels.opacity) opacity += value / 255.0 / static_cast<double>(pixels.opacity.size());
        qInfo("opacity %.4f, cover of the geometry %.4f", opacity, geometry.cover_factor);
        QVERIFY(std::abs(opacity - geometry.cover_factor) < 0.01);
        QVERIFY(std::abs(1 - pixels.open_share - opacity) < 0.002);
    }

    /// A plain weave's points at the middles of its four crossings: the yarn on top by the weave, as high as the geometry has it.
    void yarns_lie_where_the_weave_has_them()
    {
        const Cloth cloth("Textile F");
        const Textile& t = cloth.textile;
        const TopView view(t, t.ends(), t.picks());
        for (int end = 0; end < t.ends(); ++end)
            for (int pick = 0; pick < t.picks(); ++pick) {
                const TopPoint seen = view.at(end, t.picks() - 1 - pick);
                const YarnKind top = t.warp_up(end, pick) ? YarnKind::warp : YarnKind::weft;
                const int yarn = top == YarnKind::warp ? end : pick, at = top == YarnKind::warp ? pick : end;
                const YarnPoint tube = yarn_point(t, top, yarn, at, 0);
                QVERIFY(!seen.open && seen.kind == top && seen.yarn == yarn);
                QVERIFY(std::abs(seen.height - tube.centre.z - tube.half_height) < 1e-9);
                QVERIFY(std::abs(seen.normal.z - 1) < 1e-6);
            }
    }

    void wet_cloth_is_darker_and_smoother()
    {
        // Walsh's closed form of the diffuse reflection of a smooth surface, 1926, at n = 1.333 is 0.0664 (tables give 0.066).
        QVERIFY(std::abs(diffuse_reflection(1.333) - 0.0664) < 0.0005);
        QVERIFY(std::abs(diffuse_reflection(1.5) - 0.0918) < 0.0005);
        QVERIFY(std::abs(inner_reflection(1.333) - (1 - (1 - 0.0664) / (1.333 * 1.333))) < 0.001);
        double before = 0;
        for (double dry = 0.02; dry < 0.99; dry += 0.01) {
            const double wet = wet_reflectance(dry);
            QVERIFY(wet > before && wet < dry);
            before = wet;
        }
        QVERIFY(wet_reflectance(1) > 0.97); // nothing is absorbed: only what the film reflects at once is missing
        const Cloth cloth("Textile F");
        const TexturePixels pixels = cloth.pixels(600), half = cloth.pixels(600, 0.5);
        for (std::size_t i = 0; i < pixels.colour.size(); ++i)
            if (i % 4 != 3) QVERIFY(pixels.wet[i] < half.wet[i] && half.wet[i] < pixels.colour[i]);
        QVERIFY(pixels.wet_roughness[0] < half.wet_roughness[0] && half.wet_roughness[0] < pixels.roughness[0]);
    }

    void they_load_elsewhere()
    {
        const Cloth cloth("Denim");
        QTemporaryDir folder;
        const std::vector<std::string> files = write_textures(cloth.textile, cloth.fabric(), {}, folder.path().toStdString());
        for (const std::string& file : files) QVERIFY2(QFile(folder.filePath(QString::fromStdString(file))).size() > 0, file.c_str());
        const TextureSize size = texture_size(cloth.textile, 600);
        for (const char* name : {"colour.png", "normal.png", "roughness.png", "opacity.png", "colour_wet.png", "roughness_wet.png"})
            QCOMPARE(QImage(folder.filePath(name)).size(), QSize(size.columns, size.rows));
        QVERIFY(QImage(folder.filePath("colour.png")).hasAlphaChannel());

        Assimp::Importer importer;
        const aiScene* scene = importer.ReadFile(folder.filePath("plane.gltf").toStdString(), 0);
        QVERIFY2(scene != nullptr, importer.GetErrorString());
        QCOMPARE(scene->mNumMeshes, 2U);
        QVERIFY(scene->mNumMaterials >= 2U);
        aiString path;
        QCOMPARE(scene->mMaterials[0]->GetTexture(aiTextureType_BASE_COLOR, 0, &path), aiReturn_SUCCESS);
        QCOMPARE(path.C_Str(), "colour.png");
        QCOMPARE(scene->mMaterials[0]->GetTexture(aiTextureType_NORMALS, 0, &path), aiReturn_SUCCESS);
        QCOMPARE(path.C_Str(), "normal.png");
        // Each plane is a whole number of repeats, which its texture coordinates count.
        const aiMesh& plane = *scene->mMeshes[0];
        float most_u = 0, most_x = 0;
        for (unsigned i = 0; i < plane.mNumVertices; ++i) {
            most_u = std::max(most_u, plane.mTextureCoords[0][i].x);
            most_x = std::max(most_x, plane.mVertices[i].x);
        }
        QVERIFY(std::abs(1e3 * static_cast<double>(most_x) - static_cast<double>(most_u) * size.width_mm) < 1e-4);

        QFile file(folder.filePath("material.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
        const QJsonObject material = json["materials"].toArray()[0].toObject();
        QVERIFY(material["doubleSided"].toBool() && material["normalTexture"].isObject());
        QVERIFY(material["pbrMetallicRoughness"].toObject()["baseColorTexture"].isObject());
        QVERIFY(material["pbrMetallicRoughness"].toObject()["metallicRoughnessTexture"].isObject());
        QCOMPARE(material["alphaMode"].toString() == "MASK", json["extras"].toObject()["open_share"].toDouble() > 0.001);
    }

    void pictures_too_large_are_refused()
    {
        const Cloth cloth("Denim");
        QVERIFY_EXCEPTION_THROWN(texture_size(cloth.textile, 1e6), Error);
    }
};

QTEST_GUILESS_MAIN(TestTextures)
#include "tst_textures.moc"
