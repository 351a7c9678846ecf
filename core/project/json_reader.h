// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Strict reading of JSON: every key must be known, every value of the right type, and each refusal says where.
#pragma once

#include "core/base/error.h"
#include "core/project/migrations.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hygroloom {

/// A number beyond those that there are.
struct NumberTooLarge : FileError {
    using FileError::FileError;
};

/// Parses text; refuses bad UTF-8, duplicate keys, nesting deeper than 32 and numbers too large. Throws FileError with name, line and
/// column or path.
ProjectJson parse_json(std::string_view text, const std::string& name);

/// A JSON value in words, shortened: `"abc"`, `12`, `an object`.
std::string in_words(const ProjectJson& value);

/// One object of the file. Ask for every key it may have, then call finish(), which refuses the others.
class ObjectReader {
public:
    ObjectReader(const ProjectJson& value, std::string file, std::string path);

    /// The member, or nullptr when it is absent.
    const ProjectJson* find(const std::string& key);
    const ProjectJson& require(const std::string& key);
    /// Leave value alone when the key is absent.
    void read(const std::string& key, double& value);
    void read(const std::string& key, int& value);
    void read(const std::string& key, bool& value);
    void read(const std::string& key, std::string& value);
    void read(const std::string& key, std::optional<double>& value);
    void read(const std::string& key, std::optional<int>& value);
    void read(const std::string& key, std::array<double, 2>& value);
    /// The place among some words of the one that the member is. Precondition: it is there.
    int word(const std::string& key, std::span<const char* const> words);
    /// Refuses unknown keys, with the nearest known one, then a missing key of the required ones.
    void finish(const std::vector<std::string>& required = {}) const;

    std::string path_of(const std::string& key) const;
    const std::string& file() const { return file_; }
    [[noreturn]] void refuse(const std::string& key, const std::string& sentence) const;

private:
    [[noreturn]] void refuse_missing(const std::string& key) const;

    const ProjectJson& value_;
    std::string file_;
    std::string path_;
    std::vector<std::string> known_;
};

/// Refuses a file of another format or version. things: what such files hold, "lessons".
void require_format(ObjectReader& file, const std::string& format, int version, const char* things);

double number_in(const ProjectJson& value, const std::string& file, const std::string& path);
std::string text_in(const ProjectJson& value, const std::string& file, const std::string& path);
const ProjectJson& array_in(const ProjectJson& value, const std::string& file, const std::string& path);

} // namespace hygroloom
