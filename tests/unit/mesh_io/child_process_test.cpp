#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "src/mesh_io/child_process_io.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::mesh_io::testing {
namespace {

using End = ChildResult::End;

ChildResult shell(const std::string& script, std::chrono::milliseconds time_limit,
                  std::size_t output_limit = 1000) {
  return run_child({"/bin/sh", {"-c", script}, time_limit, output_limit});
}

using std::chrono::milliseconds;

TEST(ChildProcess, ItsOutputAndExitCodeAreGiven) {
  const ChildResult result = shell("echo hello; echo unheard >&2; exit 7", milliseconds(5000));
  EXPECT_EQ(result.end, End::kExited);
  EXPECT_EQ(result.code, 7);
  EXPECT_EQ(result.output, "hello\n");
}

TEST(ChildProcess, ASignalIsNamed) {
  const ChildResult result = shell("kill -SEGV $$", milliseconds(5000));
  EXPECT_EQ(result.end, End::kSignalled);
  EXPECT_EQ(result.code, SIGSEGV);
}

TEST(ChildProcess, OneThatSleepsIsEnded) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(shell("exec sleep 60", milliseconds(200)).end, End::kTimedOut);
  EXPECT_EQ(shell("exec sleep 60 >&-", milliseconds(200)).end, End::kTimedOut);  // output closed
  EXPECT_LT(std::chrono::steady_clock::now() - begin, milliseconds(5000));
}

TEST(ChildProcess, OneThatTalksForEverIsEnded) {
  const ChildResult result = shell("while :; do echo y; done", milliseconds(5000), 100'000);
  EXPECT_EQ(result.end, End::kTooMuchOutput);
  EXPECT_LE(result.output.size(), 100'000U);
}

TEST(ChildProcess, AProgramThatIsNotThereIsNotStarted) {
  const ChildResult result = run_child({"/nowhere/rubicon-mesh", {}, milliseconds(1000), 10});
  EXPECT_EQ(result.end, End::kNotStarted);
  EXPECT_EQ(result.code, ENOENT);
}

TEST(ChildProcess, ItSeesNoEnvironmentAndNoOtherOpenFiles) {
  const int open_file = ::open("/etc/passwd", O_RDONLY);
  ASSERT_GE(open_file, 0);
  const ChildResult files = shell(
      "for f in /proc/$$/fd/*; do readlink $f; done | grep -v -e ^pipe: -e ^/proc/ | tr '\\n' ' '",
      milliseconds(5000));
  ::close(open_file);
  EXPECT_EQ(files.output, "/dev/null /dev/null ");
  EXPECT_EQ(shell("echo \"[$HOME$USER$LD_PRELOAD]\"", milliseconds(5000)).output, "[]\n");
}

TEST(ChildProcess, NoProcessIsLeftBehind) {
  shell("exit 0", milliseconds(5000));
  shell("exec sleep 60", milliseconds(50));
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(ChildProcess, ACallerThatIgnoresItsChildrenIsServedToo) {
  const auto before = ::signal(SIGCHLD, SIG_IGN);
  const ChildResult result = shell("echo hello", milliseconds(5000));
  ::signal(SIGCHLD, before);
  EXPECT_EQ(result.end, End::kExited);
  EXPECT_EQ(result.output, "hello\n");
}

TEST(ChildProcess, AMissingHelperIsToldToTheUser) {
  const TemporaryFolder folder;
  MeshRequest request;
  request.path = folder.write("a.stl", as_stl_text(box_soup({0, 0, 0}, {1, 1, 1})));
  request.folder = folder.path().string();
  request.metres_per_unit = 1;
  const auto failure = [&](const std::string& helper) {
    return std::get<MeshFailure>(MeshReader(helper).read(request)).message;
  };
  EXPECT_NE(failure("/nowhere/rubicon-mesh").find("it belongs beside the command"),
            std::string::npos);
  EXPECT_NE(failure("/bin/false").find("does not belong to this version"), std::string::npos);
  EXPECT_NE(failure("/bin/echo").find("does not begin as a mesh does"), std::string::npos);
}

/// Runs only as a copy of this program with the helper beside it, by the test below.
TEST(BesideCommand, DISABLED_ReadsAMesh) {
  const TemporaryFolder folder;
  MeshRequest request;
  request.path = folder.write("a.stl", as_stl_text(box_soup({0, 0, 0}, {1, 1, 1})));
  request.folder = folder.path().string();
  request.metres_per_unit = 1;
  const auto result = read_mesh(request);
  ASSERT_FALSE(std::holds_alternative<MeshFailure>(result))
      << std::get<MeshFailure>(result).message;
  EXPECT_TRUE(std::get<0>(result)->closed);
}

TEST(BesideCommand, TheHelperIsFoundBesideTheRunningProgram) {
  const TemporaryFolder folder;
  const std::string copy = (folder.path() / "program").string();
  std::filesystem::copy_file("/proc/self/exe", copy);
  const std::vector<std::string> arguments = {"--gtest_filter=BesideCommand.DISABLED_ReadsAMesh",
                                              "--gtest_also_run_disabled_tests"};
  const ChildResult without = run_child({copy, arguments, milliseconds(20'000), 100'000});
  EXPECT_EQ(without.code, 1) << without.output;
  EXPECT_NE(without.output.find("it belongs beside the command"), std::string::npos);
  std::filesystem::copy_file(RUBICON_MESH_HELPER, folder.path() / "rubicon-mesh");
  const ChildResult with = run_child({copy, arguments, milliseconds(20'000), 100'000});
  EXPECT_EQ(with.code, 0) << with.output;
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
