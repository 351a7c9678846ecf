// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Files that are either wholly the old one or wholly the new one, also after a crash.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace hygroloom {

/// Where a file of this name is written: a link stays a link, and what it points to is replaced, or made. Throws FileError.
std::filesystem::path behind_links(std::filesystem::path path);

enum class Previous { replace, keep_as_backup };

/// Writes to a temporary file in the target's folder, syncs it, renames it over the target and syncs the folder.
/// With keep_as_backup the file that was there stays as path + "~". Throws FileError; the target is then unchanged and the temporary file
/// gone.
void write_file(const std::filesystem::path& path, std::string_view bytes, Previous previous = Previous::replace);

/// The same for a writer that needs a path of its own: it gets the temporary path (with the target's extension) and throws when it fails.
void write_file_with(const std::filesystem::path& path, const std::function<void(const std::filesystem::path& temporary)>& writer,
                     Previous previous = Previous::replace);

/// The same for files that belong together: each is renamed once all are on the disk, in the order given, so the one that names the others
/// comes last. They must lie in one folder.
void write_files_with(const std::vector<std::filesystem::path>& paths,
                      const std::function<void(const std::vector<std::filesystem::path>& temporaries)>& writer,
                      Previous previous = Previous::replace);

/// For a file that is read, changed and written again: while it lives, others that take the same wait. It locks the file's folder, for the
/// file itself is replaced; where that cannot be locked, nobody waits.
class ChangeLock {
public:
    explicit ChangeLock(const std::filesystem::path& path);
    ~ChangeLock();
    ChangeLock(const ChangeLock&) = delete;
    ChangeLock& operator=(const ChangeLock&) = delete;

private:
    int folder_ = -1;
};

/// A regular file that is open for reading. Throws FileError when it is missing, a folder, not readable, empty, or larger than most bytes.
class ReadableFile {
public:
    ReadableFile(const std::filesystem::path& path, std::size_t most);
    ~ReadableFile();
    ReadableFile(const ReadableFile&) = delete;
    ReadableFile& operator=(const ReadableFile&) = delete;
    int descriptor() const { return descriptor_; }
    std::size_t size() const { return size_; }

private:
    int descriptor_ = -1;
    std::size_t size_ = 0;
};

/// The whole file. Throws FileError when it is missing, a folder, not readable, empty, or larger than most bytes.
std::string read_file(const std::filesystem::path& path, std::size_t most);

} // namespace hygroloom
