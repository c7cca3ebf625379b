#include "src/motion/guides/nearest_index.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "src/motion/math/lanes.hpp"

namespace rubicon::guides {

namespace {

/// Points that are looked at one by one until they become a tree, and points of a leaf.
constexpr int kInNoTree = 128;
constexpr int kInLeaf = 8;
static_assert(kInNoTree % math::kLanes == 0);

using math::LaneMask;
using math::Lanes;
using math::lanes;

/// A point that is asked for, and how distances are counted.
struct Asked {
  const double* point;
  const double* weights;
  const double* turns;
  std::size_t size;
};

void take(double square, int index, NearestIndex::Found& found) {
  if (square > found.square) return;
  if (square == found.square && found.index >= 0 && found.index < index) return;
  found = {index, square};
}

/// The squares of the distances of four points, as `square_of` has them for one.
RUBICON_LANES Lanes squares_of(const double* block, const Asked& asked) {
  Lanes sum = lanes(0);
  for (std::size_t d = 0; d < asked.size; ++d, block += math::kLanes) {
    Lanes own;
    std::memcpy(&own.v, block, sizeof own.v);
    Lanes way = lanes(asked.point[d]) - own;
    if (asked.turns[d] > 0) {
      const Lanes turn = lanes(asked.turns[d]);
      const Lanes half = lanes(asked.turns[d] / 2);
      way = way - select(way > half, turn, lanes(0));
      way = way + select(~(way > -half), turn, lanes(0));
    }
    const Lanes off = way * lanes(asked.weights[d]);
    sum = sum + off * off;
  }
  return sum;
}

/// The nearest of the points of blocks; those of no block are infinitely far.
RUBICON_LANES void take_blocks(const double* blocks, int first, int last, const Asked& asked,
                               NearestIndex::Found& found) {
  Lanes least = lanes(std::numeric_limits<double>::infinity());
  Lanes at = lanes(-1);
  for (int k = first; k < last; ++k) {
    const Lanes squares =
        squares_of(blocks + static_cast<std::size_t>(k) * asked.size * math::kLanes, asked);
    const LaneMask nearer = least > squares;
    least = select(nearer, squares, least);
    at = select(nearer, lanes(k), at);
  }
  for (int lane = 0; lane < math::kLanes; ++lane) {
    if (at.v[lane] < 0) continue;
    take(least.v[lane], static_cast<int>(at.v[lane]) * math::kLanes + lane, found);
  }
}

void take_blocks_baseline(const double* blocks, int first, int last, const Asked& asked,
                          NearestIndex::Found& found) {
  take_blocks(blocks, first, last, asked, found);
}

RUBICON_AVX2 void take_blocks_avx2(const double* blocks, int first, int last, const Asked& asked,
                                   NearestIndex::Found& found) {
  take_blocks(blocks, first, last, asked, found);
}

}  // namespace

NearestIndex::NearestIndex(std::vector<double> weights, std::vector<double> turns)
    : weights_(std::move(weights)), turns_(std::move(turns)) {}

double NearestIndex::coordinate(int i, std::size_t d) const {
  const auto block = static_cast<std::size_t>(i / math::kLanes);
  return blocks_[(block * weights_.size() + d) * math::kLanes +
                 static_cast<std::size_t>(i % math::kLanes)];
}

double NearestIndex::square_of(int i, std::span<const double> point) const {
  double sum = 0;
  for (std::size_t d = 0; d < weights_.size(); ++d) {
    double way = point[d] - coordinate(i, d);
    if (turns_[d] > 0) {
      const double half = turns_[d] / 2;
      way -= way > half ? turns_[d] : 0.0;
      way += way <= -half ? turns_[d] : 0.0;
    }
    const double off = way * weights_[d];
    sum += off * off;
  }
  return sum;
}

NearestIndex::Found NearestIndex::nearest(std::span<const double> point) const {
  static const auto take_all = math::processor_has_avx2() ? take_blocks_avx2 : take_blocks_baseline;
  Found found;
  const Asked asked{point.data(), weights_.data(), turns_.data(), weights_.size()};
  take_all(blocks_.data(), in_trees_ / math::kLanes, (count_ + math::kLanes - 1) / math::kLanes,
           asked, found);
  for (auto tree = trees_.rbegin(); tree != trees_.rend(); ++tree) {
    if (!tree->nodes.empty()) search(*tree, point, found);
  }
  return found;
}

void NearestIndex::search(const Tree& tree, std::span<const double> point, Found& found) const {
  std::vector<std::pair<double, int>> open{{square_to(tree, 0, point), 0}};
  while (!open.empty()) {
    const auto [bound, at] = open.back();
    open.pop_back();
    if (bound > found.square) continue;
    const Node& node = tree.nodes[static_cast<std::size_t>(at)];
    if (node.right < 0) {
      for (int k = node.first; k < node.last; ++k) {
        const int i = tree.order[static_cast<std::size_t>(k)];
        take(square_of(i, point), i, found);
      }
      continue;
    }
    std::pair<double, int> near{square_to(tree, at + 1, point), at + 1};
    std::pair<double, int> far{square_to(tree, node.right, point), node.right};
    if (far.first < near.first) std::swap(near, far);
    open.push_back(far);
    open.push_back(near);
  }
}

void NearestIndex::add(std::span<const double> point) {
  const auto lane = static_cast<std::size_t>(count_ % math::kLanes);
  if (lane == 0) {
    blocks_.resize(blocks_.size() + weights_.size() * math::kLanes,
                   std::numeric_limits<double>::infinity());
  }
  double* block = blocks_.data() + blocks_.size() - weights_.size() * math::kLanes;
  for (std::size_t d = 0; d < weights_.size(); ++d) block[d * math::kLanes + lane] = point[d];
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
