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

Handle open_dataset(hid_t parent, const std::string& name)
{
    return {H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose,
            "The recording lacks \"" + name + "\"; it is damaged or not a recording."};
}

std::vector<hsize_t> extents(hid_t dataset)
{
    const Handle space(H5Dget_space(dataset), H5Sclose, "The recording is damaged.");
    std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.get()))));
    H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr);
    return sizes;
}

/// Datasets carry no time stamps, so that the same run writes the same bytes.
Handle untimed_properties()
{
    Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "The recording cannot be written.");
    H5Pset_obj_track_times(properties.get(), false);
    return properties;
}

void write_array(hid_t parent, const std::string& name, hid_t type, const void* values, const std::vector<hsize_t>& sizes, const char* unit)
{
    const Handle space(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose,
                       "The recording cannot be written.");
    const Handle properties = untimed_properties();
    if (sizes[0] >= 1024) {
        std::vector<hsize_t> chunk = sizes;
        chunk[0] = std::min<hsize_t>(chunk[0], 65536);
        H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data());
        H5Pset_shuffle(properties.get());
        H5Pset_deflate(properties.get(), 1);
    }
    const Handle set(H5Dcreate2(parent, name.c_str(), type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Dclose,
                     "The recording cannot be written: no room for \"" + name + "\".");
    if (sizes[0] > 0)
        check(H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "The recording cannot be written; the disk may be full.");
    if (!unit) return;
    const Handle text(H5Tcopy(H5T_C_S1), H5Tclose, "The recording cannot be written.");
    H5Tset_size(text.get(), std::max<std::size_t>(1, std::char_traits<char>::length(unit)));
    const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, "The recording cannot be written.");
    const Handle attribute(H5Acreate2(set.get(), "unit", text.get(), scalar.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                           "The recording cannot be written.");
    check(H5Awrite(attribute.get(), text.get(), unit), "The recording cannot be written.");
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
    return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "The recording cannot be written."};
}

Handle open_group(hid_t parent, const std::string& name)
{
    return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose,
            "The recording lacks \"" + name + "\"; it is damaged or not a recording."};
}

bool exists(hid_t parent, const std::string& name) { return H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0; }

void write_text(hid_t parent, const std::string& name, const std::string& value)
{
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "The recording cannot be written.");
    H5Tset_size(type.get(), std::max<std::size_t>(1, value.size()));
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "The recording cannot be written.");
    const Handle properties = untimed_properties();
    const Handle set(H5Dcreate2(parent, name.c_str(), type.get(), space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Dclose,
                     "The recording cannot be written.");
    const std::string padded = value.empty() ? std::string(1, '\0') : value;
    check(H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), "The recording cannot be written.");
}

std::string read_text(hid_t parent, const std::string& name)
{
    const Handle set = open_dataset(parent, name);
    const Handle type(H5Dget_type(set.get()), H5Tclose, "The recording is damaged.");
    if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0)
        throw FileError("The recording's \"" + name + "\" is not text.");
    const std::size_t size = H5Tget_size(type.get());
    if (size > (std::size_t(1) << 30)) throw FileError("The recording's \"" + name + "\" is too long.");
    std::string value(size, '\0');
    check(H5Dread(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()),
          "The recording is damaged: \"" + name + "\" cannot be read.");
    while (!value.empty() && value.back() == '\0') value.pop_back();
    return value;
}

void write_number(hid_t parent, const std::string& name, double value)
{
    if (H5Aexists(parent, name.c_str()) > 0) H5Adelete(parent, name.c_str());
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "The recording cannot be written.");
    const Handle attribute(H5Acreate2(parent, name.c_str(), H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                           "The recording cannot be written.");
    check(H5Awrite(attribute.get(), H5T_NATIVE_DOUBLE, &value), "The recording cannot be written.");
}

bool has_number(hid_t parent, const std::string& name) { return H5Aexists(parent, name.c_str()) > 0; }

