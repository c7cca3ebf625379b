#include "src/exchange/files/temporaries_io.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <memory>
#include <utility>

namespace rubicon::files {

namespace {

/// What asks a program to end: a user, a shell, a pipe nobody reads, a limit (ulimit).
constexpr std::array<int, 7> kEnding = {SIGINT,  SIGTERM, SIGHUP, SIGQUIT,
                                        SIGPIPE, SIGXCPU, SIGXFSZ};

/// More than a command ever writes at once; what comes on top would be left over by a signal.
constexpr std::size_t kMostAtOnce = 64;

}  // namespace

struct TemporaryPaths {
  std::vector<std::string> files;
  std::vector<std::string> folders;

  /// Only calls that a handler of signals may make.
  void remove() const {
    for (const std::string& file : files) ::unlink(file.c_str());
    for (const std::string& folder : folders) ::rmdir(folder.c_str());
  }
};

namespace {

// A handler of signals has no arguments: all it needs must be global.
std::array<std::atomic<const TemporaryPaths*>, kMostAtOnce> standing{};
std::atomic<int> holds{0};
std::atomic<int> waiting{0};
static_assert(std::atomic<const TemporaryPaths*>::is_always_lock_free);
static_assert(std::atomic<int>::is_always_lock_free);

/// Removes all that stands, and lets the signal do what it does by itself.
void end_by(int number) {
  for (const auto& slot : standing) {
    if (const TemporaryPaths* paths = slot.load()) paths->remove();
  }
  ::signal(number, SIG_DFL);
  ::raise(number);
}

extern "C" void on_signal(int number) {
  if (holds.load() > 0) {
    waiting.store(number);
  } else {
    end_by(number);
  }
}

/// What the caller of the program ignores (nohup, a job in the background) stays ignored.
void catch_signals() {
  static const bool caught = [] {
    for (const int number : kEnding) {
      struct sigaction action {};
      if (::sigaction(number, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
      action.sa_handler = on_signal;
      action.sa_flags = SA_RESTART;
      ::sigaction(number, &action, nullptr);
    }
    return true;
  }();
  static_cast<void>(caught);
}

void forget(const TemporaryPaths* paths) {
  for (auto& slot : standing) {
    const TemporaryPaths* expected = paths;
    if (slot.compare_exchange_strong(expected, nullptr)) return;
  }
}

}  // namespace

Temporaries::Temporaries(std::vector<std::string> files, std::vector<std::string> folders)
    : paths_(std::make_unique<const TemporaryPaths>(
          TemporaryPaths{std::move(files), std::move(folders)})) {
  catch_signals();
  for (auto& slot : standing) {
    const TemporaryPaths* expected = nullptr;
    if (slot.compare_exchange_strong(expected, paths_.get())) return;
  }
}

Temporaries::Temporaries() = default;
Temporaries::Temporaries(Temporaries&&) noexcept = default;

Temporaries& Temporaries::operator=(Temporaries&& other) noexcept {
  std::swap(paths_, other.paths_);
  return *this;
}

Temporaries::~Temporaries() { release(); }

void Temporaries::remove() {
  if (paths_) paths_->remove();
  release();
}

void Temporaries::release() {
  if (!paths_) return;
  const SignalHold hold;
  forget(paths_.get());
  paths_.reset();
}

SignalHold::SignalHold() {
  catch_signals();
  ++holds;
}

SignalHold::~SignalHold() {
  if (--holds > 0) return;
  if (const int number = waiting.exchange(0)) end_by(number);
}

}  // namespace rubicon::files
