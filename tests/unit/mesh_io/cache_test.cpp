#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>

#include "src/exchange/mesh_io/disk_cache_io.hpp"
#include "src/exchange/mesh_io/scene_source_io.hpp"
#include "src/exchange/mesh_io/scene_wire.hpp"
#include "tests/support/places.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"
#include "tests/unit/mesh_io/processes_io.hpp"

// What was read is remembered by content: in the reader, and in a folder of the user's.

namespace rubicon::mesh_io::testing {
namespace {

namespace fs = std::filesystem;

Digest key_of(int number) {
  encoding::Sha256 hash;
  hash.add(std::to_string(number));
  return hash.finish();
}

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

void overwrite(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& file : fs::directory_iterator(folder, none)) files.push_back(file.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Sets a variable of the environment for the length of a test.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    if (value == nullptr) {
      ::unsetenv(name);
    } else {
      ::setenv(name, value, 1);
    }
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() {
    if (before_) {
      ::setenv(name_.c_str(), before_->c_str(), 1);
    } else {
      ::unsetenv(name_.c_str());
    }
  }

 private:
  std::string name_;
  std::optional<std::string> before_;
};

TEST(DiskCache, ItsFolderIsTheUsersChoice) {
  const Variable cache("XDG_CACHE_HOME", "/somewhere");
  const Variable home("HOME", "/home/me");
  const Variable wish("RUBICON_CACHE", nullptr);
  EXPECT_EQ(default_cache_folder(), "/somewhere/rubicon/meshes");
  const Variable relative("XDG_CACHE_HOME", "somewhere");
  EXPECT_EQ(default_cache_folder(), "/home/me/.cache/rubicon/meshes");
  const Variable unset("XDG_CACHE_HOME", nullptr);
  EXPECT_EQ(default_cache_folder(), "/home/me/.cache/rubicon/meshes");
  const Variable homeless("HOME", nullptr);
  EXPECT_EQ(default_cache_folder(), "");
  const Variable again("XDG_CACHE_HOME", "/somewhere");
  const Variable off("RUBICON_CACHE", "off");
  EXPECT_EQ(default_cache_folder(), "");
}

TEST(DiskCache, GivesBackWhatWasKeptAndNothingElse) {
  const TemporaryFolder folder;
  const fs::path place = folder.path() / "a/b/c";
  DiskCache cache(place.string());
  EXPECT_FALSE(cache.find(key_of(1)));
  cache.put(key_of(1), std::string("one\0two", 7));
  EXPECT_EQ(DiskCache(place.string()).find(key_of(1)), std::string("one\0two", 7));
  EXPECT_FALSE(cache.find(key_of(2)));
  cache.put(key_of(1), "");
  EXPECT_EQ(cache.find(key_of(1)), "");
  EXPECT_EQ(files_in(place).size(), 1U);
  struct stat status {};
  ASSERT_EQ(::stat(place.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0700U);
}

TEST(DiskCache, ADamagedEntryIsNoEntry) {
  const TemporaryFolder folder;
  DiskCache cache(folder.path().string());
  const std::string payload = "what was kept";
  cache.put(key_of(1), payload);
  const fs::path file = files_in(folder.path()).at(0);
  const std::string whole = content(file);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 4);
    overwrite(file, changed);
    EXPECT_FALSE(cache.find(key_of(1))) << i;
    overwrite(file, whole.substr(0, i));
    EXPECT_FALSE(cache.find(key_of(1))) << i;
  }
  overwrite(file, whole + "x");
  EXPECT_FALSE(cache.find(key_of(1)));
  // A whole entry under the name of another.
  cache.put(key_of(2), "another");
  const std::vector<fs::path> both = files_in(folder.path());
  const fs::path other = both[0] == file ? both[1] : both[0];
  fs::copy_file(other, file, fs::copy_options::overwrite_existing);
  EXPECT_FALSE(cache.find(key_of(1)));
  cache.put(key_of(1), payload);
  EXPECT_EQ(cache.find(key_of(1)), payload);
}

TEST(DiskCache, LinksPipesAndFoldersInPlaceOfAnEntry) {
  const TemporaryFolder folder;
  DiskCache cache((folder.path() / "cache").string());
  cache.put(key_of(1), "kept");
  const fs::path file = files_in(folder.path() / "cache").at(0);
  fs::rename(file, folder.path() / "elsewhere");
  fs::create_symlink(folder.path() / "elsewhere", file);
  EXPECT_FALSE(cache.find(key_of(1)));
  fs::remove(file);
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  EXPECT_FALSE(cache.find(key_of(1)));  // and does not wait
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_FALSE(cache.find(key_of(1)));
  cache.put(key_of(1), "kept");  // cannot be
  EXPECT_EQ(files_in(folder.path() / "cache").size(), 1U);
}

TEST(DiskCache, AFolderThatCannotBeIsNoFault) {
  const TemporaryFolder folder;
  overwrite(folder.path() / "file", "no folder");
  for (const std::string& place :
       {(folder.path() / "file/cache").string(), std::string("/proc/none/cache"),
        std::string("/dev/null/x"), std::string()}) {
    DiskCache cache(place);
    cache.put(key_of(1), "kept");
    EXPECT_FALSE(cache.find(key_of(1))) << place;
  }
}

TEST(DiskCache, TheOldestGoesWhenItIsFull) {
  const TemporaryFolder folder;
  constexpr std::uint64_t kMost = 20'000;
  const std::string payload(1000, 'x');
  const auto bytes_there = [&] {
    std::uintmax_t bytes = 0;
    for (const fs::path& file : files_in(folder.path())) bytes += fs::file_size(file);
    return bytes;
  };
  // Left behind by a program that was ended, long ago and just now; and a file of somebody else.
  overwrite(folder.path() / ".tmp-old", payload);
  overwrite(folder.path() / ".tmp-new", payload);
  overwrite(folder.path() / "README", "keep me");
  fs::last_write_time(folder.path() / ".tmp-old",
                      fs::file_time_type::clock::now() - std::chrono::hours(3));
  {
    DiskCache cache(folder.path().string(), kMost);
    for (int i = 0; i < 15; ++i) cache.put(key_of(i), payload);
    int age = 0;
    for (int i = 0; i < 15; ++i) {
      const fs::path file = folder.path() / (encoding::hex(key_of(i)) + ".mesh");
      fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(100 - ++age));
    }
    EXPECT_EQ(cache.find(key_of(0)), payload);  // used: no longer the oldest
    for (int i = 15; i < 60; ++i) {
      cache.put(key_of(i), payload);
      EXPECT_LE(bytes_there(), kMost);
      if (i == 20) {
        EXPECT_TRUE(cache.find(key_of(0)));
        EXPECT_FALSE(cache.find(key_of(1)));
      }
    }
    EXPECT_TRUE(cache.find(key_of(59)));
  }
  EXPECT_FALSE(fs::exists(folder.path() / ".tmp-old"));
  EXPECT_TRUE(fs::exists(folder.path() / ".tmp-new"));
  EXPECT_TRUE(fs::exists(folder.path() / "README"));
  // Another program that finds it full.
  DiskCache(folder.path().string(), kMost / 2).put(key_of(100), payload);
  EXPECT_LE(bytes_there(), kMost / 2);
  DiskCache small(folder.path().string(), 500);
  small.put(key_of(101), payload);
  EXPECT_FALSE(small.find(key_of(101)));
}

