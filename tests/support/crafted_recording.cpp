// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "tests/support/crafted_recording.h"

#include "tests/support/drop_design.h"

#include <hdf5.h>

#include <algorithm>
#include <limits>

namespace hygroloom {
namespace {

constexpr double values[] = {0,     1,    -1,     2,      0.5,
                             1e300, 1e18, -1e300, 1e-310, std::numeric_limits<double>::quiet_NaN(),
                             3e9,   1e38, 4000,   -0.0,   std::numeric_limits<double>::infinity()};

constexpr const char* words[] = {"",
                                 "hygroloom-recording",
                                 "\xFF\xFE\x80",
                                 "\x1b]0;x\x07\x1b[31m",
                                 "{}",
                                 "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[",
                                 "{\"region\":{\"first_end\":-1,\"first_pick\":-2147483648,\"ends\":2147483647,\"picks\":1}}",
                                 "18446744073709551616",
                                 "-1",
                                 "1e9",
                                 "cloth",
                                 "drop",
                                 "2026-11-22T18:40:12Z",
                                 "null"};

/// Closes on the way out; a craft that the library refuses is left undone.
class Owned {
public:
    Owned(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Owned()
    {
        if (id_ >= 0) close_(id_);
    }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    operator hid_t() const { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

Owned text_type(std::size_t size)
{
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, size);
    return {type, H5Tclose};
}

Owned strange_type(std::size_t which)
{
    switch (which) {
    case 0: return {H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose};
    case 1: return {H5Tcopy(H5T_NATIVE_FLOAT), H5Tclose};
    case 2: return {H5Tcopy(H5T_IEEE_F64BE), H5Tclose};
    case 3: return {H5Tcopy(H5T_STD_I8LE), H5Tclose};
    case 4: return {H5Tcopy(H5T_NATIVE_LLONG), H5Tclose};
    case 5: return text_type(1);
    case 6: return text_type(4000);
    case 7: return text_type(H5T_VARIABLE);
    case 8: return {H5Tcreate(H5T_OPAQUE, 64), H5Tclose};
    case 9: {
        const hid_t type = H5Tcreate(H5T_COMPOUND, 4096);
        H5Tinsert(type, "value", 4088, H5T_NATIVE_DOUBLE);
        return {type, H5Tclose};
    }
    case 10: {
        const std::array<hsize_t, 2> extents{64, 64};
        return {H5Tarray_create2(H5T_NATIVE_DOUBLE, 2, extents.data()), H5Tclose};
    }
    case 11: return {H5Tvlen_create(H5T_NATIVE_DOUBLE), H5Tclose};
    case 12: return {H5Tcopy(H5T_STD_REF_OBJ), H5Tclose};
    case 13: {
        const hid_t type = H5Tcopy(H5T_IEEE_F64LE); // of 16 bits at a strange place
        H5Tset_fields(type, 40, 30, 8, 5, 20);
        return {type, H5Tclose};
    }
    default: return {H5Tenum_create(H5T_NATIVE_INT), H5Tclose};
    }
}
constexpr std::size_t strange_types = 15;

Owned strange_space(std::size_t which)
{
    constexpr hsize_t unlimited[] = {H5S_UNLIMITED, 13};
    const auto simple = [](std::vector<hsize_t> sizes) {
        return Owned(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose);
    };
    switch (which) {
    case 0: return {H5Screate(H5S_SCALAR), H5Sclose};
    case 1: return {H5Screate(H5S_NULL), H5Sclose};
    case 2: return simple({1});
    case 3: return simple({4000});
    case 4: return simple({0});
    case 5: return simple({3, 13});
    case 6: return simple({20'000'000, 13});
    case 7: return simple({1, 1, 1, 1, 1, 1, 1, 1});
    case 8: return simple({2'000, 3});
    case 9: return simple({std::uint64_t(1) << 40, 3});
    case 10: {
        const hsize_t now[] = {3, 13};
        return {H5Screate_simple(2, now, unlimited), H5Sclose};
    }
    default: return simple({65536});
    }
}
constexpr std::size_t strange_spaces = 12;

Owned strange_layout(std::size_t which, int rank)
{
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    const std::vector<hsize_t> small(static_cast<std::size_t>(rank), 1), large(static_cast<std::size_t>(rank), 4'000'000'000 / 8);
    const auto chunked = [&](const std::vector<hsize_t>& chunk) {
        if (rank > 0) H5Pset_chunk(properties, rank, chunk.data());
    };
    switch (which) {
    case 1: H5Pset_layout(properties, H5D_COMPACT); break;
    case 2: chunked(small); break;
    case 3: chunked(large); break;
    case 4: H5Pset_external(properties, "/etc/passwd", 0, H5F_UNLIMITED); break;
    case 5:
        chunked(small);
        H5Pset_deflate(properties, 9);
        break;
    case 6:
        chunked(small);
        H5Pset_fletcher32(properties);
        break;
    case 7:
        chunked(small);
        H5Pset_filter(properties, 32001, H5Z_FLAG_OPTIONAL, 0, nullptr);
        break;
    case 8:
        chunked(small);
        H5Pset_shuffle(properties);
        H5Pset_nbit(properties);
        break;
    default: break;
    }
    return {properties, H5Pclose};
}
constexpr std::size_t strange_layouts = 9;

/// As many bytes as the values take, at least one number.
std::vector<double> filled(hid_t space, hid_t type, double value)
{
    const hssize_t count = std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space));
    return std::vector<double>(static_cast<std::size_t>(count) * H5Tget_size(type) / sizeof(double) + 1, value);
}

template <typename Names> const char* one_of(const Names& names, Choices& choices) { return names[choices.of(std::size(names))]; }

std::string change_number(hid_t file, const CraftTargets& targets, Choices& choices)
{
    const auto& [group_name, name] = targets.numbers[choices.of(targets.numbers.size())];
    const Owned group(H5Gopen2(file, group_name, H5P_DEFAULT), H5Gclose);
    if (group < 0) return "nothing";
    H5Adelete(group, name);
    const std::size_t how = choices.of(3), type_choice = choices.of(strange_types), space_choice = choices.of(4);
    if (how == 0) return std::string("no ") + name;
    const Owned type = how == 1 ? strange_type(0) : strange_type(type_choice);
    const Owned space = how == 1 ? strange_space(0) : strange_space(space_choice);
    const Owned attribute(H5Acreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const std::vector<double> content = filled(space, type, values[choices.of(std::size(values))]);
    if (attribute >= 0 && type_choice != 7 && type_choice != 11) H5Awrite(attribute, type, content.data());
    return std::string("number ") + group_name + "/" + name + " as type " + std::to_string(how == 1 ? 0 : type_choice) + ", space " +
           std::to_string(how == 1 ? 0 : space_choice) + " of " + std::to_string(content[0]);
}

std::string change_text(hid_t file, const CraftTargets& targets, Choices& choices)
{
    const char* name = one_of(targets.texts, choices);
    const std::string word = one_of(words, choices);
    H5Ldelete(file, name, H5P_DEFAULT);
    const Owned type = text_type(word.size() + 1), space(H5Screate(H5S_SCALAR), H5Sclose);
    const Owned set(H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    if (set >= 0) H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, word.c_str());
    return std::string("text ") + name + " is " + word;
}

std::string change_set(hid_t file, const CraftTargets& targets, Choices& choices)
{
    const char* name = choices.of(2) == 0 ? one_of(targets.texts, choices) : one_of(targets.sets, choices);
    H5Ldelete(file, name, H5P_DEFAULT);
    const std::size_t type_choice = choices.of(strange_types), space_choice = choices.of(strange_spaces),
                      layout_choice = choices.of(strange_layouts);
    const Owned type = strange_type(type_choice), space = strange_space(space_choice);
    const Owned layout = strange_layout(layout_choice, H5Sget_simple_extent_ndims(space));
    const Owned set(H5Dcreate2(file, name, type, space, H5P_DEFAULT, layout, H5P_DEFAULT), H5Dclose);
    const bool is_small = H5Sget_simple_extent_npoints(space) <= 6000 && H5Tget_size(type) <= 4096;
    if (set >= 0 && is_small && layout_choice != 4 && type_choice != 7 && type_choice != 11) {
        const std::vector<double> content = filled(space, type, values[choices.of(std::size(values))]);
        H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, content.data());
    }
    return std::string("set ") + name + " as type " + std::to_string(type_choice) + ", space " + std::to_string(space_choice) +
           ", layout " + std::to_string(layout_choice);
}

std::string change_link(hid_t file, const CraftTargets& targets, Choices& choices)
{
    const std::size_t kind = choices.of(3);
    const char* name = kind == 0   ? one_of(targets.texts, choices)
                       : kind == 1 ? one_of(targets.sets, choices)
                                   : one_of(targets.groups, choices);
    H5Ldelete(file, name, H5P_DEFAULT);
    switch (choices.of(6)) {
    case 0: return std::string("no ") + name;
    case 1: H5Lcreate_soft("/nowhere", file, name, H5P_DEFAULT, H5P_DEFAULT); return std::string("dangling ") + name;
    case 2: H5Lcreate_soft(name, file, name, H5P_DEFAULT, H5P_DEFAULT); return std::string("link to itself ") + name;
    case 3: H5Lcreate_external("/etc/passwd", "/", file, name, H5P_DEFAULT, H5P_DEFAULT); return std::string("external ") + name;
    case 4: H5Lcreate_hard(file, "/", file, name, H5P_DEFAULT, H5P_DEFAULT); return std::string("the root as ") + name;
    default: H5Lcreate_hard(file, "/ledger", file, name, H5P_DEFAULT, H5P_DEFAULT); return std::string("the ledger as ") + name;
    }
}

/// In place, as a flipped bit would.
std::string change_values(hid_t file, const CraftTargets& targets, Choices& choices)
{
    const char* name = one_of(targets.sets, choices);
    const Owned set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const Owned space(H5Dget_space(set), H5Sclose);
    const hssize_t count = set < 0 ? 0 : H5Sget_simple_extent_npoints(space);
    if (count <= 0 || count > 100'000) return "nothing";
    std::vector<double> content(static_cast<std::size_t>(count));
    H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, content.data());
    const std::size_t at = choices.of(content.size());
    content[at] = values[choices.of(std::size(values))];
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, content.data());
    return std::string("value ") + std::to_string(at) + " of " + name + " is " + std::to_string(content[at]);
}

/// A number in a text of JSON.
std::string change_json(hid_t file, const CraftTargets& targets, Choices& choices)
{
    const char* name = one_of(targets.jsons, choices);
    const Owned set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const Owned type(H5Dget_type(set), H5Tclose), extent(H5Dget_space(set), H5Sclose);
    if (set < 0 || H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 || H5Sget_simple_extent_npoints(extent) != 1)
        return "nothing";
    std::string text(H5Tget_size(type), '\0');
    if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0 || text.empty()) return "nothing";
    const std::size_t from = (choices.of(256) * 256 + choices.of(256)) % text.size();
    const std::size_t digit = text.find_first_of("0123456789", from);
    if (digit == std::string::npos) return "nothing";
    const std::size_t end = text.find_first_not_of("0123456789.eE+-", digit);
    constexpr const char* strange[] = {"-1",     "0",    "1e308", "2147483647", "-2147483648",         "4294967296",
                                       "1e-300", "null", "\"\"",  "[]",         "99999999999999999999"};
    const std::string value = one_of(strange, choices);
    text.replace(digit, (end == std::string::npos ? text.size() : end) - digit, value);
    H5Ldelete(file, name, H5P_DEFAULT);
    const Owned new_type = text_type(text.size()), space(H5Screate(H5S_SCALAR), H5Sclose);
    const Owned again(H5Dcreate2(file, name, new_type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    if (again >= 0) H5Dwrite(again, new_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
    return std::string("number at ") + std::to_string(digit) + " of " + name + " is " + value;
}

} // namespace

RunRecord small_run()
{
    RunRecord run;
    run.design = drop_design();
    run.fabric = run.design.fabrics[0].name;
    run.experiment = run.design.experiments[0].name;
    const std::array<double, 2> sample = run.design.experiments[0].sample_mm;
    run.plan.region = region_of_sample(run.design.fabrics[0], sample[0], sample[1]);
    run.textile = build_textile(run.design, run.design.fabrics[0], run.plan.region);
    run.backend = "cpu";
    run.device = "a device";
    run.date = "2026-11-22T18:40:12Z";
    return run;
}

Frame small_frame(const RunRecord& run, int number)
{
    Frame frame;
    const auto n = static_cast<std::size_t>(run.textile.segments());
    frame.time = frame.ledger.time = 0.1 * number;
    frame.resize_fields(n);
    for (std::size_t i = 0; i < n; ++i) frame.saturation[i] = static_cast<float>(i % 7) / 7;
    frame.temperature.assign(n, 293.15F);
    frame.positions.assign(static_cast<std::size_t>(number), {0.001F, 0, 0.002F});
    frame.velocities.assign(static_cast<std::size_t>(number), {0, 0, -1});
    return frame;
}

void write_small_recording(const std::string& path)
{
    const RunRecord run = small_run();
    RecordingWriter writer(path, run);
    for (int k = 0; k < 3; ++k) writer.append(small_frame(run, k));
    writer.note_device("a device; from 0.1 s on another");
    writer.note_switched_on({.name = "heat", .time = 0.1, .share = 0.1, .limit = 0.01, .estimate = 0.2, .kept_off = "the run was over"});
    writer.finish(1);
}

const CraftTargets& targets_of_a_sample()
{
    static const CraftTargets targets{{{"/", "version"},
                                       {"/", "wall_s"},
                                       {"/provenance", "threads"},
                                       {"/provenance", "wall_s"},
                                       {"/provenance/switched_on/heat", "time_s"},
                                       {"/provenance/switched_on/heat", "share"},
                                       {"/provenance/switched_on/heat", "estimate"},
                                       {"/frames/000000", "time_s"},
                                       {"/frames/000001", "time_s"},
                                       {"/frames/000001", "water_top_kg"},
                                       {"/frames/000002", "water_bottom_kg"}},
                                      {"/format", "/design", "/provenance/fabric", "/provenance/experiment", "/provenance/backend",
                                       "/provenance/device", "/provenance/all_devices", "/provenance/plan", "/provenance/date",
                                       "/provenance/seed", "/provenance/switched_on/heat/kept_off"},
                                      {"/ledger", "/frames/000000/saturation", "/frames/000001/liquid", "/frames/000001/temperature",
                                       "/frames/000001/particle_position", "/frames/000001/particle_velocity", "/frames/000002/bound_water",
                                       "/frames/000002/vapour_concentration", "/frames/000002/liquid_between", "/textile/length"},
                                      {"/frames", "/frames/000000", "/frames/000001", "/provenance", "/provenance/switched_on", "/textile"},
                                      {"/provenance/plan", "/design"}};
    return targets;
}

std::string craft(const std::string& path, Choices choices, const CraftTargets& targets)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const Owned file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    if (file < 0) return "not opened";
    using Change = std::string (*)(hid_t, const CraftTargets&, Choices&);
    constexpr Change changes[] = {change_number, change_text, change_set, change_set, change_link, change_values, change_json, change_json};
    std::string did;
    do did += (did.empty() ? "" : "; ") + changes[choices.of(std::size(changes))](file, targets, choices);
    while (choices.any_left());
    return did;
}

} // namespace hygroloom
