// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/atomic_file.h"

#include "core/base/error.h"
#include "core/project/leftovers.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hygroloom {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what, int code)
{
    throw FileError(fmt::format("{}: {}: {}.", path.string(), what, std::strerror(code)));
}

/// Removes the temporary file unless it was renamed away.
struct Temporary {
    std::filesystem::path path;
    explicit Temporary(std::filesystem::path temporary) : path(std::move(temporary)) {}
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    ~Temporary()
    {
        std::error_code ignored;
        if (!path.empty()) std::filesystem::remove(path, ignored);
    }
};

/// Whether the data reached the disk; a folder on a file system that cannot sync folders counts as synced.
void sync(const std::filesystem::path& path, bool folder, const std::filesystem::path& target)
{
    const int file = ::open(path.c_str(), folder ? O_RDONLY | O_DIRECTORY | O_CLOEXEC : O_RDWR | O_CLOEXEC);
    if (file < 0) {
        if (folder) return;
        fail(target, "The file cannot be written", errno);
    }
    const int result = ::fsync(file);
    const int code = errno;
    ::close(file);
    if (result != 0 && !folder) fail(target, "The file cannot be written to the disk", code);
}

void keep_backup(const std::filesystem::path& target)
{
    const std::filesystem::path backup = target.string() + "~";
    // A hard link keeps the target in place all the time; where links are not possible, a copy does.
    const std::filesystem::path fresh = temporary_beside(backup);
    Temporary guard{fresh};
    if (::link(target.c_str(), fresh.c_str()) != 0) {
        std::error_code failure;
        std::filesystem::copy_file(target, fresh, std::filesystem::copy_options::overwrite_existing, failure);
        if (failure) fail(target, "The previous version cannot be kept", failure.value());
    }
    if (::rename(fresh.c_str(), backup.c_str()) != 0) fail(target, "The previous version cannot be kept", errno);
}

} // namespace

std::filesystem::path behind_links(std::filesystem::path path)
{
    std::error_code failure;
    const std::filesystem::path given = path;
    constexpr int most_links = 40; // as the kernel
    for (int i = 0; i < most_links && std::filesystem::is_symlink(path, failure); ++i) {
        const std::filesystem::path next = std::filesystem::read_symlink(path, failure);
        if (failure) fail(given, "The link cannot be followed", failure.value());
        path = path.parent_path() / next;
    }
    if (std::filesystem::is_symlink(path, failure)) fail(given, "The link cannot be followed", ELOOP);
    return path;
}

void write_files_with(const std::vector<std::filesystem::path>& paths,
                      const std::function<void(const std::vector<std::filesystem::path>&)>& writer, Previous previous)
{
    struct Place {
        std::filesystem::path target;
        bool there = false;
        struct stat old {};
    };
    std::vector<Place> places;
    std::error_code failure;
    for (const auto& given : paths) {
        if (std::filesystem::is_directory(given, failure)) throw FileError(given.string() + ": This is a folder; give the name of a file.");
        Place place{behind_links(given)};
        place.there = std::filesystem::exists(place.target, failure);
        if (failure == std::errc::filename_too_long) fail(given, "The file cannot be written", failure.value());
        if (place.there && ::stat(place.target.c_str(), &place.old) == 0 && !S_ISREG(place.old.st_mode))
            throw FileError(given.string() + ": This is not a regular file.");
        if (place.there && ::access(place.target.c_str(), W_OK) != 0) fail(given, "The file cannot be replaced", errno);
        places.push_back(std::move(place));
    }
    std::vector<std::filesystem::path> temporaries;
    for (const Place& place : places) remove_leftovers(place.target);
    temporaries.reserve(places.size());
    for (const Place& place : places) temporaries.push_back(temporary_beside(place.target));
    const std::vector<Temporary> guards(temporaries.begin(), temporaries.end());
    writer(temporaries);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        sync(temporaries[i], false, paths[i]);
        if (places[i].there) ::chmod(temporaries[i].c_str(), places[i].old.st_mode & 07777);
    }
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const auto& target = places[i].target;
        if (places[i].there && previous == Previous::keep_as_backup) keep_backup(target);
        if (::rename(temporaries[i].c_str(), target.c_str()) != 0) fail(paths[i], "The file cannot be put in place", errno);
        sync(target.has_parent_path() ? target.parent_path() : std::filesystem::path("."), true, paths[i]);
    }
}

void write_file_with(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& writer, Previous previous)
{
    write_files_with(
        {path}, [&](const std::vector<std::filesystem::path>& temporaries) { writer(temporaries[0]); }, previous);
}

void write_file(const std::filesystem::path& path, std::string_view bytes, Previous previous)
{
    write_file_with(
        path,
        [&](const std::filesystem::path& temporary) {
            const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (file < 0) fail(path, "The file cannot be written", errno);
            std::size_t done = 0;
            while (done < bytes.size()) {
                const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
                if (written < 0 && errno == EINTR) continue;
                if (written <= 0) {
                    const int code = written < 0 ? errno : ENOSPC;
                    ::close(file);
                    fail(path, "The file cannot be written", code);
                }
                done += static_cast<std::size_t>(written);
            }
            if (::close(file) != 0) fail(path, "The file cannot be written", errno);
        },
        previous);
}

ReadableFile::ReadableFile(const std::filesystem::path& path, std::size_t most)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK))
{
    if (descriptor_ < 0) fail(path, "The file cannot be opened", errno);
    const auto refuse = [&](const std::string& sentence) {
        ::close(descriptor_);
        throw FileError(path.string() + ": " + sentence);
    };
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) refuse(fmt::format("The file cannot be read: {}.", std::strerror(errno)));
    if (S_ISDIR(status.st_mode)) refuse("This is a folder; give the name of a file.");
    if (!S_ISREG(status.st_mode)) refuse("This is not a regular file.");
    size_ = static_cast<std::size_t>(status.st_size);
    if (size_ > most)
        refuse(fmt::format("The file has {:.1f} MiB; at most {:.0f} MiB are read.", status.st_size / 1048576.0, most / 1048576.0));
    if (size_ == 0) refuse("The file is empty.");
}

ReadableFile::~ReadableFile() { ::close(descriptor_); }

std::string read_file(const std::filesystem::path& path, std::size_t most)
{
    const ReadableFile file(path, most);
    std::string bytes(file.size(), '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = ::read(file.descriptor(), bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(path, "The file cannot be read", errno);
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    bytes.resize(done);
    return bytes;
}

ChangeLock::ChangeLock(const std::filesystem::path& path)
{
    const std::filesystem::path folder = behind_links(path).parent_path();
    folder_ = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    while (folder_ >= 0 && ::flock(folder_, LOCK_EX) != 0 && errno == EINTR) continue;
}

ChangeLock::~ChangeLock()
{
    if (folder_ >= 0) ::close(folder_);
}

} // namespace hygroloom