TEST(DiskCache, WritersAndReadersAtOnceSeeWholeEntries) {
  const TemporaryFolder folder;
  std::vector<std::jthread> threads;
  std::atomic<int> wrong = 0;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      DiskCache cache(folder.path().string(), 60'000);
      for (int i = 0; i < 200; ++i) {
        const int number = i % 20;
        cache.put(key_of(number), std::string(4000, static_cast<char>('a' + number)));
        const auto found = cache.find(key_of((number + t) % 20));
        if (found && *found != std::string(4000, static_cast<char>('a' + (number + t) % 20))) {
          ++wrong;
        }
      }
    });
  }
  threads.clear();
  EXPECT_EQ(wrong, 0);
}

/// A mesh in a folder of its own beside a cache of its own.
class Remembered : public ::testing::Test {
 protected:
  MeshReader reader_with_cache() const {
    return MeshReader(test::mesh_helper(), (folder_.path() / "cache").string());
  }
  MeshRequest request(const std::string& name, const std::string& bytes) const {
    MeshRequest result;
    result.path = folder_.write("meshes/" + name, bytes);
    result.folder = (folder_.path() / "meshes").string();
    result.metres_per_unit = needs_unit(name) ? 1 : 0;
    return result;
  }
  std::vector<fs::path> kept() const { return files_in(folder_.path() / "cache"); }
  /// Whether this reader had to start the helper: nothing else does.
  static bool asked_helper() { return !children_of(::getpid()).empty(); }

