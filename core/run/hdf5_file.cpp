// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/hdf5_file.h"

#include "core/base/error.h"

#include <algorithm>

namespace hygroloom::hdf5 {
namespace {

void check(herr_t result, const std::string& what)
{
    if (result < 0) throw FileError(what);
}

std::vector<hsize_t> extents(hid_t dataset)
{
    const Handle space(H5Dget_space(dataset), H5Sclose, "the recording cannot be written");
    std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.get()))));
    H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr);
    return sizes;
}

/// Datasets carry no time stamps, so that the same run writes the same bytes. Made once: it takes as long as a small dataset.
hid_t untimed()
{
    static const hid_t properties = [] {
        const hid_t made = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_obj_track_times(made, false);
        return made;
    }();
    return properties;
}

/// The extent of one value.
hid_t single()
{
    static const hid_t space = H5Screate(H5S_SCALAR);
    return space;
}

/// Of arrays that are compressed, so many rows in one, to this of zlib's levels.
Handle packed_properties(const std::vector<hsize_t>& sizes, hsize_t most_rows, unsigned level)
{
    Handle properties(H5Pcopy(untimed()), H5Pclose, "the recording cannot be written");
    std::vector<hsize_t> chunk = sizes;
    chunk[0] = std::min(chunk[0], most_rows);
    H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(properties.get());
    H5Pset_deflate(properties.get(), level);
    return properties;
}

void write_array(hid_t parent, const std::string& name, hid_t type, const void* values, const std::vector<hsize_t>& sizes, const char* unit)
{
    const Handle space(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose,
                       "the recording cannot be written");
    constexpr hsize_t least_packed = 1024;
    const Handle packed = sizes[0] >= least_packed ? packed_properties(sizes, 65536, 4) : Handle();
    const Handle set(
        H5Dcreate2(parent, name.c_str(), type, space.get(), H5P_DEFAULT, packed.get() >= 0 ? packed.get() : untimed(), H5P_DEFAULT),
        H5Dclose, "the recording cannot be written: no room for \"" + name + "\"");
    if (sizes[0] > 0) check(H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "the recording cannot be written");
    if (!unit) return;
    const Handle text(H5Tcopy(H5T_C_S1), H5Tclose, "the recording cannot be written");
    H5Tset_size(text.get(), std::max<std::size_t>(1, std::char_traits<char>::length(unit)));
    const Handle attribute(H5Acreate2(set.get(), "unit", text.get(), single(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                           "the recording cannot be written");
    check(H5Awrite(attribute.get(), text.get(), unit), "the recording cannot be written");
}

} // namespace

Handle::Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close)
{
    if (id < 0) throw FileError(what);
}

Handle& Handle::operator=(Handle&& other) noexcept
{
    reset();
    id_ = std::exchange(other.id_, -1);
    close_ = other.close_;
    return *this;
}

void Handle::reset()
{
    if (id_ >= 0) close_(id_);
    id_ = -1;
}

Handle create_group(hid_t parent, const std::string& name)
{
    return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "the recording cannot be written"};
}

void silence() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

bool exists(hid_t parent, const std::string& name) { return H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0; }

void write_text(hid_t parent, const std::string& name, const std::string& value)
{
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "the recording cannot be written");
    H5Tset_size(type.get(), std::max<std::size_t>(1, value.size()));
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    const Handle set(H5Dcreate2(parent, name.c_str(), type.get(), single(), H5P_DEFAULT, untimed(), H5P_DEFAULT), H5Dclose,
                     "the recording cannot be written");
    const std::string padded = value.empty() ? std::string(1, '\0') : value;
    check(H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), "the recording cannot be written");
}

void write_number(hid_t parent, const std::string& name, double value)
{
    if (H5Aexists(parent, name.c_str()) > 0) H5Adelete(parent, name.c_str());
    const Handle attribute(H5Acreate2(parent, name.c_str(), H5T_IEEE_F64LE, single(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                           "the recording cannot be written");
    check(H5Awrite(attribute.get(), H5T_NATIVE_DOUBLE, &value), "the recording cannot be written");
}

void write_floats(hid_t parent, const std::string& name, const float* values, hsize_t rows, hsize_t columns, const char* unit)
{
    write_array(parent, name, H5T_NATIVE_FLOAT, values, columns > 1 ? std::vector<hsize_t>{rows, columns} : std::vector<hsize_t>{rows},
                unit);
}

void write_doubles(hid_t parent, const std::string& name, const std::vector<double>& values, const char* unit)
{
    write_array(parent, name, H5T_NATIVE_DOUBLE, values.data(), {values.size()}, unit);
}

void write_rows(hid_t parent, const std::string& name, const std::vector<std::uint32_t>& values, hsize_t rows)
{
    const std::vector<hsize_t> sizes{rows, values.size() / rows};
    const Handle space(H5Screate_simple(2, sizes.data(), nullptr), H5Sclose, "the recording cannot be written");
    const Handle set(
        H5Dcreate2(parent, name.c_str(), H5T_STD_U32LE, space.get(), H5P_DEFAULT, packed_properties(sizes, 1, 5).get(), H5P_DEFAULT),
        H5Dclose, "the recording cannot be written: no room for \"" + name + "\"");
    check(H5Dwrite(set.get(), H5T_NATIVE_UINT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "the recording cannot be written");
}

void write_ints(hid_t parent, const std::string& name, const std::vector<int>& values)
{
    write_array(parent, name, H5T_NATIVE_INT, values.data(), {values.size()}, nullptr);
}

Handle create_table(hid_t parent, const std::string& name, hsize_t columns, const std::string& column_names)
{
    const hsize_t now[2] = {0, columns}, most[2] = {H5S_UNLIMITED, columns}, chunk[2] = {128, columns};
    const Handle space(H5Screate_simple(2, now, most), H5Sclose, "the recording cannot be written");
    const Handle properties(H5Pcopy(untimed()), H5Pclose, "the recording cannot be written");
    H5Pset_chunk(properties.get(), 2, chunk);
    Handle table(H5Dcreate2(parent, name.c_str(), H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Dclose,
                 "the recording cannot be written");
    write_text(parent, name + "_columns", column_names);
    return table;
}

void append_row(hid_t table, const std::vector<double>& row)
{
    const std::vector<hsize_t> old = extents(table);
    const hsize_t now[2] = {old[0] + 1, old[1]}, start[2] = {old[0], 0}, count[2] = {1, old[1]};
    check(H5Dset_extent(table, now), "the recording cannot be written");
    const Handle file_space(H5Dget_space(table), H5Sclose, "the recording cannot be written");
    H5Sselect_hyperslab(file_space.get(), H5S_SELECT_SET, start, nullptr, count, nullptr);
    const Handle space(H5Screate_simple(2, count, nullptr), H5Sclose, "the recording cannot be written");
    check(H5Dwrite(table, H5T_NATIVE_DOUBLE, space.get(), file_space.get(), H5P_DEFAULT, row.data()), "the recording cannot be written");
}

} // namespace hygroloom::hdf5
