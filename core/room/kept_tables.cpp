// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/kept_tables.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/project/cache_folder.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <mutex>

namespace hygroloom {

extern const char room_code[]; // digest of the sources that find tables

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_in_memory = 64, // of some ten thousand bytes each
    most_files = 2000, most_bytes = std::size_t{4} << 20U;

struct Kept {
    std::mutex mutex;
    std::map<std::string, std::shared_ptr<const RoomTables>, std::less<>> tables;
    std::filesystem::path folder;
};
Kept& kept()
{
    static Kept all;
    return all;
}
std::filesystem::path folder()
{
    const std::lock_guard lock(kept().mutex);
    return kept().folder;
}

/// All that the tables follow from.
std::string content_of(const Textile& textile, int voxels)
{
    std::string content;
    const auto add = [&content](const auto* values, std::size_t count) {
        content.append(reinterpret_cast<const char*>(values), count * sizeof(*values));
    };
    const auto add_all = [&](const auto& values) {
        const std::size_t count = values.size();
        add(&count, 1);
        add(values.data(), count);
    };
    const int whole[] = {voxels, textile.weave.ends(), textile.weave.picks()};
    add(whole, 3);
    add(&textile.thickness, 1);
    add_all(textile.weave.crossings());
    for (const YarnSystem* system : {&textile.warp, &textile.weft}) {
        add(&system->pitch, 1);
        add_all(system->order);
        for (const YarnType& type : system->types) {
            const double section[] = {type.section.width, type.section.height, type.area};
            add(section, 3);
            add_all(type.rise);
            add_all(type.length_per_pitch);
        }
        for (const YarnPath& path : system->paths)
            for (const std::vector<double>* along : {&path.height, &path.slope, &path.half_height, &path.half_width}) add_all(*along);
    }
    return content;
}

constexpr std::uint64_t first_digest = 0xcbf29ce484222325U;
/// FNV-1a.
std::uint64_t digest(std::string_view bytes, std::uint64_t start)
{
    for (const char byte : bytes) start = (start ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    return start;
}

/// Named by content and code; two digests, that no two contents share a file.
std::filesystem::path file_of(const std::filesystem::path& folder, std::string_view content)
{
    const std::uint64_t code = digest(__VERSION__, digest(room_code, first_digest));
    return folder / fmt::format("{:016x}{:016x}.room", digest(content, code), digest(content, ~code));
}

constexpr RestingState RoomStates::*states_of_file[] = {&RoomStates::almost, &RoomStates::sunk,  &RoomStates::knee,
                                                        &RoomStates::low,    &RoomStates::fills, &RoomStates::breaks};
constexpr double DrawnRoom::*numbers_of_room[] = {&DrawnRoom::warp_skin, &DrawnRoom::weft_skin, &DrawnRoom::faces, &DrawnRoom::along_warp,
                                                  &DrawnRoom::along_weft};
constexpr double RoomTables::*numbers_of_tables[] = {&RoomTables::falls_along_warp, &RoomTables::falls_along_weft,
                                                     &RoomTables::level_along_warp, &RoomTables::level_along_weft, &RoomTables::growth};

/// With the digest of what follows, so that a damaged file is known.
std::string text_of(const RoomTables& tables)
{
    Json types = Json::array(), numbers = Json::array();
    for (const DrawnRoom& room : tables.types) {
        Json row = Json::array();
        for (const auto number : numbers_of_room) row.push_back(room.*number);
        for (const auto state : states_of_file) {
            const RestingState& at = room.states.*state;
            for (const double value : {at.curvature, at.warp, at.weft}) row.push_back(value);
        }
        types.push_back(row);
    }
    for (const auto number : numbers_of_tables) numbers.push_back(tables.*number);
    const Json json{{"types", types},
                    {"numbers", numbers},
                    {"ends", tables.ends},
                    {"picks", tables.picks},
                    {"warp_places", tables.warp_places},
                    {"weft_places", tables.weft_places}};
    const std::string text = json.dump();
    return fmt::format("{:016x}{}", digest(text, first_digest), text);
}

/// Whether runs may read them: files are anybody's.
bool are_usable(const RoomTables& tables, const Textile& textile)
{
    constexpr double most = 1e12; // of any number, in SI units
    const auto bounded = [](double least) {
        return [least](auto value) { return static_cast<double>(value) >= least && static_cast<double>(value) <= most; };
    };
    const auto all = [](const auto& values, const auto& holds) { return std::all_of(values.begin(), values.end(), holds); };
    const std::size_t pairs = textile.warp.types.size() * textile.weft.types.size();
    if (!tables.types.empty() && tables.types.size() != pairs) return false;
    for (const DrawnRoom& room : tables.types) {
        for (const auto number : numbers_of_room)
            if (!bounded(0)(room.*number)) return false;
        for (const auto state : states_of_file)
            for (const auto value : {&RestingState::curvature, &RestingState::warp, &RestingState::weft})
                if (!bounded(-most)(room.states.*state.*value)) return false;
    }
    for (const auto number : numbers_of_tables)
        if (!bounded(number == &RoomTables::growth ? -most : 0)(tables.*number)) return false;
    const bool falls = bounded(0)(4 - tables.falls_along_warp) && bounded(0)(4 - tables.falls_along_weft);
    const std::size_t places = static_cast<std::size_t>(std::max(0, tables.ends)) * static_cast<std::size_t>(std::max(0, tables.picks));
    return falls && tables.ends >= 0 && tables.picks >= 0 && tables.warp_places.size() == places && tables.weft_places.size() == places &&
           all(tables.warp_places, bounded(0)) && all(tables.weft_places, bounded(0));
}

/// Throws where it is no such file.
RoomTables tables_of(std::string_view file, const Textile& textile)
{
    constexpr std::size_t digits = 16;
    const std::string_view text = file.size() > digits ? file.substr(digits) : std::string_view();
    if (file.substr(0, digits) != fmt::format("{:016x}", digest(text, first_digest))) throw FileError("damaged");
    const Json json = Json::parse(text);
    RoomTables tables;
    for (const Json& row : json.at("types")) {
        DrawnRoom room;
        std::size_t at = 0;
        for (const auto number : numbers_of_room) room.*number = row.at(at++).get<double>();
        for (const auto state : states_of_file)
            for (const auto value : {&RestingState::curvature, &RestingState::warp, &RestingState::weft})
                room.states.*state.*value = row.at(at++).get<double>();
        tables.types.push_back(room);
    }
    std::size_t at = 0;
    for (const auto number : numbers_of_tables) tables.*number = json.at("numbers").at(at++).get<double>();
    const auto count = [&](const char* key) {
        const Json& value = json.at(key);
        if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most_bytes) throw FileError("no count");
        return value.get<int>();
    };
    tables.ends = count("ends");
    tables.picks = count("picks");
    for (const auto& [key, places] : {std::pair("warp_places", &tables.warp_places), std::pair("weft_places", &tables.weft_places)})
        for (const Json& place : json.at(key)) places->push_back(static_cast<float>(std::clamp(place.get<double>(), -1e30, 1e30)));
    if (!are_usable(tables, textile)) throw FileError("no tables of this cloth");
    return tables;
}

std::shared_ptr<const RoomTables> on_disk(std::string_view content, const Textile& textile)
try {
    const std::filesystem::path in = folder();
    if (in.empty()) return nullptr;
    return std::make_shared<RoomTables>(tables_of(read_file(file_of(in, content), most_bytes), textile));
} catch (const std::exception&) {
    return nullptr; // missing or damaged: to be found again
}

std::shared_ptr<const RoomTables> in_memory(std::string_view content)
{
    const std::lock_guard lock(kept().mutex);
    const auto found = kept().tables.find(content);
    return found == kept().tables.end() ? nullptr : found->second;
}
void remember(std::string_view content, std::shared_ptr<const RoomTables> tables)
{
    const std::lock_guard lock(kept().mutex);
    if (kept().tables.size() >= most_in_memory) kept().tables.clear();
    kept().tables.emplace(content, std::move(tables));
}

void remove_oldest(const std::filesystem::path& in)
{
    std::vector<std::pair<std::filesystem::file_time_type, std::filesystem::path>> files;
    for (const auto& entry : std::filesystem::directory_iterator(in))
        if (entry.path().extension() == ".room") files.emplace_back(entry.last_write_time(), entry.path());
    if (files.size() <= most_files) return;
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i < files.size() / 2; ++i) std::filesystem::remove(files[i].second);
}

