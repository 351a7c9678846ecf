// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/frame_changes.h"

#include "core/base/error.h"
#include "core/run/hdf5_reader.h"
#include "core/run/recording_layout.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace hygroloom {

namespace h5 = hdf5;

namespace {

constexpr const char *in_frame = "changes", *of_file = "changes", *rows_name = "rows", *bundles_name = "in_bundles", *back_name = "back";
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
    constexpr std::size_t least = 4096; // fewer take little room, and whoever reads them elsewhere has plain values
    constexpr std::size_t most = h5::largest_chunk / sizeof(std::uint32_t); // a row is one piece
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
ChangesWriter::ChangesWriter(hid_t file, bool in_bundles) : back_(in_bundles ? 1 : 2), codes_(std::size(frame_fields))
{
    std::string names;
    const h5::Handle all = h5::create_group(file, of_file);
    h5::write_number(all.get(), bundles_name, in_bundles);
    h5::write_number(all.get(), back_name, static_cast<double>(back_));
    for (const FrameField& field : frame_fields) {
        names += (names.empty() ? "" : ",") + std::string(field.name);
        h5::write_number(all.get(), field.name, stored(codes_of(field)));
    }
    h5::write_text(all.get(), rows_name, names);
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

bool ChangesWriter::write(hid_t group, const Frame& frame)
{
    if (!follow(frame)) {
        since_whole_ = 0;
        return false;
    }
    h5::write_rows(group, in_frame, changes_, codes_.size());
    return true;
}

ChangesReader::ChangesReader(hid_t file)
{
    constexpr long farthest = 64;
    constexpr std::size_t most_rows = 100;
    const h5::Handle all = h5::open_group(file, of_file);
    in_bundles_ = h5::read_count(all.get(), bundles_name, 0, 1) == 1;
    back_ = static_cast<std::size_t>(h5::read_count(all.get(), back_name, 1, farthest));
    const std::string names = h5::read_text(all.get(), rows_name);
    for (std::size_t first = 0; first < names.size();) {
        const std::size_t last = std::min(names.find(',', first), names.size());
        const std::string field = names.substr(first, last - first);
        const std::optional<ValueCodes> how = from_stored(h5::read_number(all.get(), field));
        if (!how) throw FileError(fmt::format("\"{}/{}\" does not say how values are rounded.", of_file, field));
        if (rows_.size() == most_rows) throw FileError(fmt::format("\"{}/{}\" names too many fields.", of_file, rows_name));
        rows_.push_back({field, *how, -1, -1, {}});
        first = last + 1;
    }
}

/// At the last frame up to this one that has the field's values, or at the one that was found last.
void ChangesReader::begin(Row& row, hid_t frames, int number, std::size_t count)
{
    const int farthest = number - most_followed; // whatever was found before
    for (; number >= std::max(0, farthest); --number) {
        if (row.number == number && row.codes.size() == count && row.whole >= farthest) return;
        const h5::Handle group = h5::open_group(frames, frame_name(number));
        if (h5::exists(group.get(), in_frame)) continue;
        row.number = -1;
        if (!to_codes(row.how, h5::read_floats(group.get(), row.field, count), row.codes))
            throw FileError(fmt::format("\"{}\" of frame {}, from which it follows, has values that no frame shows.", row.field, number));
        row.number = row.whole = number;
        return;
    }
    throw FileError(fmt::format("the frames from which its \"{}\" follows lead too far back.", row.field));
}

void ChangesReader::add(Row& row, std::size_t place, hid_t frames, int number, std::size_t count)
{
    const h5::Handle group = h5::open_group(frames, frame_name(number));
    const std::vector<std::uint32_t> changes = h5::read_row(group.get(), in_frame, rows_.size(), count, place);
    row.number = -1; // until it is whole
    change_.resize(count);
    const std::int64_t most = row.how.most();
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t change = unfolded(changes[i]) + (i < back_ ? 0 : change_[i - back_]), code = row.codes[i] + change;
        if (code < 0 || code > most) throw FileError(fmt::format("\"{}\" changes to what is no value.", row.field));
        change_[i] = change;
        row.codes[i] = static_cast<std::int32_t>(code);
    }
    row.number = number;
}

std::optional<std::vector<float>> ChangesReader::values(hid_t frames, int number, const std::string& field, std::size_t count)
{
    const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& one) { return one.field == field; });
    if (row == rows_.end() || !h5::exists(h5::open_group(frames, frame_name(number)).get(), in_frame)) return std::nullopt;
    begin(*row, frames, number, count);
    while (row->number < number) add(*row, static_cast<std::size_t>(row - rows_.begin()), frames, row->number + 1, count);
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = row->how.value(row->codes[i]);
    return values;
}

} // namespace hygroloom
