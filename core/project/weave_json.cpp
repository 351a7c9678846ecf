// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reads a weave: a pattern's name, rows of 0 and 1, or a draft.
#include "core/design/drawdown.h"
#include "core/project/json_reader.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

Weave read_rows(const ObjectReader& object, const ProjectJson& rows)
{
    array_in(rows, object.file(), object.path_of("rows"));
    if (rows.empty() || rows.size() > largest_repeat)
        object.refuse("rows", fmt::format("A weave has from 1 to {} rows; given are {}.", largest_repeat, rows.size()));
    const std::size_t picks = rows.size();
    const std::size_t ends = text_in(rows[0], object.file(), object.path_of("rows[0]")).size();
    if (ends < 1 || ends > largest_repeat)
        object.refuse("rows[0]", fmt::format("A row has from 1 to {} crossings; given are {}.", largest_repeat, ends));
    std::vector<std::uint8_t> up(ends * picks);
    for (std::size_t row = 0; row < picks; ++row) {
        const std::string key = fmt::format("rows[{}]", row);
        const std::string text = text_in(rows[row], object.file(), object.path_of(key));
        if (text.size() != ends)
            object.refuse(key, fmt::format("All rows need {} crossings as the first; this one has {}.", ends, text.size()));
        for (std::size_t end = 0; end < ends; ++end) {
            if (text[end] != '0' && text[end] != '1')
                object.refuse(key, fmt::format("A row is made of 0 and 1 (warp up); given is {}.", in_words(rows[row])));
            up[(picks - 1 - row) * ends + end] = text[end] == '1'; // the top row is the last pick
        }
    }
    return {static_cast<int>(ends), static_cast<int>(picks), std::move(up)};
}

} // namespace

Weave weave_from_json(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    const ProjectJson* pattern = object.find("pattern");
    const ProjectJson* rows = object.find("rows");
    const ProjectJson* draft = object.find("draft");
    object.finish();
    if ((pattern != nullptr) + (rows != nullptr) + (draft != nullptr) != 1)
        throw FileError(fmt::format("{}: {}: A weave is given by one of \"pattern\", \"rows\" and \"draft\".", file, path));
    if (rows) return read_rows(object, *rows);
    if (draft) return weave_from_draft(draft_from_json(*draft, file, object.path_of("draft")));
    try {
        return weave_from_pattern(text_in(*pattern, file, object.path_of("pattern")));
    } catch (const FileError&) {
        throw;
    } catch (const Error& error) {
        object.refuse("pattern", error.what());
    }
}

} // namespace hygroloom
