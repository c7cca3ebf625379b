#include "tests/unit/mesh_io/bombs.hpp"

#include <fmt/core.h>
#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace rubicon::mesh_io::testing {

namespace {

namespace fs = std::filesystem;

/// `text` with the first `from` exchanged.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  if (place == std::string::npos) throw std::runtime_error("no " + from);
  return text.replace(place, from.size(), to);
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

/// Made when it is laid: all together they would swell the process whose size is measured.
Bomb text(const std::string& name, const std::function<std::string()>& bytes) {
  return {name, [=](const Place& place) { return place.inside.write(name, bytes()); }};
}

std::string dae() { return as_dae(unit_box(), "Z_UP", "1"); }
std::string gltf(const std::string& uri = {}) { return as_gltf(unit_box(), uri); }

std::string ply(const std::string& format, const std::string& vertices, const std::string& faces,
                const std::string& count_type = "uchar") {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list " + count_type + " int vertex_indices\nend_header\n";
}

/// Nodes each of which holds the one before twice.
std::string doubling_gltf(int times) {
  std::string nodes = "{\"mesh\":0}";
  for (int i = 0; i < times; ++i) nodes += fmt::format(",{{\"children\":[{},{}]}}", i, i);
  return with(with(gltf(), "{\"mesh\":0,\"name\":\"body\"}", nodes), "\"nodes\":[0]",
              fmt::format("\"nodes\":[{}]", times));
}

std::string doubling_dae(int times) {
  std::string library = "<library_nodes>";
  for (int i = 0; i < times; ++i) {
    const std::string next = fmt::format("<instance_node url=\"#n{}\"/>", i + 1);
    library += fmt::format("<node id=\"n{}\">", i) + next + next + "</node>";
  }
  library +=
      fmt::format("<node id=\"n{}\"><instance_geometry url=\"#g\"/></node></library_nodes>", times);
  return with(with(dae(), "<library_visual_scenes>", library + "<library_visual_scenes>"),
              "<translate>10 0 0</translate>", "<instance_node url=\"#n0\"/>");
}

std::string deep_gltf(int depth) {
  std::string nodes = "{\"mesh\":0}";
  for (int i = 0; i < depth; ++i) nodes += fmt::format(",{{\"children\":[{}]}}", i);
  return with(with(gltf(), "{\"mesh\":0,\"name\":\"body\"}", nodes), "\"nodes\":[0]",
              fmt::format("\"nodes\":[{}]", depth));
}

std::string laughs() {
  std::string entities = "<!ENTITY l0 \"0 0 0 1 0 0 0 1 0 \">";
  for (int i = 1; i <= 30; ++i) {
    entities += fmt::format("<!ENTITY l{} \"{}\">", i, repeated(fmt::format("&l{};", i - 1), 10));
  }
  return with(with(dae(), "?>", "?><!DOCTYPE COLLADA [" + entities + "]>"), ">0 0 0 0 1 0",
              ">&l30; 0 1 0");
}

/// A file of IFC with the given lines of data.
std::string ifc(const std::string& data) {
  return R"(ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('IFC2X3'));
ENDSEC;
DATA;
#1= IFCPROJECT('0$',#2,'p',$,$,$,$,(#9),#7);
#2= IFCOWNERHISTORY(#3,#4,$,.ADDED.,$,$,$,0);
#3= IFCPERSONANDORGANIZATION(#5,#6,$);
#4= IFCAPPLICATION(#6,'1','a','a');
#5= IFCPERSON($,$,'a',$,$,$,$,$);
#6= IFCORGANIZATION($,'o',$,$,$);
#7= IFCUNITASSIGNMENT((#8));
#8= IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);
#9= IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#10,$);
#10= IFCAXIS2PLACEMENT3D(#11,#12,#13);
#11= IFCCARTESIANPOINT((0.,0.,0.));
#12= IFCDIRECTION((0.,0.,1.));
#13= IFCDIRECTION((1.,0.,0.));
)" + data +
         "ENDSEC;\nEND-ISO-10303-21;\n";
}

constexpr const char* kPlacement = "#30= IFCLOCALPLACEMENT($,#10);\n";

