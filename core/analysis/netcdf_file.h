// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Arrays as a file of NetCDF's classic format with 64-bit offsets (CDF-2), which xarray, Octave, R, Panoply and others open.
#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace hygroloom {

enum class NetcdfType : std::int32_t { whole = 4, single = 5, number = 6 }; ///< int, float, double

/// First all dimensions, attributes and variables, then their values in one go: those that do not change with the records in the order in
/// which they were added, then record by record the others in theirs.
class NetcdfWriter {
public:
    /// The first dimension of what changes: how many records there are.
    NetcdfWriter(std::ostream& to, const std::string& record_name, std::size_t records);

    /// Returns its number for variables.
    int dimension(const std::string& name, std::size_t size);
    void attribute(const std::string& name, const std::string& value);
    /// changes: with each record. title: empty where there is none.
    void variable(const std::string& name, NetcdfType type, bool changes, const std::vector<int>& dimensions, const std::string& unit,
                  const std::string& title = {});
    /// What is said of the values. Throws Error where the format has no room for a record of one variable.
    void write_head();
    void put(std::span<const std::int32_t> values) { put_numbers<std::uint32_t>(values); }
    void put(std::span<const float> values) { put_numbers<std::uint32_t>(values); }
    void put(std::span<const double> values) { put_numbers<std::uint64_t>(values); }

private:
    using Attributes = std::vector<std::pair<std::string, std::string>>;
    struct Dimension {
        std::string name;
        std::size_t size; ///< 0: that of the records
    };
    struct Variable {
        std::string name;
        NetcdfType type;
        bool changes;
        std::vector<int> dimensions;
        Attributes attributes;
        std::uint64_t bytes = 0; ///< of one record, or of all
    };
    template <typename Bits, typename Number> void put_numbers(std::span<const Number> values);
    void append(std::uint64_t number, int bytes);
    void append_text(const std::string& text);
    void append_attributes(const Attributes& attributes);
    void append_variable(const Variable& variable, std::uint64_t begin);

    std::ostream& to_;
    std::size_t records_;
    std::vector<Dimension> dimensions_;
    Attributes attributes_;
    std::vector<Variable> variables_;
    std::string out_; ///< bytes that are written next
};

} // namespace hygroloom
