// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/confinement.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain {
namespace {

void limit(__rlimit_resource resource, rlim_t most) {
  const rlimit both{most, most};
  ::setrlimit(resource, &both);
}

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;
#endif

/// System calls that compute, or use what is open.
constexpr int kHarmless[] = {
    SYS_read,
    SYS_readv,
    SYS_pread64,
    SYS_write,
    SYS_writev,
    SYS_close,
    SYS_lseek,
    SYS_fstat,
    SYS_newfstatat,
    SYS_statx,
    SYS_faccessat,
    SYS_readlinkat,
    SYS_getcwd,
    SYS_getdents64,
    SYS_brk,
    SYS_munmap,
    SYS_mremap,
    SYS_madvise,
    SYS_futex,
    SYS_sched_yield,
    SYS_rt_sigaction,
    SYS_rt_sigreturn,
    SYS_rt_sigprocmask,
    SYS_sigaltstack,
    SYS_restart_syscall,
    SYS_clock_gettime,
    SYS_gettimeofday,
    SYS_times,
    SYS_clock_nanosleep,
    SYS_getrusage,
    SYS_getpid,
    SYS_getppid,
    SYS_gettid,
    SYS_getuid,
    SYS_sched_getaffinity,
    SYS_uname,
    SYS_sysinfo,
    SYS_getrandom,
    SYS_exit,
    SYS_exit_group,
#ifdef SYS_open  // older system calls, which aarch64 lacks
    SYS_stat,
    SYS_lstat,
    SYS_access,
    SYS_readlink,
    SYS_time,
#endif
};

/// A system call that is allowed if (argument & mask) == value.
struct Condition {
  int call;
  int argument;
  std::uint32_t mask, value;
};

std::vector<Condition> conditions() {
  constexpr std::uint32_t kWriting = O_ACCMODE | O_CREAT | O_TRUNC;
  return {{SYS_openat, 2, kWriting, O_RDONLY},
#ifdef SYS_open
          {SYS_open, 1, kWriting, O_RDONLY},
#endif
          {SYS_mmap, 2, PROT_EXEC, 0},
          {SYS_mprotect, 2, PROT_EXEC, 0},
          // abort() sends a signal to its own process.
          {SYS_tgkill, 0, ~0U, static_cast<std::uint32_t>(::getpid())}};
}

std::vector<sock_filter> filter() {
  std::vector<sock_filter> steps;
  const auto add = [&steps](int code, std::uint32_t k, int if_true = 0, int if_false = 0) {
    steps.push_back({static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(if_true),
                     static_cast<std::uint8_t>(if_false), k});
  };
  const auto load = [&add](std::size_t offset) {
    add(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
  };
  const auto skip_one_if_equal = [&add](std::uint32_t value) { add(BPF_JMP | BPF_JEQ | BPF_K, value, 1, 0); };
  const auto allow_if_equal = [&add](std::uint32_t value) {
    add(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1);
    add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  };
  constexpr std::uint32_t kRefuse = SECCOMP_RET_ERRNO | EPERM;

  load(offsetof(seccomp_data, arch));
  skip_one_if_equal(kArchitecture);
  add(BPF_RET | BPF_K, kRefuse);
  load(offsetof(seccomp_data, nr));
  for (const int call : kHarmless) allow_if_equal(static_cast<std::uint32_t>(call));
  for (const Condition& condition : conditions()) {
    constexpr int kStepsOfACondition = 5;
    add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(condition.call), 0, kStepsOfACondition);
    // The low half, on machines that store it first.
    load(offsetof(seccomp_data, args) +
         static_cast<std::size_t>(condition.argument) * sizeof(seccomp_data::args[0]));
    add(BPF_ALU | BPF_AND | BPF_K, condition.mask);
    allow_if_equal(condition.value);
    add(BPF_RET | BPF_K, kRefuse);
  }
  add(BPF_RET | BPF_K, kRefuse);
  return steps;
}

bool restrict_calls() {
  if (kArchitecture == 0) return false;
  std::vector<sock_filter> steps = filter();
  const sock_fprog program{static_cast<unsigned short>(steps.size()), steps.data()};
  return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// All rights to files that a version of Landlock knows. Newer versions also restrict other things.
std::uint64_t file_rights(long version) {
  const std::uint64_t first = 2 * LANDLOCK_ACCESS_FS_MAKE_SYM - 1;
  const std::uint64_t move = version >= 2 ? 1ULL << 13 : 0, truncate = version >= 3 ? 1ULL << 14 : 0;
  return first | move | truncate;
}

bool restrict_files(const std::string& path) {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return false;
  const landlock_ruleset_attr rules{file_rights(version)};
  const long rule_set = ::syscall(SYS_landlock_create_ruleset, &rules, sizeof rules.handled_access_fs, 0);
  if (rule_set < 0) return false;
  const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  const landlock_path_beneath_attr readable{LANDLOCK_ACCESS_FS_READ_FILE, file};
  const bool is_restricted =
      file >= 0 &&
      ::syscall(SYS_landlock_add_rule, rule_set, LANDLOCK_RULE_PATH_BENEATH, &readable, 0) == 0 &&
      ::syscall(SYS_landlock_restrict_self, rule_set, 0) == 0;
  if (file >= 0) ::close(file);
  ::close(static_cast<int>(rule_set));
  return is_restricted;
}

}  // namespace

Confinement confine_to_reading(const std::string& path) {
  // Enough for the file, its pipe, and what OpenCASCADE looks for in vain.
  constexpr rlim_t kMostDescriptors = 16;
  limit(RLIMIT_NOFILE, kMostDescriptors);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CORE, 0);
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return {false, false};
  // In this order, since the filter forbids Landlock's own calls.
  const bool of_files = restrict_files(path);
  const bool of_calls = restrict_calls();
  return {of_calls, of_files};
}

}  // namespace crossgrain
