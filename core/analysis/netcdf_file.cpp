// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The format: https://docs.unidata.ucar.edu/netcdf-c/current/file_format_specifications.html
#include "core/analysis/netcdf_file.h"

#include "core/base/error.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace hygroloom {
namespace {

constexpr std::uint64_t of_dimensions = 0x0A, of_variables = 0x0B, of_attributes = 0x0C, of_text = 2; // tags of lists; type of attributes
constexpr std::uint64_t most_of_variable = 0xFFFFFFFC;                                                // of a variable, or of its record

} // namespace

NetcdfWriter::NetcdfWriter(std::ostream& to, const std::string& record_name, std::size_t records) : to_(to), records_(records)
{
    dimensions_.push_back({record_name, 0});
}

int NetcdfWriter::dimension(const std::string& name, std::size_t size)
{
    dimensions_.push_back({name, size});
    return static_cast<int>(dimensions_.size()) - 1;
}

void NetcdfWriter::attribute(const std::string& name, const std::string& value) { attributes_.emplace_back(name, value); }

void NetcdfWriter::variable(const std::string& name, NetcdfType type, bool changes, const std::vector<int>& dimensions,
                            const std::string& unit, const std::string& title)
{
    Variable variable{name, type, changes, dimensions, {{"units", unit}}, type == NetcdfType::number ? 8U : 4U};
    if (!title.empty()) variable.attributes.emplace_back("long_name", title);
    for (const int dimension : dimensions) variable.bytes *= dimensions_[static_cast<std::size_t>(dimension)].size;
    if (variable.bytes > most_of_variable)
        throw Error(fmt::format("{} takes {} bytes a frame; NetCDF holds {} at most.", name, variable.bytes, most_of_variable));
    variables_.push_back(std::move(variable));
}

/// The highest byte first.
void NetcdfWriter::append(std::uint64_t number, int bytes)
{
    for (int k = bytes - 1; k >= 0; --k) out_ += static_cast<char>(number >> (8 * k) & 0xFF);
}

/// To whole fours of bytes.
void NetcdfWriter::append_text(const std::string& text)
{
    append(text.size(), 4);
    out_ += text;
    out_.append((4 - text.size() % 4) % 4, '\0');
}

void NetcdfWriter::append_attributes(const Attributes& attributes)
{
    append(of_attributes, 4);
    append(attributes.size(), 4);
    for (const auto& [name, value] : attributes) {
        append_text(name);
        append(of_text, 4);
        append_text(value);
    }
}

void NetcdfWriter::append_variable(const Variable& variable, std::uint64_t begin)
{
    append_text(variable.name);
    append(variable.dimensions.size() + (variable.changes ? 1 : 0), 4);
    if (variable.changes) append(0, 4);
    for (const int dimension : variable.dimensions) append(static_cast<std::uint64_t>(dimension), 4);
    append_attributes(variable.attributes);
    append(static_cast<std::uint64_t>(variable.type), 4);
    append(variable.bytes, 4);
    append(begin, 8);
}

void NetcdfWriter::write_head()
{
    out_ = "CDF\2";
    append(records_, 4);
    append(of_dimensions, 4);
    append(dimensions_.size(), 4);
    for (const Dimension& dimension : dimensions_) {
        append_text(dimension.name);
        append(dimension.size, 4);
    }
    append_attributes(attributes_);
    append(of_variables, 4);
    append(variables_.size(), 4);
    const std::size_t before = out_.size();
    for (const Variable& variable : variables_) append_variable(variable, 0);
    std::uint64_t begin = out_.size(); // now known
    out_.resize(before);
    std::vector<std::uint64_t> begins(variables_.size());
    for (const bool changes : {false, true})
        for (std::size_t k = 0; k < variables_.size(); ++k)
            if (variables_[k].changes == changes) {
                begins[k] = begin;
                begin += variables_[k].bytes;
            }
    for (std::size_t k = 0; k < variables_.size(); ++k) append_variable(variables_[k], begins[k]);
    to_.write(out_.data(), static_cast<std::streamsize>(out_.size()));
}

template <typename Bits, typename Number> void NetcdfWriter::put_numbers(std::span<const Number> values)
{
    out_.clear();
    for (const Number value : values) append(std::bit_cast<Bits>(value), sizeof(Bits));
    to_.write(out_.data(), static_cast<std::streamsize>(out_.size()));
}

template void NetcdfWriter::put_numbers<std::uint32_t>(std::span<const std::int32_t>);
template void NetcdfWriter::put_numbers<std::uint32_t>(std::span<const float>);
template void NetcdfWriter::put_numbers<std::uint64_t>(std::span<const double>);

} // namespace hygroloom
