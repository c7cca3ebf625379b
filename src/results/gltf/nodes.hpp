#pragma once

#include <string>
#include <vector>

#include "src/results/gltf/binary_data.hpp"
#include "src/results/gltf/meshes.hpp"

namespace rubicon::gltf {

using math::Pose;

/// The nodes of a document, a tree.
class Nodes {
 public:
  /// A node below `parent` (-1: it is a root); returns its number.
  int add(int parent, const std::string& name);

  /// How it stands in its parent.
  void place(int node, const Pose& X_PN);
  void set(int node, const char* member, Json value) {
    nodes_[index(node)].json[member] = std::move(value);
  }
  /// Hangs a mesh under it.
  void show(int node, const MeshUse& use);

  /// Writes `nodes`.
  void finish(Json& document);

 private:
  struct Node {
    Json json;
    std::vector<int> children;
  };
  static std::size_t index(int node) { return static_cast<std::size_t>(node); }
  std::vector<Node> nodes_;
};

}  // namespace rubicon::gltf
