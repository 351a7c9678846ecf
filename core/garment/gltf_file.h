// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A glTF 2.0 file (.gltf, .glb) as its objects and numbers. Trusts nothing in it: each offset and count is checked, and buffers are opened
// in the file's own folder only. All throw FileError.
#pragma once

#include "core/project/migrations.h" // ProjectJson

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hygroloom {

/// An accessor's numbers, one element after the other; integers that are normalized are shares of 1.
struct GltfNumbers {
    std::size_t count = 0, components = 0;
    std::vector<double> values;
    const double* at(std::size_t element) const { return values.data() + components * element; }
};

class GltfFile {
public:
    explicit GltfFile(const std::filesystem::path& path);

    const std::string& name() const { return name_; }
    const ProjectJson& root() const { return json_; }
    /// The elements of a list of the file, such as "nodes"; 0 where it is absent.
    std::size_t count(const char* list) const;
    const ProjectJson& item(const char* list, std::size_t number) const;
    /// Of an object of the file: a number from 0, and a list of them; none where the key is absent.
    std::optional<std::size_t> index(const ProjectJson& object, const char* key) const;
    std::vector<std::size_t> indices(const ProjectJson& object, const char* key) const;
    /// A list of so many numbers; empty where the key is absent.
    std::vector<double> numbers(const ProjectJson& object, const char* key, std::size_t count) const;
    std::string text(const ProjectJson& object, const char* key) const;
    /// type: "SCALAR", "VEC2", "VEC3", "VEC4" or "MAT4". most: elements.
    GltfNumbers accessor(std::size_t number, const std::string& type, std::size_t most) const;
    [[noreturn]] void refuse(const std::string& sentence) const;

private:
    void split_glb(std::string_view bytes);
    void read_buffers(const std::filesystem::path& folder);
    std::string buffer_of(const ProjectJson& buffer, const std::filesystem::path& folder) const;
    /// Elements of a size from a place of a view on; far: bytes from one to the next, 0: the view says, or they lie close.
    struct Bytes {
        const unsigned char* first = nullptr;
        std::size_t far = 0;
    };
    Bytes bytes(std::size_t view, std::size_t offset, std::size_t count, std::size_t size) const;
    std::size_t whole(const ProjectJson& object, const char* key) const { return index(object, key).value_or(0); }

    std::string name_, bin_;
    bool has_bin_ = false;
    ProjectJson json_;
    std::vector<std::string> buffers_;
};

} // namespace hygroloom
