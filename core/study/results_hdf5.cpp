// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The table of a study as HDF5: /project and /study, and under /rows a set for each column.
#include "core/study/results.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"
#include "core/run/hdf5_packed.h"
#include "core/run/hdf5_reader.h"
#include "core/run/recording_source.h"
#include "core/study/csv_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace hygroloom {
namespace {

using hdf5::Handle;
using Role = StudyColumnRole;

constexpr hsize_t rows_of_chunk = 4096;
constexpr std::uint64_t least_room = std::uint64_t{1} << 30U; // bytes; besides three times the file's size
constexpr std::size_t longest_cell = 4096;

/// Compressed, and without the time of day, so that the same table has the same bytes.
Handle column_properties(hsize_t rows)
{
    Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "columns");
    H5Pset_obj_track_times(properties.get(), 0);
    if (rows > 0) {
        const hsize_t chunk = std::min(rows, rows_of_chunk);
        H5Pset_chunk(properties.get(), 1, &chunk);
        H5Pset_shuffle(properties.get());
        H5Pset_deflate(properties.get(), 4);
    }
    return properties;
}

Handle word_type(std::size_t length)
{
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "words");
    H5Tset_size(type.get(), std::max<std::size_t>(length, 1));
    H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    return type;
}

/// Slashes would make groups.
std::string set_name(std::string name)
{
    std::replace(name.begin(), name.end(), '/', '|');
    return name == "." ? "dot" : name;
}

void write_column(hid_t group, const StudyColumn& column)
{
    const hsize_t rows = column.size();
    const Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose, column.name);
    const Handle properties = column_properties(rows);
    std::size_t length = 1;
    for (const std::string& word : column.words) length = std::max(length, word.size());
    const Handle type = column.is_number ? Handle(H5Tcopy(H5T_IEEE_F64LE), H5Tclose, column.name) : word_type(length);
    const Handle set(H5Dcreate2(group, set_name(column.name).c_str(), type.get(), space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                     H5Dclose, column.name);
    if (rows == 0) return;
    std::string words;
    if (!column.is_number) {
        words.assign(rows * length, '\0');
        for (std::size_t row = 0; row < rows; ++row) column.word(row).copy(&words[row * length], length);
    }
    const void* values = column.is_number ? static_cast<const void*>(column.numbers.data()) : words.data();
    if (H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
        throw FileError(column.name + ": The column cannot be written.");
}

/// A set of one dimension and one of the two types, packed as write_column() does it, or without rows. room: bytes that columns may still
/// take.
void read_column(hid_t group, StudyColumn& column, hsize_t& rows, std::uint64_t& room, const std::string& file)
{
    const auto refuse = [&](const std::string& what) { throw FileError(fmt::format("{}: rows/{}: {}", file, column.name, what)); };
    const Handle set(H5Dopen2(group, set_name(column.name).c_str(), H5P_DEFAULT), H5Dclose,
                     fmt::format("{}: rows/{}: This is missing or damaged.", file, column.name));
    const Handle space(H5Dget_space(set.get()), H5Sclose, column.name), type(H5Dget_type(set.get()), H5Tclose, column.name);
    hsize_t count = 0;
    if (H5Sget_simple_extent_ndims(space.get()) != 1) refuse("This must have one dimension.");
    H5Sget_simple_extent_dims(space.get(), &count, nullptr);
    if (rows == HSIZE_UNDEF) rows = count;
    if (count != rows || count > most_table_rows)
        refuse(fmt::format("This must have {} rows; it has {}.", std::min<hsize_t>(rows, most_table_rows), count));
    const std::size_t length = H5Tget_size(type.get());
    column.is_number = H5Tequal(type.get(), H5T_IEEE_F64LE) > 0;
    if (!column.is_number &&
        (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0 || length == 0 || length > longest_cell))
        refuse(fmt::format("This must be numbers of 8 bytes, or texts of a fixed length of {} bytes at most.", longest_cell));
    const Handle properties(H5Dget_create_plist(set.get()), H5Pclose, column.name);
    hsize_t chunk = 1;
    if (rows > 0) {
        if (H5Pget_layout(properties.get()) != H5D_CHUNKED) // what lies in other files never does
            refuse("This does not lie in chunks of the file; nothing else is read.");
        if (H5Pget_chunk(properties.get(), 1, &chunk) != 1 || chunk == 0 || chunk > rows_of_chunk)
            refuse(fmt::format("Its chunks have {} rows; 1 to {} are read.", chunk, rows_of_chunk));
    }
    const auto take_room = [&](std::uint64_t bytes) {
        if (bytes > room) refuse("This and the columns before it take more memory than a file of this size may.");
        room -= bytes;
    };
    take_room(rows * (column.is_number ? sizeof(double) : sizeof(column.word_of[0])));
    WordList words;
    const auto take = [&](hsize_t first, hsize_t taken, const unsigned char* bytes) {
        if (column.is_number) {
            std::memcpy(&column.numbers[first], bytes, taken * length);
            return;
        }
        for (hsize_t row = 0; row < taken; ++row) {
            const std::string_view whole(reinterpret_cast<const char*>(bytes) + row * length, length),
                word = whole.substr(0, whole.find('\0'));
            const std::size_t known = words.words().size();
            column.word_of.push_back(words.place_of(word));
            if (words.words().size() > known) take_room(2 * (sizeof(std::string) + word.size())); // in a list and a map
        }
    };
    if (column.is_number) column.numbers.resize(rows);
    if (rows > 0)
        hdf5::read_packed_rows(set.get(), properties.get(), {rows, chunk, 1, length, length}, take, file + ": rows/" + column.name);
    if (!column.is_number) column.words = words.words();
}

/// As the table of results.csv has it.
bool has_type_of_role(const StudyColumn& column)
{
    switch (column.role) {
    case Role::point:
    case Role::replicate:
    case Role::metric:
    case Role::wall: return column.is_number;
    case Role::factor: return true;
    default: return !column.is_number;
    }
}

/// Looks at each block before the library does.
std::unique_ptr<RecordingSource> opened(const std::filesystem::path& path)
{
    try {
        return std::make_unique<RecordingSource>(path);
    } catch (const FileError& error) {
        throw FileError(path.string() + ": " + error.what());
    }
}

} // namespace

