// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/gltf_file.h"

#include "core/base/base64.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/garment/readers.h"
#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace hygroloom {

namespace {

constexpr double largest_index = 4294967295.0;

std::uint32_t word_at(std::string_view bytes, std::size_t at)
{
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return word;
}

/// A URI's escapes as characters: %20.
std::string unescaped(const std::string& uri)
{
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned code = 0;
        const char* const digits = uri.data() + i + 1;
        const bool escape = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(digits[0])) != 0 &&
                            std::isxdigit(static_cast<unsigned char>(digits[1])) != 0;
        if (escape) {
            code = static_cast<unsigned>(std::stoul(uri.substr(i + 1, 2), nullptr, 16));
            i += 2;
        }
        text += escape ? static_cast<char>(code) : uri[i];
    }
    return text;
}

/// How an accessor's components are stored.
struct Component {
    std::size_t code, size;
    double (*read)(const unsigned char*);
    double most; ///< of normalized integers; 0: they cannot be
};

template <typename T> double read_as(const unsigned char* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof value); // glTF is little endian, as are the machines that this runs on
    return static_cast<double>(value);
}

constexpr std::array components{Component{5120, 1, read_as<std::int8_t>, 127},    Component{5121, 1, read_as<std::uint8_t>, 255},
                                Component{5122, 2, read_as<std::int16_t>, 32767}, Component{5123, 2, read_as<std::uint16_t>, 65535},
                                Component{5125, 4, read_as<std::uint32_t>, 0},    Component{5126, 4, read_as<float>, 0}};

std::size_t components_of(const std::string& type)
{
    return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
}

const Component* component_of(std::size_t code)
{
    const auto at = std::find_if(components.begin(), components.end(), [code](const Component& one) { return one.code == code; });
    return at == components.end() ? nullptr : &*at;
}

} // namespace

GltfFile::GltfFile(const std::filesystem::path& path) : name_(path.string())
{
    std::string bytes = read_file(path, largest_mesh_bytes);
    if (bytes.starts_with("glTF")) {
        split_glb(bytes);
    } else {
        json_ = parse_json(bytes.starts_with("\xEF\xBB\xBF") ? std::string_view(bytes).substr(3) : std::string_view(bytes), name_);
    }
    if (!json_.is_object()) refuse("This is no glTF: its JSON is no object.");
    std::error_code failure; // then nothing lies within
    read_buffers(std::filesystem::weakly_canonical(path, failure).parent_path());
}

void GltfFile::refuse(const std::string& sentence) const { throw FileError(name_ + ": " + sentence); }

void GltfFile::split_glb(std::string_view bytes)
{
    constexpr std::uint32_t json_chunk = 0x4E4F534A, bin_chunk = 0x004E4942;
    if (bytes.size() < 20) refuse("The file is cut short: it ends within its header.");
    if (const std::uint32_t version = word_at(bytes, 4); version != 2)
        refuse(fmt::format("The file is GLB of version {}; version 2 is read.", version));
    std::string_view json;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::size_t size = word_at(bytes, at);
        const std::uint32_t kind = word_at(bytes, at + 4);
        at += 8;
        if (size > bytes.size() - at) refuse("The file is cut short: it ends within one of its chunks.");
        if (kind == json_chunk && json.empty()) json = bytes.substr(at, size);
        if (kind == bin_chunk && !has_bin_) {
            bin_ = bytes.substr(at, size);
            has_bin_ = true;
        }
        at += size;
    }
    if (json.empty()) refuse("The file has no chunk of JSON.");
    json_ = parse_json(json, name_);
}

