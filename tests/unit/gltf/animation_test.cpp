#include "src/results/gltf/animation.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

namespace rubicon::gltf {
namespace {

/// The numbers of an accessor of a document.
Floats numbers(const Json& document, const std::string& binary, int accessor) {
  const Json& entry = document["accessors"][static_cast<std::size_t>(accessor)];
  const std::size_t view = entry["bufferView"].get<std::size_t>();
  const std::size_t width = entry["type"] == "SCALAR" ? 1 : entry["type"] == "VEC3" ? 3 : 4;
  std::size_t place = document["bufferViews"][view]["byteOffset"].get<std::size_t>() +
                      entry["byteOffset"].get<std::size_t>();
  Floats result;
  for (std::size_t i = 0; i < width * entry["count"].get<std::size_t>(); ++i, place += 4) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(binary[place + k])) << 8 * k;
    }
    result.push_back(std::bit_cast<float>(bits));
  }
  return result;
}

/// Times and values of the one channel of an animation.
struct Played {
  Floats times, values;
};
Played play(Animation& animation, BinaryData& data) {
  Json document;
  animation.finish(document);
  const std::string binary = data.finish(document);
  const Json& sampler = document["animations"][0]["samplers"][0];
  return {numbers(document, binary, sampler["input"]),
          numbers(document, binary, sampler["output"])};
}

TEST(Animation, DrawsKeysApartThatFallTogether) {
  ElementCurve curve;
  curve.keys = {{0, {0, 0, 0}}, {100, {1, 0, 0}}};
  for (int i = 1; i <= 50; ++i) curve.keys.push_back({100 + 1e-7 * i, {1.0 + i, 0, 0}});
  curve.keys.push_back({200, {60, 0, 0}});
  BinaryData data;
  Animation animation(10, data);
  animation.add_element(0, curve);
  const Played played = play(animation, data);
  ASSERT_EQ(played.times.size(), 4U);
  EXPECT_LT(played.times[1], played.times[2]);
  EXPECT_FLOAT_EQ(played.times[2], 10);
  EXPECT_EQ(played.values[3], 1);   // the first of them
  EXPECT_EQ(played.values[6], 51);  // and the last
}

TEST(Animation, SwitchesThings) {
  BinaryData data;
  Animation animation(1, data);
  EXPECT_FALSE(animation.add_presence(0, {0, 100}, 100));  // always there: no channel
  EXPECT_TRUE(animation.add_presence(1, {10, 20}, 100));
  const Played played = play(animation, data);
  EXPECT_EQ(played.times, (Floats{0, 10, 20}));
  EXPECT_EQ(played.values, (Floats{0, 0, 0, 1, 1, 1, 0, 0, 0}));
}

TEST(Animation, IsNotThereWhereNothingMoves) {
  BinaryData data;
  Animation animation(1, data);
  Json document = Json::object();
  animation.finish(document);
  EXPECT_TRUE(data.finish(document).empty());
  EXPECT_TRUE(document.empty());
}

TEST(Animation, TurnsByUnitQuaternions) {
  for (double degrees = -720; degrees <= 720; degrees += 7.5) {
    for (const auto kind : {robot::FrameElement::Kind::rotx, robot::FrameElement::Kind::roty,
                            robot::FrameElement::Kind::rotz}) {
      EXPECT_NEAR(turn_of(kind, degrees).norm(), 1, 1e-15);
    }
  }
  EXPECT_EQ(turn_of(robot::FrameElement::Kind::rotz, 180), Eigen::Vector4d(0, 0, 1, 0));
}

}  // namespace
}  // namespace rubicon::gltf
