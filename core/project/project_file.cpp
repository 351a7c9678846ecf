// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/project_file.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"
#include "core/project/project_json.h"

namespace hygroloom {

Design read_project(const std::filesystem::path& path) { return parse_project(read_file(path, largest_project_bytes), path.string()); }

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
