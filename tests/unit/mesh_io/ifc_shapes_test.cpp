#include <gtest/gtest.h>

#include "tests/unit/mesh_io/ifc_shape_cases.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::mesh_io::testing {
namespace {

/// The only element of a file, z up.
NamedMesh element_of(const std::string& text) {
  TemporaryFolder folder;
  MeshRequest request;
  request.path = folder.write("a.ifc", text);
  request.folder = folder.path();
  const auto nodes = reader().read_nodes(request);
  if (const auto* failure = std::get_if<MeshFailure>(&nodes)) {
    ADD_FAILURE() << failure->message;
    return {};
  }
  EXPECT_EQ(std::get<std::vector<NamedMesh>>(nodes).size(), 1U);
  return std::get<std::vector<NamedMesh>>(nodes).front();
}

/// Metres: what is left of a file's numbers after all that is done with them.
constexpr double kExact = 1e-9;

TEST(IfcShapes, AreWhatTheyAreByHand) {
  for (const ShapeCase& each : shape_cases()) {
    SCOPED_TRACE(each.name);
    const NamedMesh element = element_of(ifc_of(each.records, each.openings));
    if (element.mesh.triangles.empty()) continue;
    EXPECT_TRUE(element.mesh.closed);
    EXPECT_EQ(element.note, "");
    EXPECT_NEAR(volume(element.mesh), each.volume, 1e-9 * (1 + each.volume));
    const geometry::Box box = extent(element.mesh);
    EXPECT_LT((box.upper - box.lower - each.size).norm(), kExact)
        << (box.upper - box.lower).transpose();
    EXPECT_LT((box.lower - each.lower).norm(), kExact) << box.lower.transpose();
  }
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
