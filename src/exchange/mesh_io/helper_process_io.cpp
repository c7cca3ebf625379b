#include "src/exchange/mesh_io/helper_process_io.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace rubicon::mesh_io {

namespace {

using Clock = std::chrono::steady_clock;

/// How long the helper may take to end a child and say so, or to end itself. It does nothing but
/// wait, so a helper that needs longer is broken, or the machine is stuck.
constexpr std::chrono::seconds kPatience{2};

int milliseconds_until(Clock::time_point deadline) {
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long long>(left, 0, 60'000));
}

/// The set-up of posix_spawn, freed when done.
class SpawnSetup {
 public:
  explicit SpawnSetup(int socket) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_adddup2(&actions_, socket, STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_RDWR, 0);
    ::posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_RDWR, 0);
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
  int spawn(const std::string& program, pid_t& pid) {
    std::array<std::string, 2> words{program, "serve"};
    std::array<char*, 3> argv{words[0].data(), words[1].data(), nullptr};
    // Functions of libraries are looked up once here rather than in every child. assimp takes 16 MB
    // for any OBJ file: large pages save 4,000 page faults, 10 of 11 ms.
    std::array<std::string, 2> settings{"LD_BIND_NOW=1", "GLIBC_TUNABLES=glibc.malloc.hugetlb=1"};
    std::array<char*, 3> environment{settings[0].data(), settings[1].data(), nullptr};
    return ::posix_spawn(&pid, program.c_str(), &actions_, &attributes_, argv.data(),
                         environment.data());
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

enum class Collected { kAll, kTooLate, kTooMuch };

/// Waits until something can be read from `fd` or it is closed; false at the deadline.
bool wait_readable(int fd, Clock::time_point deadline) {
  for (;;) {
    pollfd waiting{fd, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, milliseconds_until(deadline));
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return false;
    if (Clock::now() >= deadline) return false;
  }
}

/// Reads until the other end is closed.
Collected collect(int fd, Clock::time_point deadline, std::size_t limit, std::string& output) {
  // Small at first: most meshes of a site are boxes.
  std::vector<char> buffer(std::size_t{1} << 14);
  for (;;) {
    if (!wait_readable(fd, deadline)) return Collected::kTooLate;
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got == 0) return Collected::kAll;
    if (got < 0) {
      if (errno == EINTR || errno == EAGAIN) continue;
      return Collected::kTooLate;
    }
    const auto size = static_cast<std::size_t>(got);
    if (output.size() + size > limit) return Collected::kTooMuch;
    output.append(buffer.data(), size);
    if (size == buffer.size()) buffer.resize(std::min(2 * size, std::size_t{1} << 18));
  }
}

enum class Heard { kEnd, kNothing, kClosed };

/// What the helper says about the end of a child.
Heard hear(int status, Clock::time_point deadline, ChildEnd& end) {
  for (;;) {
    if (!wait_readable(status, deadline)) return Heard::kNothing;
    const ssize_t got = ::read(status, &end, sizeof end);
    if (got < 0 && errno == EINTR) continue;
    return got == sizeof end ? Heard::kEnd : Heard::kClosed;
  }
}

}  // namespace

/// The two channels of a job; our ends and those for the helper.
struct HelperProcess::JobFiles {
  FileDescriptor output;
  FileDescriptor status;
  FileDescriptor output_there;
  FileDescriptor status_there;
  int input = -1;

  /// 0, or errno.
  int open() {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return errno;
    output = FileDescriptor(pipe[0]);
    output_there = FileDescriptor(pipe[1]);
    std::array<int, 2> pair{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pair.data()) != 0) return errno;
    status = FileDescriptor(pair[0]);
    status_there = FileDescriptor(pair[1]);
    return 0;
  }
};

HelperProcess::HelperProcess(std::string program) : program_(std::move(program)) {}

HelperProcess::~HelperProcess() { stop(process_, false); }

