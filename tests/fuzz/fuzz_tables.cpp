// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any bytes, as a table (CSV) of measurements, laboratory values, sweat by zone or sweat over time, either are refused with an Error, or
// become numbers that are finite and as many as the table's rows.
#include "core/analysis/laboratory_table.h"
#include "core/analysis/measured_data.h"
#include "core/base/error.h"
#include "core/garment/sweat_table.h"
#include "core/verify/set_ups.h"
#include "tests/fuzz/require.h"

#include <cmath>
#include <fstream>
#include <unistd.h>

using namespace hygroloom;

namespace {

template <typename Read> void attempt(const Read& read)
{
    try {
        read();
    } catch (const Error& error) {
        require(*error.what() != '\0', "a refusal says why");
    }
}

void as_measurements(const std::string& text)
{
    static const Design design = drop_on_cotton(2, 100, 35);
    const MeasuredData data = read_measured_data(text, "input.csv", design, design.fabrics[0], design.experiments[0]);
    for (const MeasuredNumber& number : data.numbers)
        require(std::isfinite(number.time) && std::isfinite(number.value) && std::isfinite(number.spread.value_or(0)),
                "what was measured is finite");
}

void as_laboratory(const std::string& text)
{
    for (const LaboratoryValue& value : read_laboratory_table(text, "input.csv", {"cotton", "linen"}, {{"absorbency_time_s", "s"}}))
        require(std::isfinite(value.value) && std::isfinite(value.spread.value_or(0)), "laboratory values are finite");
}

void as_sweat(const std::filesystem::path& file)
{
    attempt([&] {
        for (const double rate : sweat_table(file.filename().string(), file.parent_path()).g_m2_h)
            require(std::isfinite(rate) && rate >= 0, "a zone sweats a finite amount");
    });
    attempt([&] {
        const SweatCourse course = sweat_course(file.filename().string(), file.parent_path());
        require(course.rows > 0 && course.first_time <= course.last_time, "a course has rows");
        for (const auto& moments : course.zones)
            for (std::size_t i = 0; i < moments.size(); ++i)
                require(std::isfinite(moments[i].g_m2_h) && (i == 0 || moments[i - 1].time_s <= moments[i].time_s), "times go on");
    });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size);
    attempt([&] { as_measurements(text); });
    attempt([&] { as_laboratory(text); });
    const std::filesystem::path file = std::filesystem::temp_directory_path() / ("tables-" + std::to_string(::getpid()) + ".csv");
    std::ofstream(file, std::ios::binary) << text;
    as_sweat(file);
    return 0;
}
