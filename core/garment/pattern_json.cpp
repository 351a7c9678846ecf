// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Sewing patterns as GarmentCode and Garment-Pattern-Generator write them (Korosteleva and Lee). Lengths are in units_in_meter. A curve's
// control point is given along its edge, from 0 to 1, and in edge lengths to its left; "circle" has the radius in the file's unit, whether
// the larger arc is meant, and whether it bulges to the right of the edge. Panels are placed by turns about x, then y, then z, all of the
// room, in degrees, and then moved; they face outwards where they go round counter-clockwise, and inwards where they go round clockwise.
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/garment/outline.h"
#include "core/garment/readers.h"
#include "core/garment/stitches.h"
#include "core/project/json_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr double largest_panel_m = 20, farthest_placed_m = 100; // m; more is a wrong unit
constexpr double farthest_control = 1000;                       // edge lengths
constexpr std::size_t most_places_of_all = 400'000;

/// One panel as the file has it, in metres.
struct RawEdge {
    int from = 0, to = 0;
    std::vector<FlatPlace> controls; ///< relative to the edge
    std::optional<std::array<double, 3>> circle;
};

class PatternReader {
public:
    PatternReader(const ProjectJson& json, const std::string& name) : json_(json), name_(name) {}
    GarmentPattern read();

private:
    [[noreturn]] void refuse(const std::string& path, const std::string& sentence) const
    {
        throw FileError(fmt::format("{}: {}: {}", name_, path, sentence));
    }
    void note(const std::string& sentence)
    {
        if (std::find(pattern_.issues.begin(), pattern_.issues.end(), sentence) == pattern_.issues.end() && pattern_.issues.size() < 200)
            pattern_.issues.push_back(sentence);
    }
    void note_unknown(const ProjectJson& object, const std::vector<const char*>& known, const char* where);
    const ProjectJson& object_in(const ProjectJson& parent, const char* key, const std::string& path) const;
    FlatPlace pair_in(const ProjectJson& value, const std::string& path, double most) const;
    void read_properties(const ProjectJson& json);
    void read_panel(const std::string& panel, const ProjectJson& json);
    void read_placement(const ProjectJson& json, const std::string& path, PatternPanel& panel);
    RawEdge read_edge(const ProjectJson& json, const std::string& path, const std::vector<FlatPlace>& corners) const;
    void read_curvature(const ProjectJson& json, const std::string& path, const std::vector<FlatPlace>& corners, RawEdge& edge) const;
    PanelEdge drawn(const RawEdge& edge, const std::vector<FlatPlace>& corners) const;
    void close(PatternPanel& panel, std::vector<RawEdge>& edges, const std::vector<FlatPlace>& corners, std::vector<int>& numbers);
    void check(const PatternPanel& panel);

    const ProjectJson& json_;
    const std::string& name_;
    GarmentPattern pattern_;
    double metre_ = 0.01; ///< of the file's unit
    bool absolute_controls_ = false;
    std::vector<std::vector<int>> edge_numbers_; ///< of each panel: of the file's edges among the panel's, -1: left out
    std::size_t places_ = 0, comparisons_ = 0;
};

void PatternReader::note_unknown(const ProjectJson& object, const std::vector<const char*>& known, const char* where)
{
    for (const auto& [key, value] : object.items())
        if (std::find_if(known.begin(), known.end(), [&key = key](const char* word) { return key == word; }) == known.end())
            note(fmt::format("The key {} of {} is not known and was left out.", in_words(key), where));
}

const ProjectJson& PatternReader::object_in(const ProjectJson& parent, const char* key, const std::string& path) const
{
    const auto at = parent.find(key);
    if (at == parent.end()) refuse(path, fmt::format("The key \"{}\" is missing.", key));
    if (!at->is_object()) refuse(path + "." + key, fmt::format("This must be an object in {{ }}; given is {}.", in_words(*at)));
    return *at;
}

/// Of a file that is no pattern: what it may be.
std::string what_it_has(const ProjectJson& json)
{
    constexpr std::size_t most = 5;
    if (const auto format = json.find("format"); format != json.end() && *format == "hygroloom-project")
        return "it is a project of Hygroloom; name one of its garments' sources.";
    std::string keys;
    std::size_t count = 0;
    for (const auto& [key, value] : json.items())
        if (count++ < most) keys += (keys.empty() ? "" : ", ") + in_words(key);
    return keys.empty() ? "it is empty." : "its keys are " + keys + (count > most ? " and more." : ".");
}

