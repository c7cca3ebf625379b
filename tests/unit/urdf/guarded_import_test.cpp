#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <new>

#include "src/exchange/urdf/guarded_import_io.hpp"
#include "tests/unit/urdf/machine_support.hpp"

namespace rubicon::urdf::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* kMachine =
    "<robot name=\"r\" xmlns:xacro=\"x\"><xacro:include filename=\"a.xacro\"/></robot>";

std::variant<GuardedImport, std::string> guarded(const Printer& print) {
  MemoryPackage files;
  files.texts["a.xacro"] =
      "<robot><link name=\"a\"><collision><geometry><mesh filename=\"b.stl\" scale=\"1 2 3\"/>"
      "</geometry></collision></link></robot>";
  files.texts["b.stl"] = "";
  MachineTerms terms;
  terms.path = "machine.urdf";
  terms.meshes = "meshes";
  return import_guarded(terms, kMachine, files, print);
}

TEST(GuardedImport, AnswersAsTheImportDoes) {
  const auto result = guarded(
      [](const interpreter::Diagnostics& diagnostics, const interpreter::SourceMap& sources) {
        return std::to_string(diagnostics.all().size()) + " of " + std::to_string(sources.size());
      });
  ASSERT_TRUE(std::holds_alternative<GuardedImport>(result)) << std::get<std::string>(result);
  const auto& import = std::get<GuardedImport>(result);
  EXPECT_EQ(import.messages, "1 of 2");  // nothing moves; two files
  ASSERT_TRUE(import.machine);
  EXPECT_THAT(import.machine->robot, HasSubstr("shape mesh(\"meshes/b_scaled.obj\", m);"));
  ASSERT_EQ(import.machine->meshes.size(), 1U);
  EXPECT_EQ(import.machine->meshes[0].source, "b.stl");
  EXPECT_EQ(import.machine->meshes[0].scale, (Triple{1, 2, 3}));
}

/// What is printed is made in the child: so a test can try there what a taken-over child would.
TEST(GuardedImport, TheChildOpensNothing) {
  if (kSanitized) GTEST_SKIP() << "sanitizers need system calls that are filtered";
  const auto result = guarded([](const auto&, const auto&) {
    std::string done;
    if (::open("/etc/passwd", O_RDONLY) >= 0) done += "read ";
    if (::open("/tmp/rubicon_guarded_import", O_CREAT | O_WRONLY, 0600) >= 0) done += "wrote ";
    if (::socket(AF_INET, SOCK_STREAM, 0) >= 0) done += "connected ";
    if (::fork() >= 0) done += "forked ";
    for (int fd = 4; fd < 100; ++fd) {
      if (struct stat status{}; ::fstat(fd, &status) == 0) done += "inherited ";
    }
    return done;
  });
  ASSERT_TRUE(std::holds_alternative<GuardedImport>(result));
  EXPECT_EQ(std::get<GuardedImport>(result).messages, "");
}

TEST(GuardedImport, AChildThatEndsIsAMessage) {
  const auto ended = guarded([](const auto&, const auto&) -> std::string { ::_exit(7); });
  ASSERT_TRUE(std::holds_alternative<std::string>(ended));
  EXPECT_THAT(std::get<std::string>(ended), HasSubstr("ended without an answer"));
  const auto full =
      guarded([](const auto&, const auto&) -> std::string { throw std::bad_alloc(); });
  ASSERT_TRUE(std::holds_alternative<std::string>(full));
  EXPECT_THAT(std::get<std::string>(full), HasSubstr("MB of memory"));
}

}  // namespace
}  // namespace rubicon::urdf::testing
