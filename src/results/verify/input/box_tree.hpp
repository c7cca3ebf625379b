#pragma once

#include <utility>
#include <vector>

#include "src/results/verify/input/convex.hpp"

namespace rubicon::verify {

/// Boxes in a tree that is built once: each node splits its boxes at the middle one, along the side
/// on which their centres are spread the most.
class BoxTree {
 public:
  struct Node {
    Bounds bounds;
    int left = -1;   ///< node; -1: a leaf
    int right = -1;  ///< node
    int item = -1;   ///< of a leaf
  };

  BoxTree() = default;
  explicit BoxTree(const std::vector<Bounds>& boxes);

  bool empty() const { return nodes_.empty(); }
  const std::vector<Node>& nodes() const { return nodes_; }  ///< the first is the root

  /// Calls visit(item) for every box that meets `bounds`, in a fixed order.
  template <typename Visit>
  void meeting(const Bounds& bounds, Visit visit) const {
    if (!nodes_.empty()) descend(0, bounds, visit);
  }

 private:
  using Entry = std::pair<Bounds, int>;
  int build(std::vector<Entry>& entries, std::size_t begin, std::size_t end);

  template <typename Visit>
  void descend(int index, const Bounds& bounds, Visit& visit) const {
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (!node.bounds.meets(bounds)) return;
    if (node.left < 0) {
      visit(node.item);
      return;
    }
    descend(node.left, bounds, visit);
    descend(node.right, bounds, visit);
  }

  std::vector<Node> nodes_;
};

}  // namespace rubicon::verify
