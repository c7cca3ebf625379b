#include "tests/unit/gltf/film_player.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

namespace rubicon::test {

namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

std::size_t width_of(const nlohmann::json& accessor) {
  const std::map<std::string, std::size_t> widths = {{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
  return widths.at(accessor.at("type"));
}

Eigen::Quaterniond quaternion(const std::vector<double>& v) { return {v[3], v[0], v[1], v[2]}; }

/// As the specification writes it (appendix C.4).
std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b,
                            double share, bool turn) {
  double first = 1 - share;
  double second = share;
  if (turn) {
    double dot = 0;
    for (std::size_t i = 0; i < 4; ++i) dot += a[i] * b[i];
    const double angle = std::acos(std::min(std::fabs(dot), 1.0));
    if (angle > 1e-9) {
      first = std::sin(angle * (1 - share)) / std::sin(angle);
      second = std::sin(angle * share) / std::sin(angle) * (dot < 0 ? -1 : 1);
    }
  }
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(first * a[i] + second * b[i]);
  return result;
}

}  // namespace

FilmPlayer::FilmPlayer(const std::string& glb) {
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(number_at(glb, 4), 2U);
  EXPECT_EQ(number_at(glb, 8), glb.size());
  const std::uint32_t length = number_at(glb, 12);
  EXPECT_EQ(length % 4, 0U);
  EXPECT_EQ(glb.substr(16, 4), "JSON");
  json_ = nlohmann::json::parse(glb.substr(20, length));
  if (glb.size() > 20 + length) {
    EXPECT_EQ(glb.substr(24 + length, 4), std::string("BIN\0", 4));
    binary_ = glb.substr(28 + length);
    EXPECT_EQ(number_at(glb, 20 + length), binary_.size());
    const std::size_t wanted = json_.at("buffers").at(0).at("byteLength");
    EXPECT_LE(wanted, binary_.size());
    EXPECT_LT(binary_.size(), wanted + 4);
  }
  check_accessors();
  parent_.assign(json_.at("nodes").size(), -1);
  for (std::size_t i = 0; i < parent_.size(); ++i) {
    for (const int child : json_.at("nodes").at(i).value("children", std::vector<int>{})) {
      EXPECT_EQ(parent_.at(static_cast<std::size_t>(child)), -1) << child;
      parent_[static_cast<std::size_t>(child)] = static_cast<int>(i);
    }
  }
  read_channels();
}

std::vector<std::vector<double>> FilmPlayer::read(int number) const {
  const auto& accessor = json_.at("accessors").at(static_cast<std::size_t>(number));
  const auto& view = json_.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
  const std::size_t width = width_of(accessor);
  EXPECT_EQ(accessor.at("componentType"), 5126);
  const std::size_t offset = accessor.at("byteOffset");
  const std::size_t count = accessor.at("count");
  const std::size_t begin = view.at("byteOffset").get<std::size_t>() + offset;
  EXPECT_EQ(begin % 4, 0U);
  EXPECT_LE(offset + 4 * width * count, view.at("byteLength").get<std::size_t>());
  EXPECT_LE(begin + 4 * width * count, binary_.size());
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double>& row = rows.emplace_back();
    for (std::size_t k = 0; k < width; ++k) {
      float value = 0;
      std::memcpy(&value, binary_.data() + begin + 4 * (i * width + k), 4);
      EXPECT_TRUE(std::isfinite(value));
      row.push_back(static_cast<double>(value));
    }
  }
  return rows;
}

void FilmPlayer::check_accessors() const {
  for (std::size_t i = 0; i < json_.value("accessors", nlohmann::json::array()).size(); ++i) {
    const auto& accessor = json_.at("accessors").at(i);
    const auto rows = read(static_cast<int>(i));
    EXPECT_FALSE(rows.empty());
    if (!accessor.contains("min")) continue;
    for (std::size_t k = 0; k < width_of(accessor); ++k) {
      const auto [least, most] = std::minmax_element(
          rows.begin(), rows.end(), [k](const auto& a, const auto& b) { return a[k] < b[k]; });
      EXPECT_EQ((*least)[k], accessor.at("min").at(k)) << i;
      EXPECT_EQ((*most)[k], accessor.at("max").at(k)) << i;
    }
  }
  for (const auto& mesh : json_.value("meshes", nlohmann::json::array())) {
    const auto& attributes = mesh.at("primitives").at(0).at("attributes");
    const auto corners = read(attributes.at("POSITION"));
    const auto normals = read(attributes.at("NORMAL"));
    EXPECT_EQ(corners.size(), normals.size());
    EXPECT_EQ(corners.size() % 3, 0U);
    for (const auto& n : normals) {
      EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-6);
    }
  }
}

