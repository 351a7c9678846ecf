// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a solver has come to, as bytes that one on another machine of the same kind of processor goes on from.
#pragma once

#include "core/base/error.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace hygroloom {

/// Counts their bytes.
class StateSize {
public:
    static constexpr bool reads = false, stays = false;

    template <typename T> void value(const T&) { bytes_ += sizeof(T); }
    template <typename T> void values(const std::vector<T>& values, const char*)
    {
        bytes_ += sizeof(std::size_t) + values.size() * sizeof(T);
    }
    template <typename Buffer> void buffer(Buffer& buffer, const char*)
    {
        bytes_ += sizeof(std::size_t) + buffer.size() * sizeof(*buffer.data());
    }
    template <typename Buffer> void first(Buffer& buffer, std::size_t count, const char*)
    {
        bytes_ += sizeof(std::size_t) + std::min(count, buffer.size()) * sizeof(*buffer.data());
    }
    std::size_t bytes() const { return bytes_; }

private:
    std::size_t bytes_ = 0;
};

/// Appends numbers and arrays.
class StateWriter {
public:
    static constexpr bool reads = false, stays = false;

    explicit StateWriter(std::size_t bytes) { bytes_.reserve(bytes); }
    template <typename T> void value(const T& value) { append(&value, sizeof value); }
    template <typename T> void values(const std::vector<T>& values, const char*)
    {
        value(values.size());
        append(values.data(), values.size() * sizeof(T));
    }
    template <typename Buffer> void buffer(const Buffer& buffer, const char* name) { values(buffer.download(), name); }
    template <typename Buffer> void first(const Buffer& buffer, std::size_t count, const char* name)
    {
        auto some = buffer.download();
        some.resize(std::min(count, some.size()));
        values(some, name);
    }
    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    void append(const void* from, std::size_t bytes)
    {
        const auto* first = static_cast<const std::byte*>(from);
        bytes_.insert(bytes_.end(), first, first + bytes);
    }
    std::vector<std::byte> bytes_;
};

/// Reads them again, in the same order. Throws Error when they are of another scene.
class StateReader {
public:
    static constexpr bool reads = true, stays = false;

    explicit StateReader(const std::vector<std::byte>& bytes) : bytes_(bytes) {}
    template <typename T> void value(T& value) { take(&value, sizeof value); }
    /// The name is for the sentence of the error.
    template <typename T> void values(std::vector<T>& values, const char* name)
    {
        std::size_t count = 0;
        value(count);
        if (count != values.size())
            throw Error("The state of a run is of another scene: it has " + std::to_string(count) + " values of \"" + name +
                        "\", the scene " + std::to_string(values.size()) + ".");
        take(values.data(), count * sizeof(T));
    }
    template <typename Buffer> void buffer(Buffer& buffer, const char* name)
    {
        auto all = buffer.download();
        values(all, name);
        buffer.upload(all);
    }
    /// The first elements alone; the others stay as they are.
    template <typename Buffer> void first(Buffer& buffer, std::size_t count, const char* name)
    {
        auto some = buffer.download();
        some.resize(std::min(count, some.size()));
        values(some, name);
        buffer.write_range(0, some);
    }

private:
    void take(void* to, std::size_t bytes)
    {
        if (bytes > bytes_.size() - at_) throw Error("The state of a run is cut short.");
        if (bytes > 0) std::memcpy(to, bytes_.data() + at_, bytes);
        at_ += bytes;
    }
    const std::vector<std::byte>& bytes_;
    std::size_t at_ = 0;
};

} // namespace hygroloom
