// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// OBJ as text. Assimp's reader forgets which place of the file a corner names, which the text beside a draped pattern counts by.
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/garment/flat_mesh.h"

#include <fmt/format.h>

#include <charconv>
#include <map>

namespace hygroloom {

namespace {

constexpr std::size_t most_labels = 10000, longest_name = 100;

/// Which of groups, objects and materials tell panels apart: the first that has several names.
class Labels {
public:
    enum Kind { group, object, material };
    void name(Kind kind, std::string_view text)
    {
        const std::string label = in_whole_utf8(cut_text(text, longest_name));
        auto& known = names_[kind];
        if (known.size() < most_labels || known.contains(label))
            now_[kind] = known.try_emplace(label, static_cast<int>(known.size())).first->second;
    }
    void add_triangle() { of_triangles_.push_back(now_); }
    void give(FlatMesh& mesh) const
    {
        std::size_t kind = 0;
        while (kind < 3 && names_[kind].size() < 2) ++kind;
        for (std::size_t other = 0; kind == 3 && other < 3; ++other)
            if (!names_[other].empty()) kind = other;
        mesh.label.assign(of_triangles_.size(), -1);
        if (kind == 3) return;
        mesh.labels.resize(names_[kind].size());
        for (const auto& [label, number] : names_[kind]) mesh.labels[static_cast<std::size_t>(number)] = label;
        for (std::size_t t = 0; t < of_triangles_.size(); ++t) mesh.label[t] = of_triangles_[t][kind];
    }

private:
    std::array<std::map<std::string, int>, 3> names_;
    std::array<int, 3> now_{-1, -1, -1};
    std::vector<std::array<int, 3>> of_triangles_;
};

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}
    FlatMesh read();

private:
    [[noreturn]] void refuse(const std::string& sentence) const { throw FileError(fmt::format("{}: line {}: {}", name_, line_, sentence)); }
    std::string_view next_line();
    static std::string_view next_word(std::string_view& line);
    double number(std::string_view& line) const;
    int index(std::string_view text, std::size_t count) const;
    void face(std::string_view line);

    std::string_view rest_;
    const std::string& name_;
    std::size_t line_ = 0, without_uv_ = 0;
    FlatMesh mesh_;
    Labels labels_;
};

std::string_view ObjReader::next_line()
{
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
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
        refuse(fmt::format("This must be a number; given is \"{}\".", in_whole_utf8(cut_text(word, 40))));
    return value;
}

/// Counted from 0; the file counts from 1, or backwards from the last.
int ObjReader::index(std::string_view text, std::size_t count) const
{
    long long value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    const long long all = static_cast<long long>(count);
    if (failure != std::errc() || end != text.data() + text.size() || value == 0 || value > all || value < -all)
        refuse(fmt::format("This must be a number from 1 to {}; given is \"{}\".", count, in_whole_utf8(cut_text(text, 40))));
    return static_cast<int>(value > 0 ? value - 1 : all + value);
}

void ObjReader::face(std::string_view line)
{
    std::vector<std::array<int, 2>> corners;
    bool has_uv = true;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
        const std::size_t slash = std::min(word.find('/'), word.size());
        std::array<int, 2> corner{index(word.substr(0, slash), mesh_.places.size()), -1};
        std::string_view uv = slash < word.size() ? word.substr(slash + 1) : std::string_view();
        uv = uv.substr(0, std::min(uv.find('/'), uv.size()));
        if (uv.empty())
            has_uv = false;
        else
            corner[1] = index(uv, mesh_.uv.size());
        corners.push_back(corner);
        if (corners.size() > 1000) refuse("A face has up to 1000 corners; this one has more.");
    }
    if (!has_uv) {
        ++without_uv_;
        return;
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
        mesh_.triangles.push_back({corners[0][0], corners[i - 1][0], corners[i][0]});
        mesh_.uv_triangles.push_back({corners[0][1], corners[i - 1][1], corners[i][1]});
        labels_.add_triangle();
    }
    if (mesh_.triangles.size() > most_mesh_triangles)
        refuse(fmt::format("A mesh has up to {} triangles; this one has more.", most_mesh_triangles));
}

FlatMesh ObjReader::read()
{
    while (!rest_.empty()) {
        std::string_view line = next_line();
        const std::string_view word = next_word(line);
        if (word == "v") {
            const double x = number(line), y = number(line);
            mesh_.places.push_back({x, y, number(line)});
        } else if (word == "vt") {
            const double u = number(line);
            mesh_.uv.push_back({u, number(line)});
        } else if (word == "f") {
            face(line);
        } else if (word == "g" || word == "o" || word == "usemtl") {
            const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
            std::string_view label = line.substr(begin);
            while (label.ends_with(' ')) label.remove_suffix(1);
            labels_.name(word == "g" ? Labels::group : word == "o" ? Labels::object : Labels::material, label);
        }
        if (std::max(mesh_.places.size(), mesh_.uv.size()) > most_mesh_places)
            refuse(fmt::format("A mesh has up to {} places; this one has more.", most_mesh_places));
    }
    if (mesh_.triangles.empty())
        throw FileError(without_uv_ > 0 ? name_ + ": The mesh has no flat coordinates (UV); without them its panels are not known."
                                        : name_ + ": The file has no faces.");
    if (without_uv_ > 0) mesh_.issues.push_back(fmt::format("{} faces have no flat coordinates and were left out.", without_uv_));
    labels_.give(mesh_);
    return std::move(mesh_);
}

} // namespace

FlatMesh mesh_from_obj(std::string_view text, const std::string& name) { return ObjReader(text, name).read(); }

} // namespace hygroloom
