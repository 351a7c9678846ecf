// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Prints a hash of each recorded field of a recording, over all frames: fingerprint drop.hygrorec. Two programs that print the same
// computed the same bytes. It reads HDF5 alone and knows nothing of the program, so that moves inside the program cannot change it. Who ran
// it, when and on what (/provenance, wall times) is left out.
#include <hdf5.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace {

/// FNV-1a, 64 bits.
struct Hash {
    std::uint64_t value = 0xcbf29ce484222325u;
    std::size_t bytes = 0;
    void add(const char* data, std::size_t count)
    {
        bytes += count;
        for (std::size_t i = 0; i < count; ++i) value = (value ^ static_cast<unsigned char>(data[i])) * 0x100000001b3u;
    }
};

using Hashes = std::map<std::string, Hash>;

bool belongs_to_the_result(const std::string& path) { return path.rfind("provenance", 0) != 0 && path.find("wall_s") == std::string::npos; }

/// All frames add to the hash of their field: frames/000012/liquid counts as frames/liquid.
std::string field_of(const std::string& path)
{
    if (path.rfind("frames/", 0) != 0) return path;
    const std::size_t slash = path.find('/', 7);
    return slash == std::string::npos ? "frames" : "frames" + path.substr(slash);
}

std::vector<char> read_dataset(hid_t dataset)
{
    const hid_t type = H5Dget_type(dataset), native = H5Tget_native_type(type, H5T_DIR_DEFAULT), space = H5Dget_space(dataset);
    std::vector<char> data;
    if (H5Tis_variable_str(type) > 0) {
        char* text = nullptr;
        H5Dread(dataset, native, H5S_ALL, H5S_ALL, H5P_DEFAULT, &text);
        if (text) data.assign(text, text + std::strlen(text));
        H5free_memory(text);
    } else {
        data.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)) * H5Tget_size(native));
        if (!data.empty()) H5Dread(dataset, native, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data());
    }
    H5Sclose(space);
    H5Tclose(native);
    H5Tclose(type);
    return data;
}

herr_t add_number(hid_t object, const char* name, const H5A_info_t*, void* place)
{
    auto& [hashes, path] = *static_cast<std::pair<Hashes*, std::string>*>(place);
    const std::string full = path + "@" + name;
    const hid_t attribute = H5Aopen(object, name, H5P_DEFAULT), type = H5Aget_type(attribute);
    if (belongs_to_the_result(full) && H5Tget_class(type) == H5T_FLOAT) {
        double value = 0;
        H5Aread(attribute, H5T_NATIVE_DOUBLE, &value);
        (*hashes)[field_of(full)].add(reinterpret_cast<const char*>(&value), sizeof value);
    }
    H5Tclose(type);
    H5Aclose(attribute);
    return 0;
}

herr_t add_object(hid_t file, const char* name, const H5L_info_t*, void* data)
{
    auto& hashes = *static_cast<Hashes*>(data);
    if (!belongs_to_the_result(name)) return 0;
    const hid_t object = H5Oopen(file, name, H5P_DEFAULT);
    if (H5Iget_type(object) == H5I_DATASET) {
        const std::vector<char> values = read_dataset(object);
        hashes[field_of(name)].add(values.data(), values.size());
    }
    std::pair<Hashes*, std::string> place{&hashes, name};
    hsize_t at = 0;
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &at, add_number, &place);
    H5Oclose(object);
    return 0;
}

} // namespace

int main(int count, char** names)
{
    for (int i = 1; i < count; ++i) {
        const hid_t file = H5Fopen(names[i], H5F_ACC_RDONLY, H5P_DEFAULT);
        if (file < 0) return 1;
        Hashes hashes;
        H5Lvisit(file, H5_INDEX_NAME, H5_ITER_INC, add_object, &hashes);
        H5Fclose(file);
        if (hashes.empty()) return 1;
        for (const auto& [field, hash] : hashes)
            std::printf("%-44s %12zu bytes %016llx\n", field.c_str(), hash.bytes, static_cast<unsigned long long>(hash.value));
    }
    return count > 1 ? 0 : 2;
}
