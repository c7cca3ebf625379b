#include "src/studies/cluster/mpi_channel_io.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <limits.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <utility>

#include "src/studies/cluster/mpi_plugin.hpp"

namespace rubicon::cluster {

namespace {

constexpr const char* kPluginFile = "rubicon-mpi.so";
constexpr auto kPause = std::chrono::microseconds(200);

/// How many ranks the launcher says there are: by Open MPI's mpirun, else by srun and others.
int ranks_of_launcher() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    if (const char* text = std::getenv(name))
      return static_cast<int>(std::strtol(text, nullptr, 10));
  }
  const char* slurm = std::getenv("SLURM_NTASKS");
  return slurm && std::getenv("PMIX_RANK") ? static_cast<int>(std::strtol(slurm, nullptr, 10)) : 1;
}

std::string folder_of_command() {
  std::array<char, PATH_MAX> buffer{};
  const ssize_t length = ::readlink("/proc/self/exe", buffer.data(), buffer.size());
  const std::string command(buffer.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  const std::size_t slash = command.rfind('/');
  return slash == std::string::npos ? std::string() : command.substr(0, slash + 1);
}

std::string host_name() {
  std::array<char, 256> buffer{};
  ::gethostname(buffer.data(), buffer.size() - 1);
  return buffer.data();
}

class LoadedMpi : public MpiChannel {
 public:
  explicit LoadedMpi(const MpiPlugin& plugin) : plugin_(plugin), host_(host_name()) {}

  int rank() const override { return plugin_.rank(); }
  int size() const override { return plugin_.size(); }
  void send(int to, std::string message) override {
    plugin_.send(to, message.data(), static_cast<long>(message.size()));
  }
  std::optional<Received> receive() override {
    Received received;
    const long size = plugin_.look(&received.from);
    if (size < 0) return std::nullopt;
    received.message.resize(static_cast<std::size_t>(size));
    if (plugin_.take(received.from, received.message.data(), size) == 0) return std::nullopt;
    return received;
  }
  std::string identity() const override { return fmt::format("{} {}", ::getpid(), host_); }
  /// Of another computer nobody can tell.
  bool is_gone(const std::string& identity) const override {
    const std::size_t space = identity.find(' ');
    if (space == std::string::npos || identity.substr(space + 1) != host_) return false;
    const long process = std::strtol(identity.c_str(), nullptr, 10);
    return process > 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
  }
  double now() const override {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
  }
  void pause() override { std::this_thread::sleep_for(kPause); }
  void end(bool all_there) override { plugin_.end(all_there ? 1 : 0); }

 private:
  const MpiPlugin& plugin_;
  std::string host_;
};

}  // namespace

std::variant<std::unique_ptr<MpiChannel>, std::string> open_mpi() {
  const int ranks = ranks_of_launcher();
  if (ranks <= 1) return std::unique_ptr<MpiChannel>();
  const std::string path = folder_of_command() + kPluginFile;
  // MPI loads files of its own, which must find it.
  void* const file = ::dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (file == nullptr) {
    return fmt::format(
        "started as one of {} ranks, and this build has no MPI ({}): each would make the whole "
        "study. Install libopenmpi-dev and build again, or start one process with --jobs {}",
        ranks, ::dlerror(), ranks);
  }
  using Begin = const MpiPlugin* (*)(int);
  const auto begin = reinterpret_cast<Begin>(::dlsym(file, kMpiBegin));
  const MpiPlugin* const plugin = begin ? begin(kMpiPluginVersion) : nullptr;
  if (plugin == nullptr) return fmt::format("'{}': MPI cannot begin", path);
  std::unique_ptr<MpiChannel> channel = std::make_unique<LoadedMpi>(*plugin);
  if (channel->size() == 1) {
    channel->end(true);
    return std::unique_ptr<MpiChannel>();
  }
  return channel;
}

}  // namespace rubicon::cluster
