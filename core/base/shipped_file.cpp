// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/shipped_file.h"

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

namespace hygroloom {
namespace {

/// The program, or the library that holds this code, as the kernel knows it: a name that was given at the start may mean another file.
std::filesystem::path own_file()
{
    static const char place = 0;
    const auto own = reinterpret_cast<std::uintptr_t>(&place);
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        std::uintptr_t first = 0, end = 0;
        if (std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR, &first, &end) != 2 || own < first || own >= end) continue;
        const std::size_t path = line.find('/');
        return path == std::string::npos ? std::filesystem::path() : std::filesystem::path(line.substr(path));
    }
    return {};
}

} // namespace

std::filesystem::path shipped_file(const std::string& name)
{
    const std::filesystem::path folder = own_file().parent_path();
    if (folder.empty()) return {};
    // From bin; from bin/tests and the build's python/hygroloom; from lib/python3/dist-packages/hygroloom.
    for (const char* way : {"../lib/hygroloom", "../../lib/hygroloom", "../../../hygroloom"}) {
        const std::filesystem::path file = (folder / way / name).lexically_normal();
        std::error_code none;
        if (std::filesystem::is_regular_file(file, none)) return file;
    }
    return {};
}

} // namespace hygroloom
