// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/mesh/confine.h"

#include "core/garment/mesh_limits.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <vector>

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>

namespace hygroloom {

namespace {

void limit(__rlimit_resource what, rlim_t soft, rlim_t hard)
{
    const rlimit limits{soft, hard};
    setrlimit(what, &limits); // where the limit is lower already, it stays
}

#if defined(__x86_64__)
constexpr unsigned architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned architecture = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned architecture = 0;
#endif

constexpr std::array allowed{__NR_read,           __NR_write,        __NR_mmap,         __NR_munmap, __NR_mprotect,
                             __NR_mremap,         __NR_madvise,      __NR_brk,          __NR_futex,  __NR_getrandom,
                             __NR_clock_gettime,  __NR_sched_yield,  __NR_getpid,       __NR_gettid, __NR_tgkill,
                             __NR_rt_sigprocmask, __NR_rt_sigaction, __NR_rt_sigreturn, __NR_exit,   __NR_exit_group};

} // namespace

void limit_resources([[maybe_unused]] std::size_t memory)
{
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // they take terabytes of addresses
    limit(RLIMIT_AS, memory, memory);
#endif
    limit(RLIMIT_CPU, most_reader_seconds, most_reader_seconds + 1);
    limit(RLIMIT_FSIZE, 0, 0);
    limit(RLIMIT_CORE, 0, 0);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
}

void refuse_calls()
{
    if (architecture == 0) return;
    std::vector<sock_filter> filter{
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS), BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
    for (const int call : allowed) {
        filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call), 0, 1));
        filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    }
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM));
    const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

} // namespace hygroloom
