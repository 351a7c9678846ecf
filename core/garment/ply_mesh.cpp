// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// PLY: text, and binary of both orders of bytes. Flat coordinates stand with the vertices (s and t, u and v, texture_u and texture_v) or
// with the corners of each face (the list texcoord).
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/garment/mesh_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

namespace hygroloom {

namespace {

/// A number of the file by the bytes that it takes.
struct Number {
    std::string_view name, other_name;
    std::size_t size;
    double (*read)(const char*);
};

template <typename T> double read_as(const char* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

constexpr std::array numbers{Number{"char", "int8", 1, read_as<std::int8_t>},    Number{"uchar", "uint8", 1, read_as<std::uint8_t>},
                             Number{"short", "int16", 2, read_as<std::int16_t>}, Number{"ushort", "uint16", 2, read_as<std::uint16_t>},
                             Number{"int", "int32", 4, read_as<std::int32_t>},   Number{"uint", "uint32", 4, read_as<std::uint32_t>},
                             Number{"float", "float32", 4, read_as<float>},      Number{"double", "float64", 8, read_as<double>}};

struct Property {
    std::string name;
    const Number* number = nullptr;
    const Number* count = nullptr; ///< of a list; none: it is one number
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;

    /// Number of the first property of one of these names; -1: none.
    int find(std::initializer_list<std::string_view> names) const
    {
        for (const std::string_view name_ : names)
            for (std::size_t i = 0; i < properties.size(); ++i)
                if (properties[i].name == name_) return static_cast<int>(i);
        return -1;
    }
};

class PlyReader {
public:
    PlyReader(std::string_view bytes, const std::string& name) : rest_(bytes), mesh_(name) {}
    FlatMesh read();

private:
    enum class Form { text, little, big };

    std::string_view next_line();
    static std::string_view next_word(std::string_view& line);
    void read_header();
    void read_property(std::string_view line);
    const Number& number_named(std::string_view word) const;
    double next(const Number& number);
    /// The numbers of a property of the row that is being read.
    void take_row(const Element& element);
    const std::vector<double>& of(int property) const { return row_[property]; }
    void read_vertices(const Element& element);
    void read_faces(const Element& element);

    std::string_view rest_;
    Form form_ = Form::text;
    std::vector<Element> elements_;
    std::vector<std::vector<double>> row_;
    MeshBuilder mesh_;
    bool has_flat_ = false;
};

std::string_view PlyReader::next_line()
{
    if (rest_.empty()) mesh_.refuse("The file is cut short: its header has no end_header.");
    const std::string_view line = rest_.substr(0, std::min(rest_.find_first_of("\n\r"), rest_.size()));
    rest_.remove_prefix(line.size());
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : rest_.empty() ? 0 : 1);
    return line;
}

std::string_view PlyReader::next_word(std::string_view& line)
{
    constexpr std::string_view blanks = " \t\r\n\v\f";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, std::min(line.find_first_of(blanks), line.size()));
    line.remove_prefix(word.size());
    return word;
}

const Number& PlyReader::number_named(std::string_view word) const
{
    const auto at =
        std::find_if(numbers.begin(), numbers.end(), [word](const Number& one) { return one.name == word || one.other_name == word; });
    if (at == numbers.end()) mesh_.refuse(fmt::format("A property's type is \"{}\", which PLY has not.", in_one_line(cut_text(word, 40))));
    return *at;
}

void PlyReader::read_property(std::string_view line)
{
    if (elements_.empty()) mesh_.refuse("A property stands before the first element.");
    Property property;
    std::string_view word = next_word(line);
    if (word == "list") {
        property.count = &number_named(next_word(line));
        word = next_word(line);
    }
    property.number = &number_named(word);
    property.name = next_word(line);
    if (elements_.back().properties.size() >= 1000) mesh_.refuse("An element has up to 1000 properties; this one has more.");
    elements_.back().properties.push_back(std::move(property));
}

void PlyReader::read_header()
{
    if (next_line() != "ply") mesh_.refuse("This is no PLY file: its first line is not \"ply\".");
    bool has_format = false;
    while (true) {
        std::string_view line = next_line();
        const std::string_view word = next_word(line);
        if (word == "end_header") break;
        if (word == "format") {
            const std::string_view form = next_word(line);
            has_format = form == "ascii" || form == "binary_little_endian" || form == "binary_big_endian";
            form_ = form == "ascii" ? Form::text : form == "binary_big_endian" ? Form::big : Form::little;
        } else if (word == "element") {
            Element element;
            element.name = next_word(line);
            const std::string_view count = next_word(line);
            const auto [end, failure] = std::from_chars(count.data(), count.data() + count.size(), element.count);
            if (failure != std::errc() || end != count.data() + count.size())
                mesh_.refuse(fmt::format("The element \"{}\" has no number of rows; given is \"{}\".",
                                         in_one_line(cut_text(element.name, 40)), in_one_line(cut_text(count, 40))));
            elements_.push_back(std::move(element));
        } else if (word == "property") {
            read_property(line);
        } else if (word != "comment" && word != "obj_info" && !word.empty()) {
            mesh_.refuse(fmt::format("The header has a line that begins with \"{}\", which PLY has not.", in_one_line(cut_text(word, 40))));
        }
    }
    if (!has_format) mesh_.refuse("The header's format is none of ascii, binary_little_endian and binary_big_endian.");
    for (const Element& element : elements_) { // the shortest row there can be
        std::size_t least = 0;
        for (const Property& property : element.properties)
            least += form_ == Form::text ? 1 : property.count ? property.count->size : property.number->size;
        if (element.count > 0 && (least == 0 || element.count > rest_.size() / least))
            mesh_.refuse(fmt::format("The file is cut short: its header says {} rows of \"{}\", and {} bytes follow.", element.count,
                                     in_one_line(cut_text(element.name, 40)), rest_.size()));
    }
}

double PlyReader::next(const Number& number)
{
    if (form_ == Form::text) {
        std::string_view word = next_word(rest_);
        if (word.empty()) mesh_.refuse("The file is cut short: numbers are missing at its end.");
        if (word.starts_with('+')) word.remove_prefix(1);
        double value = 0;
        const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (failure != std::errc() || end != word.data() + word.size())
            mesh_.refuse(fmt::format("This must be a number; given is \"{}\".", in_one_line(cut_text(word, 40))));
        return value;
    }
    if (rest_.size() < number.size) mesh_.refuse("The file is cut short: numbers are missing at its end.");
    std::array<char, 8> bytes{};
    std::copy_n(rest_.begin(), number.size, bytes.begin());
    rest_.remove_prefix(number.size);
    if ((form_ == Form::big) != (std::endian::native == std::endian::big))
        std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(number.size));
    return number.read(bytes.data());
}

