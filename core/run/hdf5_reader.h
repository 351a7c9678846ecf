// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reading from HDF5 files of strangers: link, type, extent, layout and size are compared with what is expected before a byte is read.
// All throw FileError, which names the group and what is wrong with it.
#pragma once

#include "core/run/hdf5_file.h"

namespace hygroloom::hdf5 {

/// Not through a link that leads elsewhere.
Handle open_group(hid_t parent, const std::string& name);

/// A scalar dataset of fixed length. What is no UTF-8 becomes the replacement character.
std::string read_text(hid_t parent, const std::string& name);

/// An attribute, finite.
bool has_number(hid_t parent, const std::string& name);
double read_number(hid_t parent, const std::string& name);
/// A whole number within bounds.
long read_count(hid_t parent, const std::string& name, long least, long most);

/// As many as expected, finite.
std::vector<float> read_floats(hid_t parent, const std::string& name, hsize_t expected);
/// Any number of rows of 3, up to a limit; x, y and z of one after those of another.
std::vector<float> read_triples(hid_t parent, const std::string& name, hsize_t most_rows);

/// One row of so many whole numbers, of a set that holds so many of these, each packed alone. Precondition: row < rows.
std::vector<std::uint32_t> read_row(hid_t parent, const std::string& name, hsize_t rows, hsize_t columns, hsize_t row);

/// A table of doubles, read by rows. It must outlive no file that it is of.
class Table {
public:
    Table(hid_t parent, const std::string& name, hsize_t least_columns, hsize_t most_columns);
    hsize_t rows() const { return rows_; }
    hsize_t columns() const { return columns_; }
    /// Row after row. Rows must lie in the table.
    std::vector<double> read(hsize_t first, hsize_t count) const;

private:
    std::string place_;
    Handle set_;
    hsize_t rows_ = 0, columns_ = 0;
};

} // namespace hygroloom::hdf5