  const TemporaryFolder folder_;
  const Soup soup_ = box_soup({1, 2, 3}, {2, 4, 6});
};

const ReadMesh& mesh_in(const std::variant<ReadMesh, MeshFailure>& result) {
  if (const auto* failure = std::get_if<MeshFailure>(&result)) {
    throw std::runtime_error(failure->message);
  }
  return std::get<ReadMesh>(result);
}

void expect_equal(const ReadMesh& a, const ReadMesh& b) {
  EXPECT_EQ(a.mesh->vertices, b.mesh->vertices);
  EXPECT_EQ(a.mesh->triangles, b.mesh->triangles);
  EXPECT_EQ(a.mesh->closed, b.mesh->closed);
  EXPECT_EQ(a.report.welded_vertices, b.report.welded_vertices);
  EXPECT_EQ(a.report.turned_triangles, b.report.turned_triangles);
}

TEST_F(Remembered, EqualRequestsShareAMesh) {
  const MeshReader meshes = reader();
  const MeshRequest a = request("a.stl", as_stl_text(soup_));
  const MeshRequest same = request("b.stl", as_stl_text(soup_));
  const auto first = meshes.read(a);
  EXPECT_EQ(mesh_in(first).mesh, mesh_in(meshes.read(a)).mesh);
  EXPECT_EQ(mesh_in(first).mesh, mesh_in(meshes.read(same)).mesh);
  MeshRequest other = a;
  other.scale = 2;
  EXPECT_NE(mesh_in(first).mesh, mesh_in(meshes.read(other)).mesh);
  EXPECT_EQ(extent(*mesh_in(meshes.read(other)).mesh).upper, geometry::Vec3(4, 8, 12));
  other = a;
  other.up = 'y';
  EXPECT_EQ(extent(*mesh_in(meshes.read(other)).mesh).upper, geometry::Vec3(2, -3, 4));
  other = a;
  other.hull = true;
  EXPECT_NE(mesh_in(first).mesh, mesh_in(meshes.read(other)).mesh);
  // A changed file is another mesh.
  folder_.write("meshes/a.stl", as_stl_text(box_soup({0, 0, 0}, {1, 1, 1})));
  EXPECT_EQ(extent(*mesh_in(meshes.read(a)).mesh).upper, geometry::Vec3(1, 1, 1));
}

TEST_F(Remembered, PartsOfAFileAreReadFromOneParse) {
  const MeshReader meshes = reader();
  MeshRequest part = request("a.dae", as_dae(soup_, "Z_UP", "1"));
  part.part = "part_a";
  EXPECT_EQ(extent(*mesh_in(meshes.read(part)).mesh).upper, geometry::Vec3(12, 4, 6));
  ASSERT_TRUE(asked_helper());
  ::kill(children_of(::getpid()).at(0), SIGSTOP);  // it could not answer again
  part.part = "part_c";
  EXPECT_EQ(extent(*mesh_in(meshes.read(part)).mesh).upper, geometry::Vec3(2, 4, 106));
}

/// Long enough that the next change of a file gives it another stamp.
void let_files_settle() { std::this_thread::sleep_for(std::chrono::milliseconds(150)); }

