// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A thin, checked layer over the HDF5 C library: handles that close themselves, and writing the few kinds of value a recording holds.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace hygroloom::hdf5 {

constexpr hsize_t largest_chunk = 16 << 20; // bytes that readers take in one piece; the library has it in memory as a whole

/// Owns an HDF5 identifier; throws FileError with the given words when the library refused it.
class Handle {
public:
    Handle() = default;
    Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what);
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Handle& operator=(Handle&& other) noexcept;
    void reset();
    hid_t get() const { return id_; }

private:
    hid_t id_ = -1;
    herr_t (*close_)(hid_t) = nullptr;
};

/// Keeps the library from printing its own error stack, in this thread.
void silence();

Handle create_group(hid_t parent, const std::string& name);
bool exists(hid_t parent, const std::string& name);

void write_text(hid_t parent, const std::string& name, const std::string& value); ///< a scalar dataset
void write_number(hid_t parent, const std::string& name, double value);           ///< an attribute; replaces an old one

/// Compressed where that pays.
void write_floats(hid_t parent, const std::string& name, const float* values, hsize_t rows, hsize_t columns, const char* unit);
void write_doubles(hid_t parent, const std::string& name, const std::vector<double>& values, const char* unit);
/// Row after row, each packed alone. Preconditions: some rows, of as many values each; at least one.
void write_rows(hid_t parent, const std::string& name, const std::vector<std::uint32_t>& values, hsize_t rows);
void write_ints(hid_t parent, const std::string& name, const std::vector<int>& values);

/// A table of doubles that grows by rows.
Handle create_table(hid_t parent, const std::string& name, hsize_t columns, const std::string& column_names);
void append_row(hid_t table, const std::vector<double>& row);

} // namespace hygroloom::hdf5