void write_results_hdf5(const StudyTable& table, const std::string& project, const std::string& study, const std::filesystem::path& path)
{
    hdf5::silence();
    ProjectJson names = ProjectJson::array();
    for (const StudyColumn& column : table.columns) names.push_back({column.name, static_cast<int>(column.role)});
    // In memory first: where the disk is full, the library ends the program when it closes the file.
    const Handle in_memory(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "properties");
    constexpr std::size_t more = std::size_t{1} << 20U;
    H5Pset_fapl_core(in_memory.get(), more, 0);
    const Handle file(H5Fcreate("a study in memory", H5F_ACC_TRUNC, H5P_DEFAULT, in_memory.get()), H5Fclose,
                      path.string() + ": The file cannot be created.");
    hdf5::write_text(file.get(), "project", project);
    hdf5::write_text(file.get(), "study", study);
    hdf5::write_text(file.get(), "columns", names.dump());
    {
        const Handle rows = hdf5::create_group(file.get(), "rows");
        for (const StudyColumn& column : table.columns) write_column(rows.get(), column);
    }
    if (H5Fflush(file.get(), H5F_SCOPE_LOCAL) < 0) throw FileError(path.string() + ": The memory does not suffice for the file.");
    std::string image(static_cast<std::size_t>(std::max<ssize_t>(0, H5Fget_file_image(file.get(), nullptr, 0))), '\0');
    if (H5Fget_file_image(file.get(), image.data(), image.size()) < 0)
        throw FileError(path.string() + ": The memory does not suffice for the file.");
    write_file(path, image);
}

StudyTable read_results_hdf5(const std::filesystem::path& path)
{
    hdf5::silence();
    const std::unique_ptr<RecordingSource> source = opened(path); // outlives the library's handle on it
    const Handle file = hdf5::open_file(*source, path.string() + ": This is no table of a study, or it is damaged.");
    const ProjectJson names = parse_json(hdf5::read_text(file.get(), "columns"), path.string());
    const Handle rows = hdf5::open_group(file.get(), "rows");
    StudyTable table;
    hsize_t count = HSIZE_UNDEF;
    std::uint64_t room = least_room + 3 * source->size();
    for (const ProjectJson& name : array_in(names, path.string(), "columns")) {
        if (table.columns.size() == most_table_columns || !name.is_array() || name.size() != 2 || !name[0].is_string() ||
            !name[1].is_number_unsigned() || name[1].get<unsigned>() > static_cast<unsigned>(Role::reason))
            throw FileError(path.string() + ": columns: This is no table of a study.");
        table.columns.push_back({name[0].get<std::string>(), static_cast<Role>(name[1].get<int>()), true, {}, {}, {}});
        read_column(rows.get(), table.columns.back(), count, room, path.string());
        if (!has_type_of_role(table.columns.back()))
            throw FileError(
                fmt::format("{}: rows/{}: This has words for numbers, or numbers for words.", path.string(), table.columns.back().name));
    }
    for (const Role role : {Role::point, Role::replicate, Role::status})
        if (!table.find(role)) throw FileError(path.string() + ": columns: The point, the replicate or the status is missing.");
    return table;
}

} // namespace hygroloom