/// A building that holds one element with the given placement and item of shape; #60 is a block.
std::string ifc_element(const std::string& placement, const std::string& item,
                        const std::string& more) {
  return ifc(R"(#20= IFCBUILDING('1$',#2,'b',$,$,#30,$,$,.ELEMENT.,$,$,$);
#21= IFCRELAGGREGATES('2$',#2,$,$,#1,(#20));
#22= IFCBUILDINGELEMENTPROXY('3$',#2,'e',$,$,#30,#23,$,$);
#23= IFCPRODUCTDEFINITIONSHAPE($,$,(#24));
#24= IFCSHAPEREPRESENTATION(#9,'Body','SweptSolid',()" +
             item + R"());
#25= IFCRELCONTAINEDINSPATIALSTRUCTURE('4$',#2,$,$,(#22),#20);
#60= IFCEXTRUDEDAREASOLID(#61,#10,#12,1.);
#61= IFCRECTANGLEPROFILEDEF(.AREA.,$,#63,1.,1.);
#63= IFCAXIS2PLACEMENT2D(#64,$);
#64= IFCCARTESIANPOINT((0.,0.));
)" + placement +
             more);
}

/// A shape with `times` uses of one that holds `times` blocks. (assimp follows no deeper ones.)
std::string growing_ifc(int times) {
  const std::string more =
      "#100= IFCMAPPEDITEM(#101,#99);\n#101= IFCREPRESENTATIONMAP(#10,#102);\n"
      "#102= IFCSHAPEREPRESENTATION(#9,'Body','SweptSolid',(#60" +
      repeated(",#60", times - 1) + "));\n" +
      "#99= IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#11,$,$);\n";
  return ifc_element(kPlacement, "#100" + repeated(",#100", times - 1), more);
}

std::string deep_ifc(int depth) {
  std::string more;
  for (int i = 0; i < depth; ++i) {
    more += fmt::format("#{}= IFCBOOLEANRESULT(.UNION.,#{},#60);\n", 100 + i,
                        i + 1 < depth ? 101 + i : 60);
  }
  return ifc_element(kPlacement, "#100", more);
}

std::string glb(std::uint32_t length, std::uint32_t chunk_length, const std::string& chunk) {
  std::string bytes = "glTF";
  const auto put = [&](std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift);
  };
  put(2);
  put(length);
  put(chunk_length);
  return bytes + "JSON" + chunk;
}

std::string without_view(std::uint64_t count) {
  return with(with(gltf(), "\"bufferView\":0,", ""), "\"count\":36",
              fmt::format("\"count\":{}", count));
}

std::string sparse_gltf() {
  return with(gltf(), "\"type\":\"VEC3\"",
              "\"type\":\"VEC3\",\"sparse\":{\"count\":4000000000,\"indices\":{\"bufferView\":0,"
              "\"componentType\":5125},\"values\":{\"bufferView\":0}}");
}

Bomb link(const std::string& name, const std::string& target) {
  return {name, [=](const Place& place) {
            const fs::path path = place.inside.path() / name;
            fs::create_symlink(target.empty() ? place.secret() : target, path);
            return path.string();
          }};
}

/// A glTF whose buffer is `uri`, where SECRET stands for the file outside.
Bomb reaching(const std::string& name, const std::string& uri) {
  return {name, [=](const Place& place) {
            std::string where = uri;
            if (const std::size_t at = where.find("SECRET"); at != std::string::npos) {
              where.replace(at, 6, place.secret());
            }
            if (const std::size_t at = where.find("OUTSIDE"); at != std::string::npos) {
              where.replace(at, 7, place.outside.path().filename().string());
            }
            return place.inside.write(name, gltf(where));
          }};
}

constexpr const char* kPoints = "0 0 0\n1 0 0\n0 1 0\n";

Soup not_numbers() {
  Soup soup = unit_box();
  soup[3][1].y() = std::numeric_limits<double>::quiet_NaN();
  return soup;
}

/// Says that it has 16,777,215 triangles.
std::string false_count() {
  std::string bytes = as_stl_binary(unit_box());
  bytes[80] = bytes[81] = bytes[82] = '\xff';
  return bytes;
}

}  // namespace

