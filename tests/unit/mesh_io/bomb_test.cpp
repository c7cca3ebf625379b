#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "tests/unit/mesh_io/bombs.hpp"

// Files made to do harm. Each is read by a process of its own, so that the time and memory of all
// that the reading started are known when it has ended.

namespace rubicon::mesh_io::testing {
namespace {

namespace fs = std::filesystem;

/// The promise: refused in this time and memory (all processes together).
constexpr double kSeconds = 2;
constexpr double kMegabytes = 512;

/// Waiting is not counted against a busy machine; a reader that hangs is still found.
constexpr double kWallSeconds = 120;

/// What reading a bomb took.
struct Cost {
  std::string message;  ///< empty: it was read
  double processor_seconds = 0;
  double seconds = 0;
  double megabytes = 0;  ///< the reader's process and the largest one it started
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Reads a file in a process of its own.
Cost cost_of(const std::string& path) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) throw std::runtime_error("no pipe");
  const auto begin = std::chrono::steady_clock::now();
  const pid_t process = ::fork();
  if (process == 0) {
    std::string said;
    {
      const auto result = read_in_own_folder(path);
      const auto* failure = std::get_if<MeshFailure>(&result);
      said = failure == nullptr ? "" : failure->message;
    }
    rusage self{};
    rusage started{};
    ::getrusage(RUSAGE_SELF, &self);
    ::getrusage(RUSAGE_CHILDREN, &started);
    said = fmt::format("{} {}", self.ru_maxrss + started.ru_maxrss, said);
    const bool told = ::write(pipe[1], said.data(), said.size()) >= 0;
    ::_exit(told ? 0 : 1);
  }
  ::close(pipe[1]);
  std::string said;
  std::array<char, 4096> buffer{};
  for (ssize_t got = 0; (got = ::read(pipe[0], buffer.data(), buffer.size())) > 0;) {
    said.append(buffer.data(), static_cast<std::size_t>(got));
  }
  ::close(pipe[0]);
  int status = 0;
  rusage used{};
  ::wait4(process, &status, 0, &used);
  EXPECT_EQ(status, 0) << path;  // the reader itself is unharmed
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  const std::size_t space = said.find(' ');
  Cost cost;
  cost.seconds = wall.count();
  cost.processor_seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  if (space == std::string::npos) return cost;
  cost.megabytes = std::stod(said.substr(0, space)) / 1000;
  cost.message = said.substr(space + 1);
  return cost;
}

/// Counts how often files of a folder are opened or read, by any process.
class Watch {
 public:
  explicit Watch(const fs::path& folder)
      : events_(::inotify_init1(IN_NONBLOCK)),
        works_(::inotify_add_watch(events_, folder.c_str(), IN_OPEN | IN_ACCESS) >= 0) {}
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch() { ::close(events_); }

  bool works() const { return works_; }
  bool seen() const {
    std::array<char, 4096> buffer{};
    return ::read(events_, buffer.data(), buffer.size()) > 0;
  }

 private:
  int events_;
  bool works_;
};

TEST(HarmlessFiles, OfTheSameMakeAreRead) {
  // The bombs above differ from these in one thing only.
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : harmless_files()) {
    const Cost cost = cost_of(folder.write(name, bytes));
    EXPECT_EQ(cost.message, "") << name;
    EXPECT_GT(cost.megabytes, 1) << name;
  }
}

class Bombs : public ::testing::TestWithParam<Bomb> {};

TEST_P(Bombs, AreRefusedSoonAndSmall) {
  const TemporaryFolder inside;
  const TemporaryFolder outside;
  const std::string secret =
      outside.write("secret.bin", gltf_buffer(box_soup({0, 0, 0}, {1, 1, 1})));
  const std::string path = GetParam().lay({inside, outside});
  const Watch watch(outside.path());
  ASSERT_TRUE(watch.works());
  const Cost cost = cost_of(path);
  EXPECT_TRUE(cost.message.starts_with("mesh '")) << "it was read: " << cost.message;
  EXPECT_LT(cost.processor_seconds, kSeconds);
  EXPECT_LT(cost.seconds, kWallSeconds);
  EXPECT_LT(cost.megabytes, kMegabytes);
  EXPECT_FALSE(watch.seen()) << "something outside the folder was opened";
  fmt::print("{:5.2f} s {:5.2f} s processor {:4.0f} MB  {}\n", cost.seconds, cost.processor_seconds,
             cost.megabytes, cost.message.substr(cost.message.find("used: ") + 6, 90));
  RecordProperty("processor_seconds", fmt::format("{:.2f}", cost.processor_seconds));
  RecordProperty("megabytes", fmt::format("{:.0f}", cost.megabytes));
  // The watch can see: otherwise the test would prove nothing.
  std::ifstream(secret).get();
  EXPECT_TRUE(watch.seen());
}

INSTANTIATE_TEST_SUITE_P(Mesh, Bombs, ::testing::ValuesIn(bombs()), [](const auto& tested) {
  std::string name = tested.param.name;
  for (char& c : name) {
    if (c == '.') c = '_';
  }
  return name;
});

}  // namespace
}  // namespace rubicon::mesh_io::testing