double read_number(hid_t parent, const std::string& name)
{
    const Handle attribute(H5Aopen(parent, name.c_str(), H5P_DEFAULT), H5Aclose, "The recording lacks \"" + name + "\"; it is damaged.");
    double value = 0;
    check(H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value), "The recording is damaged: \"" + name + "\" cannot be read.");
    return value;
}

void write_floats(hid_t parent, const std::string& name, const float* values, hsize_t rows, hsize_t columns, const char* unit)
{
    write_array(parent, name, H5T_NATIVE_FLOAT, values, columns > 1 ? std::vector<hsize_t>{rows, columns} : std::vector<hsize_t>{rows},
                unit);
}

std::vector<float> read_floats(hid_t parent, const std::string& name)
{
    const Handle set = open_dataset(parent, name);
    hsize_t count = 1;
    for (hsize_t size : extents(set.get())) count *= size;
    if (count > (hsize_t(1) << 32)) throw FileError("The recording's \"" + name + "\" is too large.");
    std::vector<float> values(count);
    if (count > 0)
        check(H5Dread(set.get(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
              "The recording is damaged: \"" + name + "\" cannot be read.");
    return values;
}

void write_doubles(hid_t parent, const std::string& name, const std::vector<double>& values, const char* unit)
{
    write_array(parent, name, H5T_NATIVE_DOUBLE, values.data(), {values.size()}, unit);
}

void write_ints(hid_t parent, const std::string& name, const std::vector<int>& values)
{
    write_array(parent, name, H5T_NATIVE_INT, values.data(), {values.size()}, nullptr);
}

Handle create_table(hid_t parent, const std::string& name, hsize_t columns, const std::string& column_names)
{
    const hsize_t now[2] = {0, columns}, most[2] = {H5S_UNLIMITED, columns}, chunk[2] = {128, columns};
    const Handle space(H5Screate_simple(2, now, most), H5Sclose, "The recording cannot be written.");
    const Handle properties = untimed_properties();
    H5Pset_chunk(properties.get(), 2, chunk);
    Handle table(H5Dcreate2(parent, name.c_str(), H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Dclose,
                 "The recording cannot be written.");
    write_text(parent, name + "_columns", column_names);
    return table;
}

void append_row(hid_t table, const std::vector<double>& row)
{
    const std::vector<hsize_t> old = extents(table);
    const hsize_t now[2] = {old[0] + 1, old[1]}, start[2] = {old[0], 0}, count[2] = {1, old[1]};
    check(H5Dset_extent(table, now), "The recording cannot be written; the disk may be full.");
    const Handle file_space(H5Dget_space(table), H5Sclose, "The recording cannot be written.");
    H5Sselect_hyperslab(file_space.get(), H5S_SELECT_SET, start, nullptr, count, nullptr);
    const Handle space(H5Screate_simple(2, count, nullptr), H5Sclose, "The recording cannot be written.");
    check(H5Dwrite(table, H5T_NATIVE_DOUBLE, space.get(), file_space.get(), H5P_DEFAULT, row.data()),
          "The recording cannot be written; the disk may be full.");
}

std::vector<std::vector<double>> read_table(hid_t parent, const std::string& name)
{
    const Handle set = open_dataset(parent, name);
    const std::vector<hsize_t> sizes = extents(set.get());
    if (sizes.size() != 2 || sizes[0] * sizes[1] > (hsize_t(1) << 28)) throw FileError("The recording's \"" + name + "\" is not a table.");
    std::vector<double> values(sizes[0] * sizes[1]);
    if (!values.empty())
        check(H5Dread(set.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
              "The recording is damaged: \"" + name + "\" cannot be read.");
    std::vector<std::vector<double>> rows;
    for (hsize_t i = 0; i < sizes[0]; ++i)
        rows.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(i * sizes[1]),
                          values.begin() + static_cast<std::ptrdiff_t>((i + 1) * sizes[1]));
    return rows;
}

Quiet::Quiet()
{
    H5Eget_auto2(H5E_DEFAULT, &old_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Quiet::~Quiet() { H5Eset_auto2(H5E_DEFAULT, old_, data_); }

} // namespace hygroloom::hdf5