void write(std::string_view content, const RoomTables& tables, const Textile& textile)
try {
    const std::filesystem::path in = folder();
    if (in.empty() || !are_usable(tables, textile)) return;
    std::filesystem::create_directories(in);
    write_file(file_of(in, content), text_of(tables));
    remove_oldest(in);
} catch (const std::exception&) {
    // The next program finds them again.
}

} // namespace

std::filesystem::path usual_kept_tables()
{
    const std::filesystem::path cache = cache_folder();
    return cache.empty() ? cache : cache / "rooms";
}

void keep_tables_in(const std::filesystem::path& folder)
{
    const std::lock_guard lock(kept().mutex);
    kept().folder = folder;
    kept().tables.clear();
}

std::shared_ptr<const RoomTables> room_tables(const Textile& textile, int voxels)
{
    const std::string content = content_of(textile, voxels);
    if (auto before = in_memory(content)) return before;
    auto tables = on_disk(content, textile);
    if (!tables) {
        tables = std::make_shared<RoomTables>(find_room_tables(textile, voxels));
        write(content, *tables, textile);
    }
    remember(content, tables);
    return tables;
}

bool room_tables_are_kept(const Textile& textile, int voxels)
{
    const std::filesystem::path in = folder();
    std::error_code missing;
    return !in.empty() && std::filesystem::exists(file_of(in, content_of(textile, voxels)), missing);
}

} // namespace hygroloom
