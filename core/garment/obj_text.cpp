// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// OBJ as text. Assimp's reader forgets which place of the file a corner names, which the text beside a draped pattern counts by.
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/garment/mesh_builder.h"

#include <fmt/format.h>

#include <charconv>

namespace hygroloom {

namespace {

/// How MeshBuilder counts names.
enum : std::size_t { group, object, material };

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& name) : rest_(text), name_(name), mesh_(name) {}
    FlatMesh read();

private:
    [[noreturn]] void refuse(const std::string& sentence) const { throw FileError(fmt::format("{}: line {}: {}", name_, line_, sentence)); }
    std::string_view next_line();
    std::string_view whole_line();
    static std::string_view next_word(std::string_view& line);
    double number(std::string_view& line) const;
    int index(std::string_view text, std::size_t count) const;
    void face(std::string_view line);

    std::string_view rest_;
    const std::string& name_;
    std::size_t line_ = 0;
    std::string joined_; ///< of lines that go on in the next
    MeshBuilder mesh_;
    std::vector<MeshBuilder::Corner> corners_;
};

/// Lines end with LF, CR or both.
std::string_view ObjReader::next_line()
{
    const std::string_view line = rest_.substr(0, std::min(rest_.find_first_of("\n\r"), rest_.size()));
    rest_.remove_prefix(line.size());
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : rest_.empty() ? 0 : 1);
    ++line_;
    return line;
}

/// With what follows in the next lines where a line ends with a backslash.
std::string_view ObjReader::whole_line()
{
    std::string_view line = next_line();
    if (!line.ends_with('\\') || line.starts_with('#')) return line;
    joined_.clear();
    while (line.ends_with('\\')) {
        line.remove_suffix(1);
        joined_.append(line).append(" ");
        line = rest_.empty() ? std::string_view() : next_line();
    }
    return joined_.append(line);
}

std::string_view ObjReader::next_word(std::string_view& line)
{
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
}

double ObjReader::number(std::string_view& line) const
{
    std::string_view word = next_word(line);
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size() || !(std::abs(value) < 1e12))
        refuse(fmt::format("This must be a number; given is \"{}\".", in_one_line(cut_text(word, 40))));
    return value;
}

/// Counted from 0; the file counts from 1, or backwards from the last.
int ObjReader::index(std::string_view text, std::size_t count) const
{
    long long value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    const long long all = static_cast<long long>(count);
    if (failure != std::errc() || end != text.data() + text.size() || value == 0 || value > all || value < -all)
        refuse(fmt::format("This must be a number from 1 to {}; given is \"{}\".", count, in_one_line(cut_text(text, 40))));
    return static_cast<int>(value > 0 ? value - 1 : all + value);
}

void ObjReader::face(std::string_view line)
{
    corners_.clear();
    bool has_uv = true;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
        const std::size_t slash = std::min(word.find('/'), word.size());
        MeshBuilder::Corner corner{index(word.substr(0, slash), mesh_.places()), -1};
        std::string_view uv = slash < word.size() ? word.substr(slash + 1) : std::string_view();
        uv = uv.substr(0, std::min(uv.find('/'), uv.size()));
        if (uv.empty())
            has_uv = false;
        else
            corner[1] = index(uv, mesh_.flats());
        corners_.push_back(corner);
    }
    if (has_uv)
        mesh_.add_face(corners_);
    else
        mesh_.add_face_without_flat();
}

FlatMesh ObjReader::read()
{
    while (!rest_.empty()) {
        std::string_view line = whole_line();
        const std::string_view word = next_word(line);
        if (word == "v") {
            const double x = number(line), y = number(line);
            mesh_.add_place({x, y, number(line)});
        } else if (word == "vt") {
            const double u = number(line);
            mesh_.add_flat({u, number(line)});
        } else if (word == "f") {
            face(line);
        } else if (word == "g" || word == "o" || word == "usemtl") {
            const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
            std::string_view label = line.substr(begin);
            while (label.ends_with(' ')) label.remove_suffix(1);
            mesh_.name(word == "g" ? group : word == "o" ? object : material, label);
        }
    }
    return mesh_.finish(0);
}

} // namespace

FlatMesh mesh_from_obj(std::string_view text, const std::string& name) { return ObjReader(text, name).read(); }

} // namespace hygroloom
