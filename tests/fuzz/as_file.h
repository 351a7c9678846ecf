// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Bytes as a file for readers that open it by its name.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace hygroloom {

/// The same file each time.
inline std::string as_file(const std::uint8_t* data, std::size_t size, const char* name)
{
    const std::filesystem::path memory = "/dev/shm";
    static const std::filesystem::path folder = std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
    std::string path = (folder / ("hygroloom-" + std::to_string(::getpid()) + "-" + name)).string();
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (!file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size))) std::abort();
    return path;
}

} // namespace hygroloom
