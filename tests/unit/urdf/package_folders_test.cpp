#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "src/exchange/urdf/package_folders_io.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::urdf {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A package with a machine in it, and a file outside.
class Packages : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"pack/urdf/parts", "pack/meshes", "other"}) {
      fs::create_directories(folder_.path() / name);
    }
    machine_ = folder_.write("pack/urdf/machine.urdf", "");
    folder_.write("pack/urdf/parts/a.stl", "near");
    folder_.write("pack/meshes/b.stl", "above");
    folder_.write("other/c.stl", "outside");
  }

  /// The path within the folder of the test, or "! MESSAGE | HINT".
  std::string find(PackageFolders& folders, const std::string& reference) const {
    const auto found = folders.find(reference, machine_);
    if (const auto* failure = std::get_if<PackageFailure>(&found)) {
      return "! " + failure->message + " | " + failure->hint;
    }
    const fs::path path = std::get<FoundFile>(found).path;
    return path.lexically_relative(fs::canonical(folder_.path())).string();
  }

  mesh_io::testing::TemporaryFolder folder_;
  std::string machine_;
};

TEST_F(Packages, TheNearestFolderAboveThatHoldsTheRest) {
  PackageFolders folders(machine_, {});
  EXPECT_EQ(find(folders, "parts/a.stl"), "pack/urdf/parts/a.stl");
  EXPECT_EQ(find(folders, "package://any/meshes/b.stl"), "pack/meshes/b.stl");
  // Now the package is known, and its other files may be named directly.
  EXPECT_EQ(find(folders, "../meshes/b.stl"), "pack/meshes/b.stl");
  EXPECT_EQ(find(folders, "file://package://any/meshes/b.stl"), "pack/meshes/b.stl");
  EXPECT_THAT(find(folders, "package://any/meshes/z.stl"),
              HasSubstr("expected the file 'meshes/z.stl'"));
  PackageFolders fresh(machine_, {});
  EXPECT_EQ(find(fresh, "package://pack/meshes/b.stl"), "pack/meshes/b.stl");
  PackageFolders next(machine_, {});
  EXPECT_EQ(find(next, "package://other/c.stl"), "other/c.stl");
}

TEST_F(Packages, ANamedPackageIsThatFolder) {
  PackageFolders folders(machine_, {{"any", (folder_.path() / "other").string()}});
  EXPECT_EQ(find(folders, "package://any/c.stl"), "other/c.stl");
  EXPECT_THAT(find(folders, "package://any/meshes/b.stl"),
              HasSubstr("expected the file 'meshes/b.stl'"));
  PackageFolders missing(machine_, {{"any", "/no/such/folder"}});
  EXPECT_EQ(missing.missing_package(), "/no/such/folder");
}

TEST_F(Packages, NothingIsReadOutsideOfThem) {
  PackageFolders folders(machine_, {});
  EXPECT_THAT(find(folders, "../meshes/b.stl"), HasSubstr("lies outside of"));
  EXPECT_THAT(find(folders, "/etc/passwd"), HasSubstr("lies outside of"));
  EXPECT_THAT(find(folders, "file:///etc/passwd"), HasSubstr("lies outside of"));
  EXPECT_THAT(find(folders, "package://any/../other/c.stl"),
              HasSubstr("lies outside of its package"));
  fs::create_symlink(folder_.path() / "other" / "c.stl",
                     folder_.path() / "pack" / "urdf" / "parts" / "link.stl");
  EXPECT_THAT(find(folders, "parts/link.stl"), HasSubstr("lies outside of"));
  PackageFolders named(machine_, {{"p", (folder_.path() / "pack").string()}});
  EXPECT_THAT(find(named, "package://p/urdf/parts/link.stl"),
              HasSubstr("lies outside of its package"));
  EXPECT_THAT(find(named, "package://p/../other/c.stl"), HasSubstr("lies outside of its package"));
}

TEST_F(Packages, OtherReferencesAreRefused) {
  PackageFolders folders(machine_, {});
  EXPECT_THAT(find(folders, "http://host/a.stl"), HasSubstr("nothing is read over the network"));
  EXPECT_THAT(find(folders, "package://any"), HasSubstr("expected package://NAME/FILE"));
  EXPECT_THAT(find(folders, "package://../c.stl"), HasSubstr("expected package://NAME/FILE"));
  EXPECT_THAT(find(folders, ""), HasSubstr("expected package://NAME/FILE or a path"));
  EXPECT_THAT(find(folders, "parts"), HasSubstr("there is no file"));
  EXPECT_THAT(find(folders, "nothing.stl"), HasSubstr("there is no file"));
  EXPECT_THAT(find(folders, "package://any/nothing.stl"), HasSubstr("--package any=FOLDER"));
}

}  // namespace
}  // namespace rubicon::urdf
