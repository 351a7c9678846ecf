// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// hygroloom-mesh FORMAT NAME: reads a stranger's mesh from its standard input by a foreign library and writes what it found, or why there
// is nothing, to its standard output: core/garment/mesh_bytes.h. Hygroloom starts it; people do not.
#include "app/mesh/assimp_mesh.h"
#include "app/mesh/confine.h"
#include "core/base/text.h"
#include "core/garment/mesh_bytes.h"
#include "core/garment/mesh_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>

#include <sys/stat.h>
#include <unistd.h>

namespace {

std::size_t size_of_input()
{
    struct stat status {};
    fstat(STDIN_FILENO, &status);
    return static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
}

std::string read_all(std::size_t size)
{
    std::string bytes(size, '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = read(STDIN_FILENO, bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        done += static_cast<std::size_t>(got);
    }
    bytes.resize(done);
    return bytes;
}

void write_all(const std::string& bytes)
{
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t put = write(STDOUT_FILENO, bytes.data() + done, bytes.size() - done);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return;
        done += static_cast<std::size_t>(put);
    }
}

std::string answer_for(const std::string& format, const std::string& name, std::size_t size)
try {
    const std::string bytes = read_all(size);
    hygroloom::refuse_calls();
    return hygroloom::answer_bytes(hygroloom::mesh_by_assimp(bytes, format, name));
} catch (const std::bad_alloc&) {
    return hygroloom::refusal_bytes(
        fmt::format("Reading the file takes more than {} of memory, which is the most. Export it anew with fewer "
                    "triangles, as OBJ or GLB.",
                    hygroloom::bytes_text(static_cast<double>(hygroloom::most_reader_bytes(size)))));
} catch (const std::exception& error) {
    return hygroloom::refusal_bytes(error.what());
}

} // namespace

int main(int count, char** words)
{
    if (count != 3) {
        std::fputs("Hygroloom starts this program to read a garment's mesh: hygroloom-mesh fbx|dae NAME < FILE\n", stderr);
        return 2;
    }
    const std::size_t size = size_of_input();
    hygroloom::limit_resources(hygroloom::most_reader_bytes(size));
    write_all(answer_for(words[1], words[2], size));
    _exit(0); // what the library holds is not worth taking apart
}
