// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Weaves drawn as text or as pictures, and the choice of a reader.
#include "core/base/error.h"
#include "core/design/jam.h"
#include "core/design/weave_analysis.h"
#include "core/project/atomic_file.h"
#include "core/project/wif_file.h"
#include "core/project/wif_private.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

[[noreturn]] void refuse_size(const std::string& name, long long ends, long long picks)
{
    throw FileError(
        fmt::format("{}: The drawing has {} ends and {} picks; a weave has from 1 to {} of each.", name, ends, picks, largest_repeat));
}

/// Rows from the top, 1 = up.
DraftImport imported(const std::string& name, int ends, int picks, const std::vector<std::uint8_t>& from_top, const char* what)
{
    std::vector<std::uint8_t> up(from_top.size());
    const auto row = static_cast<std::size_t>(ends), rows = static_cast<std::size_t>(picks);
    for (std::size_t pick = 0; pick < rows; ++pick)
        std::copy_n(from_top.begin() + static_cast<std::ptrdiff_t>((rows - 1 - pick) * row), ends,
                    up.begin() + static_cast<std::ptrdiff_t>(pick * row));
    DraftImport result;
    Fabric& fabric = result.fabric;
    fabric.name = cut_text(name_of_file(name), longest_name);
    if (fabric.name.empty()) fabric.name = "weave";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = assumed_diameter_mm;
    fabric.weave = reduced({ends, picks, std::move(up)});
    const auto note = [&](std::string sentence) { result.report.push_back({Severity::note, std::move(sentence)}); };
    note(fmt::format("Read a {} of {} ends and {} picks; the top row is the last pick.", what, ends, picks));
    if (fabric.weave.ends() < ends || fabric.weave.picks() < picks)
        note(fmt::format("The weave repeats after {} ends and {} picks; one repeat was kept.", fabric.weave.ends(), fabric.weave.picks()));
    note(assumed_numbers(fabric));
    return result;
}

/// Brightness of each pixel from the top left, 0 to 255.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> grey;
};

Picture read_png(std::string_view bytes, const std::string& name)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()))
        throw FileError(fmt::format("{}: The picture cannot be read: {}.", name, image.message));
    if (image.width < 1 || image.height < 1 || image.width > largest_repeat || image.height > largest_repeat) {
        const auto [width, height] = std::pair(image.width, image.height);
        png_image_free(&image);
        refuse_size(name, width, height);
    }
    image.format = PNG_FORMAT_GRAY;
    Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
    picture.grey.resize(PNG_IMAGE_SIZE(image));
    const png_color white{255, 255, 255}; // behind what is transparent
    if (!png_image_finish_read(&image, &white, picture.grey.data(), 0, nullptr))
        throw FileError(fmt::format("{}: The picture cannot be read: {}.", name, image.message));
    return picture;
}

/// Uncompressed BMP of 1, 4, 8, 24 or 32 bits.
Picture read_bmp(std::string_view bytes, const std::string& name)
{
    const auto number = [&](std::size_t at, std::size_t length) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < length; ++i) value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
        return value;
    };
    const auto cut_short = [&] { return FileError(name + ": The picture ends too early."); };
    if (bytes.size() < 54) throw cut_short();
    const std::uint32_t data = number(10, 4), header = number(14, 4), bits = number(28, 2), compression = number(30, 4);
    const auto width = static_cast<std::int32_t>(number(18, 4)), signed_height = static_cast<std::int32_t>(number(22, 4));
    const long long height = std::abs(static_cast<long long>(signed_height)); // a negative one counts from the top
    if (header < 40 || compression != 0 || (bits != 1 && bits != 4 && bits != 8 && bits != 24 && bits != 32))
        throw FileError(name + ": Only uncompressed BMP pictures of 1, 4, 8, 24 or 32 bits are read; save the picture as PNG.");
    if (width < 1 || height < 1 || width > largest_repeat || height > largest_repeat) refuse_size(name, width, height);
    const std::size_t stride = (static_cast<std::size_t>(width) * bits + 31) / 32 * 4, palette = 14 + static_cast<std::size_t>(header);
    if (data > bytes.size() || stride * static_cast<std::size_t>(height) > bytes.size() - data) throw cut_short();
    Picture picture{width, static_cast<int>(height), {}};
    const auto brightness = [&](std::size_t at) { // blue, green, red
        return static_cast<std::uint8_t>((114 * number(at, 1) + 587 * number(at + 1, 1) + 299 * number(at + 2, 1)) / 1000);
    };
    for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row) {
        const std::size_t line = data + stride * (signed_height < 0 ? row : static_cast<std::size_t>(height) - 1 - row);
        for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
            if (bits >= 24) {
                picture.grey.push_back(brightness(line + x * bits / 8));
                continue;
            }
            const std::size_t bit = x * bits;
            const std::uint32_t index = (number(line + bit / 8, 1) >> (8 - bits - bit % 8)) & ((1u << bits) - 1);
            const std::size_t entry = palette + 4 * static_cast<std::size_t>(index);
            if (entry + 4 > bytes.size() || entry + 4 > data)
                throw FileError(name + ": The picture uses a colour that its palette does not have.");
            picture.grey.push_back(brightness(entry));
        }
    }
    return picture;
}

} // namespace