std::string GltfFile::buffer_of(const ProjectJson& buffer, const std::filesystem::path& folder) const
{
    const std::string uri = text(buffer, "uri");
    if (uri.starts_with("data:")) {
        const std::size_t comma = uri.find(',');
        if (comma == std::string::npos || !std::string_view(uri).substr(0, comma).ends_with(";base64"))
            refuse("A buffer's data: URI is not in base64.");
        std::optional<std::string> bytes = from_base64(std::string_view(uri).substr(comma + 1));
        if (!bytes) refuse("A buffer's base64 holds what is none.");
        return *std::move(bytes);
    }
    const std::string shown = in_one_line(cut_text(uri, 100));
    if (uri.find('\0') != std::string::npos || uri.find("://") != std::string::npos)
        refuse(fmt::format("The buffer \"{}\" is no file beside this one.", shown));
    std::error_code failure;
    const std::filesystem::path file = std::filesystem::weakly_canonical(folder / unescaped(uri), failure);
    const std::filesystem::path inside = file.lexically_relative(folder);
    if (failure || inside.empty() || *inside.begin() == "..")
        refuse(fmt::format("The buffer \"{}\" lies outside of the file's folder and is not opened.", shown));
    return read_file(file, largest_mesh_bytes);
}

void GltfFile::read_buffers(const std::filesystem::path& folder)
{
    std::size_t all = 0;
    for (std::size_t i = 0; i < count("buffers"); ++i) {
        const ProjectJson& buffer = item("buffers", i);
        const bool is_bin = i == 0 && has_bin_ && !buffer.contains("uri");
        if (!is_bin && !buffer.contains("uri")) refuse(fmt::format("buffers[{}] has no bytes: it names no file.", i));
        buffers_.push_back(is_bin ? std::move(bin_) : buffer_of(buffer, folder));
        const std::size_t size = whole(buffer, "byteLength");
        if (buffers_.back().size() < size)
            refuse(fmt::format("buffers[{}] is cut short: it should have {} bytes and has {}.", i, size, buffers_.back().size()));
        buffers_.back().resize(size);
        all += size;
        if (all > largest_mesh_bytes)
            refuse(fmt::format("The buffers have more than {:.0f} MiB, which is the most.", largest_mesh_bytes / 1048576.0));
    }
}

std::size_t GltfFile::count(const char* list) const
{
    const auto at = json_.find(list);
    return at == json_.end() ? 0 : array_in(*at, name_, list).size();
}

const ProjectJson& GltfFile::item(const char* list, std::size_t number) const
{
    if (number >= count(list)) refuse(fmt::format("{}[{}] is not there: the file has {} of these.", list, number, count(list)));
    const ProjectJson& object = json_[list][number];
    if (!object.is_object()) refuse(fmt::format("{}[{}] must be an object in {{ }}; given is {}.", list, number, in_words(object)));
    return object;
}

std::optional<std::size_t> GltfFile::index(const ProjectJson& object, const char* key) const
{
    const auto at = object.find(key);
    if (at == object.end()) return {};
    const double number = number_in(*at, name_, key);
    if (!(number >= 0 && number <= largest_index && number == std::floor(number)))
        refuse(fmt::format("{} must be a whole number from 0; given is {}.", key, in_words(*at)));
    return static_cast<std::size_t>(number);
}

std::vector<std::size_t> GltfFile::indices(const ProjectJson& object, const char* key) const
{
    const auto at = object.find(key);
    std::vector<std::size_t> all;
    if (at == object.end()) return all;
    for (const ProjectJson& one : array_in(*at, name_, key)) {
        const double number = number_in(one, name_, key);
        if (!(number >= 0 && number <= largest_index && number == std::floor(number)))
            refuse(fmt::format("{} must hold whole numbers from 0; given is {}.", key, in_words(one)));
        all.push_back(static_cast<std::size_t>(number));
    }
    return all;
}

std::vector<double> GltfFile::numbers(const ProjectJson& object, const char* key, std::size_t count) const
{
    const auto at = object.find(key);
    std::vector<double> all;
    if (at == object.end()) return all;
    for (const ProjectJson& one : array_in(*at, name_, key)) all.push_back(number_in(one, name_, key));
    if (all.size() != count) refuse(fmt::format("{} must be a list of {} numbers; given is {}.", key, count, in_words(*at)));
    return all;
}

