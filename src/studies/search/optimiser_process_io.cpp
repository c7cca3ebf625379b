#include "src/studies/search/optimiser_process_io.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <limits.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

namespace rubicon::study {

namespace {

constexpr const char* kProgram = "rubicon-search";
/// Of one line of an answer.
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

std::string path_of_program() {
  std::array<char, PATH_MAX> buffer{};
  const ssize_t length = ::readlink("/proc/self/exe", buffer.data(), buffer.size());
  const std::string command(buffer.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  const std::size_t folder = command.rfind('/');
  return folder == std::string::npos ? kProgram : command.substr(0, folder + 1) + kProgram;
}

/// "0x1p-1 3": numbers of a line, exact.
std::optional<std::vector<double>> numbers_in(const std::string& line, std::size_t count) {
  std::vector<double> result;
  const char* at = line.c_str();
  while (result.size() < count) {
    char* end = nullptr;
    result.push_back(std::strtod(at, &end));
    if (end == at) return std::nullopt;
    at = end;
  }
  return *at == '\0' ? std::optional(std::move(result)) : std::nullopt;
}

std::string line_of(std::span<const double> numbers) {
  std::string result;
  for (const double each : numbers)
    result += fmt::format("{}{:a}", result.empty() ? "" : " ", each);
  return result + "\n";
}

class OptimiserProcess : public Optimiser {
 public:
  OptimiserProcess(const SearchSpace& space, const SearchPoint& start, std::uint32_t seed)
      : width_(space.ranges + space.values.size()), generation_(space.generation) {
    const std::string program = path_of_program();
    if (const int error = spawn(program); error != 0) {
      failure_ = fmt::format("cannot start '{}': {}", program, std::strerror(error));
      return;
    }
    std::string text = fmt::format("search 1 {} {} {} {} {}\n", seed, space.generation,
                                   space.objectives, space.ranges, space.values.size());
    for (const std::size_t each : space.values) text += fmt::format("{}\n", each);
    send(text + line_of(start));
  }
  OptimiserProcess(const OptimiserProcess&) = delete;
  OptimiserProcess& operator=(const OptimiserProcess&) = delete;

  ~OptimiserProcess() override {
    if (socket_ >= 0) ::close(socket_);
    if (process_ < 0) return;
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
  }

  std::optional<std::vector<SearchPoint>> ask() override {
    std::vector<SearchPoint> result;
    while (result.size() < generation_) {
      const auto line = read_line();
      if (!line) return std::nullopt;
      auto point = numbers_in(*line, width_);
      if (!point) {
        failure_ = fmt::format("{} answers '{}'", kProgram, line->substr(0, 60));
        return std::nullopt;
      }
      result.push_back(std::move(*point));
    }
    return result;
  }

  bool tell(std::span<const std::vector<double>> worths) override {
    std::string text;
    for (const auto& each : worths) text += line_of(each);
    return send(text);
  }

  std::string failure() const override { return failure_; }

 private:
  /// 0, or errno.
  int spawn(const std::string& program) {
    std::array<int, 2> pair{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) return errno;
    socket_ = pair[0];
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, pair[1], STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, pair[1], STDOUT_FILENO);
    ::posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    std::string name = program;
    std::array<char*, 2> words{name.data(), nullptr};
    std::array<char*, 1> environment{nullptr};
    const int error = ::posix_spawn(&process_, program.c_str(), &actions, nullptr, words.data(),
                                    environment.data());
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(pair[1]);
    if (error != 0) process_ = -1;
    return error;
  }

  bool send(std::string_view text) {
    if (!failure_.empty()) return false;
    while (!text.empty()) {
      const ssize_t sent = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) {
        failure_ = fmt::format("{} has ended", kProgram);
        return false;
      }
      text.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }

  std::optional<std::string> read_line() {
    if (!failure_.empty()) return std::nullopt;
    while (true) {
      const std::size_t end = received_.find('\n');
      if (end != std::string::npos) {
        std::string line = received_.substr(0, end);
        received_.erase(0, end + 1);
        return line;
      }
      std::array<char, 4096> buffer{};
      const ssize_t got = ::recv(socket_, buffer.data(), buffer.size(), 0);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0 || received_.size() > kLongestLine) {
        failure_ = fmt::format("{} has ended", kProgram);
        return std::nullopt;
      }
      received_.append(buffer.data(), static_cast<std::size_t>(got));
    }
  }

  std::size_t width_;
  std::size_t generation_;
  int socket_ = -1;
  pid_t process_ = -1;
  std::string received_;
  std::string failure_;
};

}  // namespace

std::unique_ptr<Optimiser> open_optimiser(const SearchSpace& space, const SearchPoint& start,
                                          std::uint32_t seed) {
  return std::make_unique<OptimiserProcess>(space, start, seed);
}

}  // namespace rubicon::study