FlatPlace PatternReader::pair_in(const ProjectJson& value, const std::string& path, double most) const
{
    if (!value.is_array() || value.size() != 2)
        refuse(path, fmt::format("This must be a list of 2 numbers; given is {}.", in_words(value)));
    FlatPlace place{};
    for (std::size_t i = 0; i < 2; ++i) {
        place[i] = number_in(value[i], name_, fmt::format("{}[{}]", path, i));
        if (!(std::abs(place[i]) <= most))
            refuse(fmt::format("{}[{}]", path, i), fmt::format("This must be from {:g} to {:g}; given is {:g}.", -most, most, place[i]));
    }
    return place;
}

void PatternReader::read_properties(const ProjectJson& json)
{
    double units = 100;
    if (const auto at = json.find("units_in_meter"); at != json.end())
        units = number_in(*at, name_, "properties.units_in_meter");
    else
        note("The file does not say how many of its units are a metre (units_in_meter); centimetres were taken.");
    if (!(units >= 1 && units <= 1e5))
        refuse("properties.units_in_meter", fmt::format("This must be from 1 to 100000; given is {:g}.", units));
    metre_ = 1 / units;
    if (const auto at = json.find("curvature_coords"); at != json.end()) {
        const std::string coords = text_in(*at, name_, "properties.curvature_coords");
        if (coords != "relative" && coords != "absolute")
            refuse("properties.curvature_coords", fmt::format("This must be \"relative\" or \"absolute\"; given is {}.", in_words(*at)));
        absolute_controls_ = coords == "absolute";
    }
    if (const auto at = json.find("normalize_panel_translation"); at != json.end() && at->is_boolean() && at->get<bool>())
        note("The file asks to move each panel's middle to its origin (normalize_panel_translation); the panels were placed as they are.");
    note_unknown(json,
                 {"curvature_coords", "normalize_panel_translation", "normalized_edge_loops", "units_in_meter", "original_units_in_meter"},
                 "properties");
}

void PatternReader::read_placement(const ProjectJson& json, const std::string& path, PatternPanel& panel)
{
    const auto three = [&](const char* key, double unit, double most) {
        std::array<double, 3> values{};
        const auto at = json.find(key);
        if (at == json.end()) return values;
        const std::string where = path + "." + key;
        if (!at->is_array() || at->size() != 3) refuse(where, fmt::format("This must be a list of 3 numbers; given is {}.", in_words(*at)));
        for (std::size_t i = 0; i < 3; ++i) {
            values[i] = unit * number_in((*at)[i], name_, fmt::format("{}[{}]", where, i));
            if (!(std::abs(values[i]) <= most))
                refuse(fmt::format("{}[{}]", where, i),
                       fmt::format("This must be from {:g} to {:g}; given is {:g}.", -most / unit, most / unit, values[i] / unit));
        }
        return values;
    };
    const std::array<double, 3> at = three("translation", metre_, farthest_placed_m), turn = three("rotation", 1, 36000);
    if (json.contains("translation")) pattern_.is_placed = true;
    const double cx = std::cos(radian_from_degree(turn[0])), sx = std::sin(radian_from_degree(turn[0]));
    const double cy = std::cos(radian_from_degree(turn[1])), sy = std::sin(radian_from_degree(turn[1]));
    const double cz = std::cos(radian_from_degree(turn[2])), sz = std::sin(radian_from_degree(turn[2]));
    panel.placed = {Vec3d{at[0], at[1], at[2]}, Vec3d{cz * cy, sz * cy, -sy},
                    Vec3d{cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx}};
}

void PatternReader::read_curvature(const ProjectJson& json, const std::string& path, const std::vector<FlatPlace>& corners,
                                   RawEdge& edge) const
{
    const auto control = [&](const ProjectJson& value, const std::string& at) {
        if (!absolute_controls_) return pair_in(value, at, farthest_control);
        const FlatPlace &a = corners[edge.from], &b = corners[edge.to];
        FlatPlace place = pair_in(value, at, largest_panel_m / metre_);
        const double ux = b[0] - a[0], uy = b[1] - a[1], square = ux * ux + uy * uy;
        const double px = metre_ * place[0] - a[0], py = metre_ * place[1] - a[1];
        if (square == 0) return FlatPlace{};
        return FlatPlace{(px * ux + py * uy) / square, (py * ux - px * uy) / square};
    };
    if (json.is_array()) { // the older dialect
        edge.controls.push_back(control(json, path));
        return;
    }
    const auto type_at = json.is_object() ? json.find("type") : json.end();
    const auto params = json.is_object() ? json.find("params") : json.end();
    if (!json.is_object() || type_at == json.end() || params == json.end() || !params->is_array())
        refuse(path, fmt::format("This must be [x, y] or an object with \"type\" and the list \"params\"; given is {}.", in_words(json)));
    const std::string type = text_in(*type_at, name_, path + ".type");
    const std::size_t wanted = type == "quadratic" ? 1 : type == "cubic" ? 2 : type == "circle" ? 3 : 0;
    if (wanted == 0)
        refuse(path + ".type", fmt::format("This must be \"quadratic\", \"cubic\" or \"circle\"; given is {}.", in_words(*type_at)));
    if (params->size() != wanted)
        refuse(path + ".params", fmt::format("A {} edge has {} of them; given are {}.", type, wanted, params->size()));
    for (std::size_t i = 0; i < wanted; ++i) {
        const std::string at = fmt::format("{}.params[{}]", path, i);
        if (type != "circle") {
            edge.controls.push_back(control((*params)[i], at));
            continue;
        }
        if (i == 0) edge.circle.emplace();
        const ProjectJson& value = (*params)[i];
        (*edge.circle)[i] = value.is_boolean() ? (value.get<bool>() ? 1 : 0) : number_in(value, name_, at);
    }
    if (!edge.circle) return;
    double& radius = (*edge.circle)[0];
    radius *= metre_;
    if (!(radius > 0 && radius <= 1000))
        refuse(path + ".params[0]", fmt::format("The radius must be more than 0 and up to 1000 m; given is {:g} m.", radius));
}

