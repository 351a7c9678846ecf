// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/hdf5_driver.h"

#include "core/base/error.h"

#include <H5FDpublic.h>
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include <algorithm>
#include <new>

namespace hygroloom::hdf5 {
namespace {

/// The library keeps it; its first member is what the library knows of.
struct OpenFile {
    H5FD_t known{};
    Storage* storage = nullptr;
    haddr_t end = 0; ///< of what the library has allocated
};

OpenFile& own(H5FD_t* file) { return *reinterpret_cast<OpenFile*>(file); }
const OpenFile& own(const H5FD_t* file) { return *reinterpret_cast<const OpenFile*>(file); }

H5FD_t* open_storage(const char*, unsigned, hid_t properties, haddr_t)
{
    const auto* storage = static_cast<Storage* const*>(H5Pget_driver_info(properties));
    if (!storage) return nullptr;
    auto* file = new (std::nothrow) OpenFile;
    if (!file) return nullptr;
    file->storage = *storage;
    return &file->known;
}

herr_t close_storage(H5FD_t* file)
{
    delete &own(file);
    return 0;
}

herr_t query(const H5FD_t* file, unsigned long* flags)
{
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA;
    if (file && own(file).storage->is_written()) *flags |= H5FD_FEAT_ACCUMULATE_METADATA;
    return 0;
}

haddr_t allocated(const H5FD_t* file, H5FD_mem_t) { return own(file).end; }

herr_t allocate(H5FD_t* file, H5FD_mem_t, haddr_t end)
{
    own(file).end = end;
    return 0;
}

haddr_t size_of(const H5FD_t* file, H5FD_mem_t) { return own(file).storage->size(); }

BlockKind kind_of(H5FD_mem_t type)
{
    switch (type) {
    case H5FD_MEM_SUPER: return BlockKind::superblock;
    case H5FD_MEM_BTREE: return BlockKind::tree;
    case H5FD_MEM_OHDR: return BlockKind::header;
    case H5FD_MEM_LHEAP: return BlockKind::heap;
    case H5FD_MEM_DRAW: return BlockKind::data;
    default: return BlockKind::other;
    }
}

herr_t read(H5FD_t* file, H5FD_mem_t type, hid_t, haddr_t at, size_t count, void* bytes)
{
    return own(file).storage->read(at, bytes, count, kind_of(type)) ? 0 : -1;
}

herr_t write(H5FD_t* file, H5FD_mem_t type, hid_t, haddr_t at, size_t count, const void* bytes)
{
    return own(file).storage->write(at, bytes, count, type != H5FD_MEM_DRAW) ? 0 : -1;
}

herr_t truncate(H5FD_t* file, hid_t, hbool_t)
{
    own(file).storage->resize(own(file).end);
    return 0;
}

hid_t driver()
{
    static const hid_t registered = [] {
        static H5FD_class_t driver{};
#if H5_VERSION_GE(1, 13, 0)
        driver.version = H5FD_CLASS_VERSION;
        driver.value = static_cast<H5FD_class_value_t>(H5_VFD_RESERVED + 1);
#endif
        driver.name = "hygroloom";
        driver.maxaddr = static_cast<haddr_t>(INT64_MAX);
        driver.fc_degree = H5F_CLOSE_STRONG;
        driver.fapl_size = sizeof(Storage*); // NOLINT(bugprone-sizeof-expression): a pointer is what it keeps
        driver.open = open_storage;
        driver.close = close_storage;
        driver.query = query;
        driver.get_eoa = allocated;
        driver.set_eoa = allocate;
        driver.get_eof = size_of;
        driver.read = read;
        driver.write = write;
        driver.truncate = truncate;
        constexpr H5FD_mem_t kinds[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY; // freed metadata never becomes room for data
        std::copy(std::begin(kinds), std::end(kinds), std::begin(driver.fl_map));
        H5PLset_loading_state(0); // files name filters; no code is loaded for them
        return H5FDregister(&driver);
    }();
    return registered;
}

Handle access_to(Storage& storage)
{
    Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "The HDF5 library cannot be used.");
    Storage* const info = &storage;
    if (H5Pset_driver(properties.get(), driver(), &info) < 0) throw FileError("The HDF5 library cannot be used.");
    return properties;
}

} // namespace

Handle create_file(Storage& storage, const std::string& what)
{
    return {H5Fcreate("recording", H5F_ACC_TRUNC, H5P_DEFAULT, access_to(storage).get()), H5Fclose, what};
}

Handle open_file(Storage& storage, const std::string& what)
{
    return {H5Fopen("recording", H5F_ACC_RDONLY, access_to(storage).get()), H5Fclose, what};
}

} // namespace hygroloom::hdf5