std::string assumed_numbers(const Fabric& fabric)
{
    return fmt::format("{} ends and {} picks per cm of cotton yarn {} mm across are assumed; give the real ones.", fabric.ends_per_cm,
                       fabric.picks_per_cm, *fabric.warp.diameter_mm);
}

/// The first of these rows with one of these marks; their number when there is none.
std::size_t first_line_with(std::string_view marks, const std::vector<std::string_view>& rows)
{
    const auto has = [marks](std::string_view row) { return row.find_first_of(marks) != std::string_view::npos; };
    return static_cast<std::size_t>(std::find_if(rows.begin(), rows.end(), has) - rows.begin());
}

DraftImport import_grid(std::string_view bytes, const std::string& name)
{
    const std::string text = decoded_text(bytes, name);
    std::vector<std::string_view> rows;
    for (std::string_view rest = text; !rest.empty();) {
        rows.push_back(take_line(rest));
        if (rows.size() > static_cast<std::size_t>(largest_repeat) + 1000) refuse_size(name, 0, static_cast<long long>(rows.size()));
    }
    while (!rows.empty() && rows.back().empty()) rows.pop_back();
    std::size_t empty = 0;
    while (empty < rows.size() && rows[empty].empty()) ++empty;
    rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(empty));
    std::size_t ends = 0;
    for (std::string_view row : rows) ends = std::max(ends, row.size());
    const auto limit = static_cast<std::size_t>(largest_repeat);
    if (ends < 1 || ends > limit || rows.size() > limit)
        refuse_size(name, static_cast<long long>(ends), static_cast<long long>(rows.size()));

    // Blanks are crossings only where x draws the others; there an editor may have cut them from a line's end.
    const std::size_t first_cross = first_line_with("xX", rows), first_other = first_line_with("01.#", rows);
    const bool crosses = first_cross < rows.size(), others = first_other < rows.size();
    if (crosses && others)
        throw FileError(fmt::format("{}: line {}: The drawing mixes x with other marks; use 0 and 1, or . and #, or blanks and x.", name,
                                    empty + std::max(first_cross, first_other) + 1));
    std::vector<std::uint8_t> up(ends * rows.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (!crosses && rows[row].size() != ends)
            throw FileError(fmt::format("{}: line {}: All rows need {} crossings as the longest; this one has {}.", name, empty + row + 1,
                                        ends, rows[row].size()));
        for (std::size_t end = 0; end < rows[row].size(); ++end) {
            const char mark = rows[row][end];
            const bool is_up = mark == '1' || mark == '#' || mark == 'x' || mark == 'X';
            if (!is_up && mark != '0' && mark != '.' && !(crosses && mark == ' '))
                throw FileError(
                    fmt::format("{}: line {}, column {}: A drawing is made of 0 and 1, of . and #, or of blanks and x (warp up).", name,
                                empty + row + 1, end + 1));
            up[row * ends + end] = is_up;
        }
    }
    return imported(name, static_cast<int>(ends), static_cast<int>(rows.size()), up, "drawing");
}

DraftImport import_picture(std::string_view bytes, const std::string& name)
{
    const Picture picture = bytes.starts_with("BM") ? read_bmp(bytes, name) : read_png(bytes, name);
    std::vector<std::uint8_t> up;
    bool greys = false;
    for (std::uint8_t grey : picture.grey) {
        up.push_back(grey < 128);
        greys = greys || (grey > 16 && grey < 239);
    }
    DraftImport result = imported(name, picture.width, picture.height, up, "picture");
    if (greys)
        result.report.push_back({Severity::warning, "The picture has greys or colours; what is darker than half was taken as warp up."});
    return result;
}