FileQuery query(const MeshRequest& request) { return {request.path, request.folder, false}; }

TEST_F(Remembered, AFileIsHashedAndParsedOnceHoweverManyOfItsPartsAreAskedFor) {
  const MeshRequest model = request("a.dae", as_dae(soup_, "Z_UP", "1"));
  let_files_settle();
  for (const bool again : {false, true}) {
    SceneSource source(test::mesh_helper(), (folder_.path() / "cache").string());
    for (int i = 0; i < 50; ++i) {
      EXPECT_TRUE(std::holds_alternative<FileContent>(source.read(query(model))));
    }
    EXPECT_EQ(source.work().hashed, 1U);
    EXPECT_EQ(source.work().parsed, again ? 0U : 1U);
    EXPECT_EQ(source.work().decoded, 1U);
  }
}

TEST_F(Remembered, AChangedFileIsReadAgain) {
  SceneSource source(test::mesh_helper(), "");
  const auto upper_x = [&](const MeshRequest& request) {
    const auto read = source.read(query(request));
    double x = 0;
    for (const FileNode& node : std::get<FileContent>(read).scene->nodes) {
      for (const auto& p : node.vertices) x = std::max(x, p.x());
    }
    return x;
  };
  // Of the same size each, one behind the other as fast as can be: stamps may be equal.
  for (int i = 1; i <= 9; ++i) {
    EXPECT_EQ(upper_x(request("a.stl", as_stl_binary(box_soup({0, 0, 0}, {1.0 * i, 1, 1})))), i);
  }
  let_files_settle();
  upper_x(request("a.stl", as_stl_binary(soup_)));
  EXPECT_EQ(source.work().hashed, 10U);
}

TEST_F(Remembered, WhatCannotBeReadIsTriedOnce) {
  const MeshRequest damaged = request("a.stl", "solid\nfacet");
  let_files_settle();
  SceneSource source(test::mesh_helper(), "");
  std::set<std::string> said;
  for (int i = 0; i < 20; ++i) said.insert(std::get<SceneFailure>(source.read(query(damaged))));
  EXPECT_EQ(said.size(), 1U);
  EXPECT_EQ(source.work().hashed, 1U);
  EXPECT_EQ(source.work().parsed, 1U);
}

TEST_F(Remembered, AFileWithOthersBesideItIsParsedOnceUntilOneOfThemChanges) {
  folder_.write("meshes/own.bin", gltf_buffer(soup_));
  const MeshRequest gltf = request("a.gltf", as_gltf(soup_, "own.bin"));
  let_files_settle();
  SceneSource source(test::mesh_helper(), "");
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(std::holds_alternative<FileContent>(source.read(query(gltf))));
  }
  EXPECT_EQ(source.work().hashed, 1U);
  EXPECT_EQ(source.work().parsed, 1U);
  folder_.write("meshes/own.bin", gltf_buffer(box_soup({1, 2, 3}, {2, 4, 60})));
  const auto read = source.read(query(gltf));
  double farthest = 0;
  for (const FileNode& node : std::get<FileContent>(read).scene->nodes) {
    for (const auto& p : node.vertices) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  }
  EXPECT_EQ(farthest, 60);
}

TEST_F(Remembered, TheNextRunNeedsNoHelperAndGivesTheSame) {
  const std::map<std::string, std::string> files = {{"a.stl", as_stl_text(soup_)},
                                                    {"b.stl", as_stl_binary(soup_)},
                                                    {"a.obj", as_obj(soup_)},
                                                    {"a.ply", as_ply(soup_)},
                                                    {"a.dae", as_dae(soup_, "Y_UP", "2")},
                                                    {"a.gltf", as_gltf(soup_, "")}};
  for (const auto& [name, bytes] : files) {
    MeshRequest each = request(name, bytes);
    for (const char up : {'\0', 'y', 'z'}) {
      for (const bool hull : {false, true}) {
        each.up = up;
        each.hull = hull;
        const auto fresh = reader().read(each);
        const auto first = reader_with_cache().read(each);
        const MeshReader meshes = reader_with_cache();
        const auto second = meshes.read(each);
        EXPECT_FALSE(asked_helper()) << name;
        expect_equal(mesh_in(fresh), mesh_in(first));
        expect_equal(mesh_in(fresh), mesh_in(second));
      }
    }
  }
}

