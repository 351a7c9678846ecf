// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/frame_changes.h"

#include "core/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace hygroloom {

namespace {

constexpr const char* back_name = "changes/back";
constexpr int changes_level = 5;             // of zlib
constexpr int whole_every = 16;              // frames
constexpr int most_followed = 64;            // frames that a reader follows: a stranger's file could lead back through all of them
constexpr std::int64_t most_steps = 1 << 24; // of which a float is the exact number
constexpr int float_bits = 24;               // of these the first is not stored

/// A change as a number that is small when the change is: 0, -1, 1, -2, 2 …
std::uint32_t folded(std::int64_t change) { return static_cast<std::uint32_t>(change < 0 ? -2 * change - 1 : 2 * change); }
std::int64_t unfolded(std::uint32_t number)
{
    const std::int64_t half = number >> 1U;
    return number % 2 == 0 ? half : -half - 1;
}

/// Whether all values have one.
bool to_codes(const ValueCodes& how, const std::vector<float>& values, std::vector<std::int32_t>& codes)
{
    codes.resize(values.size());
    bool all = true;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::optional<std::int32_t> code = how.of(values[i]);
        codes[i] = code.value_or(0);
        all = all && code.has_value();
    }
    return all;
}

static_assert(std::all_of(std::begin(frame_fields), std::end(frame_fields), [](const FrameField& f) { return f.bits > 0 || f.step > 0; }),
              "a field that is not rounded has no codes");
ValueCodes codes_of(const FrameField& field) { return field.bits > 0 ? ValueCodes{0, field.bits} : ValueCodes{field.step, 0}; }

std::string number_name(const std::string& field) { return "changes/" + field; }

/// The file has one number for either: a step is a power of two up to 1, what is more are bits.
double stored(const ValueCodes& how) { return how.bits > 0 ? how.bits : static_cast<double>(how.step); }
std::optional<ValueCodes> from_stored(double number)
{
    if (number >= 2 && number < float_bits && number == std::floor(number)) return ValueCodes{0, static_cast<int>(number)};
    if (number >= 0x1p-40 && number <= 1 && std::exp2(std::round(std::log2(number))) == number)
        return ValueCodes{static_cast<float>(number), 0};
    return std::nullopt;
}

} // namespace

bool keeps_changes(std::size_t values, bool shows_cells)
{
    constexpr std::size_t least = 4096;   // fewer take little room, and whoever reads them elsewhere has plain values
    constexpr std::size_t most = 4 << 20; // what is followed lies in memory as a whole
    return values >= least && values <= most && !shows_cells;
}

std::optional<std::int32_t> ValueCodes::of(float value) const
{
    const auto as_bits = std::bit_cast<std::uint32_t>(value);
    if (bits == 0) {
        const float steps = value / step;
        if (!(steps >= 0 && steps <= static_cast<float>(most_steps))) return std::nullopt;
        const auto code = static_cast<std::int32_t>(steps);
        return std::bit_cast<std::uint32_t>(static_cast<float>(code) * step) == as_bits ? std::optional(code) : std::nullopt;
    }
    const int dropped = float_bits - bits;
    if ((as_bits & ((1U << dropped) - 1)) != 0 || !std::isfinite(value) || std::signbit(value)) return std::nullopt;
    return static_cast<std::int32_t>(as_bits >> dropped);
}

std::int64_t ValueCodes::most() const
{
    constexpr std::int64_t largest_float = 0x7f7fffff; // as bits
    return bits == 0 ? most_steps : largest_float >> (float_bits - bits);
}

float ValueCodes::value(std::int32_t code) const
{
    return bits == 0 ? static_cast<float>(code) * step : std::bit_cast<float>(static_cast<std::uint32_t>(code) << (float_bits - bits));
}

/// Along a yarn the next segment but one lies on the same face of plain weave; bundles lie on both.
ChangesWriter::ChangesWriter(RunFileWriter& file, bool in_bundles) : back_(in_bundles ? 1 : 2), codes_(std::size(frame_fields))
{
    file.number(back_name, static_cast<double>(back_));
    for (const FrameField& field : frame_fields) file.number(number_name(field.name), stored(codes_of(field)));
}

