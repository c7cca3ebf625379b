#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "src/exchange/mesh_io/mesh_io.hpp"
#include "src/motion/math/pose.hpp"
#include "tests/support/places.hpp"

// The program that writes the plan of a real floor, against the model itself.

namespace rubicon::scenes {
namespace {

namespace fs = std::filesystem;
using geometry::Vec3;

fs::path model() {
  return fs::path(test::source_dir()) / "../shared/data/schependomlaan/IFC-kanaalplaatvloer.ifc";
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Row {
  std::string component;
  Vec3 top = Vec3::Zero();
  double turn_deg = 0;
};

/// Rows of elements.csv by the name in the model.
std::map<std::string, Row> rows_of(const fs::path& folder) {
  std::map<std::string, Row> rows;
  std::istringstream table(text_of(folder / "elements.csv"));
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    std::istringstream cells(line);
    Row row;
    std::string ifc;
    std::string number;
    std::getline(cells, row.component, ',');
    std::getline(cells, ifc, ',');
    for (int k = 0; k < 3; ++k) {
      std::getline(cells, number, ',');
      row.top[k] = std::stod(number);
    }
    std::getline(cells, number, ',');
    row.turn_deg = std::stod(number);
    rows[ifc] = row;
  }
  return rows;
}

class MakeSchependomlaan : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(model())) GTEST_SKIP() << "the shared data folder is not beside the project";
    std::string name = (fs::temp_directory_path() / "rubicon_scene_XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  void make(const std::string& order) const {
    const std::string command = test::build_dir() + "/tests/scenes/make_schependomlaan" + " '" +
                                model().string() + "' '" + folder_.string() + "' --order " + order;
    ASSERT_EQ(std::system(command.c_str()), 0);
  }

  fs::path folder_;
};

TEST_F(MakeSchependomlaan, EveryElementAtItsTargetIsTheOneOfTheModel) {
  make("good");
  const mesh_io::MeshReader reader(test::mesh_helper());
  const auto scene = reader.read_scene({model().string(), model().parent_path().string()});
  ASSERT_TRUE(std::holds_alternative<std::vector<mesh_io::NamedMesh>>(scene));
  const std::map<std::string, Row> rows = rows_of(folder_);
  ASSERT_EQ(rows.size(), 48U);
  int compared = 0;
  for (const auto& node : std::get<std::vector<mesh_io::NamedMesh>>(scene)) {
    const auto found = rows.find(node.name);
    if (found == rows.end()) continue;
    const Row& row = found->second;
    mesh_io::MeshRequest request;
    request.path = (folder_ / (row.component + ".obj")).string();
    request.folder = folder_.string();
    request.metres_per_unit = 1;
    const auto read = reader.read(request);
    ASSERT_TRUE(std::holds_alternative<mesh_io::ReadMesh>(read)) << request.path;
    const geometry::TriangleMesh& mesh = *std::get<mesh_io::ReadMesh>(read).mesh;
    EXPECT_TRUE(mesh.closed) << row.component;
    ASSERT_EQ(mesh.triangles.size(), node.mesh.triangles.size()) << row.component;
    const math::Pose X_WO = math::translation(row.top.x(), row.top.y(), row.top.z()) *
                            math::rotation_z_deg(row.turn_deg);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 placed = X_WO * mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][k])];
        const Vec3& p = node.mesh.vertices[static_cast<std::size_t>(node.mesh.triangles[t][k])];
        EXPECT_LT((placed - Vec3(p.x(), -p.z(), p.y())).norm(), 1e-5) << row.component;
      }
    }
    ++compared;
  }
  EXPECT_EQ(compared, 48);
}

TEST_F(MakeSchependomlaan, ThePlanLaysEachElementOnce) {
  make("good");
  const std::string plan = text_of(folder_ / "site.plan");
  std::set<std::string> laid;
  for (std::size_t i = 0; (i = plan.find("task lay_", i)) != std::string::npos; ++i) {
    laid.insert(plan.substr(i + 9, 8));
  }
  EXPECT_EQ(laid.size(), 48U);
  EXPECT_EQ(plan.find("task park_"), std::string::npos);
}

TEST_F(MakeSchependomlaan, TheBadOrderLeavesOneGapToTheLast) {
  make("bad");
  const std::string plan = text_of(folder_ / "site.plan");
  const std::size_t park = plan.find("task park_");
  ASSERT_NE(park, std::string::npos);
  EXPECT_LT(park, plan.find("task lay_"));
  const std::string name = plan.substr(park + 10, 8);
  EXPECT_EQ(plan.rfind("task lay_"), plan.find("task lay_" + name));
}

TEST_F(MakeSchependomlaan, TwoRunsGiveTheSameBytes) {
  make("good");
  const std::string plan = text_of(folder_ / "site.plan");
  const std::string mesh = text_of(folder_ / "floor_10.obj");
  make("good");
  EXPECT_FALSE(mesh.empty());
  EXPECT_EQ(text_of(folder_ / "site.plan"), plan);
  EXPECT_EQ(text_of(folder_ / "floor_10.obj"), mesh);
}

}  // namespace
}  // namespace rubicon::scenes