DraftImport import_draft(const std::filesystem::path& path, const Design& known)
{
    const std::string bytes = read_file(path, largest_import_bytes), name = path.string();
    if (bytes.starts_with("\x89PNG") || bytes.starts_with("BM")) return import_picture(bytes, name);
    if (bytes.starts_with("\xFF\xD8\xFF") || bytes.starts_with("GIF8") || bytes.starts_with("RIFF") || // JPEG, GIF, WebP and TIFF
        bytes.starts_with(std::string_view("II*\0", 4)) || bytes.starts_with(std::string_view("MM\0*", 4)))
        throw FileError(name + ": Of pictures only PNG and BMP are read; save it as one of them and import it again.");
    std::string ending = capitals(path.extension().string());
    const bool wif = ending == ".WIF" || bytes.find('[') != std::string::npos;
    return wif ? import_wif(bytes, name, known) : import_grid(bytes, name);
}

namespace {

/// Makes what was assumed smaller where yarns so thick have no room at such setts, until these are usual ones: diameters before setts.
void fit_assumed(DraftImport& draft, const std::vector<double*>& diameters, const std::vector<double*>& setts)
{
    Fabric& fabric = draft.fabric;
    const auto share = [&] {
        const JamGauge gauge =
            jam_gauge(fabric.weave, fabric.ends_per_cm, fabric.picks_per_cm, *fabric.warp.diameter_mm, *fabric.weft.diameter_mm);
        return 0.01 * std::max(gauge.warp.ashenhurst_percent, gauge.weft.ashenhurst_percent);
    };
    if (share() <= 1) return;
    for (const std::vector<double*>* assumed : {&diameters, &setts}) {
        for (int times = 0; times < 50 && share() > usual_share_of_ashenhurst && !assumed->empty(); ++times)
            for (double* const number : *assumed) *number *= 0.95;
        for (double* const number : *assumed) *number = 0.001 * std::round(1000 * *number);
    }
}

/// Yarns of other colours are like the base yarn of their system.
void fit_extra_yarns(Fabric& fabric)
{
    for (const auto& [order, yarn] : {std::pair(&fabric.weft_order, &fabric.weft), {&fabric.warp_order, &fabric.warp}})
        for (const YarnRun& run : *order)
            if (run.yarn > 0) fabric.extra_yarns[run.yarn - 1].diameter_mm = yarn->diameter_mm;
}

} // namespace

void take_suggestions(DraftImport& draft)
{
    Fabric& fabric = draft.fabric;
    const std::string assumed = assumed_numbers(fabric);
    const auto takes = [](const Suggestion& suggestion) { return suggestion.value && suggestion.plausible; };
    std::vector<double*> assumed_diameters, assumed_setts;
    for (const auto& [sett, value] : {std::pair(&draft.ends_per_cm, &fabric.ends_per_cm), {&draft.picks_per_cm, &fabric.picks_per_cm}})
        if (takes(*sett))
            *value = *sett->value;
        else
            assumed_setts.push_back(value);
    for (const auto& [diameter, yarn] : {std::pair(&draft.warp_diameter_mm, &fabric.warp), {&draft.weft_diameter_mm, &fabric.weft}}) {
        if (takes(*diameter))
            yarn->diameter_mm = *diameter->value;
        else if (yarn->diameter_mm)
            assumed_diameters.push_back(&*yarn->diameter_mm);
    }
    fit_assumed(draft, assumed_diameters, assumed_setts);
    fit_extra_yarns(fabric);
    std::string taken, left;
    const auto tell = [&](const Suggestion& suggestion, double value, const char* what) {
        std::string& list = takes(suggestion) ? taken : left;
        list += fmt::format("{}{} {:.4g}", list.empty() ? "" : ", ", what, value);
    };
    tell(draft.ends_per_cm, fabric.ends_per_cm, "ends per cm");
    tell(draft.picks_per_cm, fabric.picks_per_cm, "picks per cm");
    tell(draft.warp_diameter_mm, fabric.warp.diameter_mm.value(), "mm of warp diameter");
    tell(draft.weft_diameter_mm, fabric.weft.diameter_mm.value(), "mm of weft diameter");
    for (ImportLine& line : draft.report)
        if (!taken.empty() && line.text == assumed)
            line.text =
                fmt::format("Taken from the file: {}. Assumed: {}{}cotton; give the real ones.", taken, left, left.empty() ? "" : ", ");
}

} // namespace hygroloom
