// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A file of points, lines or polygons with arrays of values, as VTK's programs read it (XML, .vtp).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hygroloom {

/// A PolyData file whose arrays lie behind its text, each after its size in bytes.
class PolyData {
public:
    struct Counts {
        std::size_t points = 0, verts = 0, lines = 0, polys = 0;
    };
    void begin(const char* group) { text_ += std::string("<") + group + ">\n"; }
    void end(const char* group) { text_ += std::string("</") + group + ">\n"; }
    /// The values must stay as long as the file is not written.
    void add(const char* name, const std::vector<float>& values, int components = 1);
    void add(const char* name, const std::vector<double>& values, int components = 1);
    void add(const char* name, const std::vector<std::int32_t>& values);
    void add(const char* name, const std::vector<std::uint8_t>& values);
    /// Words of the whole file, by which numbers in its arrays may go.
    void add_words(const char* name, const std::vector<std::string>& words);
    /// time: s. Throws FileError.
    void write(const std::filesystem::path& path, double time, const Counts& counts) const;

private:
    struct Bytes {
        const char* first;
        std::size_t bytes;
    };
    void add_bytes(const char* type, const char* name, int components, Bytes bytes);

    std::string text_, words_;
    std::vector<Bytes> arrays_;
    std::size_t offset_ = 0;
};

} // namespace hygroloom
