#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>

#include "tests/unit/mesh_io/mesh_files_io.hpp"

// Damaged and hostile files: each is refused with a message, soon, and without harm.

namespace rubicon::mesh_io::testing {
namespace {

using geometry::Vec3;

/// The message for a file that must not be read; fails the test where it is read or takes long.
std::string refused(const std::string& path, const MeshRequest& request = {}) {
  const auto begin = std::chrono::steady_clock::now();
  const auto result = read_in_own_folder(path, request);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  // None of them comes to the watchdog; the rest is for a busy machine.
  EXPECT_LT(seconds.count(), 30) << path;
  const auto* failure = std::get_if<MeshFailure>(&result);
  if (failure == nullptr) {
    ADD_FAILURE() << path << " was read";
    return {};
  }
  EXPECT_TRUE(failure->message.starts_with("mesh '")) << failure->message;
  return failure->message;
}

void expect_part(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

std::string ply_head(const std::string& vertices, const std::string& faces) {
  return "ply\nformat ascii 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

TEST(Damage, AnEmptyFile) {
  const TemporaryFolder folder;
  for (const char* name : {"a.stl", "a.ply", "a.obj", "a.dae", "a.gltf", "a.glb", "a.ifc"}) {
    expect_part(refused(folder.write(name, "")), "it is empty");
  }
}

TEST(Damage, AFolderAPipeADeviceOrNothing) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "folder.stl");
  expect_part(refused((folder.path() / "folder.stl").string()), "it is a folder");
  const std::string pipe = (folder.path() / "pipe.stl").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  expect_part(refused(pipe), "it is a pipe");
  expect_part(refused((folder.path() / "none.stl").string()), "there is no such file");
  expect_part(refused((folder.path() / "none.step").string()), "does not end in .stl, .obj");
  std::filesystem::create_symlink("/dev/zero", folder.path() / "zero.stl");
  expect_part(refused((folder.path() / "zero.stl").string()), "it lies outside the folder");
  MeshRequest device;
  device.path = (folder.path() / "zero.stl").string();
  device.folder = "/";
  expect_part(std::get<MeshFailure>(reader().read(device)).message, "it is a device");
  expect_part(refused(folder.path().string() + "/a\0b.stl"), "");
}

TEST(Damage, AFileOutsideTheFolder) {
  const TemporaryFolder folder;
  const TemporaryFolder elsewhere;
  const std::string outside = elsewhere.write("a.stl", as_stl_text(unit_box()));
  std::filesystem::create_symlink(outside, folder.path() / "link.stl");
  expect_part(refused((folder.path() / "link.stl").string()), "it lies outside the folder");
  std::filesystem::create_symlink(elsewhere.path(), folder.path() / "sub");
  MeshRequest request;
  request.folder = folder.path().string();
  request.metres_per_unit = 1;
  for (const std::string& path :
       {outside, (folder.path() / "sub/a.stl").string(),
        (folder.path() / ".." / elsewhere.path().filename() / "a.stl").string()}) {
    request.path = path;
    const auto result = reader().read(request);
    ASSERT_TRUE(std::holds_alternative<MeshFailure>(result)) << path;
    expect_part(std::get<MeshFailure>(result).message, "it lies outside the folder");
  }
  // A folder whose name begins alike is another folder.
  const std::string alike = folder.path().string() + "_b";
  std::filesystem::create_directory(alike);
  std::ofstream(alike + "/a.stl") << as_stl_text(unit_box());
  request.path = alike + "/a.stl";
  const auto result = reader().read(request);
  std::filesystem::remove_all(alike);
  ASSERT_TRUE(std::holds_alternative<MeshFailure>(result));
}

TEST(Damage, ALinkInACircleAndAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("b.stl", folder.path() / "a.stl");
  std::filesystem::create_symlink("a.stl", folder.path() / "b.stl");
  expect_part(refused((folder.path() / "a.stl").string()), "lead in a circle");
  expect_part(refused("/nowhere/at/all/a.stl"), "its folder cannot be used");
}

TEST(Damage, AGltfThatReachesOutOfItsFolder) {
  const TemporaryFolder outer;
  outer.write("secret.bin", gltf_buffer(unit_box()));
  outer.write("inner/own.bin", gltf_buffer(unit_box()));
  const auto fine = read_in_own_folder(outer.write("inner/a.gltf", as_gltf(unit_box(), "own.bin")));
  EXPECT_TRUE(std::holds_alternative<ReadMesh>(fine));
  for (const std::string& uri :
       {std::string("../secret.bin"), (outer.path() / "secret.bin").string(),
        "file://" + (outer.path() / "secret.bin").string(),
        std::string("../../../../../../../../etc/passwd"), std::string("/dev/zero"),
        std::string("%2e%2e/secret.bin")}) {
    refused(outer.write("inner/b.gltf", as_gltf(unit_box(), uri)));
  }
  ASSERT_EQ(::mkfifo((outer.path() / "inner/pipe.bin").c_str(), 0600), 0);
  refused(outer.write("inner/c.gltf", as_gltf(unit_box(), "pipe.bin")));
  std::filesystem::create_symlink("../secret.bin", outer.path() / "inner/link.bin");
  refused(outer.write("inner/d.gltf", as_gltf(unit_box(), "link.bin")));
}

TEST(Damage, AnObjReadsNoMaterials) {
  const TemporaryFolder folder;
  // assimp's reader of materials breaks on some; a pipe would even stop it for ever.
  ASSERT_EQ(::mkfifo((folder.path() / "other.mtl").c_str(), 0600), 0);
  const auto result = read_in_own_folder(folder.write("a.obj", as_obj(unit_box())));
  EXPECT_TRUE(std::holds_alternative<ReadMesh>(result));
}

TEST(Damage, FilesCutOff) {
  const TemporaryFolder folder;
  const std::string binary = as_stl_binary(unit_box());
  refused(folder.write("a.stl", binary.substr(0, binary.size() - 30)));
  refused(folder.write("b.stl", binary.substr(0, 82)));
  const std::string dae = as_dae(unit_box(), "Z_UP", "1");
  refused(folder.write("a.dae", dae.substr(0, dae.size() / 2)));
  const std::string gltf = as_gltf(unit_box(), "");
  refused(folder.write("a.gltf", gltf.substr(0, gltf.size() / 2)));
  const std::string ply = as_ply(unit_box());
  refused(folder.write("a.ply", ply.substr(0, 120)));
}

TEST(Damage, TextGarbageUnderEveryName) {
  const TemporaryFolder folder;
  std::mt19937 random(3);
  for (const char* extension : {"stl", "obj", "ply", "dae", "gltf", "glb", "ifc"}) {
    std::string text;
    for (int i = 0; i < 3000; ++i) text += static_cast<char>(' ' + random() % 95);
    refused(folder.write(std::string("text.") + extension, text));
    std::string bytes;
    for (int i = 0; i < 3000; ++i) bytes += static_cast<char>(random());
    refused(folder.write(std::string("bytes.") + extension, bytes));
    refused(folder.write(std::string("zero.") + extension, std::string(3000, '\0')));
  }
}

TEST(Damage, APlyThatClaimsAHundredMillionVertices) {
  const TemporaryFolder folder;
  expect_part(
      refused(folder.write("a.ply", ply_head("100000000", "1") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")),
      "it announces 100000000 elements");
  refused(folder.write("b.ply", ply_head("3", "4000000000") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  std::string binary = ply_head("4000000000", "4000000000");
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  refused(folder.write("c.ply", binary + std::string(100, '\0')));
}

TEST(Damage, APlyWithoutAnEnd) {
  const TemporaryFolder folder;
  expect_part(refused(folder.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n")),
              "its header has no end");
  refused(folder.write("b.ply", "ply\nformat ascii 1.0\ncomment " + std::string(100'000, 'x')));
  refused(folder.write("c.ply",
                       "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int "
                       "vertex_indices\nend_header\n255"));
}

TEST(Damage, AnStlThatClaimsMoreTrianglesThanItHas) {
  const TemporaryFolder folder;
  std::string bytes = as_stl_binary(unit_box());
  bytes[80] = bytes[81] = bytes[82] = '\xff';
  refused(folder.write("a.stl", bytes));
}

TEST(Damage, NodesNestedAHundredThousandDeep) {
  const TemporaryFolder folder;
  constexpr int kDepth = 100'000;
  std::string open;
  std::string close;
  for (int i = 0; i < kDepth; ++i) {
    open += "<node>";
    close += "</node>";
  }
  std::string dae = as_dae(unit_box(), "Z_UP", "1");
  dae.replace(dae.find("<node id=\"part_a\""), 0, open + close);
  refused(folder.write("a.dae", dae));

  std::string nodes = "{\"mesh\":0}";
  for (int i = 0; i < kDepth; ++i) nodes += fmt::format(",{{\"children\":[{}]}}", i);
  std::string gltf = as_gltf(unit_box(), "");
  gltf.replace(gltf.find("{\"mesh\":0,\"name\":\"body\"}"), 24, nodes);
  gltf.replace(gltf.find("\"nodes\":[0]"), 11, fmt::format("\"nodes\":[{}]", kDepth));
  refused(folder.write("a.gltf", gltf));
  refused(folder.write("b.gltf", std::string(1'000'000, '[')));
  refused(folder.write("c.gltf", "{\"a\":" + std::string(1'000'000, '{')));
}

TEST(Damage, ANodeThatIsItsOwnAncestor) {
  const TemporaryFolder folder;
  std::string gltf = as_gltf(unit_box(), "");
  gltf.replace(gltf.find("\"mesh\":0,\"name\""), 8, "\"mesh\":0,\"children\":[0]");
  refused(folder.write("a.gltf", gltf));
  std::string dae = as_dae(unit_box(), "Z_UP", "1");
  dae.replace(dae.find("<translate>10"), 0, "<instance_node url=\"#part_a\"/>");
  refused(folder.write("a.dae", dae));
}

TEST(Damage, NodesThatDoubleFortyTimes) {
  const TemporaryFolder folder;
  std::string library = "<library_nodes>";
  for (int i = 0; i < 40; ++i) {
    library += fmt::format(
        "<node id=\"n{}\"><instance_node url=\"#n{}\"/>"
        "<instance_node url=\"#n{}\"/></node>",
        i, i + 1, i + 1);
  }
  library += "<node id=\"n40\"><instance_geometry url=\"#g\"/></node></library_nodes>";
  std::string dae = as_dae(unit_box(), "Z_UP", "1");
  dae.replace(dae.find("<library_visual_scenes>"), 0, library);
  dae.replace(dae.find("<translate>10"), 0, "<instance_node url=\"#n0\"/>");
  refused(folder.write("a.dae", dae));

  std::string nodes = "{\"mesh\":0}";
  for (int i = 0; i < 40; ++i) nodes += fmt::format(",{{\"children\":[{},{}]}}", i, i);
  std::string gltf = as_gltf(unit_box(), "");
  gltf.replace(gltf.find("{\"mesh\":0,\"name\":\"body\"}"), 24, nodes);
  gltf.replace(gltf.find("\"nodes\":[0]"), 11, "\"nodes\":[40]");
  refused(folder.write("a.gltf", gltf));
}

TEST(Damage, APolygonOfTwentyThousandCorners) {
  const TemporaryFolder folder;
  expect_part(refused(folder.write("a.obj", spiral_obj(10'000))),
              "its polygons have too many corners");
}

TEST(Damage, CoordinatesThatAreNotNumbers) {
  const TemporaryFolder folder;
  Soup soup = unit_box();
  soup[3][1].y() = std::numeric_limits<double>::quiet_NaN();
  expect_part(refused(folder.write("nan.stl", as_stl_binary(soup))), "not a finite number");
  refused(folder.write("nan.ply", as_ply(soup)));
  refused(folder.write("nan.obj", as_obj(soup)));
  refused(folder.write("nan.dae", as_dae(soup, "Z_UP", "1")));
  refused(folder.write("nan.gltf", as_gltf(soup, "")));
  soup[3][1].y() = std::numeric_limits<double>::infinity();
  expect_part(refused(folder.write("inf.stl", as_stl_binary(soup))), "not a finite number");
  soup[3][1].y() = 1e30;
  expect_part(refused(folder.write("far.stl", as_stl_binary(soup))), "check the unit");
}

TEST(Damage, IndicesOutOfRange) {
  const TemporaryFolder folder;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  refused(folder.write("a.ply", ply_head("3", "1") + points + "3 0 1 7\n"));
  refused(folder.write("b.ply", ply_head("3", "1") + points + "3 0 1 -5\n"));
  refused(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 70\n"));
  std::string dae = as_dae(unit_box(), "Z_UP", "1");
  dae.replace(dae.find("<p>0 1 2"), 8, "<p>0 1 999999");
  refused(folder.write("a.dae", dae));
  std::string gltf = as_gltf(unit_box(), "");
  gltf.replace(gltf.find("\"count\":36"), 10, "\"count\":99999999");
  refused(folder.write("a.gltf", gltf));
  std::string negative = as_gltf(unit_box(), "");
  negative.replace(negative.find("\"byteOffset\":0"), 14, "\"byteOffset\":4294967295");
  refused(folder.write("b.gltf", negative));
}

TEST(Damage, PointsAndLinesAreNoMesh) {
  const TemporaryFolder folder;
  refused(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\np 1\n"));
  refused(folder.write("a.ply", ply_head("3", "0") + "0 0 0\n1 0 0\n0 1 0\n"));
  refused(folder.write("a.stl", "solid nothing\nendsolid nothing\n"));
  const Vec3 p(1, 1, 1);
  expect_part(refused(folder.write("b.stl", as_stl_binary({{p, p, p}}))),
              "no triangle of any size");
}

TEST(Damage, AFileTooLargeToRead) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.stl", "solid\n");
  std::filesystem::resize_file(path, 300'000'000);  // a sparse file: no room is taken
  expect_part(refused(path), "at most 256 MB are read");
}

TEST(Damage, MoreTrianglesThanAreAllowed) {
  const TemporaryFolder folder;
  constexpr std::uint32_t kCount = 2'000'001;
  std::string bytes(80, ' ');
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(kCount >> shift);
  const std::string path = folder.write("a.stl", bytes);
  std::filesystem::resize_file(path, 84 + 50ULL * kCount);
  expect_part(refused(path), "more than 2000000 triangles");
}

TEST(Damage, TheCallerItselfStaysSmall) {
  const TemporaryFolder folder;
  rusage before{};
  ::getrusage(RUSAGE_SELF, &before);
  refused(folder.write("a.ply", ply_head("100000000", "100000000") + "0 0 0\n"));
  rusage after{};
  ::getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 50'000);  // KB
}

TEST(Damage, NamesFromTheFileAreMadePrintable) {
  const TemporaryFolder folder;
  std::string dae = as_dae(unit_box(), "Z_UP", "1");
  for (std::size_t i = 0; (i = dae.find("\"part_a\"", i)) != std::string::npos; ++i) {
    dae.replace(i, 8, "\"x\x1b[31my\xff\"");
  }
  MeshRequest request;
  request.part = "none";
  const std::string message = refused(folder.write("a.dae", dae), request);
  EXPECT_EQ(message.find('\x1b'), std::string::npos);
  EXPECT_EQ(message.find('\xff'), std::string::npos);
}

TEST(Damage, AFewBytesChangedAnywhere) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> files = {
      {"stl", as_stl_binary(unit_box())}, {"stl", as_stl_text(unit_box())},
      {"obj", as_obj(unit_box())},        {"ply", as_ply(unit_box())},
      {"gltf", as_gltf(unit_box(), "")},  {"dae", as_dae(unit_box(), "Z_UP", "1")}};
  constexpr int kVariants = 8;
  std::mt19937 random(11);
  for (const auto& [extension, whole] : files) {
    for (int variant = 0; variant < kVariants; ++variant) {
      std::string bytes = whole;
      for (int k = 0; k < 4; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
      const auto result = read_in_own_folder(folder.write("a." + extension, bytes));
      const auto* read = std::get_if<ReadMesh>(&result);
      if (read == nullptr) {
        EXPECT_GT(std::get<MeshFailure>(result).message.size(), 30U);
        continue;
      }
      ASSERT_FALSE(read->mesh->triangles.empty());
      for (const Vec3& p : read->mesh->vertices) ASSERT_TRUE(p.allFinite());
      for (const auto& t : read->mesh->triangles) {
        for (const int corner : t) {
          ASSERT_GE(corner, 0);
          ASSERT_LT(static_cast<std::size_t>(corner), read->mesh->vertices.size());
        }
      }
    }
  }
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
