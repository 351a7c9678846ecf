// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/project_file.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"
#include "core/project/project_json.h"

#include <fstream>

namespace hygroloom {

namespace {

/// Whether a file is a database, as recordings are; they may be larger than a project.
bool is_recording(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    constexpr std::string_view signature = "SQLite format 3";
    char begin[signature.size()] = {};
    std::ifstream(path, std::ios::binary).read(begin, sizeof begin);
    return std::string_view(begin, sizeof begin) == signature;
}

} // namespace

Design read_project(const std::filesystem::path& path)
{
    if (is_recording(path))
        throw FileError(path.string() + ": This is a recording, not a project. The verb measure reads it, and the window shows it.");
    return parse_project(read_file(path, largest_project_bytes), path.string());
}

Design parse_project(std::string_view text, const std::string& name)
{
    if (text.size() > largest_project_bytes) throw FileError(name + ": The project is larger than 64 MiB.");
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) throw FileError(name + ": The file is empty.");
    return design_from_json(parse_json(text, name), name);
}

std::string format_project(const Design& design) { return text_from_json(json_from_design(design)); }

void write_project(const Design& design, const std::filesystem::path& path)
{
    std::string text;
    try {
        text = format_project(design);
    } catch (const Error& error) {
        throw FileError(path.string() + ": " + error.what());
    }
    write_file(path, text, Previous::keep_as_backup);
}

} // namespace hygroloom
