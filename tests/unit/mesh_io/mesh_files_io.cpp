#include "tests/unit/mesh_io/mesh_files_io.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "src/motion/math/angles.hpp"
#include "tests/support/places.hpp"

namespace rubicon::mesh_io::testing {

namespace {

template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

void put_point(std::string& bytes, const geometry::Vec3& p) {
  for (int k = 0; k < 3; ++k) put(bytes, static_cast<float>(p[k]));
}

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t j = i + k;
      group = group * 256 + (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[(group >> (18 - 6 * k)) & 63U];
    }
  }
  return text;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "rubicon_mesh_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& bytes) const {
  const std::filesystem::path file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
  return file.string();
}

MeshReader reader() { return MeshReader(test::mesh_helper()); }

std::variant<ReadMesh, MeshFailure> read_in_own_folder(const std::string& path,
                                                       MeshRequest request) {
  request.path = path;
  request.folder = std::filesystem::path(path).parent_path().string();
  if (request.metres_per_unit == 0 && needs_unit(path)) request.metres_per_unit = 1;
  return reader().read(request);
}

Soup box_soup(const geometry::Vec3& lower, const geometry::Vec3& upper) {
  const auto corner = [&](int i) {
    return geometry::Vec3((i & 1) != 0 ? upper.x() : lower.x(),
                          (i & 2) != 0 ? upper.y() : lower.y(),
                          (i & 4) != 0 ? upper.z() : lower.z());
  };
  constexpr std::array<std::array<int, 4>, 6> kFaces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  Soup soup;
  for (const std::array<int, 4>& f : kFaces) {
    soup.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
    soup.push_back({corner(f[0]), corner(f[2]), corner(f[3])});
  }
  return soup;
}

std::string as_stl_text(const Soup& soup) {
  std::string text = "solid test\n";
  for (const auto& t : soup) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const auto& p : t) text += fmt::format("vertex {} {} {}\n", p.x(), p.y(), p.z());
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid test\n";
}

std::string as_stl_binary(const Soup& soup) {
  std::string bytes(80, ' ');
  put(bytes, static_cast<std::uint32_t>(soup.size()));
  for (const auto& t : soup) {
    put_point(bytes, geometry::Vec3::Zero());
    for (const auto& p : t) put_point(bytes, p);
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string as_obj(const Soup& soup) {
  std::string text = "mtllib other.mtl\no test\n";
  for (const auto& t : soup) {
    for (const auto& p : t) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
    text += "f -3 -2 -1\n";
  }
  return text;
}

std::string as_ply(const Soup& soup) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      3 * soup.size(), soup.size());
  for (const auto& t : soup) {
    for (const auto& p : t) text += fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
  }
  for (std::size_t i = 0; i < soup.size(); ++i) {
    text += fmt::format("3 {} {} {}\n", 3 * i, 3 * i + 1, 3 * i + 2);
  }
  return text;
}

std::string as_dae(const Soup& soup, const std::string& up_axis, const std::string& unit) {
  std::string points;
  std::string indices;
  for (std::size_t i = 0; i < soup.size(); ++i) {
    for (const auto& p : soup[i]) points += fmt::format("{} {} {} ", p.x(), p.y(), p.z());
    indices += fmt::format("{} {} {} ", 3 * i, 3 * i + 1, 3 * i + 2);
  }
  return fmt::format(
      R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter="{}"/><up_axis>{}</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="pa" count="{}">{}</float_array><technique_common>
<accessor source="#pa" count="{}" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="{}"><input semantic="VERTEX" source="#v" offset="0"/><p>{}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="part_a" name="part_a">
<translate>10 0 0</translate><instance_geometry url="#g"/></node>
<node id="part_b" name="part_b"><instance_geometry url="#g"/>
<node id="part_c" name="part_c"><translate>0 0 100</translate><instance_geometry url="#g"/></node>
</node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)",
      unit, up_axis, 9 * soup.size(), points, 3 * soup.size(), soup.size(), indices);
}

std::string gltf_buffer(const Soup& soup) {
  std::string bytes;
  for (const auto& t : soup) {
    for (const auto& p : t) put_point(bytes, p);
  }
  return bytes;
}

std::string as_gltf(const Soup& soup, const std::string& uri) {
  const std::string buffer = gltf_buffer(soup);
  const std::string source =
      uri.empty() ? "data:application/octet-stream;base64," + base64(buffer) : uri;
  geometry::Vec3 low = geometry::Vec3::Constant(std::numeric_limits<double>::max());
  geometry::Vec3 high = -low;
  for (const auto& t : soup) {
    for (const auto& p : t) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
"nodes":[{{"mesh":0,"name":"body"}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"mode":4}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3",
"min":[{},{},{}],"max":[{},{},{}]}}],
"bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":{}}}],
"buffers":[{{"byteLength":{},"uri":"{}"}}]}})",
      3 * soup.size(), low.x(), low.y(), low.z(), high.x(), high.y(), high.z(), buffer.size(),
      buffer.size(), source);
}

std::string spiral_obj(int turns) {
  std::string text;
  std::string face = "f";
  for (int i = 0; i < 2 * turns; ++i) {
    const int step = i < turns ? i : 2 * turns - 1 - i;
    const double radius = (i < turns ? 1 : 1.3) + step * 0.01;
    text += fmt::format("v {} {} 0\n", radius * math::cos_deg(3 * step),
                        radius * math::sin_deg(3 * step));
    face += fmt::format(" {}", i + 1);
  }
  return text + face + "\n";
}

geometry::Box extent(const geometry::TriangleMesh& mesh) {
  geometry::Box box{mesh.vertices.at(0), mesh.vertices.at(0)};
  for (const geometry::Vec3& p : mesh.vertices) {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
  return box;
}

double volume(const geometry::TriangleMesh& mesh) {
  double six = 0;
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) {
      return mesh.vertices.at(static_cast<std::size_t>(t.at(k)));
    };
    six += corner(0).dot(corner(1).cross(corner(2)));
  }
  return six / 6;
}

}  // namespace rubicon::mesh_io::testing
