// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// "HLM" and "e", a sentence; or "HLM" and "m", six counts, the arrays in the order of FlatMesh, and "." at the end. Both programs are of
// one build and one machine, so numbers are as they lie in memory.
#include "core/garment/mesh_bytes.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hygroloom {

namespace {

constexpr std::string_view mark = "HLM";
constexpr std::size_t most_texts = 10001, longest_text = 500;

template <typename T> void put(std::string& bytes, const std::vector<T>& all)
{
    bytes.append(reinterpret_cast<const char*>(all.data()), sizeof(T) * all.size());
}

void put(std::string& bytes, const std::vector<std::string>& texts)
{
    for (const std::string& text : texts) {
        const std::string cut = cut_text(text, longest_text);
        put(bytes, std::vector<std::uint64_t>{cut.size()});
        bytes += cut;
    }
}

/// Takes values off the answer; false, from the first on that is not there or makes no sense.
class Answer {
public:
    explicit Answer(std::string_view bytes) : rest_(bytes) {}
    bool good() const { return good_; }
    bool at_end() const { return good_ && rest_ == "."; }
    void demand(bool holds) { good_ = good_ && holds; }

    template <typename T> std::vector<T> take(std::uint64_t count)
    {
        demand(count <= rest_.size() / sizeof(T));
        if (!good_) return {};
        std::vector<T> all(count);
        std::memcpy(all.data(), rest_.data(), sizeof(T) * count);
        rest_.remove_prefix(sizeof(T) * count);
        return all;
    }
    std::vector<std::string> take_texts(std::uint64_t count)
    {
        demand(count <= most_texts);
        std::vector<std::string> texts;
        for (std::uint64_t i = 0; i < count && good_; ++i) {
            const std::vector<std::uint64_t> size = take<std::uint64_t>(1);
            demand(good_ && size[0] <= longest_text);
            const std::vector<char> text = take<char>(good_ ? size[0] : 0);
            texts.push_back(in_one_line({text.data(), text.size()}));
        }
        return texts;
    }

private:
    std::string_view rest_;
    bool good_ = true;
};

bool are_finite(const FlatMesh& mesh)
{
    const auto is_near = [](double number) { return std::abs(number) <= 1e12; };
    return std::all_of(mesh.places.begin(), mesh.places.end(),
                       [&](const Vec3d& p) { return is_near(p.x) && is_near(p.y) && is_near(p.z); }) &&
           std::all_of(mesh.uv.begin(), mesh.uv.end(), [&](const FlatPlace& p) { return is_near(p[0]) && is_near(p[1]); });
}

bool are_within(const std::vector<std::array<int, 3>>& triangles, std::size_t count)
{
    return std::all_of(triangles.begin(), triangles.end(), [count](const std::array<int, 3>& triangle) {
        return std::all_of(triangle.begin(), triangle.end(),
                           [count](int corner) { return corner >= 0 && static_cast<std::size_t>(corner) < count; });
    });
}

} // namespace

std::string answer_bytes(const FlatMesh& mesh)
{
    std::string bytes(mark);
    bytes += 'm';
    put(bytes, std::vector<std::uint64_t>{mesh.places.size(), mesh.uv.size(), mesh.triangles.size(), mesh.label.size(), mesh.labels.size(),
                                          mesh.issues.size()});
    put(bytes, mesh.places);
    put(bytes, mesh.uv);
    put(bytes, mesh.triangles);
    put(bytes, mesh.uv_triangles);
    put(bytes, mesh.label);
    put(bytes, mesh.labels);
    put(bytes, mesh.issues);
    put(bytes, std::vector<double>{mesh.metre});
    return bytes + ".";
}

std::string refusal_bytes(const std::string& sentence) { return std::string(mark) + "e" + sentence; }

FlatMesh mesh_from_answer(std::string_view bytes, const std::string& name)
{
    const auto refuse = [&name](const std::string& sentence) { throw FileError(name + ": " + sentence); };
    if (bytes.starts_with(std::string(mark) + "e")) {
        const std::string sentence = in_one_line(cut_text(bytes.substr(mark.size() + 1), name.size() + longest_text));
        if (sentence.starts_with(in_one_line(name) + ": ")) throw FileError(sentence);
        refuse(sentence);
    }
    FlatMesh mesh;
    Answer answer(bytes.substr(std::min(bytes.size(), mark.size() + 1)));
    answer.demand(bytes.starts_with(std::string(mark) + "m"));
    const std::vector<std::uint64_t> counts = answer.take<std::uint64_t>(6);
    answer.demand(answer.good() && counts[0] <= most_mesh_places && counts[1] <= most_mesh_places && counts[2] <= most_mesh_triangles &&
                  counts[3] == counts[2]);
    if (answer.good()) {
        mesh.places = answer.take<Vec3d>(counts[0]);
        mesh.uv = answer.take<FlatPlace>(counts[1]);
        mesh.triangles = answer.take<std::array<int, 3>>(counts[2]);
        mesh.uv_triangles = answer.take<std::array<int, 3>>(counts[2]);
        mesh.label = answer.take<int>(counts[3]);
        mesh.labels = answer.take_texts(counts[4]);
        mesh.issues = answer.take_texts(counts[5]);
        const std::vector<double> metre = answer.take<double>(1);
        answer.demand(answer.good() && metre[0] >= 0 && metre[0] <= 1000);
        mesh.metre = answer.good() ? metre[0] : 0;
    }
    const int labels = static_cast<int>(mesh.labels.size());
    answer.demand(are_finite(mesh) && are_within(mesh.triangles, mesh.places.size()) && are_within(mesh.uv_triangles, mesh.uv.size()) &&
                  !mesh.triangles.empty() &&
                  std::all_of(mesh.label.begin(), mesh.label.end(), [labels](int label) { return label >= -1 && label < labels; }));
    if (!answer.at_end())
        refuse("What its reader hygroloom-mesh made of the file makes no sense; it is damaged, or made to do harm. Export it anew, as OBJ "
               "or GLB.");
    return mesh;
}

} // namespace hygroloom
