// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/poly_data.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>

#include <bit>
#include <fstream>

namespace hygroloom {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

template <typename T> std::size_t size_of(const std::vector<T>& values) { return values.size() * sizeof(T); }
template <typename T> const char* first_of(const std::vector<T>& values) { return reinterpret_cast<const char*>(values.data()); }

} // namespace

void PolyData::add_bytes(const char* type, const char* name, int components, Bytes bytes)
{
    text_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type, name,
                         components, offset_);
    arrays_.push_back(bytes);
    offset_ += sizeof(std::uint64_t) + bytes.bytes;
}

void PolyData::add(const char* name, const std::vector<float>& values, int components)
{
    add_bytes("Float32", name, components, {first_of(values), size_of(values)});
}
void PolyData::add(const char* name, const std::vector<double>& values, int components)
{
    add_bytes("Float64", name, components, {first_of(values), size_of(values)});
}
void PolyData::add(const char* name, const std::vector<std::int32_t>& values)
{
    add_bytes("Int32", name, 1, {first_of(values), size_of(values)});
}
void PolyData::add(const char* name, const std::vector<std::uint8_t>& values)
{
    add_bytes("UInt8", name, 1, {first_of(values), size_of(values)});
}

void PolyData::add_words(const char* name, const std::vector<std::string>& words)
{
    std::string codes; // VTK writes the bytes of a word as numbers, with a 0 after each word
    for (const std::string& word : words) {
        for (const char letter : word) codes += fmt::format("{} ", static_cast<unsigned>(static_cast<unsigned char>(letter)));
        codes += "0 ";
    }
    words_ += fmt::format("<DataArray type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">{}</DataArray>\n", name,
                          words.size(), codes);
}

void PolyData::write(const std::filesystem::path& path, double time, const Counts& counts) const
{
    write_file_with(path, [&](const std::filesystem::path& temporary) {
        std::ofstream file(temporary, std::ios::binary);
        file << "<?xml version=\"1.0\"?>\n"
                "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n"
             << fmt::format("<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}"
                            "</DataArray>{}</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                            "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
                            time, words_, counts.points, counts.verts, counts.lines, counts.polys)
             << text_ << "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
        for (const Bytes& array : arrays_) {
            const auto size = static_cast<std::uint64_t>(array.bytes);
            file.write(reinterpret_cast<const char*>(&size), sizeof size);
            file.write(array.first, static_cast<std::streamsize>(array.bytes));
        }
        file << "\n</AppendedData>\n</VTKFile>\n";
        file.close();
        if (!file) throw FileError(path.string() + ": The file cannot be written; the disk may be full.");
    });
}

} // namespace hygroloom
