#include "src/exchange/mesh_io/scene_wire.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rubicon::mesh_io {
namespace {

std::string encoded(const SceneMessage& message) {
  std::string bytes;
  EXPECT_TRUE(encode(message, [&](std::string_view piece) {
    bytes += piece;
    return true;
  }));
  return bytes;
}

FileScene small_scene() {
  FileScene scene;
  scene.declared_metres_per_unit = 0.001;
  scene.in_metres = true;
  scene.y_up = true;
  scene.nodes.push_back({"root", -1, {}, {}});
  scene.nodes.push_back({"kopf", 0, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}, {{0, 1, 2}}});
  return scene;
}

TEST(SceneWire, ASceneComesBackAsItWas) {
  const auto decoded = decode(encoded(small_scene()), {});
  ASSERT_TRUE(std::holds_alternative<SceneMessage>(decoded));
  const auto& scene = std::get<FileScene>(std::get<SceneMessage>(decoded));
  EXPECT_EQ(scene.declared_metres_per_unit, 0.001);
  EXPECT_TRUE(scene.in_metres);
  EXPECT_TRUE(scene.y_up);
  ASSERT_EQ(scene.nodes.size(), 2U);
  EXPECT_EQ(scene.nodes[0].parent, -1);
  EXPECT_EQ(scene.nodes[1].parent, 0);
  EXPECT_EQ(scene.nodes[1].name, "kopf");
  EXPECT_EQ(scene.nodes[1].vertices, small_scene().nodes[1].vertices);
  EXPECT_EQ(scene.nodes[1].triangles, small_scene().nodes[1].triangles);
}

TEST(SceneWire, AFailureComesBackAsText) {
  const auto decoded = decode(encoded(std::string("no such thing")), {});
  ASSERT_TRUE(std::holds_alternative<SceneMessage>(decoded));
  EXPECT_EQ(std::get<std::string>(std::get<SceneMessage>(decoded)), "no such thing");
}

TEST(SceneWire, EveryShorterMessageIsRefused) {
  for (const SceneMessage& message :
       {SceneMessage(small_scene()), SceneMessage(std::string("x"))}) {
    const std::string whole = encoded(message);
    for (std::size_t length = 0; length < whole.size(); ++length) {
      EXPECT_TRUE(std::holds_alternative<WireError>(decode(whole.substr(0, length), {}))) << length;
    }
    EXPECT_TRUE(std::holds_alternative<WireError>(decode(whole + "x", {})));
  }
}

TEST(SceneWire, IndicesParentsAndLimitsAreChecked) {
  FileScene index = small_scene();
  index.nodes[1].triangles[0][2] = 3;
  EXPECT_TRUE(std::holds_alternative<WireError>(decode(encoded(index), {})));
  FileScene negative = small_scene();
  negative.nodes[1].triangles[0][0] = -1;
  EXPECT_TRUE(std::holds_alternative<WireError>(decode(encoded(negative), {})));
  FileScene parent = small_scene();
  parent.nodes[1].parent = 1;
  EXPECT_TRUE(std::holds_alternative<WireError>(decode(encoded(parent), {})));
  EXPECT_TRUE(std::holds_alternative<WireError>(decode(encoded(small_scene()), {0, 10})));
  EXPECT_TRUE(std::holds_alternative<WireError>(decode(encoded(small_scene()), {10, 1})));
}

TEST(SceneWire, AnyOtherByteAnywhereIsHarmless) {
  const std::string whole = encoded(small_scene());
  std::mt19937 random(7);
  for (int i = 0; i < 20'000; ++i) {
    std::string changed = whole;
    for (int k = 0; k < 3; ++k) changed[random() % changed.size()] = static_cast<char>(random());
    const auto decoded = decode(changed, {});
    if (std::holds_alternative<WireError>(decoded)) continue;
    const auto* scene = std::get_if<FileScene>(&std::get<SceneMessage>(decoded));
    if (scene == nullptr) continue;
    for (const FileNode& node : scene->nodes) {
      for (const auto& t : node.triangles) {
        for (const int corner : t) {
          ASSERT_GE(corner, 0);
          ASSERT_LT(static_cast<std::size_t>(corner), node.vertices.size());
        }
      }
    }
  }
}

TEST(SceneWire, ALargeMessageStaysBelowItsBound) {
  FileScene scene;
  const std::string name(5000, 'n');
  for (int i = 0; i < 50; ++i) {
    scene.nodes.push_back({name, -1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  }
  const SceneLimits limits{50, 50};
  const std::string bytes = encoded(scene);
  EXPECT_LE(bytes.size(), largest_message(limits));
  EXPECT_TRUE(std::holds_alternative<SceneMessage>(decode(bytes, limits)));
}

TEST(SceneWire, NamesBecomePrintable) {
  EXPECT_EQ(printable("Stütze 3 µ €\U0001F3D7", 100), "Stütze 3 µ €\U0001F3D7");
  EXPECT_EQ(printable(std::string_view("a\0b\n\x1b\x7f", 6), 100), "a?b???");
  EXPECT_EQ(printable("\xff\xc3 \xe2\x82", 100), "?? ??");
  EXPECT_EQ(printable("\xc0\xaf\xed\xa0\x80", 100), "?????");  // overlong, surrogate
  EXPECT_EQ(printable("aüb", 2), "a");                         // never half a character
}

}  // namespace
}  // namespace rubicon::mesh_io