RawEdge PatternReader::read_edge(const ProjectJson& json, const std::string& path, const std::vector<FlatPlace>& corners) const
{
    if (!json.is_object()) refuse(path, fmt::format("This must be an object in {{ }}; given is {}.", in_words(json)));
    const auto ends = json.find("endpoints");
    if (ends == json.end() || !ends->is_array() || ends->size() != 2)
        refuse(path + ".endpoints", "This must be a list of 2 numbers of vertices.");
    RawEdge edge;
    for (std::size_t i = 0; i < 2; ++i) {
        const double number = number_in((*ends)[i], name_, fmt::format("{}.endpoints[{}]", path, i));
        if (!(number >= 0 && number < static_cast<double>(corners.size()) && number == std::floor(number)))
            refuse(fmt::format("{}.endpoints[{}]", path, i),
                   fmt::format("This must be a whole number from 0 to {}; given is {:g}.", corners.size() - 1, number));
        (i == 0 ? edge.from : edge.to) = static_cast<int>(number);
    }
    if (const auto curvature = json.find("curvature"); curvature != json.end() && !curvature->is_null())
        read_curvature(*curvature, path + ".curvature", corners, edge);
    return edge;
}

PanelEdge PatternReader::drawn(const RawEdge& edge, const std::vector<FlatPlace>& corners) const
{
    const FlatPlace &a = corners[edge.from], &b = corners[edge.to];
    if (edge.circle) return {flattened_arc(a, b, (*edge.circle)[0], (*edge.circle)[1] != 0, (*edge.circle)[2] != 0)};
    if (edge.controls.empty()) return {{a, b}};
    std::vector<FlatPlace> controls;
    for (const FlatPlace& c : edge.controls)
        controls.push_back({a[0] + c[0] * (b[0] - a[0]) - c[1] * (b[1] - a[1]), a[1] + c[0] * (b[1] - a[1]) + c[1] * (b[0] - a[0])});
    return {flattened_bezier(a, controls, b)};
}

/// Puts the edges after each other. numbers: where each of the file's edges ends up.
void PatternReader::close(PatternPanel& panel, std::vector<RawEdge>& edges, const std::vector<FlatPlace>& corners,
                          std::vector<int>& numbers)
{
    const auto same = [&corners](int a, int b) { return a == b || corners[a] == corners[b]; };
    const auto turned = [](RawEdge edge) {
        std::swap(edge.from, edge.to);
        for (FlatPlace& c : edge.controls) c = {1 - c[0], -c[1]};
        std::reverse(edge.controls.begin(), edge.controls.end());
        if (edge.circle) (*edge.circle)[2] = (*edge.circle)[2] != 0 ? 0 : 1;
        return edge;
    };
    numbers.assign(edges.size(), -1);
    std::optional<int> first, last;
    const auto join = [&](int from, int to) {
        const FlatPlace &a = corners[from], &b = corners[to];
        note(fmt::format("The outline of the panel \"{}\" is open by {:.3g} mm; a straight edge closes it.", panel.name,
                         mm_from_metre(std::hypot(b[0] - a[0], b[1] - a[1]))));
        panel.edges.push_back({{a, b}});
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (same(edges[i].from, edges[i].to)) {
            note(fmt::format("The edge {} of the panel \"{}\" has no length and was left out.", i, panel.name));
            continue;
        }
        const bool against_next = !last && i + 1 < edges.size() && !same(edges[i].to, edges[i + 1].from) &&
                                  !same(edges[i].to, edges[i + 1].to) &&
                                  (same(edges[i].from, edges[i + 1].from) || same(edges[i].from, edges[i + 1].to));
        if (against_next || (last && !same(edges[i].from, *last) && same(edges[i].to, *last))) {
            edges[i] = turned(edges[i]);
            note(fmt::format("The edge {} of the panel \"{}\" runs against the others and was turned.", i, panel.name));
        }
        if (last && !same(edges[i].from, *last)) join(*last, edges[i].from);
        if (!first) first = edges[i].from;
        last = edges[i].to;
        numbers[i] = static_cast<int>(panel.edges.size());
        panel.edges.push_back(drawn(edges[i], corners));
        places_ += panel.edges.back().places.size();
        if (places_ > most_places_of_all) refuse("pattern.panels." + panel.name, "The pattern's curves are too many to be drawn.");
    }
    if (first && !same(*last, *first)) join(*last, *first);
}

