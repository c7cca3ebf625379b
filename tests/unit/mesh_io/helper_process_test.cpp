#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <thread>

#include "src/exchange/mesh_io/scene_source_io.hpp"
#include "tests/support/places.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"
#include "tests/unit/mesh_io/processes_io.hpp"

namespace rubicon::mesh_io::testing {
namespace {

/// A folder with a mesh, and requests for it.
class Helper : public ::testing::Test {
 protected:
  MeshRequest box(const std::string& name = "a.stl", double size = 1) const {
    MeshRequest request;
    request.path = folder_.write(name, as_stl_text(box_soup({0, 0, 0}, {size, 1, 1})));
    request.folder = folder_.path().string();
    request.metres_per_unit = 1;
    return request;
  }

  /// A mesh that takes seconds, and is just within what is counted.
  MeshRequest slow() const {
    MeshRequest request = box();
    request.path = folder_.write("slow.obj", spiral_obj(7'000));
    return request;
  }

  /// Waits for a child no longer than a second of processor time, or three by the clock.
  static SceneSource impatient(const std::string& helper = test::mesh_helper()) {
    return {helper, "", {1, 8'000'000, 2, 1}};
  }

  static std::string message(SceneSource& source, const MeshRequest& request) {
    const auto result = source.read({request.path, request.folder, request.up != 0});
    const auto* failure = std::get_if<SceneFailure>(&result);
    return failure == nullptr ? "" : *failure;
  }

  std::string message(const MeshReader& meshes, const MeshRequest& request) const {
    const auto result = meshes.read(request);
    const auto* failure = std::get_if<MeshFailure>(&result);
    return failure == nullptr ? "" : failure->message;
  }

  const TemporaryFolder folder_;
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The process that parses for us just now.
pid_t child_of(pid_t helper) {
  pid_t child = -1;
  comes_true([&] {
    const std::vector<pid_t> children = children_of(helper);
    // Not before it has closed the door behind itself.
    if (children.size() == 1 && status_of(children[0], "Seccomp") == "2") child = children[0];
    return child > 0;
  });
  return child;
}

TEST_F(Helper, IsStartedOnceAndEndsWithItsReader) {
  {
    const MeshReader meshes = reader();
    EXPECT_TRUE(children_of(::getpid()).empty());
    ASSERT_EQ(message(meshes, box("a.stl", 1)), "");
    const std::vector<pid_t> helper = children_of(::getpid());
    ASSERT_EQ(helper.size(), 1U);
    ASSERT_EQ(message(meshes, box("a.stl", 2)), "");
    EXPECT_EQ(children_of(::getpid()), helper);
    EXPECT_TRUE(children_of(helper[0]).empty());
  }
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST_F(Helper, IsStartedAgainWhenItWasKilled) {
  const MeshReader meshes = reader();
  ASSERT_EQ(message(meshes, box("a.stl", 1)), "");
  const pid_t first = children_of(::getpid()).at(0);
  ::kill(first, SIGKILL);
  ASSERT_TRUE(comes_true([&] { return status_of(first, "State").starts_with("Z"); }));
  EXPECT_EQ(message(meshes, box("a.stl", 2)), "");
  EXPECT_NE(children_of(::getpid()).at(0), first);
}

TEST_F(Helper, EndsWhenWeAreKilled) {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // so that we see what is left behind
  const MeshRequest request = box();
  const MeshRequest long_one = slow();
  const pid_t user = ::fork();
  if (user == 0) {
    const MeshReader meshes = reader();
    static_cast<void>(meshes.read(request));
    static_cast<void>(meshes.read(long_one));  // never ends: we are killed before
    ::pause();
  }
  ASSERT_TRUE(comes_true([&] { return children_of(user).size() == 1; }));
  const pid_t helper = children_of(user).at(0);
  const pid_t child = child_of(helper);
  ASSERT_GT(child, 0);
  ::kill(user, SIGKILL);
  // All three become ours, and end.
  int reaped = 0;
  EXPECT_TRUE(comes_true([&] {
    while (::waitpid(-1, nullptr, WNOHANG) > 0) ++reaped;
    return reaped >= 2 && ::kill(helper, 0) != 0 && ::kill(child, 0) != 0;
  }));
  ::prctl(PR_SET_CHILD_SUBREAPER, 0);
}

TEST_F(Helper, SeesNoEnvironmentAndNoOpenFilesOfOurs) {
  const MeshReader meshes = reader();
  ASSERT_EQ(message(meshes, box()), "");
  const pid_t helper = children_of(::getpid()).at(0);
  const std::vector<std::string> own = {"0 socket", "1 /dev/null", "2 /dev/null", "3 anon_inode"};
  // It closes the last channel of a job after it has told us its end.
  EXPECT_TRUE(comes_true([&] { return open_files_of(helper) == own; }))
      << ::testing::PrintToString(open_files_of(helper));
  std::ifstream environment("/proc/" + std::to_string(helper) + "/environ");
  const std::string text(std::istreambuf_iterator<char>(environment), {});
  EXPECT_FALSE(has(text, "HOME")) << text;
  EXPECT_FALSE(has(text, "PATH")) << text;
}

TEST_F(Helper, ItsChildIsGuarded) {
  SceneSource meshes = impatient();
  ASSERT_EQ(message(meshes, box()), "");
  auto reading = std::async(std::launch::async, [&] { return message(meshes, slow()); });
  const pid_t child = child_of(children_of(::getpid()).at(0));
  ASSERT_GT(child, 0);
  EXPECT_EQ(status_of(child, "NoNewPrivs"), "1");
  const std::vector<std::string> files = open_files_of(child);
  EXPECT_EQ(files.size(), 5U) << ::testing::PrintToString(files);
  for (const std::string& file : files) EXPECT_FALSE(has(file, "socket")) << file;
  std::ifstream limits("/proc/" + std::to_string(child) + "/limits");
  const std::string text(std::istreambuf_iterator<char>(limits), {});
  for (const char* limit : {"Max cpu time              1 ", "Max file size             0 ",
                            "Max core file size        1 ", "Max open files            16 "}) {
    EXPECT_TRUE(has(text, limit)) << limit << "\n" << text;
  }
  EXPECT_FALSE(has(text, "Max address space         unlimited")) << text;
  EXPECT_TRUE(has(reading.get(), "hung: it was ended after 1 s of processor time"));
}

TEST_F(Helper, AChildThatSleepsIsEnded) {
  SceneSource meshes = impatient();
  ASSERT_EQ(message(meshes, box()), "");
  auto reading = std::async(std::launch::async, [&] { return message(meshes, slow()); });
  const pid_t helper = children_of(::getpid()).at(0);
  const pid_t child = child_of(helper);
  ASSERT_GT(child, 0);
  ::kill(child, SIGSTOP);
  EXPECT_TRUE(has(reading.get(), "gave no answer for 3 s"));
  EXPECT_TRUE(children_of(helper).empty());
  EXPECT_EQ(message(meshes, box("a.stl", 3)), "");
  EXPECT_EQ(children_of(::getpid()).at(0), helper);
}

TEST_F(Helper, AHelperThatSleepsIsEnded) {
  SceneSource meshes = impatient();
  ASSERT_EQ(message(meshes, box()), "");
  const pid_t helper = children_of(::getpid()).at(0);
  ::kill(helper, SIGSTOP);
  EXPECT_TRUE(has(message(meshes, box("a.stl", 2)), "gave no answer for 3 s"));
  EXPECT_TRUE(children_of(::getpid()).empty());
  EXPECT_EQ(message(meshes, box("a.stl", 3)), "");
}

TEST_F(Helper, ACallerThatIgnoresItsChildrenIsServedToo) {
  const auto before = ::signal(SIGCHLD, SIG_IGN);
  sigset_t all;
  sigset_t mask;
  ::sigfillset(&all);
  ::sigprocmask(SIG_SETMASK, &all, &mask);
  EXPECT_EQ(message(reader(), box()), "");
  {
    SceneSource meshes = impatient();
    EXPECT_TRUE(has(message(meshes, slow()), "hung: it was ended after 1 s of processor time"));
  }
  ::sigprocmask(SIG_SETMASK, &mask, nullptr);
  ::signal(SIGCHLD, before);
  EXPECT_TRUE(comes_true([] { return children_of(::getpid()).empty(); }));
}

TEST_F(Helper, ManyThreadsReadAtOnceAndNothingIsLeftOpen) {
  const MeshReader meshes = reader();
  ASSERT_EQ(message(meshes, box()), "");
  const std::size_t files_before = open_files_of(::getpid()).size();
  constexpr int kThreads = 8;
  constexpr int kFiles = 20;
  std::vector<MeshRequest> requests;
  for (int i = 0; i < kThreads * kFiles; ++i) {
    // Every fourth is damaged: its child ends otherwise.
    requests.push_back(box("m" + std::to_string(i) + ".stl", 1 + i));
    if (i % 4 == 3)
      folder_.write("m" + std::to_string(i) + ".stl", "solid\nfacet" + std::to_string(i));
  }
  std::atomic<int> right = 0;
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < kThreads; ++t) {
      threads.emplace_back([&, t] {
        for (int i = t; i < kThreads * kFiles; i += kThreads) {
          const auto result = meshes.read(requests[static_cast<std::size_t>(i)]);
          const auto* read = std::get_if<ReadMesh>(&result);
          if (i % 4 == 3) {
            right += read == nullptr ? 1 : 0;
          } else if (read != nullptr) {
            right += extent(*read->mesh).upper.x() == 1 + i ? 1 : 0;
          }
        }
      });
    }
  }
  EXPECT_EQ(right, kThreads * kFiles);
  EXPECT_EQ(open_files_of(::getpid()).size(), files_before);
  const std::vector<pid_t> helpers = children_of(::getpid());
  ASSERT_EQ(helpers.size(), 1U);
  EXPECT_TRUE(children_of(helpers[0]).empty());
  EXPECT_TRUE(comes_true([&] { return open_files_of(helpers[0]).size() == 4; }));
}

TEST_F(Helper, AMissingOrWrongProgramIsToldToTheUser) {
  const auto failure = [&](const std::string& helper) {
    SceneSource meshes = impatient(helper);
    return message(meshes, box());
  };
  EXPECT_TRUE(has(failure("/nowhere/rubicon-mesh"), "it belongs beside the command"));
  EXPECT_TRUE(has(failure(""), "it belongs beside the command"));
  for (const char* wrong : {"/bin/false", "/bin/echo", "/bin/cat"}) {
    // It depends on who is faster whether the job can still be handed over.
    const std::string told = failure(wrong);
    EXPECT_TRUE(has(told, wrong)) << told;
    EXPECT_TRUE(has(told, "does not belong to this version") ||
                has(told, "it belongs beside the command"))
        << told;
  }
  // Takes no jobs and does not end.
  EXPECT_NE(failure("/usr/bin/yes"), "");
  EXPECT_TRUE(children_of(::getpid()).empty());
}

/// Runs only as a copy of this program with the helper beside it, by the test below.
TEST(BesideCommand, DISABLED_ReadsAMesh) {
  const TemporaryFolder folder;
  MeshRequest request;
  request.path = folder.write("a.stl", as_stl_text(box_soup({0, 0, 0}, {1, 1, 1})));
  request.folder = folder.path().string();
  request.metres_per_unit = 1;
  const auto result = MeshReader::beside_command().read(request);
  ASSERT_FALSE(std::holds_alternative<MeshFailure>(result))
      << std::get<MeshFailure>(result).message;
  EXPECT_TRUE(std::get<ReadMesh>(result).mesh->closed);
}

TEST(BesideCommand, TheHelperIsFoundBesideTheRunningProgram) {
  const TemporaryFolder folder;
  const std::string copy = (folder.path() / "program").string();
  std::filesystem::copy_file("/proc/self/exe", copy);
  const std::string command = "RUBICON_CACHE=off '" + copy +
                              "' --gtest_filter=BesideCommand.DISABLED_ReadsAMesh "
                              "--gtest_also_run_disabled_tests > '" +
                              (folder.path() / "said").string() + "' 2>&1";
  const auto said = [&] {
    std::ifstream file(folder.path() / "said");
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_TRUE(has(said(), "it belongs beside the command")) << said();
  std::filesystem::copy_file(test::mesh_helper(), folder.path() / "rubicon-mesh");
  EXPECT_EQ(std::system(command.c_str()), 0) << said();
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
