// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/writer_lock.h"

#include <cerrno>
#include <fcntl.h>
#include <mutex>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace hygroloom {
namespace {

using FileId = std::pair<dev_t, ino_t>;

std::mutex& of_written()
{
    static std::mutex mutex;
    return mutex;
}

std::set<FileId>& written_here()
{
    static std::set<FileId> files;
    return files;
}

FileId id_of(int file)
{
    struct stat status {};
    ::fstat(file, &status);
    return {status.st_dev, status.st_ino};
}

struct flock first_byte(short type)
{
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_len = 1;
    return lock;
}

} // namespace

bool lock_as_writer(int file)
{
    struct flock lock = first_byte(F_WRLCK);
    return ::fcntl(file, F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES);
}

void note_written_here(int file)
{
    const std::lock_guard alone(of_written());
    written_here().insert(id_of(file));
}

void forget_written_here(int file)
{
    const std::lock_guard alone(of_written());
    written_here().erase(id_of(file));
}

bool is_being_written(const std::filesystem::path& path)
{
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return false;
    const std::lock_guard alone(of_written());
    if (written_here().contains({status.st_dev, status.st_ino})) return true;
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) return false;
    struct flock lock = first_byte(F_RDLCK);
    const bool is = ::fcntl(file, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
    ::close(file);
    return is;
}

} // namespace hygroloom
