#include "src/results/gltf/nodes.hpp"

namespace rubicon::gltf {

int Nodes::add(int parent, const std::string& name) {
  const int number = static_cast<int>(nodes_.size());
  nodes_.push_back({{{"name", name}}, {}});
  if (parent >= 0) nodes_[index(parent)].children.push_back(number);
  return number;
}

void Nodes::place(int node, const Pose& X_PN) {
  const Vec3 p = X_PN.translation();
  if (!p.isZero(0)) set(node, "translation", {p.x(), p.y(), p.z()});
  const math::Mat3 R = X_PN.linear();
  if (R.isIdentity(0)) return;
  const Eigen::Quaterniond turn = Eigen::Quaterniond(R).normalized();
  set(node, "rotation", {turn.x(), turn.y(), turn.z(), turn.w()});
}

void Nodes::show(int node, const MeshUse& use) {
  int holder = node;
  if (!use.offset.isZero(0)) {
    holder = add(node, "surface");
    place(holder, math::translation(use.offset.x(), use.offset.y(), use.offset.z()));
  }
  set(holder, "mesh", use.mesh);
}

void Nodes::finish(Json& document) {
  Json list = Json::array();
  for (Node& node : nodes_) {
    if (!node.children.empty()) node.json["children"] = node.children;
    list.push_back(std::move(node.json));
  }
  document["nodes"] = std::move(list);
}

}  // namespace rubicon::gltf