TEST_F(Remembered, ADamagedEntryIsReadAnewAndMended) {
  const MeshRequest box = request("a.stl", as_stl_text(soup_));
  const auto first = reader_with_cache().read(box);
  ASSERT_EQ(kept().size(), 1U);
  const fs::path file = kept()[0];
  const std::string whole = content(file);
  std::string changed = whole;
  changed[whole.size() / 2] = static_cast<char>(changed[whole.size() / 2] ^ 1);
  for (const std::string& bytes : {std::string(), whole.substr(0, whole.size() / 2), changed}) {
    overwrite(file, bytes);
    const MeshReader meshes = reader_with_cache();
    expect_equal(mesh_in(first), mesh_in(meshes.read(box)));
    EXPECT_TRUE(asked_helper());
    EXPECT_EQ(content(file), whole);
  }
}

/// An entry with a right checksum around `message`, in place of the only one.
void forge(const fs::path& folder, const fs::path& file, const std::string& message) {
  Digest key{};
  const std::string name = file.stem().string();
  for (std::size_t i = 0; i < key.size(); ++i) {
    key[i] = static_cast<std::uint8_t>(std::stoi(name.substr(2 * i, 2), nullptr, 16));
  }
  DiskCache(folder.string()).put(key, message);
}

TEST_F(Remembered, AHostileEntryCannotGetThrough) {
  const MeshRequest box = request("a.stl", as_stl_text(soup_));
  const auto first = reader_with_cache().read(box);
  const fs::path file = kept().at(0);
  const auto message = [](const FileScene& scene) {
    std::string bytes;
    encode(scene, [&](std::string_view piece) {
      bytes += piece;
      return true;
    });
    return bytes;
  };
  FileScene scene;
  scene.nodes.push_back({"a", -1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  FileScene out_of_range = scene;
  out_of_range.nodes[0].triangles[0][2] = 1'000'000;
  FileScene negative = scene;
  negative.nodes[0].triangles[0][2] = -1;
  FileScene endless = scene;
  endless.nodes[0].vertices[1].x() = std::numeric_limits<double>::infinity();
  FileScene no_unit = scene;
  no_unit.declared_metres_per_unit = std::numeric_limits<double>::quiet_NaN();
  std::string failure;
  encode(std::string("not true"), [&](std::string_view piece) {
    failure += piece;
    return true;
  });
  for (const std::string& bytes :
       {message(out_of_range), message(negative), message(endless), message(no_unit),
        message(scene) + "more", failure, std::string("garbage"), message(scene).substr(0, 100)}) {
    forge(folder_.path() / "cache", file, bytes);
    expect_equal(mesh_in(first), mesh_in(reader_with_cache().read(box)));
  }
}

TEST_F(Remembered, AFileWithOthersBesideItIsNot) {
  folder_.write("meshes/own.bin", gltf_buffer(soup_));
  const MeshRequest gltf = request("a.gltf", as_gltf(soup_, "own.bin"));
  const MeshReader meshes = reader_with_cache();
  EXPECT_EQ(extent(*mesh_in(meshes.read(gltf)).mesh).upper, geometry::Vec3(2, -3, 4));
  EXPECT_TRUE(kept().empty());
  folder_.write("meshes/own.bin", gltf_buffer(box_soup({1, 2, 3}, {2, 4, 60})));
  EXPECT_EQ(extent(*mesh_in(meshes.read(gltf)).mesh).lower, geometry::Vec3(1, -60, 2));
}

TEST_F(Remembered, AFailureIsNot) {
  const MeshRequest damaged = request("a.stl", "solid\nfacet");
  EXPECT_TRUE(std::holds_alternative<MeshFailure>(reader_with_cache().read(damaged)));
  EXPECT_TRUE(kept().empty());
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