std::vector<Bomb> bombs() {
  return {
      // Claims.
      text("claims_1e8_vertices.ply",
           [] { return ply("ascii", "100000000", "1") + kPoints + "3 0 1 2\n"; }),
      text("claims_4e9_faces.ply",
           [] { return ply("ascii", "3", "4000000000") + kPoints + "3 0 1 2\n"; }),
      text("claims_4e9_binary.ply",
           [] {
             return ply("binary_little_endian", "4000000000", "4000000000") +
                    std::string(100, '\0');
           }),
      text("claims_a_list_of_4e9.ply",
           [] {
             return ply("binary_little_endian", "3", "1", "uint") + std::string(36, '\0') +
                    std::string(4, '\xff');
           }),
      text("claims_16e6_triangles.stl", [] { return false_count(); }),
      text("claims_1e9_floats.dae",
           [] { return with(dae(), "count=\"108\"", "count=\"1000000000\""); }),
      text(
          "claims_1e9_triangles.dae",
          [] { return with(dae(), "<triangles count=\"12\"", "<triangles count=\"1000000000\""); }),
      text("claims_1e9_points.gltf", [] { return without_view(1'000'000'000); }),
      text("claims_1e8_points.gltf", [] { return without_view(99'999'999); }),
      text("claims_4e9_sparse.gltf", [] { return sparse_gltf(); }),
      text("claims_4_gb.gltf",
           [] {
             return with(gltf(), "\"byteLength\":432,\"uri\"", "\"byteLength\":4294967295,\"uri\"");
           }),
      text("claims_4_gb.glb", [] { return glb(0xFFFFFFFF, 0xFFFFFFF0, gltf()); }),
      text("claims_2_gb.glb", [] { return glb(0x7FFFFFFF, 0x7FFFFFF0, gltf()); }),
      // Depth.
      text("deep_nodes.dae",
           [] {
             return with(dae(), "<node id=\"part_a\"",
                         repeated("<node>", 100'000) + repeated("</node>", 100'000) +
                             "<node id=\"part_a\"");
           }),
      text("deep_tags.dae", [] { return "<?xml version=\"1.0\"?>" + repeated("<a>", 1'000'000); }),
      text("deep_nodes.gltf", [] { return deep_gltf(100'000); }),
      text("deep_arrays.gltf", [] { return std::string(1'000'000, '['); }),
      text("deep_objects.gltf", [] { return repeated("{\"a\":", 500'000); }),
      text("deep_brackets.ifc",
           [] { return ifc("#50= IFCSPHERE(" + std::string(1'000'000, '(') + ");\n"); }),
      text("deep_booleans.ifc", [] { return deep_ifc(100'000); }),
      // Rings.
      text("its_own_child.gltf",
           [] {
             return with(gltf(), "\"mesh\":0,\"name\"", "\"mesh\":0,\"children\":[0],\"name\"");
           }),
      text("its_own_child.dae",
           [] {
             return with(dae(), "<translate>10 0 0</translate>",
                         "<instance_node url=\"#part_a\"/>");
           }),
      text("ring_of_placements.ifc",
           [] {
             return ifc_element(
                 "#30= IFCLOCALPLACEMENT(#31,#10);\n#31= IFCLOCALPLACEMENT(#30,#10);\n", "#60", "");
           }),
      text("ring_of_booleans.ifc",
           [] {
             return ifc_element(kPlacement, "#50",
                                "#50= IFCBOOLEANRESULT(.DIFFERENCE.,#50,#60);\n");
           }),
      text("ring_of_maps.ifc",
           [] {
             return ifc_element(
                 kPlacement, "#50",
                 "#50= IFCMAPPEDITEM(#51,#52);\n#51= IFCREPRESENTATIONMAP(#10,#24);\n"
                 "#52= IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#11,$,$);\n");
           }),
      text("ring_of_storeys.ifc",
           [] {
             return ifc(
                 "#20= IFCBUILDING('1$',#2,'b',$,$,$,$,$,.ELEMENT.,$,$,$);\n"
                 "#21= IFCRELAGGREGATES('2$',#2,$,$,#1,(#20));\n"
                 "#22= IFCRELAGGREGATES('3$',#2,$,$,#20,(#20));\n");
           }),
      // Growth.
      text("doubling.gltf", [] { return doubling_gltf(40); }),
      text("doubling.dae", [] { return doubling_dae(40); }),
      text("growing.ifc", [] { return growing_ifc(3000); }),
      text("billion_laughs.dae", [] { return laughs(); }),
      text("huge_polygon.obj", [] { return spiral_obj(10'000); }),
      text("huge_data_uri.gltf",
           [] {
             return gltf("data:application/octet-stream;base64," + std::string(7'000'000, 'A'));
           }),
      text("long_line.obj", [] { return "v " + std::string(7'000'000, '1') + "\n"; }),
      text("corner_repeated.obj",
           [] { return "v 0 0 0\nv 1 0 0\nv 0 1 0\nf" + repeated(" 1 2 3", 300'000); }),
      // Numbers and indices.
      text("not_a_number.stl", [] { return as_stl_binary(not_numbers()); }),
      text("not_a_number.obj", [] { return as_obj(not_numbers()); }),
      text("not_a_number.ply", [] { return as_ply(not_numbers()); }),
      text("out_of_range.ply", [] { return ply("ascii", "3", "1") + kPoints + "3 0 1 7\n"; }),
      text("out_of_range.obj", [] { return "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2000000000\n"; }),
      text("out_of_range.dae", [] { return with(dae(), "<p>0 1 2", "<p>0 1 999999999"); }),
      text("out_of_range.gltf",
           [] { return with(gltf(), "\"byteOffset\":0", "\"byteOffset\":4294967295"); }),
      text("compressed_garbage.gltf",
           [] {
             return with(with(gltf(), "\"mode\":4",
                              "\"mode\":4,\"extensions\":{\"KHR_draco_mesh_compression\":"
                              "{\"bufferView\":0,\"attributes\":{\"POSITION\":0}}}"),
                         "\"scene\":0",
                         "\"extensionsUsed\":[\"KHR_draco_mesh_compression\"],\"scene\":0");
           }),
      // Cut off.
      text("cut_off.stl", [] { return as_stl_binary(unit_box()).substr(0, 500); }),
      text("cut_off.dae", [] { return dae().substr(0, dae().size() / 2); }),
      text("cut_off.gltf", [] { return gltf().substr(0, gltf().size() / 2); }),
      text("cut_off.ifc", [] { return ifc_element(kPlacement, "#60", "").substr(0, 900); }),
      // Out of the folder.
      link("link_outside.stl", ""),
      link("link_to_a_device.stl", "/dev/zero"),
      link("link_to_memory.stl", "/proc/self/mem"),
      reaching("dots.gltf", "../OUTSIDE/secret.bin"),
      reaching("many_dots.gltf", "../../../../../../../../../../etc/passwd"),
      reaching("absolute.gltf", "SECRET"),
      reaching("file_uri.gltf", "file://SECRET"),
      reaching("encoded_dots.gltf", "%2e%2e/OUTSIDE/secret.bin"),
      reaching("device.gltf", "/dev/zero"),
      reaching("endless_text.gltf", "/proc/self/environ"),
      {"linked_buffer.gltf",
       [](const Place& place) {
         fs::create_symlink(place.secret(), place.inside.path() / "own.bin");
         return place.inside.write("linked_buffer.gltf", gltf("own.bin"));
       }},
      {"external_entity.dae",
       [](const Place& place) {
         return place.inside.write("external_entity.dae",
                                   with(with(dae(), "?>",
                                             "?><!DOCTYPE COLLADA [<!ENTITY x SYSTEM \"file://" +
                                                 place.secret() + "\">]>"),
                                        ">0 0 0 0 1 0", ">&x; 0 1 0"));
       }},
      {"pipe.stl",
       [](const Place& place) {
         const std::string path = (place.inside.path() / "pipe.stl").string();
         ::mkfifo(path.c_str(), 0600);
         return path;
       }},
      {"pipe_as_buffer.gltf",
       [](const Place& place) {
         ::mkfifo((place.inside.path() / "pipe.bin").c_str(), 0600);
         return place.inside.write("pipe_as_buffer.gltf", gltf("pipe.bin"));
       }},
      {"too_large.stl",
       [](const Place& place) {
         const std::string path = place.inside.write("too_large.stl", "solid\n");
         fs::resize_file(path, 5'000'000'000);  // a sparse file: no room is taken
         return path;
       }},
      {"sparse.stl",
       [](const Place& place) {
         std::string head(80, ' ');
         head += std::string("\x00\x09\x3d\x00", 4);  // 4,000,000
         const std::string path = place.inside.write("sparse.stl", head);
         fs::resize_file(path, 84 + 50 * 4'000'000ULL);
         return path;
       }},
  };
}

std::vector<std::pair<std::string, std::string>> harmless_files() {
  return {{"a.ifc", ifc_element(kPlacement, "#60", "")},
          {"b.ifc", growing_ifc(3)},
          {"c.ifc", deep_ifc(1)},
          {"a.gltf", doubling_gltf(3)},
          {"b.gltf", deep_gltf(3)},
          {"a.dae", doubling_dae(3)},
          {"b.dae", dae()},
          {"a.obj", spiral_obj(100)},
          {"a.ply", ply("ascii", "3", "1") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}};
}

}  // namespace rubicon::mesh_io::testing
