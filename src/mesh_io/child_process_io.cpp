#include "src/mesh_io/child_process_io.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "src/mesh_io/guarded_file_io.hpp"

namespace rubicon::mesh_io {

namespace {

using Clock = std::chrono::steady_clock;

int milliseconds_until(Clock::time_point deadline) {
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long long>(left, 0, 60'000));
}

/// The set-up of posix_spawn, freed when done.
class SpawnSetup {
 public:
  explicit SpawnSetup(int output) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    ::posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
    ::posix_spawnattr_init(&attributes_);
    // A caller that ignores or blocks signals must not hand that on: limits end a child by signal.
    sigset_t none;
    sigset_t all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;
  ~SpawnSetup() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::posix_spawnattr_destroy(&attributes_);
  }

  /// 0, or errno.
  int spawn(const ChildQuery& query, pid_t& pid) {
    std::vector<std::string> words{query.program};
    words.insert(words.end(), query.arguments.begin(), query.arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    std::array<char*, 1> environment{nullptr};
    return ::posix_spawn(&pid, query.program.c_str(), &actions_, &attributes_, argv.data(),
                         environment.data());
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

enum class Collected { kAll, kTooLate, kTooMuch };

/// Reads until the other end is closed.
Collected collect(int fd, Clock::time_point deadline, std::size_t limit, std::string& output) {
  std::vector<char> buffer(std::size_t{1} << 18);
  for (;;) {
    pollfd waiting{fd, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, milliseconds_until(deadline));
    if (ready < 0 && errno != EINTR) return Collected::kTooLate;
    if (ready <= 0) {
      if (Clock::now() >= deadline) return Collected::kTooLate;
      continue;
    }
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got == 0) return Collected::kAll;
    if (got < 0) {
      if (errno == EINTR || errno == EAGAIN) continue;
      return Collected::kTooLate;
    }
    if (output.size() + static_cast<std::size_t>(got) > limit) return Collected::kTooMuch;
    output.append(buffer.data(), static_cast<std::size_t>(got));
  }
}

/// Waits for the end of the child until the deadline; then, or at once if `kill_now`, ends it.
/// Returns its status, -1 when another part of the program has already taken it.
int reap(pid_t pid, Clock::time_point deadline, bool kill_now, bool& killed) {
  killed = false;
  if (kill_now) {
    ::kill(pid, SIGKILL);
    killed = true;
  }
  for (;;) {
    int status = 0;
    const pid_t ended = ::waitpid(pid, &status, killed ? 0 : WNOHANG);
    if (ended == pid) return status;
    if (ended < 0 && errno != EINTR) return -1;
    if (killed) continue;
    if (Clock::now() >= deadline) {
      ::kill(pid, SIGKILL);
      killed = true;
    } else {
      constexpr timespec kPause{0, 500'000};
      ::nanosleep(&kPause, nullptr);
    }
  }
}

}  // namespace

ChildResult run_child(const ChildQuery& query) {
  ChildResult result;
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    result.code = errno;
    return result;
  }
  FileDescriptor output(ends[0]);
  FileDescriptor input(ends[1]);
  pid_t pid = -1;
  const Clock::time_point deadline = Clock::now() + query.time_limit;
  const int error = SpawnSetup(input.get()).spawn(query, pid);
  input.close();
  if (error != 0) {
    result.code = error;
    return result;
  }

  const Collected collected = collect(output.get(), deadline, query.output_limit, result.output);
  bool killed = false;
  const int status = reap(pid, deadline, collected != Collected::kAll, killed);
  if (collected == Collected::kTooMuch) {
    result.end = ChildResult::End::kTooMuchOutput;
  } else if (killed) {
    result.end = ChildResult::End::kTimedOut;
  } else if (status >= 0 && WIFSIGNALED(status)) {
    result.end = ChildResult::End::kSignalled;
    result.code = WTERMSIG(status);
  } else {
    // Where the status was taken elsewhere, the message itself shows whether it is whole.
    result.end = ChildResult::End::kExited;
    result.code = status >= 0 && WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  }
  return result;
}

}  // namespace rubicon::mesh_io
