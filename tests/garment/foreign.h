// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Sheets in the formats that a foreign library reads: FBX 7.4 in binary, as programs write it, and Collada.
#pragma once

#include "tests/garment/sheets.h"

namespace hygroloom {

/// A record of FBX: properties, then records within it.
struct FbxRecord {
    std::string name, properties = {};
    std::uint32_t count = 0; ///< of properties
    std::vector<FbxRecord> within = {};

    FbxRecord& with(const std::string& text)
    {
        properties += 'S';
        append(properties, static_cast<std::uint32_t>(text.size()));
        properties += text;
        ++count;
        return *this;
    }
    FbxRecord& with(std::int64_t number)
    {
        properties += 'L';
        append(properties, number);
        ++count;
        return *this;
    }
    FbxRecord& with(std::int32_t number)
    {
        properties += 'I';
        append(properties, number);
        ++count;
        return *this;
    }
    template <typename T> FbxRecord& with_array(char kind, const std::vector<T>& numbers)
    {
        properties += kind;
        append(properties, static_cast<std::uint32_t>(numbers.size()));
        append(properties, std::uint32_t{0}); // not compressed
        append(properties, static_cast<std::uint32_t>(sizeof(T) * numbers.size()));
        for (const T number : numbers) append(properties, number);
        ++count;
        return *this;
    }
    void write(std::string& bytes) const
    {
        const std::size_t begin = bytes.size();
        append(bytes, std::uint32_t{0});
        append(bytes, count);
        append(bytes, static_cast<std::uint32_t>(properties.size()));
        append(bytes, static_cast<std::uint8_t>(name.size()));
        bytes += name + properties;
        for (const FbxRecord& one : within) one.write(bytes);
        if (!within.empty()) bytes.append(13, '\0');
        const auto end = static_cast<std::uint32_t>(bytes.size());
        bytes.replace(begin, 4, reinterpret_cast<const char*>(&end), 4);
    }
};

inline FbxRecord fbx_geometry(const Sheet& one, std::int64_t id)
{
    std::vector<double> places, flats;
    std::vector<std::int32_t> corners, uv;
    for (const Vec3d& p : one.places) places.insert(places.end(), {100 * p.x, 100 * p.y, 100 * p.z}); // cm
    for (const FlatPlace& p : one.uv) flats.insert(flats.end(), {p[0], p[1]});
    for (const auto& [a, b, c] : one.triangles) {
        corners.insert(corners.end(), {a, b, -c - 1});
        uv.insert(uv.end(), {a, b, c});
    }
    FbxRecord geometry{"Geometry"};
    geometry.with(id).with(one.name + std::string("\0\1Geometry", 10)).with(std::string("Mesh"));
    FbxRecord layer{"LayerElementUV"};
    layer.with(std::int32_t{0});
    layer.within = {FbxRecord{"Version"}.with(std::int32_t{101}),
                    FbxRecord{"Name"}.with(std::string("uv")),
                    FbxRecord{"MappingInformationType"}.with(std::string("ByPolygonVertex")),
                    FbxRecord{"ReferenceInformationType"}.with(std::string("IndexToDirect")),
                    FbxRecord{"UV"}.with_array('d', flats),
                    FbxRecord{"UVIndex"}.with_array('i', uv)};
    FbxRecord element{"LayerElement"};
    element.within = {FbxRecord{"Type"}.with(std::string("LayerElementUV")), FbxRecord{"TypedIndex"}.with(std::int32_t{0})};
    FbxRecord layers{"Layer"};
    layers.with(std::int32_t{0});
    layers.within = {FbxRecord{"Version"}.with(std::int32_t{100}), element};
    geometry.within = {FbxRecord{"Vertices"}.with_array('d', places), FbxRecord{"PolygonVertexIndex"}.with_array('i', corners), layer,
                       layers};
    return geometry;
}

inline std::string fbx_of(const std::vector<Sheet>& sheets)
{
    FbxRecord objects{"Objects"}, connections{"Connections"}, head{"FBXHeaderExtension"};
    head.within = {FbxRecord{"FBXHeaderVersion"}.with(std::int32_t{1003}), FbxRecord{"FBXVersion"}.with(std::int32_t{7400})};
    const auto join = [&connections](std::int64_t one, std::int64_t other) {
        connections.within.push_back(FbxRecord{"C"}.with(std::string("OO")).with(one).with(other));
    };
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        const std::int64_t geometry = 1000 + static_cast<std::int64_t>(i), model = 2000 + static_cast<std::int64_t>(i);
        objects.within.push_back(fbx_geometry(sheets[i], geometry));
        objects.within.push_back(
            FbxRecord{"Model"}.with(model).with(sheets[i].name + std::string("\0\1Model", 7)).with(std::string("Mesh")));
        objects.within.back().within = {FbxRecord{"Version"}.with(std::int32_t{232})};
        join(model, 0);
        join(geometry, model);
    }
    std::string bytes("Kaydara FBX Binary  \0\x1a\0", 23);
    append(bytes, std::uint32_t{7400});
    for (const FbxRecord& one : {head, objects, connections}) one.write(bytes);
    return bytes + std::string(13, '\0');
}

inline std::string dae_source(const std::string& id, const std::string& numbers, std::size_t count, std::size_t stride)
{
    std::string names;
    for (std::size_t i = 0; i < stride; ++i) names += fmt::format("<param name=\"{}\" type=\"float\"/>", "XYZ"[i]);
    return fmt::format(
        "<source id=\"{0}\"><float_array id=\"{0}-n\" count=\"{1}\">{2}</float_array><technique_common><accessor source=\"#{0}-n\" "
        "count=\"{3}\" stride=\"{4}\">{5}</accessor></technique_common></source>\n",
        id, count * stride, numbers, count, stride, names);
}

inline std::string dae_of(const std::vector<Sheet>& sheets)
{
    std::string geometries, nodes;
    for (const Sheet& one : sheets) {
        std::string places, flats, corners;
        for (const Vec3d& p : one.places) places += fmt::format("{} {} {} ", p.x, p.y, p.z);
        for (const FlatPlace& p : one.uv) flats += fmt::format("{} {} ", p[0], p[1]);
        for (const auto& triangle : one.triangles)
            for (const int corner : triangle) corners += fmt::format("{0} {0} ", corner);
        geometries +=
            fmt::format("<geometry id=\"{0}-g\" name=\"{0}\"><mesh>\n{1}{2}<vertices id=\"{0}-v\"><input semantic=\"POSITION\" "
                        "source=\"#{0}-p\"/></vertices>\n<triangles count=\"{3}\"><input semantic=\"VERTEX\" source=\"#{0}-v\" "
                        "offset=\"0\"/><input semantic=\"TEXCOORD\" source=\"#{0}-f\" offset=\"1\" set=\"0\"/><p>{4}</p></triangles>"
                        "</mesh></geometry>\n",
                        one.name, dae_source(one.name + "-p", places, one.places.size(), 3),
                        dae_source(one.name + "-f", flats, one.uv.size(), 2), one.triangles.size(), corners);
        nodes += fmt::format("<node id=\"{0}\" name=\"{0}\"><instance_geometry url=\"#{0}-g\"/></node>\n", one.name);
    }
    return "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset><unit "
           "meter=\"1\"/><up_axis>Y_UP</up_axis></asset>\n<library_geometries>" +
           geometries + "</library_geometries>\n<library_visual_scenes><visual_scene id=\"s\">" + nodes +
           "</visual_scene></library_visual_scenes>\n<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
}

} // namespace hygroloom
