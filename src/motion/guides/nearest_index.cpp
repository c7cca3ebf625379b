#include "src/motion/guides/nearest_index.hpp"

#include <algorithm>
#include <limits>

namespace rubicon::guides {

namespace {

/// Points that are looked at one by one until they become a tree, and points of a leaf.
constexpr int kInNoTree = 128;
constexpr int kInLeaf = 8;

}  // namespace

void NearestIndex::add(std::span<const double> point) {
  points_.insert(points_.end(), point.begin(), point.end());
  if (++count_ - in_trees_ < kInNoTree) return;
  Tree tree;
  for (int i = in_trees_; i < count_; ++i) tree.order.push_back(i);
  in_trees_ = count_;
  std::size_t place = 0;
  for (; place < trees_.size() && !trees_[place].nodes.empty(); ++place) {
    const std::vector<int>& order = trees_[place].order;
    tree.order.insert(tree.order.end(), order.begin(), order.end());
    trees_[place] = {};
  }
  if (place == trees_.size()) trees_.emplace_back();
  build(tree, 0, static_cast<int>(tree.order.size()));
  trees_[place] = std::move(tree);
}

void NearestIndex::build(Tree& tree, int first, int last) {
  const std::size_t at = tree.nodes.size();
  const std::size_t size = weights_.size();
  tree.nodes.push_back({first, last, -1});
  std::size_t widest = 0;
  double width = 0;
  for (std::size_t d = 0; d < size; ++d) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int k = first; k < last; ++k) {
      const double each = coordinate(tree.order[static_cast<std::size_t>(k)], d);
      low = std::min(low, each);
      high = std::max(high, each);
    }
    tree.boxes.push_back(low);
    tree.boxes.push_back(high);
    if ((high - low) * weights_[d] <= width) continue;
    width = (high - low) * weights_[d];
    widest = d;
  }
  if (last - first <= kInLeaf || width == 0) return;
  const int middle = first + (last - first) / 2;
  const auto less = [&](int a, int b) {
    const double one = coordinate(a, widest);
    const double other = coordinate(b, widest);
    return one != other ? one < other : a < b;
  };
  const auto begin = tree.order.begin();
  std::nth_element(begin + first, begin + middle, begin + last, less);
  build(tree, first, middle);
  tree.nodes[at].right = static_cast<int>(tree.nodes.size());
  build(tree, middle, last);
}

double NearestIndex::square_to(const Tree& tree, int node, std::span<const double> point) const {
  constexpr double kRounding = 1 - 1e-9;
  const double* box = tree.boxes.data() + static_cast<std::size_t>(node) * 2 * weights_.size();
  double sum = 0;
  for (std::size_t d = 0; d < weights_.size(); ++d, box += 2) {
    const auto off = [&](double p) { return std::max({box[0] - p, p - box[1], 0.0}); };
    double least = off(point[d]);
    if (turns_[d] > 0) {
      least = std::min({least, off(point[d] - turns_[d]), off(point[d] + turns_[d])});
    }
    least *= weights_[d];
    sum += least * least;
  }
  return sum * kRounding;
}

}  // namespace rubicon::guides
