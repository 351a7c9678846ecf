// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Prints a hash of each recorded field of a recording, over all frames: fingerprint drop.hygrorec. Two programs that print the same
// computed the same bytes. It reads SQLite and zlib alone and knows nothing of the program, so that moves inside the program cannot change
// it. Who ran it, when and on what (provenance, wall times) is left out.
#include <sqlite3.h>
#include <zlib.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// FNV-1a, 64 bits.
struct Hash {
    std::uint64_t value = 0xcbf29ce484222325u;
    std::size_t bytes = 0;
    void add(std::string_view data)
    {
        bytes += data.size();
        for (const char byte : data) value = (value ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    }
};

using Hashes = std::map<std::string, Hash>;

/// The bytes of a field's numbers, which has its size before it and may be packed, by the bytes of numbers of this size.
std::string numbers_of(std::string_view field, std::size_t size)
{
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, field.data(), sizeof bytes);
    field.remove_prefix(sizeof bytes);
    if (field.size() == bytes) return std::string(field);
    std::string shuffled(bytes, '\0'), numbers(bytes, '\0');
    uLongf count = bytes;
    uncompress(reinterpret_cast<Bytef*>(shuffled.data()), &count, reinterpret_cast<const Bytef*>(field.data()), field.size());
    for (std::size_t i = 0; i < bytes / size; ++i)
        for (std::size_t k = 0; k < size; ++k) numbers[size * i + k] = shuffled[k * (bytes / size) + i];
    return numbers;
}

std::string bytes_of(sqlite3_stmt* row, int column, std::size_t size)
{
    const double number = sqlite3_column_double(row, column);
    switch (sqlite3_column_type(row, column)) {
    case SQLITE_NULL: return {};
    case SQLITE_FLOAT:
    case SQLITE_INTEGER: return {reinterpret_cast<const char*>(&number), sizeof number};
    default: break;
    }
    const std::string_view held(static_cast<const char*>(sqlite3_column_blob(row, column)),
                                static_cast<std::size_t>(sqlite3_column_bytes(row, column)));
    return sqlite3_column_type(row, column) == SQLITE_BLOB ? numbers_of(held, size) : std::string(held);
}

template <typename See> bool each_row(sqlite3* file, const char* sql, See see)
{
    sqlite3_stmt* rows = nullptr;
    if (sqlite3_prepare_v2(file, sql, -1, &rows, nullptr) != SQLITE_OK) return false;
    while (sqlite3_step(rows) == SQLITE_ROW) see(rows);
    return sqlite3_finalize(rows) == SQLITE_OK;
}

std::string text_of(const unsigned char* text) { return reinterpret_cast<const char*>(text); }

/// All but what was noted beside the result.
void add_value(sqlite3_stmt* row, Hashes& hashes)
{
    const std::string name = text_of(sqlite3_column_text(row, 0));
    if (name.rfind("provenance/", 0) == 0 || name == "wall_s") return;
    hashes[name].add(bytes_of(row, 1, name == "textile/length" ? 8 : 4));
}

/// All frames add to the hash of their column, but the ledger's columns, which come first, to one, and so do time and water of the faces;
/// fields that hold changes add to another than those with values.
void add_frame(sqlite3_stmt* row, Hashes& hashes)
{
    const auto is_field = [&](int k) { return sqlite3_column_decltype(row, k) == std::string_view("BLOB"); };
    std::map<std::string, std::string> numbers;
    bool is_ledger = true;
    for (int k = 1; k < sqlite3_column_count(row); ++k) {
        const std::string name = sqlite3_column_name(row, k);
        is_ledger = is_ledger && name != "water_top_kg" && !is_field(k);
        if (is_ledger && name != "time_s") hashes["ledger"].add(bytes_of(row, k, 4));
        if (!is_field(k)) numbers[name] = bytes_of(row, k, 4);
        if (!is_field(k) || sqlite3_column_type(row, k) == SQLITE_NULL) continue;
        const bool may_follow = name.rfind("particle", 0) != 0 && name.rfind("cap_", 0) != 0;
        const bool follows = may_follow && numbers.contains("follows") && !numbers["follows"].empty();
        hashes[follows ? "frames/changes" : "frames/" + name].add(bytes_of(row, k, 4));
    }
    for (const char* name : {"time_s", "water_bottom_kg", "water_top_kg"}) hashes["frames"].add(numbers[name]);
}

} // namespace

int main(int count, char** names)
{
    for (int i = 1; i < count; ++i) {
        sqlite3* file = nullptr;
        Hashes hashes;
        const bool is_read = sqlite3_open_v2(names[i], &file, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK &&
                             each_row(file, "SELECT name, value FROM meta", [&](sqlite3_stmt* row) { add_value(row, hashes); }) &&
                             each_row(file, "SELECT * FROM frames ORDER BY number", [&](sqlite3_stmt* row) { add_frame(row, hashes); });
        sqlite3_close(file);
        if (!is_read || hashes.empty()) return 1;
        for (const auto& [field, hash] : hashes)
            std::printf("%-44s %12zu bytes %016llx\n", field.c_str(), hash.bytes, static_cast<unsigned long long>(hash.value));
    }
    return count > 1 ? 0 : 2;
}
