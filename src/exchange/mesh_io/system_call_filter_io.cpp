#include "src/exchange/mesh_io/system_call_filter_io.hpp"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rubicon::mesh_io {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;
#endif

// tgkill is left out: it reaches other processes too. abort() then ends by an illegal instruction.
constexpr long kAlways[] = {
    SYS_read,           SYS_pread64,      SYS_write,         SYS_lseek,     SYS_close,
    SYS_fstat,          SYS_newfstatat,   SYS_mmap,          SYS_munmap,    SYS_mremap,
    SYS_mprotect,       SYS_madvise,      SYS_brk,           SYS_futex,     SYS_rt_sigreturn,
    SYS_rt_sigprocmask, SYS_rt_sigaction, SYS_clock_gettime, SYS_getrandom, SYS_sched_yield,
    SYS_getpid,         SYS_gettid,       SYS_exit,          SYS_exit_group};

constexpr long kPaths[] = {
#ifdef SYS_open
    SYS_open,       SYS_readlink,   SYS_stat,   SYS_lstat, SYS_access,
#endif
#ifdef SYS_faccessat2
    SYS_faccessat2,
#endif
    SYS_faccessat,  SYS_readlinkat, SYS_openat, SYS_getcwd};

sock_filter statement(unsigned code, std::uint32_t value) {
  return {static_cast<std::uint16_t>(code), 0, 0, value};
}

/// Goes on behind the next `otherwise` statements unless the loaded value is `value`.
sock_filter unless_equal_skip(std::uint32_t value, std::uint8_t otherwise) {
  return {static_cast<std::uint16_t>(BPF_JMP | BPF_JEQ | BPF_K), 0, otherwise, value};
}

}  // namespace

void filter_system_calls(FileAccess access) {
  if (kArchitecture == 0) return;
  const sock_filter refuse = statement(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM);
  const sock_filter allow = statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  std::vector<sock_filter> program;
  program.push_back(statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)));
  program.push_back({static_cast<std::uint16_t>(BPF_JMP | BPF_JEQ | BPF_K), 1, 0, kArchitecture});
  program.push_back(refuse);
  program.push_back(statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)));
  const auto let = [&](long call) {
    program.push_back(unless_equal_skip(static_cast<std::uint32_t>(call), 1));
    program.push_back(allow);
  };
  for (const long call : kAlways) let(call);
  if (access == FileAccess::kReadPaths) {
    for (const long call : kPaths) let(call);
  }
  program.push_back(refuse);
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0);
}

}  // namespace rubicon::mesh_io
