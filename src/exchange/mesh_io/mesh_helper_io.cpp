// The program `rubicon-mesh`: takes jobs from a socket and forks a guarded child for each. It is
// started by HelperProcess; it reads no file itself and holds nothing that a child could spoil.

#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "src/exchange/mesh_io/guarded_file_io.hpp"
#include "src/exchange/mesh_io/guarded_job_io.hpp"
#include "src/exchange/mesh_io/helper_job.hpp"

namespace rubicon::mesh_io {

namespace {

/// Where HelperProcess puts the socket that jobs come from.
constexpr int kJobs = STDIN_FILENO;

struct Child {
  pid_t process = -1;
  FileDescriptor status;
  bool ended_by_us = false;
};

struct Received {
  std::optional<HelperJob> job;  // nothing: no job, or not with its files
  std::array<FileDescriptor, kJobFiles> files;
};

FileDescriptor& file(Received& received, JobFile which) {
  return received.files[static_cast<std::size_t>(which)];
}

/// The next job; false when there will be none.
bool receive(Received& received) {
  std::array<char, kLongestJob> message{};
  iovec part{message.data(), message.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(kJobFiles * sizeof(int))> control{};
  msghdr header{};
  header.msg_iov = &part;
  header.msg_iovlen = 1;
  header.msg_control = control.data();
  header.msg_controllen = control.size();
  ssize_t size = 0;
  do {
    size = ::recvmsg(kJobs, &header, MSG_CMSG_CLOEXEC);
  } while (size < 0 && errno == EINTR);
  if (size <= 0) return false;
  std::size_t count = 0;
  for (cmsghdr* part_of = CMSG_FIRSTHDR(&header); part_of != nullptr;
       part_of = CMSG_NXTHDR(&header, part_of)) {
    if (part_of->cmsg_level != SOL_SOCKET || part_of->cmsg_type != SCM_RIGHTS) continue;
    const std::size_t bytes = part_of->cmsg_len - CMSG_LEN(0);
    std::array<int, kJobFiles> numbers{};
    count = std::min(bytes, sizeof numbers) / sizeof(int);
    std::memcpy(numbers.data(), CMSG_DATA(part_of), count * sizeof(int));
    for (std::size_t i = 0; i < count; ++i) received.files[i] = FileDescriptor(numbers[i]);
  }
  const bool whole = (header.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) == 0 && count == kJobFiles;
  if (whole) received.job = decode_job({message.data(), static_cast<std::size_t>(size)});
  return true;
}

void send_end(const FileDescriptor& status, bool signalled, int code) {
  const ChildEnd end{signalled ? 1 : 0, code};
  // There is always room for it; when nobody listens any more it does not matter.
  static_cast<void>(::send(status.get(), &end, sizeof end, MSG_NOSIGNAL | MSG_DONTWAIT));
}

class Server {
 public:
  int run() {
    sigset_t child_ended;
    ::sigemptyset(&child_ended);
    ::sigaddset(&child_ended, SIGCHLD);
    ::sigprocmask(SIG_BLOCK, &child_ended, nullptr);
    signals_ = FileDescriptor(::signalfd(-1, &child_ended, SFD_CLOEXEC | SFD_NONBLOCK));
    if (signals_.get() < 0) return kExitUsage;
    bool more = true;
    while (more) more = wait() && serve();
    for (const Child& child : children_) ::kill(child.process, SIGKILL);
    return 0;
  }

 private:
  bool wait() {
    polled_.assign({{kJobs, POLLIN, 0}, {signals_.get(), POLLIN, 0}});
    // Anything that comes from the other side of a status channel means: end it.
    for (const Child& child : children_) {
      polled_.push_back({child.ended_by_us ? -1 : child.status.get(), POLLIN, 0});
    }
    const int ready = ::poll(polled_.data(), polled_.size(), -1);
    return ready >= 0 || errno == EINTR;
  }

  bool serve() {
    for (std::size_t i = 0; i < children_.size(); ++i) {
      if (polled_[i + 2].revents == 0 || children_[i].ended_by_us) continue;
      ::kill(children_[i].process, SIGKILL);  // not reaped yet, so the number is still its own
      children_[i].ended_by_us = true;
    }
    if (polled_[1].revents != 0) reap();
    if (polled_[0].revents == 0) return true;
    Received received;
    if (!receive(received)) return false;
    if (received.job) {
      begin(received);
    } else {
      send_end(file(received, JobFile::kStatus), false, kExitUsage);
    }
    return true;
  }

  void begin(Received& received) {
    const pid_t helper = ::getpid();
    const pid_t process = ::fork();
    if (process == 0) {
      // Nothing of the helper stays open, least of all the socket that jobs come from.
      const JobDescriptors descriptors =
          keep_only(file(received, JobFile::kInput).get(), file(received, JobFile::kOutput).get());
      ::_exit(run_guarded_job(*received.job, descriptors, helper));
    }
    if (process < 0) {
      send_end(file(received, JobFile::kStatus), false, kExitOutput);
      return;
    }
    children_.push_back({process, std::move(file(received, JobFile::kStatus)), false});
  }

  void reap() {
    signalfd_siginfo ignored{};
    while (::read(signals_.get(), &ignored, sizeof ignored) > 0) {
    }
    for (;;) {
      int status = 0;
      const pid_t ended = ::waitpid(-1, &status, WNOHANG);
      if (ended <= 0) return;
      const auto child = std::find_if(children_.begin(), children_.end(),
                                      [&](const Child& each) { return each.process == ended; });
      if (child == children_.end()) continue;
      send_end(child->status, WIFSIGNALED(status),
               WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
      children_.erase(child);
    }
  }

  FileDescriptor signals_;
  std::vector<Child> children_;
  std::vector<pollfd> polled_;
};

}  // namespace

}  // namespace rubicon::mesh_io

int main(int argc, char** argv) {
  if (argc != 2 || std::string_view(argv[1]) != "serve") {
    fmt::print(stderr,
               "usage: rubicon-mesh serve\n"
               "reads meshes for the command rubicon; not meant to be called by hand\n");
    return rubicon::mesh_io::kExitUsage;
  }
  return rubicon::mesh_io::Server().run();
}
