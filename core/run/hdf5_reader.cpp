// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/hdf5_reader.h"

#include "core/base/error.h"
#include "core/base/utf8.h"
#include "core/run/hdf5_packed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hygroloom::hdf5 {
namespace {

constexpr hsize_t any = HSIZE_UNDEF;

/// As "frames/000001/temperature", for sentences.
std::string place_of(hid_t parent, const std::string& name)
{
    char path[200] = "";
    H5Iget_name(parent, path, sizeof path);
    const std::string group = path[0] == '/' ? path + 1 : path;
    return group.empty() ? name : group + "/" + name;
}

[[noreturn]] void refuse(const std::string& place, const std::string& what)
{
    throw FileError(in_whole_utf8(fmt::format("\"{}\" {}", place, what)));
}

void require_no_link(hid_t parent, const std::string& name, const std::string& place)
{
    if (!exists(parent, name)) refuse(place, "is missing; the recording is damaged or no recording.");
    H5L_info_t info{};
    if (H5Lget_info(parent, name.c_str(), &info, H5P_DEFAULT) < 0)
        refuse(place, "cannot be read; it is damaged, or of a kind that recordings do not hold.");
    if (info.type != H5L_TYPE_HARD) refuse(place, "is a link; recordings hold none, and none is followed.");
}

bool is_plain_float(hid_t type)
{
    return H5Tequal(type, H5T_IEEE_F64LE) > 0 || H5Tequal(type, H5T_IEEE_F32LE) > 0 || H5Tequal(type, H5T_IEEE_F64BE) > 0 ||
           H5Tequal(type, H5T_IEEE_F32BE) > 0;
}

bool is_whole_number(hid_t type) { return H5Tequal(type, H5T_STD_U32LE) > 0; }

bool is_fixed_text(hid_t type) { return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0; }

std::vector<hsize_t> extents_of(hid_t space, const std::string& place)
{
    const H5S_class_t kind = H5Sget_simple_extent_type(space);
    if (kind == H5S_SCALAR) return {};
    const int rank = kind == H5S_SIMPLE ? H5Sget_simple_extent_ndims(space) : -1;
    if (rank < 0 || rank > H5S_MAX_RANK) refuse(place, "holds no values.");
    std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
    if (H5Sget_simple_extent_dims(space, sizes.data(), nullptr) != rank) refuse(place, "has an extent that cannot be read.");
    return sizes;
}

std::string text_of(const std::vector<hsize_t>& sizes)
{
    std::string text;
    for (const hsize_t size : sizes) text += (text.empty() ? "" : " x ") + (size == any ? "any number" : std::to_string(size));
    return text.empty() ? "one value" : text + " values";
}

/// Scalars may also be written as lists of one.
void require_extents(const std::vector<hsize_t>& sizes, const std::vector<hsize_t>& expected, const std::string& place)
{
    const bool is_one = expected.empty() && sizes == std::vector<hsize_t>{1};
    const bool fits = std::equal(sizes.begin(), sizes.end(), expected.begin(), expected.end(),
                                 [](hsize_t size, hsize_t wanted) { return wanted == any || size == wanted; });
    if (!fits && !is_one) refuse(place, fmt::format("has {}; expected is {}.", text_of(sizes), text_of(expected)));
}

struct Checked {
    std::string place;
    Handle set, type, properties;
    std::vector<hsize_t> sizes;
    std::vector<hsize_t> chunk; ///< empty: not in chunks
    bool is_packed = false;
    hsize_t count = 1;
};

/// Layout, filters, and that the file holds all bytes.
void check_storage(Checked& of)
{
    const hid_t properties = of.properties.get();
    const H5D_layout_t layout = H5Pget_layout(properties);
    if (H5Pget_external_count(properties) != 0) refuse(of.place, "lies in another file; none is opened for it.");
    if (layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED)
        refuse(of.place, "is put together from other files or sets; recordings hold none of that kind.");
    const hsize_t size = H5Tget_size(of.type.get());
    for (const hsize_t extent : of.sizes) {
        if (extent != 0 && of.count > INT64_MAX / size / extent) refuse(of.place, "is too large.");
        of.count *= extent;
    }
    if (layout == H5D_CHUNKED) {
        of.chunk.resize(of.sizes.size());
        const int rank = static_cast<int>(of.chunk.size());
        hsize_t bytes = size;
        if (H5Pget_chunk(properties, rank, of.chunk.data()) != rank) refuse(of.place, "has chunks that cannot be read.");
        for (const hsize_t extent : of.chunk) {
            if (extent == 0 || extent > largest_chunk) refuse(of.place, "lies in chunks that are too large.");
            bytes = std::min(bytes * extent, 2 * largest_chunk);
        }
        if (bytes > largest_chunk) refuse(of.place, "lies in chunks that are too large.");
    }
    of.is_packed = H5Pget_nfilters(properties) != 0;
    if (!of.is_packed && H5Dget_storage_size(of.set.get()) < of.count * size)
        refuse(of.place, fmt::format("should have {}, which the file does not hold.", text_of(of.sizes)));
}

Checked checked(hid_t parent, const std::string& name, bool (*is_type)(hid_t), const char* type, const std::vector<hsize_t>& expected)
{
    Checked of;
    of.place = place_of(parent, name);
    require_no_link(parent, name, of.place);
    const std::string damaged = fmt::format("\"{}\" cannot be read; it is damaged, or of a kind that recordings do not hold.", of.place);
    of.set = Handle(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, damaged);
    of.type = Handle(H5Dget_type(of.set.get()), H5Tclose, damaged);
    if (!is_type(of.type.get())) refuse(of.place, fmt::format("is not {}.", type));
    const Handle space(H5Dget_space(of.set.get()), H5Sclose, damaged);
    of.sizes = extents_of(space.get(), of.place);
    require_extents(of.sizes, expected, of.place);
    of.properties = Handle(H5Dget_create_plist(of.set.get()), H5Pclose, damaged);
    check_storage(of);
    return of;
}

std::vector<float> floats_of(const Checked& of)
{
    std::vector<float> values(of.count);
    if (of.count > 0 && of.is_packed)
        read_packed(of.set.get(), of.type.get(), of.properties.get(), of.sizes, of.chunk, values.data(), of.place);
    else if (of.count > 0 && H5Dread(of.set.get(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
        refuse(of.place, "cannot be read; it is damaged, or of a kind that recordings do not hold.");
    if (!std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); }))
        refuse(of.place, "holds a number that is not finite.");
    return values;
}

} // namespace