HelperResult HelperProcess::run(const HelperQuery& query) {
  HelperResult result;
  JobFiles files;
  files.input = query.input;
  const Clock::time_point deadline = Clock::now() + query.time_limit;
  pid_t process = -1;
  result.code = files.open();
  if (result.code == 0) result.code = send(query.job, files, process);
  if (result.code != 0) return result;
  files.output_there.close();
  files.status_there.close();

  const Collected collected =
      collect(files.output.get(), deadline, query.output_limit, result.output);
  ChildEnd end;
  Heard heard = Heard::kNothing;
  if (collected == Collected::kAll) heard = hear(files.status.get(), deadline, end);
  const bool too_late = heard == Heard::kNothing;
  if (too_late) {
    // Asks the helper to end the child, and waits until that is done.
    ::shutdown(files.status.get(), SHUT_WR);
    files.output.close();
    heard = hear(files.status.get(), Clock::now() + kPatience, end);
    if (heard == Heard::kNothing) stop(process, true);
  }
  if (collected == Collected::kTooMuch) {
    result.end = HelperResult::End::kTooMuchOutput;
  } else if (too_late) {
    result.end = HelperResult::End::kTimedOut;
  } else if (heard == Heard::kClosed) {
    result.end = HelperResult::End::kNoAnswer;
    result.code = stop(process, false);
  } else {
    const bool signalled = end.signalled != 0;
    result.end = signalled ? HelperResult::End::kSignalled : HelperResult::End::kExited;
    result.code = end.code;
  }
  return result;
}

/// Sends a job; 0 or errno. Says to which process.
int HelperProcess::send(const HelperJob& job, const JobFiles& files, pid_t& process) {
  std::string message = encode_job(job);
  if (message.size() > kLongestJob) return ENAMETOOLONG;
  iovec part{message.data(), message.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(kJobFiles * sizeof(int))> control{};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  header.msg_control = control.data();
  header.msg_controllen = control.size();
  cmsghdr* const rights = CMSG_FIRSTHDR(&header);
  rights->cmsg_level = SOL_SOCKET;
  rights->cmsg_type = SCM_RIGHTS;
  rights->cmsg_len = CMSG_LEN(kJobFiles * sizeof(int));
  std::array<int, kJobFiles> sent{};
  sent[static_cast<std::size_t>(JobFile::kInput)] = files.input;
  sent[static_cast<std::size_t>(JobFile::kOutput)] = files.output_there.get();
  sent[static_cast<std::size_t>(JobFile::kStatus)] = files.status_there.get();
  std::memcpy(CMSG_DATA(rights), sent.data(), sizeof sent);

  const std::scoped_lock lock(mutex_);
  for (int attempt = 0;; ++attempt) {
    if (const int error = process_ < 0 ? start() : 0; error != 0) return error;
    process = process_;
    ssize_t done = 0;
    do {
      done = ::sendmsg(socket_.get(), &header, MSG_NOSIGNAL);
    } while (done < 0 && errno == EINTR);
    if (done >= 0) return 0;
    const int error = errno;
    stop_held(false);
    if (attempt > 0) return error;
  }
}

/// 0, or errno.
int HelperProcess::start() {
  std::array<int, 2> pair{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pair.data()) != 0) return errno;
  FileDescriptor here(pair[0]);
  const FileDescriptor there(pair[1]);
  // A helper that does not take jobs must not hold us up.
  const timeval patience{kPatience.count(), 0};
  ::setsockopt(here.get(), SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  pid_t pid = -1;
  if (const int error = SpawnSetup(there.get()).spawn(program_, pid); error != 0) return error;
  socket_ = std::move(here);
  process_ = pid;
  return 0;
}

/// Ends this helper, unless another thread has done so and a new one runs. Its exit code, or -1.
int HelperProcess::stop(pid_t process, bool at_once) {
  const std::scoped_lock lock(mutex_);
  return process_ >= 0 && process_ == process ? stop_held(at_once) : -1;
}

int HelperProcess::stop_held(bool at_once) {
  const pid_t process = std::exchange(process_, -1);
  socket_.close();
  if (process < 0) return -1;
  int status = 0;
  const Clock::time_point deadline =
      Clock::now() + (at_once ? Clock::duration::zero() : Clock::duration(kPatience));
  for (bool killed = false;;) {
    const pid_t ended = ::waitpid(process, &status, killed ? 0 : WNOHANG);
    // Another part of the program may have taken its status.
    if (ended < 0 && errno != EINTR) return -1;
    if (ended == process) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (killed) continue;
    if (Clock::now() >= deadline) {
      ::kill(process, SIGKILL);
      killed = true;
    } else {
      constexpr timespec kPause{0, 100'000};
      ::nanosleep(&kPause, nullptr);
    }
  }
}

}  // namespace rubicon::mesh_io
