// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/stitches.h"

#include "core/base/units.h"
#include "core/base/words.h"
#include "core/garment/outline.h"
#include "core/project/json_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace hygroloom {

namespace {

constexpr std::size_t most_stitches = 20000, most_issues = 400;
constexpr double most_ease = 0.3; // of the longer edge
constexpr double clearly = 0.9;   // the nearer way is at most so much of the other

using Side = std::array<int, 2>; ///< panel, edge

class StitchReader {
public:
    StitchReader(const std::vector<std::vector<int>>& numbers, GarmentPattern& pattern) : numbers_(numbers), pattern_(pattern) {}
    void read(const ProjectJson& stitch, std::size_t number);

private:
    void note(const std::string& sentence)
    {
        if (pattern_.issues.size() < most_issues) pattern_.issues.push_back(sentence);
    }
    std::optional<Side> side_in(const ProjectJson& value, std::size_t number);
    void sew(Side a, Side b, bool turned, std::size_t number);

    const std::vector<std::vector<int>>& numbers_;
    GarmentPattern& pattern_;
    std::set<Side> sewn_;
};

std::optional<Side> StitchReader::side_in(const ProjectJson& value, std::size_t number)
{
    const auto panel = value.is_object() ? value.find("panel") : value.end(), edge = value.is_object() ? value.find("edge") : value.end();
    if (!value.is_object() || panel == value.end() || edge == value.end() || !panel->is_string() || !edge->is_number()) {
        note(fmt::format("The stitch {} names no panel and edge but {}; it was left out.", number, in_words(value)));
        return {};
    }
    const std::string name = panel->get<std::string>();
    std::vector<std::string> names;
    for (std::size_t p = 0; p < pattern_.panels.size(); ++p) {
        names.push_back(pattern_.panels[p].name);
        if (names.back() != name) continue;
        const double index = edge->get<double>();
        if (!(index >= 0 && index < static_cast<double>(numbers_[p].size()) && index == std::floor(index))) {
            note(fmt::format("The stitch {} goes to the edge {:g} of the panel \"{}\", which has {}; it was left out.", number, index, name,
                             numbers_[p].size()));
            return {};
        }
        const int own = numbers_[p][index];
        if (own >= 0) return Side{static_cast<int>(p), own};
        note(fmt::format("The stitch {} goes to an edge without length; it was left out.", number));
        return {};
    }
    note(fmt::format("The stitch {} goes to the panel {}, which is not there{} It was left out.", number, in_words(*panel),
                     did_you_mean(name, names)));
    return {};
}

void StitchReader::sew(Side a, Side b, bool turned, std::size_t number)
{
    if (a == b) {
        note(fmt::format("The stitch {} sews an edge to itself; it was left out.", number));
        return;
    }
    const auto edge_of = [this](const Side& side) -> const PanelEdge& { return pattern_.panels[side[0]].edges[side[1]]; };
    const double long_a = length_of(edge_of(a)), long_b = length_of(edge_of(b));
    const std::string &name_a = pattern_.panels[a[0]].name, &name_b = pattern_.panels[b[0]].name;
    if (std::abs(long_a - long_b) > most_ease * std::max(long_a, long_b))
        note(fmt::format("The stitch {} joins edges of different length: {:.0f} mm of \"{}\" and {:.0f} mm of \"{}\".", number,
                         mm_from_metre(long_a), name_a, mm_from_metre(long_b), name_b));
    for (const Side& side : {a, b})
        if (!sewn_.insert(side).second)
            note(fmt::format("The edge {} of the panel \"{}\" is sewn more than once.", side[1], pattern_.panels[side[0]].name));
    pattern_.seams.push_back(seam_of(pattern_, a, b, turned));
}

void StitchReader::read(const ProjectJson& stitch, std::size_t number)
{
    if (!stitch.is_array()) {
        note(fmt::format("The stitch {} is no list but {}; it was left out.", number, in_words(stitch)));
        return;
    }
    bool turned = false;
    std::vector<std::vector<Side>> sides;
    for (const ProjectJson& item : stitch) {
        if (item.is_string()) {
            const std::string flag = item.get<std::string>();
            if (flag == "right_wrong")
                turned = true;
            else
                note(fmt::format("The stitch {} has the word {}, which is not known.", number, in_words(item)));
            continue;
        }
        sides.emplace_back();
        bool sound = true;
        for (const ProjectJson& one : item.is_array() ? item : ProjectJson::array({item})) {
            const std::optional<Side> side = side_in(one, number);
            if (side)
                sides.back().push_back(*side);
            else
                sound = false;
        }
        if (!sound) return;
    }
    if (sides.size() < 2) {
        note(fmt::format("The stitch {} has {} sides, not two; it was left out.", number, sides.size()));
        return;
    }
    for (std::size_t i = 1; i < sides.size(); ++i) {
        if (sides[i].size() != sides[0].size()) {
            note(fmt::format("The stitch {} has {} edges on one side and {} on another; it was left out.", number, sides[0].size(),
                             sides[i].size()));
            continue;
        }
        for (std::size_t k = 0; k < sides[0].size(); ++k) sew(sides[0][k], sides[i][k], turned, number);
    }
}

} // namespace

PatternSeam seam_of(const GarmentPattern& pattern, std::array<int, 2> a, std::array<int, 2> b, bool turned)
{
    const PatternPanel &one = pattern.panels[a[0]], &other = pattern.panels[b[0]];
    const std::vector<FlatPlace>&ends_a = one.edges[a[1]].places, &ends_b = other.edges[b[1]].places;
    const Vec3d a0 = in_space(one, ends_a.front()), a1 = in_space(one, ends_a.back());
    const Vec3d b0 = in_space(other, ends_b.front()), b1 = in_space(other, ends_b.back());
    const double against = length(a0 - b1) + length(a1 - b0), along = length(a0 - b0) + length(a1 - b1);
    PatternSeam seam{a[0], a[1], b[0], b[1], !turned};
    if (pattern.is_placed && a[0] != b[0]) {
        if (against < clearly * along) seam.reversed = true;
        if (along < clearly * against) seam.reversed = false;
    }
    return seam;
}

void read_stitches(const ProjectJson& list, const std::string& file, const std::vector<std::vector<int>>& edge_numbers,
                   GarmentPattern& pattern)
{
    if (list.size() > most_stitches)
        throw FileError(
            fmt::format("{}: pattern.stitches: A pattern has up to {} stitches; given are {}.", file, most_stitches, list.size()));
    StitchReader reader(edge_numbers, pattern);
    for (std::size_t i = 0; i < list.size(); ++i) reader.read(list[i], i);
}

} // namespace hygroloom