void FilmPlayer::read_channels() {
  channels_.resize(parent_.size());
  if (!json_.contains("animations")) return;
  EXPECT_EQ(json_.at("animations").size(), 1U);
  const auto& animation = json_.at("animations").at(0);
  for (const auto& channel : animation.at("channels")) {
    const auto& sampler = animation.at("samplers").at(channel.at("sampler").get<std::size_t>());
    Channel read_in;
    read_in.path = channel.at("target").at("path");
    read_in.step = sampler.at("interpolation") == "STEP";
    for (const auto& row : read(sampler.at("input"))) read_in.times.push_back(row[0]);
    EXPECT_GE(read_in.times.front(), 0);
    for (std::size_t i = 1; i < read_in.times.size(); ++i) {
      EXPECT_LT(read_in.times[i - 1], read_in.times[i]);
    }
    read_in.values = read(sampler.at("output"));
    EXPECT_EQ(read_in.values.size(), read_in.times.size());
    for (std::size_t i = 0; i < read_in.values.size(); ++i) {
      if (read_in.path != "rotation") continue;
      const Eigen::Quaterniond turn = quaternion(read_in.values[i]);
      EXPECT_NEAR(turn.norm(), 1, 1e-6);
      if (i == 0) continue;
      EXPECT_GT(std::fabs(turn.dot(quaternion(read_in.values[i - 1]))), 0.7071);  // 90 degrees
    }
    end_ = std::max(end_, read_in.times.back());
    auto& of_node = channels_.at(channel.at("target").at("node").get<std::size_t>());
    for (const Channel& other : of_node) EXPECT_NE(other.path, read_in.path);
    of_node.push_back(std::move(read_in));
  }
}

std::vector<int> FilmPlayer::named(const std::string& name) const {
  std::vector<int> found;
  for (std::size_t i = 0; i < parent_.size(); ++i) {
    if (json_.at("nodes").at(i).at("name") == name) found.push_back(static_cast<int>(i));
  }
  return found;
}

std::vector<double> FilmPlayer::value(int node, const std::string& path, double time) const {
  for (const Channel& channel : channels_[static_cast<std::size_t>(node)]) {
    if (channel.path != path) continue;
    if (time <= channel.times.front()) return channel.values.front();
    if (time >= channel.times.back()) return channel.values.back();
    const auto next = std::upper_bound(channel.times.begin(), channel.times.end(), time);
    const auto i = static_cast<std::size_t>(next - channel.times.begin());
    if (channel.step) return channel.values[i - 1];
    const double share = (time - channel.times[i - 1]) / (channel.times[i] - channel.times[i - 1]);
    return between(channel.values[i - 1], channel.values[i], share, path == "rotation");
  }
  const std::vector<double> usual = path == "rotation" ? std::vector<double>{0, 0, 0, 1}
                                    : path == "scale"  ? std::vector<double>{1, 1, 1}
                                                       : std::vector<double>{0, 0, 0};
  return json_.at("nodes").at(static_cast<std::size_t>(node)).value(path, usual);
}

math::Pose FilmPlayer::pose(int node, double time) const {
  math::Pose X = math::Pose::Identity();
  for (; parent_[static_cast<std::size_t>(node)] >= 0;
       node = parent_[static_cast<std::size_t>(node)]) {
    const auto p = value(node, "translation", time);
    math::Pose X_PN = math::translation(p[0], p[1], p[2]);
    X_PN.linear() = quaternion(value(node, "rotation", time)).normalized().toRotationMatrix();
    X = X_PN * X;
  }
  return X;
}

const nlohmann::json& FilmPlayer::material(int node) const {
  const std::size_t mesh = json_.at("nodes").at(static_cast<std::size_t>(node)).at("mesh");
  const std::size_t material = json_.at("meshes").at(mesh).at("primitives").at(0).at("material");
  return json_.at("materials").at(material);
}

bool FilmPlayer::visible(int node, double time) const {
  for (; node >= 0; node = parent_[static_cast<std::size_t>(node)]) {
    const double scale = value(node, "scale", time)[0];  // of a rope z is its length
    EXPECT_TRUE(scale == 0 || scale == 1);
    if (scale == 0) return false;
  }
  return true;
}

}  // namespace rubicon::test
