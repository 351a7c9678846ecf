// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A thin, checked layer over the HDF5 C library: handles that close themselves, and the few kinds of value a recording holds.
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>
#include <vector>

namespace hygroloom::hdf5 {

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

Handle create_group(hid_t parent, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);
bool exists(hid_t parent, const std::string& name);

void write_text(hid_t parent, const std::string& name, const std::string& value); ///< a scalar dataset
std::string read_text(hid_t parent, const std::string& name);
void write_number(hid_t parent, const std::string& name, double value); ///< an attribute; replaces an old one
bool has_number(hid_t parent, const std::string& name);
double read_number(hid_t parent, const std::string& name);

/// Compressed where that pays.
void write_floats(hid_t parent, const std::string& name, const float* values, hsize_t rows, hsize_t columns, const char* unit);
std::vector<float> read_floats(hid_t parent, const std::string& name);
void write_doubles(hid_t parent, const std::string& name, const std::vector<double>& values, const char* unit);
void write_ints(hid_t parent, const std::string& name, const std::vector<int>& values);

/// A table of doubles that grows by rows.
Handle create_table(hid_t parent, const std::string& name, hsize_t columns, const std::string& column_names);
void append_row(hid_t table, const std::vector<double>& row);
std::vector<std::vector<double>> read_table(hid_t parent, const std::string& name);

/// Keeps the library from printing its own error stack while in scope.
class Quiet {
public:
    Quiet();
    ~Quiet();

private:
    H5E_auto2_t old_ = nullptr;
    void* data_ = nullptr;
};

} // namespace hygroloom::hdf5