Handle open_group(hid_t parent, const std::string& name)
{
    const std::string place = place_of(parent, name);
    require_no_link(parent, name, place);
    return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose,
            in_whole_utf8(fmt::format("\"{}\" cannot be read; it is damaged, or of a kind that recordings do not hold.", place))};
}

std::string read_text(hid_t parent, const std::string& name)
{
    const Checked of = checked(parent, name, is_fixed_text, "a text of fixed length", {});
    if (of.is_packed) refuse(of.place, "is a compressed text; recordings hold none.");
    std::string value(H5Tget_size(of.type.get()), '\0');
    if (H5Dread(of.set.get(), of.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()) < 0)
        refuse(of.place, "cannot be read; it is damaged, or of a kind that recordings do not hold.");
    value.erase(std::find_if(value.rbegin(), value.rend(), [](char c) { return c != '\0'; }).base(), value.end());
    return in_whole_utf8(value);
}

bool has_number(hid_t parent, const std::string& name) { return H5Aexists(parent, name.c_str()) > 0; }

double read_number(hid_t parent, const std::string& name)
{
    const std::string place = place_of(parent, name);
    if (!has_number(parent, name)) refuse(place, "is missing; the recording is damaged or no recording.");
    const std::string damaged = fmt::format("\"{}\" cannot be read; it is damaged, or of a kind that recordings do not hold.", place);
    const Handle attribute(H5Aopen(parent, name.c_str(), H5P_DEFAULT), H5Aclose, damaged);
    const Handle type(H5Aget_type(attribute.get()), H5Tclose, damaged);
    if (!is_plain_float(type.get())) refuse(place, "is not a number.");
    const Handle space(H5Aget_space(attribute.get()), H5Sclose, damaged);
    require_extents(extents_of(space.get(), place), {}, place);
    double value = 0;
    if (H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value) < 0)
        refuse(place, "cannot be read; it is damaged, or of a kind that recordings do not hold.");
    if (!std::isfinite(value)) refuse(place, "is not a finite number.");
    return value;
}