void PlyReader::take_row(const Element& element)
{
    row_.resize(element.properties.size());
    for (std::size_t i = 0; i < row_.size(); ++i) {
        const Property& property = element.properties[i];
        row_[i].clear();
        const double count = property.count ? next(*property.count) : 1;
        if (!(count >= 0 && count <= 100000 && count == std::floor(count)))
            mesh_.refuse(fmt::format("A list has {} numbers; it may have up to 100000.", count));
        for (int k = 0; k < static_cast<int>(count); ++k) row_[i].push_back(next(*property.number));
    }
}

void PlyReader::read_vertices(const Element& element)
{
    const int x = element.find({"x"}), y = element.find({"y"}), z = element.find({"z"}),
              u = element.find({"s", "u", "texture_u", "texture_s"}), v = element.find({"t", "v", "texture_v", "texture_t"});
    if (x < 0 || y < 0 || z < 0) mesh_.refuse("The element \"vertex\" lacks one of the properties x, y and z.");
    for (const Property& property : element.properties)
        if (property.count) mesh_.refuse("The element \"vertex\" has a list, which is not read here.");
    has_flat_ = u >= 0 && v >= 0;
    mesh_.expect(element.count, 0);
    for (std::size_t i = 0; i < element.count; ++i) {
        take_row(element);
        mesh_.add_place({of(x)[0], of(y)[0], of(z)[0]});
        if (has_flat_) mesh_.add_flat({of(u)[0], of(v)[0]});
    }
}

void PlyReader::read_faces(const Element& element)
{
    const int corners = element.find({"vertex_indices", "vertex_index"}), flats = element.find({"texcoord"});
    if (corners < 0 || !element.properties[corners].count) mesh_.refuse("The element \"face\" has no list vertex_indices.");
    if (mesh_.places() == 0) mesh_.refuse("The faces stand before the vertices, which is not read here.");
    std::vector<MeshBuilder::Corner> face;
    for (std::size_t i = 0; i < element.count; ++i) {
        take_row(element);
        const std::vector<double>& given = of(corners);
        const bool own = flats >= 0 && of(flats).size() == 2 * given.size();
        face.clear();
        for (std::size_t k = 0; k < given.size(); ++k) {
            if (!(given[k] >= 0 && given[k] < static_cast<double>(mesh_.places())))
                mesh_.refuse(fmt::format("Face {} names vertex {}, which is not there; the last is {}, counted from 0.", i, given[k],
                                         mesh_.places() - 1));
            const int place = static_cast<int>(given[k]);
            if (own) {
                face.push_back({place, static_cast<int>(mesh_.flats())});
                mesh_.add_flat({of(flats)[2 * k], of(flats)[2 * k + 1]});
            } else {
                face.push_back({place, place});
            }
        }
        if (own || has_flat_)
            mesh_.add_face(face);
        else
            mesh_.add_face_without_flat();
    }
}

FlatMesh PlyReader::read()
{
    read_header();
    for (const Element& element : elements_) {
        if (element.name == "vertex") {
            read_vertices(element);
        } else if (element.name == "face") {
            read_faces(element);
        } else {
            for (std::size_t i = 0; i < element.count; ++i) take_row(element);
        }
    }
    return mesh_.finish(0);
}

} // namespace

FlatMesh mesh_from_ply(std::string_view bytes, const std::string& name) { return PlyReader(bytes, name).read(); }

} // namespace hygroloom