std::string GltfFile::text(const ProjectJson& object, const char* key) const
{
    const auto at = object.find(key);
    return at == object.end() ? std::string() : text_in(*at, name_, key);
}

GltfFile::Bytes GltfFile::bytes(std::size_t view_number, std::size_t offset, std::size_t count, std::size_t size) const
{
    const ProjectJson& view = item("bufferViews", view_number);
    const std::size_t buffer = whole(view, "buffer"), begin = whole(view, "byteOffset"), length = whole(view, "byteLength");
    if (buffer >= buffers_.size()) refuse(fmt::format("bufferViews[{}] names buffers[{}], which is not there.", view_number, buffer));
    if (begin > buffers_[buffer].size() || length > buffers_[buffer].size() - begin)
        refuse(fmt::format("bufferViews[{}] reaches beyond the end of its buffer.", view_number));
    const std::size_t stride = whole(view, "byteStride"), far = stride > 0 ? stride : size;
    // Each factor is below 2^32, so the product fits.
    if (count > 0 && (offset > length || size > length || far * (count - 1) > length || offset + far * (count - 1) + size > length))
        refuse(fmt::format("An accessor reaches beyond the end of bufferViews[{}].", view_number));
    return {reinterpret_cast<const unsigned char*>(buffers_[buffer].data()) + begin + offset, far};
}

GltfNumbers GltfFile::accessor(std::size_t number, const std::string& type, std::size_t most) const
{
    const ProjectJson& given = item("accessors", number);
    if (text(given, "type") != type)
        refuse(fmt::format("accessors[{}] must be of type {}; given is \"{}\".", number, type,
                           in_one_line(cut_text(text(given, "type"), 40))));
    const Component* const component = component_of(whole(given, "componentType"));
    if (component == nullptr)
        refuse(fmt::format("accessors[{}] has componentType {}, which glTF has not.", number, whole(given, "componentType")));
    GltfNumbers found{whole(given, "count"), components_of(type), {}};
    if (found.count > most) refuse(fmt::format("accessors[{}] has {} elements; up to {} are read.", number, found.count, most));
    found.values.assign(found.count * found.components, 0);
    const auto normalized = given.find("normalized");
    const double by = normalized != given.end() && *normalized == true && component->most > 0 ? component->most : 0;
    const std::size_t size = component->size * found.components;
    const auto take = [&](const unsigned char* from, std::size_t element) {
        for (std::size_t k = 0; k < found.components; ++k) {
            const double value = component->read(from + k * component->size);
            found.values[element * found.components + k] = by > 0 ? std::max(value / by, -1.0) : value;
        }
    };
    if (const auto view = index(given, "bufferView")) {
        const Bytes dense = bytes(*view, whole(given, "byteOffset"), found.count, size);
        for (std::size_t i = 0; i < found.count; ++i) take(dense.first + i * dense.far, i);
    }
    const auto sparse = given.find("sparse");
    if (sparse == given.end()) return found;
    if (!sparse->is_object() || !sparse->contains("indices") || !sparse->contains("values"))
        refuse(fmt::format("accessors[{}].sparse lacks its indices or values.", number));
    const ProjectJson &where = (*sparse)["indices"], &what = (*sparse)["values"];
    const std::size_t count = whole(*sparse, "count");
    const Component* const place = component_of(whole(where, "componentType"));
    if (place == nullptr || count > found.count) refuse(fmt::format("accessors[{}].sparse names more elements than there are.", number));
    const Bytes places = bytes(whole(where, "bufferView"), whole(where, "byteOffset"), count, place->size),
                values = bytes(whole(what, "bufferView"), whole(what, "byteOffset"), count, size);
    for (std::size_t i = 0; i < count; ++i) {
        const double element = place->read(places.first + i * places.far);
        if (!(element >= 0 && element < static_cast<double>(found.count)))
            refuse(fmt::format("accessors[{}].sparse names element {}, which is not there.", number, element));
        take(values.first + i * values.far, static_cast<std::size_t>(element));
    }
    return found;
}

} // namespace hygroloom
