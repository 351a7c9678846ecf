// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A weave's draft in a project's JSON.
#include "core/project/json_reader.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

namespace hygroloom {

namespace {

using Lists = std::vector<std::vector<int>>;

int index_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    const double number = number_in(value, file, path);
    if (!(number >= 1 && number <= 1e9 && number == static_cast<int>(number)))
        throw FileError(fmt::format("{}: {}: This must be a whole number of 1 or more; given is {}.", file, path, in_words(value)));
    return static_cast<int>(number) - 1;
}

/// One number, or a list of them; 0 and [] stand for none.
Lists read_lists(ObjectReader& object, const char* key)
{
    Lists lists;
    const ProjectJson& json = array_in(object.require(key), object.file(), object.path_of(key));
    if (json.size() > static_cast<std::size_t>(std::max(largest_repeat, most_shafts)))
        object.refuse(key, fmt::format("The list may have up to {} entries; given are {}.", largest_repeat, json.size()));
    for (std::size_t i = 0; i < json.size(); ++i) {
        const std::string path = fmt::format("{}[{}]", object.path_of(key), i);
        std::vector<int>& list = lists.emplace_back();
        if (json[i].is_array()) {
            for (std::size_t j = 0; j < json[i].size(); ++j)
                list.push_back(index_in(json[i][j], object.file(), fmt::format("{}[{}]", path, j)));
        } else if (json[i] != 0) {
            list.push_back(index_in(json[i], object.file(), path));
        }
    }
    return lists;
}

/// Threads are one number as a rule; tie-up and liftplan are lists.
ProjectJson write_lists(const Lists& lists, bool one_as_number)
{
    ProjectJson json = ProjectJson::array();
    for (const std::vector<int>& list : lists) {
        if (one_as_number && list.size() <= 1) {
            json.push_back(list.empty() ? 0 : list.front() + 1);
            continue;
        }
        ProjectJson& entry = json.emplace_back(ProjectJson::array());
        for (int index : list) entry.push_back(index + 1);
    }
    return json;
}

} // namespace

Draft draft_from_json(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    Draft draft;
    object.require("shafts");
    object.read("shafts", draft.shafts);
    draft.threading = read_lists(object, "threading");
    if (object.find("liftplan")) {
        draft.liftplan = read_lists(object, "liftplan");
        if (draft.liftplan.empty()) object.refuse("liftplan", "The liftplan needs a list of shafts for each pick; it is empty.");
    } else {
        object.require("treadles");
        object.read("treadles", draft.treadles);
        draft.tie_up = read_lists(object, "tie_up");
        draft.treadling = read_lists(object, "treadling");
    }
    if (const ProjectJson* rising = object.find("rising_shed")) {
        if (!rising->is_boolean()) object.refuse("rising_shed", fmt::format("This must be true or false; given is {}.", in_words(*rising)));
        draft.rising_shed = rising->get<bool>();
    }
    if (const ProjectJson* lines = object.find("private_lines")) {
        array_in(*lines, file, object.path_of("private_lines"));
        for (std::size_t i = 0; i < lines->size(); ++i)
            draft.private_lines.push_back(text_in((*lines)[i], file, fmt::format("{}[{}]", object.path_of("private_lines"), i)));
    }
    object.finish();
    const std::string fault = fault_in(draft);
    if (!fault.empty()) throw FileError(fmt::format("{}: {}.{}", file, path, fault));
    return draft;
}

ProjectJson json_from_draft(const Draft& draft)
{
    ProjectJson json{{"shafts", draft.shafts}};
    if (draft.liftplan.empty()) json["treadles"] = draft.treadles;
    json["threading"] = write_lists(draft.threading, true);
    if (draft.liftplan.empty()) {
        json["tie_up"] = write_lists(draft.tie_up, false);
        json["treadling"] = write_lists(draft.treadling, true);
    } else {
        json["liftplan"] = write_lists(draft.liftplan, false);
    }
    json["rising_shed"] = draft.rising_shed;
    if (!draft.private_lines.empty()) json["private_lines"] = draft.private_lines;
    return json;
}

} // namespace hygroloom
