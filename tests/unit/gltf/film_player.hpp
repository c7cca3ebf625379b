#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::test {

/// Plays a .glb as a viewer would, with nothing but the file: see the glTF 2.0 specification, 3.11.
class FilmPlayer {
 public:
  /// Fails the test where the file breaks a rule: lengths, bounds, keys that do not increase,
  /// rotations that are none.
  explicit FilmPlayer(const std::string& glb);

  const nlohmann::json& json() const { return json_; }
  double end() const { return end_; }

  /// The numbers of the nodes with this name.
  std::vector<int> named(const std::string& name) const;

  /// A node in the frame of the file's root node (z up) at a time of the film; its scale is left
  /// out.
  math::Pose pose(int node, double time) const;
  /// Its own scale.
  std::vector<double> scale(int node, double time) const { return value(node, "scale", time); }
  /// The material of its mesh, or of the mesh of its one child "surface".
  const nlohmann::json& material(int node) const;
  /// Whether it and all it hangs on have a size.
  bool visible(int node, double time) const;

 private:
  struct Channel {
    std::string path;
    bool step = false;
    std::vector<double> times;
    std::vector<std::vector<double>> values;
  };
  std::vector<std::vector<double>> read(int accessor) const;
  void check_accessors() const;
  void read_channels();
  std::vector<double> value(int node, const std::string& path, double time) const;

  nlohmann::json json_;
  std::string binary_;
  std::vector<int> parent_;
  std::vector<std::vector<Channel>> channels_;  ///< by node
  double end_ = 0;
};

}  // namespace rubicon::test