long read_count(hid_t parent, const std::string& name, long least, long most)
{
    const double value = read_number(parent, name);
    if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)) || value != std::floor(value))
        refuse(place_of(parent, name), fmt::format("is {:g}; expected is a whole number from {} to {}.", value, least, most));
    return static_cast<long>(value);
}

std::vector<float> read_floats(hid_t parent, const std::string& name, hsize_t expected)
{
    return floats_of(checked(parent, name, is_plain_float, "a set of numbers", {expected}));
}

std::vector<float> read_triples(hid_t parent, const std::string& name, hsize_t most_rows)
{
    const Checked of = checked(parent, name, is_plain_float, "a set of numbers", {any, 3});
    if (of.sizes[0] > most_rows) refuse(of.place, fmt::format("has {}; a file of this size cannot hold them.", text_of(of.sizes)));
    return floats_of(of);
}

std::vector<std::uint32_t> read_row(hid_t parent, const std::string& name, hsize_t rows, hsize_t columns, hsize_t row)
{
    const Checked of = checked(parent, name, is_whole_number, "a set of whole numbers", {rows, columns});
    if (!of.is_packed || of.chunk != std::vector<hsize_t>{1, columns}) refuse(of.place, "is not packed row by row.");
    std::vector<std::uint32_t> values(columns);
    const std::size_t bytes = columns * sizeof values[0];
    const TakeRows take = [&](hsize_t, hsize_t, const unsigned char* from) { std::memcpy(values.data(), from, bytes); };
    read_packed_rows(of.set.get(), of.properties.get(), {row + 1, 1, of.sizes.size(), bytes, sizeof values[0], row}, take, of.place);
    return values;
}

Table::Table(hid_t parent, const std::string& name, hsize_t least_columns, hsize_t most_columns)
{
    Checked of = checked(parent, name, is_plain_float, "a table of numbers", {any, any});
    columns_ = of.sizes[1];
    if (columns_ < least_columns || columns_ > most_columns)
        refuse(of.place, fmt::format("has {} columns; {} to {} are possible.", columns_, least_columns, most_columns));
    if (of.is_packed) refuse(of.place, "is a compressed table; recordings hold none.");
    place_ = of.place;
    set_ = std::move(of.set);
    rows_ = of.sizes[0];
}

std::vector<double> Table::read(hsize_t first, hsize_t count) const
{
    const hsize_t start[2] = {first, 0}, size[2] = {count, columns_};
    const std::string damaged = fmt::format("\"{}\" cannot be read; it is damaged, or of a kind that recordings do not hold.", place_);
    std::vector<double> values(count * columns_);
    const Handle in_file(H5Dget_space(set_.get()), H5Sclose, damaged), in_memory(H5Screate_simple(2, size, nullptr), H5Sclose, damaged);
    if (H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start, nullptr, size, nullptr) < 0 ||
        H5Dread(set_.get(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(), H5P_DEFAULT, values.data()) < 0)
        throw FileError(damaged);
    return values;
}

} // namespace hygroloom::hdf5