void PatternReader::check(const PatternPanel& panel)
{
    if (crosses_itself(outline_of(panel), comparisons_))
        note(fmt::format("The outline of the panel \"{}\" crosses itself; its area is not that of a piece of cloth.", panel.name));
}

void PatternReader::read_panel(const std::string& name, const ProjectJson& json)
{
    const std::string path = "pattern.panels." + name;
    if (!json.is_object()) refuse(path, fmt::format("This must be an object in {{ }}; given is {}.", in_words(json)));
    note_unknown(json, {"translation", "rotation", "vertices", "edges", "label"}, "a panel");
    PatternPanel panel;
    panel.name = name;
    read_placement(json, path, panel);
    for (const char* key : {"vertices", "edges"})
        if (!json.contains(key)) refuse(path, fmt::format("The key \"{}\" is missing.", key));
    const ProjectJson &vertices = array_in(json.at("vertices"), name_, path + ".vertices"),
                      &list = array_in(json.at("edges"), name_, path + ".edges");
    if (vertices.size() > most_corners || list.size() > most_corners)
        refuse(path,
               fmt::format("A panel has up to {} vertices and edges; given are {} and {}.", most_corners, vertices.size(), list.size()));
    std::vector<FlatPlace> corners;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        FlatPlace corner = pair_in(vertices[i], fmt::format("{}.vertices[{}]", path, i), largest_panel_m / metre_);
        for (double& number : corner) number *= metre_;
        corners.push_back(corner);
    }
    std::vector<RawEdge> edges;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string at = fmt::format("{}.edges[{}]", path, i);
        edges.push_back(read_edge(list[i], at, corners));
        note_unknown(list[i], {"endpoints", "curvature", "label"}, "an edge");
    }
    std::vector<int> numbers;
    close(panel, edges, corners, numbers);
    const double area = panel.edges.size() < 2 ? 0 : signed_area(outline_of(panel));
    if (!(std::abs(area) > 1e-8)) { // a square of 0.1 mm
        note(fmt::format("The panel \"{}\" has no area and was left out.", name));
        return;
    }
    if (area < 0) { // it is seen from inside
        for (PanelEdge& edge : panel.edges)
            for (FlatPlace& place : edge.places) place[0] = -place[0];
        panel.placed[1] = -panel.placed[1];
    }
    check(panel);
    pattern_.panels.push_back(std::move(panel));
    edge_numbers_.push_back(std::move(numbers));
}

GarmentPattern PatternReader::read()
{
    if (!json_.is_object())
        throw FileError(name_ + ": This is no sewing pattern: it holds " + in_words(json_) + " in place of an object in { }.");
    if (!json_.contains("pattern")) throw FileError(name_ + ": This is no sewing pattern: it has no \"pattern\"; " + what_it_has(json_));
    note_unknown(json_, {"pattern", "properties", "parameters", "parameter_order", "constraints", "constraint_order"}, "the file");
    const ProjectJson& pattern = object_in(json_, "pattern", "the file");
    note_unknown(pattern, {"panels", "stitches", "panel_order"}, "pattern");
    const ProjectJson& panels = object_in(pattern, "panels", "pattern");
    static const ProjectJson nothing = ProjectJson::object();
    read_properties(json_.contains("properties") ? object_in(json_, "properties", "the file") : nothing);
    pattern_.is_placed = false;
    pattern_.uv_scale = metre_;
    if (panels.size() > most_panels)
        refuse("pattern.panels", fmt::format("A pattern has up to {} panels; given are {}.", most_panels, panels.size()));
    for (const auto& [name, panel] : panels.items()) read_panel(name, panel);
    if (pattern_.panels.empty()) refuse("pattern.panels", "The pattern has no panel with an area.");
    if (const auto stitches = pattern.find("stitches"); stitches != pattern.end())
        read_stitches(array_in(*stitches, name_, "pattern.stitches"), name_, edge_numbers_, pattern_);
    else
        note("The file has no stitches; nothing is sewn.");
    return std::move(pattern_);
}

} // namespace

GarmentPattern pattern_from_json(std::string_view text, const std::string& name)
{
    const ProjectJson json = parse_json(text, name);
    return PatternReader(json, name).read();
}

} // namespace hygroloom