/// From the last frame to this one. Returns whether changes_ tells all of it.
bool ChangesWriter::follow(const Frame& frame)
{
    const std::size_t n = frame.saturation.size();
    bool tells_all = ++since_whole_ < whole_every && n > back_;
    changes_.resize(n * codes_.size());
    change_.resize(n);
    for (std::size_t k = 0; k < codes_.size(); ++k) {
        std::vector<std::int32_t>& last = codes_[k];
        std::swap(last, change_);
        if (!to_codes(codes_of(frame_fields[k]), frame_fields[k].in(frame), last)) last.clear();
        tells_all = tells_all && last.size() == n && change_.size() == n;
        if (!tells_all) continue;
        for (std::size_t i = 0; i < n; ++i) change_[i] = last[i] - change_[i];
        std::uint32_t* const to = changes_.data() + k * n;
        for (std::size_t i = 0; i < back_; ++i) to[i] = folded(change_[i]);
        for (std::size_t i = back_; i < n; ++i) to[i] = folded(std::int64_t{change_[i]} - change_[i - back_]);
    }
    return tells_all;
}

bool ChangesWriter::write(RunRow& row, const Frame& frame)
{
    if (!follow(frame)) {
        since_whole_ = 0;
        return false;
    }
    const std::size_t n = frame.saturation.size();
    row.number(follows_column, 1);
    for (std::size_t k = 0; k < codes_.size(); ++k)
        row.field(frame_fields[k].name, std::span<const std::uint32_t>(changes_).subspan(k * n, n), changes_level);
    return true;
}

ChangesReader::ChangesReader(const RunFileReader& file)
{
    constexpr long farthest = 64;
    back_ = static_cast<std::size_t>(file.count(back_name, 1, farthest));
    for (const TableColumn& column : file.columns()) {
        const std::string name = number_name(column.name);
        if (!file.has(name)) continue;
        const std::optional<ValueCodes> how = from_stored(file.number(name));
        if (!how) throw FileError(fmt::format("\"{}\" does not say how values are rounded.", name));
        fields_[column.name].how = *how;
    }
}

/// At the last frame up to this one that has the field's values, or at the one that was found last.
void ChangesReader::begin(Field& field, const std::string& name, const RunFileReader& file, std::int64_t number, std::size_t count)
{
    const std::int64_t farthest = number - most_followed; // whatever was found before
    for (; number >= std::max<std::int64_t>(0, farthest); --number) {
        if (field.number == number && field.codes.size() == count && field.whole >= farthest) return;
        const StoredRow row = file.row(number, {follows_column, name});
        if (row.has(follows_column)) continue;
        field.number = -1;
        if (!to_codes(field.how, row.floats(name, count), field.codes))
            throw FileError(fmt::format("\"{}\" of frame {}, from which it follows, has values that no frame shows.", name, number));
        field.number = field.whole = number;
        return;
    }
    throw FileError(fmt::format("the frames from which its \"{}\" follows lead too far back.", name));
}

void ChangesReader::add(Field& field, const std::string& name, const RunFileReader& file, std::int64_t number, std::size_t count)
{
    const std::vector<std::uint32_t> changes = file.row(number, {name}).counts(name, count);
    field.number = -1; // until it is whole
    change_.resize(count);
    const std::int64_t most = field.how.most();
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t change = unfolded(changes[i]) + (i < back_ ? 0 : change_[i - back_]), code = field.codes[i] + change;
        if (code < 0 || code > most) throw FileError(fmt::format("\"{}\" changes to what is no value.", name));
        change_[i] = change;
        field.codes[i] = static_cast<std::int32_t>(code);
    }
    field.number = number;
}

std::vector<float> ChangesReader::values(const RunFileReader& file, std::int64_t number, const std::string& name, std::size_t count)
{
    const auto found = fields_.find(name);
    if (found == fields_.end())
        throw FileError(fmt::format("\"{}\" is missing; the recording is damaged or no recording.", number_name(name)));
    Field& field = found->second;
    begin(field, name, file, number, count);
    while (field.number < number) add(field, name, file, field.number + 1, count);
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = field.how.value(field.codes[i]);
    return values;
}

} // namespace hygroloom
