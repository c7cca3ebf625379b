#include "src/motion/collision/tree/wide_tree.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/tree/float_box.hpp"
#include "src/motion/collision/tree/kernels.hpp"
#include "src/motion/collision/tree/tree_groups.hpp"

namespace rubicon::collision {
namespace {

/// Changes that never cause a new build, however small the tree.
constexpr int kFreeChanges = 64;
/// A child that an additional box enlarges no more than this takes it even where there is a free
/// slot above.
constexpr double kFittingGrowth = 1.2;
/// Beyond this depth a build halves by number, which ends after 20 levels whatever the boxes.
constexpr int kHeuristicDepth = 11;
/// A distance in doubles is certain to this share; more than enough for a dozen roundings.
constexpr double kSafeShare = 1 - 1e-12;

/// A part of the tree that is built anew has at least so many items.
constexpr int kLeastPart = 1024;

/// Numbers this large stand for "without bound"; larger ones are cut, and so is "not a number".
constexpr double kUnbounded = 1e38;
/// Rounding to single precision and the step below are each good to 2^-24: this share covers both.
constexpr float kOutwards = 0x1p-22F;
/// The test against a slab adds some ten numbers up to the size of the tree, each rounded
/// to 2^-24 of it: this share covers twice that.
constexpr double kFloatRounding = 0x1p-19;

float rounded_down(double value) {
  const auto result = static_cast<float>(std::min(std::max(-kUnbounded, value), kUnbounded));
  return result - std::fabs(result) * kOutwards;
}

float rounded_up(double value) {
  const auto result = static_cast<float>(std::max(std::min(kUnbounded, value), -kUnbounded));
  return result + std::fabs(result) * kOutwards;
}

FloatBox slot_box(const WideNode& node, int slot) {
  FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = node.lower[axis][slot];
    box.upper[axis] = node.upper[axis][slot];
  }
  return box;
}

void set_box(WideNode& node, int slot, const FloatBox& box) {
  for (int axis = 0; axis < 3; ++axis) {
    node.lower[axis][slot] = box.lower[axis];
    node.upper[axis][slot] = box.upper[axis];
  }
}

FloatBox node_box(const WideNode& node) {
  FloatBox box = kEmptyBox;
  for (int slot = 0; slot < kWidth; ++slot) join(box, slot_box(node, slot));
  return box;
}

int node_count(const WideNode& node) {
  int count = 0;
  for (int slot = 0; slot < kWidth; ++slot) count += node.count[slot];
  return count;
}

}  // namespace

void ItemList::grow() {
  heap_.resize(2 * static_cast<std::size_t>(capacity_));
  data_ = heap_.data();
  capacity_ = static_cast<int>(heap_.size());
  size_ = 0;
}

WideTree::WideTree(const std::vector<Bounds>& items) {
  if (items.empty()) return;
  set_origin(items.front());
  std::vector<TreeEntry> entries;
  for (std::size_t i = 0; i < items.size(); ++i) {
    entries.push_back({to_float(items[i]), static_cast<int>(i)});
  }
  build(std::move(entries));
}

void WideTree::set_origin(const Bounds& first) {
  const Vec3 centre = first.centre();
  for (int axis = 0; axis < 3; ++axis) {
    origin_[axis] = std::isfinite(centre[axis]) ? std::floor(centre[axis]) : 0;
  }
}

FloatBox WideTree::to_float(const Bounds& bounds) const {
  FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = rounded_down(bounds.lower[axis] - kBoundsMargin - origin_[axis]);
    box.upper[axis] = rounded_up(bounds.upper[axis] + kBoundsMargin - origin_[axis]);
  }
  return box;
}

void WideTree::note_extent(const FloatBox& box) {
  Bounds bounds;
  for (int axis = 0; axis < 3; ++axis) {
    bounds.lower[axis] = origin_[axis] + box.lower[axis] - kBoundsMargin;
    bounds.upper[axis] = origin_[axis] + box.upper[axis] + kBoundsMargin;
  }
  around_.add(bounds);
  for (int axis = 0; axis < 3; ++axis) {
    farthest_ = std::max({farthest_, static_cast<double>(std::fabs(box.lower[axis])),
                          static_cast<double>(std::fabs(box.upper[axis]))});
  }
}

void WideTree::build(std::vector<TreeEntry> entries) {
  nodes_.clear();
  parents_.clear();
  free_nodes_.clear();
  changes_ = 0;
  depth_ = 0;
  size_ = static_cast<int>(entries.size());
  around_ = {};
  for (const TreeEntry& entry : entries) note_extent(entry.box);
  add_node({});
  if (!entries.empty()) fill_node(0, entries, 0, entries.size(), 1);
}

void WideTree::fill_node(int node, std::vector<TreeEntry>& entries, std::size_t begin,
                         std::size_t end, int depth) {
  depth_ = std::max(depth_, depth);
  if (end - begin <= kWidth) {
    for (std::size_t i = begin; i < end; ++i) {
      const int slot = static_cast<int>(i - begin);
      set_slot(node, slot, entries[i].box, ~entries[i].item, 1);
      note_place(entries[i].item, {node, slot});
    }
    return;
  }
  int slot = 0;
  for (const TreeGroup& group : tree_groups(entries, begin, end, depth > kHeuristicDepth)) {
    const int child = add_node({node, slot});
    fill_node(child, entries, group.begin, group.end, depth + 1);
    set_slot(node, slot, node_box(nodes_[child]), child, static_cast<int>(group.size()));
    ++slot;
  }
}

int WideTree::add_node(Place parent) {
  int index = 0;
  if (free_nodes_.empty()) {
    index = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    parents_.emplace_back();
  } else {
    index = free_nodes_.back();
    free_nodes_.pop_back();
  }
  parents_[index] = parent;
  for (int slot = 0; slot < kWidth; ++slot) set_slot(index, slot, kEmptyBox, 0, 0);
  return index;
}

void WideTree::set_slot(int node, int slot, const FloatBox& box, int child, int count) {
  set_box(nodes_[node], slot, box);
  nodes_[node].child[slot] = child;
  nodes_[node].count[slot] = count;
}

void WideTree::note_place(int item, Place place) {
  if (item >= static_cast<int>(places_.size())) places_.resize(item + 1);
  places_[item] = place;
}

/// Puts right the boxes and counts above a node; a node without items goes.
void WideTree::refresh_above(int node) {
  while (parents_[node].node >= 0) {
    const Place up = parents_[node];
    const int count = node_count(nodes_[node]);
    if (count == 0) {
      set_slot(up.node, up.slot, kEmptyBox, 0, 0);
      free_nodes_.push_back(node);
    } else {
      set_slot(up.node, up.slot, node_box(nodes_[node]), node, count);
    }
    node = up.node;
  }
}

/// The used slot that an additional box enlarges least; of equal ones that with the fewest items.
int WideTree::cheapest_slot(const WideNode& node, const FloatBox& box) {
  int best = -1;
  double best_cost = 0;
  for (int slot = 0; slot < kWidth; ++slot) {
    if (node.count[slot] == 0) continue;
    const FloatBox own = slot_box(node, slot);
    const double cost = area(joined(own, box)) - area(own);
    // Boxes without bound cost "not a number" more, which is as good as nothing.
    const bool better = best < 0 || cost < best_cost ||
                        (!(best_cost < cost) && node.count[slot] < node.count[best]);
    if (better) {
      best = slot;
      best_cost = cost;
    }
  }
  return best;
}

void WideTree::insert(int item, const Bounds& bounds) {
  if (nodes_.empty()) {
    set_origin(bounds);
    add_node({});
    depth_ = 1;
  }
  const FloatBox box = to_float(bounds);
  note_extent(box);
  ++size_;
  int node = 0;
  for (int depth = 1;; ++depth) {
    WideNode& here = nodes_[node];
    int free_slot = -1;
    for (int slot = 0; slot < kWidth && free_slot < 0; ++slot) {
      if (here.count[slot] == 0) free_slot = slot;
    }
    const int cheapest = cheapest_slot(here, box);
    const bool fits_below = cheapest >= 0 && here.child[cheapest] >= 0 &&
                            area(joined(slot_box(here, cheapest), box)) <=
                                kFittingGrowth * area(slot_box(here, cheapest));
    if (free_slot >= 0 && !fits_below) {
      set_slot(node, free_slot, box, ~item, 1);
      note_place(item, {node, free_slot});
      refresh_above(node);
      break;
    }
    if (here.child[cheapest] < 0) {
      // An item there: from now on a node of two.
      const FloatBox other_box = slot_box(here, cheapest);
      const int other = ~here.child[cheapest];
      const int child = add_node({node, cheapest});  // `here` is no longer valid
      set_slot(child, 0, other_box, ~other, 1);
      note_place(other, {child, 0});
      set_slot(child, 1, box, ~item, 1);
      note_place(item, {child, 1});
      depth_ = std::max(depth_, depth + 1);
      refresh_above(child);
      if (depth + 1 >= kMaxDepth) rebuild_part_around(child, depth + 1);
      break;
    }
    node = here.child[cheapest];
  }
  changed();
}

void WideTree::remove(int item) {
  const Place place = places_[item];
  assert(place.node >= 0 && nodes_[place.node].child[place.slot] == ~item);
  set_slot(place.node, place.slot, kEmptyBox, 0, 0);
  places_[item] = {};
  --size_;
  refresh_above(place.node);
  changed();
}

void WideTree::replace(int item, const Bounds& bounds) {
  const Place place = places_[item];
  assert(place.node >= 0 && nodes_[place.node].child[place.slot] == ~item);
  const FloatBox box = to_float(bounds);
  const FloatBox before = slot_box(nodes_[place.node], place.slot);
  const double joint = area(joined(before, box));
  // Boxes without bound, too: their areas are no numbers.
  if (!(joint <= kFittingGrowth * area(before))) {
    remove(item);
    insert(item, bounds);
    return;
  }
  note_extent(box);
  set_slot(place.node, place.slot, box, ~item, 1);
  refresh_above(place.node);
  // What only becomes smaller leaves the tree as good as it was.
  if (joint > area(before)) changed();
}

void WideTree::changed() {
  ++changes_;
  if (depth_ < kMaxDepth && changes_ <= std::max(kFreeChanges, size_ / 2)) return;
  std::vector<TreeEntry> entries;
  for (std::size_t item = 0; item < places_.size(); ++item) {
    const Place place = places_[item];
    if (place.node < 0) continue;
    entries.push_back({slot_box(nodes_[place.node], place.slot), static_cast<int>(item)});
  }
  build(std::move(entries));
}

/// Items that come one beside the other, as a building grows, make a deep and narrow part of the
/// tree, over and over again at another place. Only that part is built anew: above `node`, at
/// `depth`, as much as makes it shallow.
void WideTree::rebuild_part_around(int node, int depth) {
  int enough = kLeastPart;
  do {
    while (parents_[node].node >= 0 && node_count(nodes_[node]) < enough) {
      node = parents_[node].node;
      --depth;
    }
    std::vector<TreeEntry> entries = take_items(node);
    depth_ = 0;
    fill_node(node, entries, 0, entries.size(), depth);
    enough *= kWidth;
  } while (depth_ > kMaxDepth / 2 && parents_[node].node >= 0);
}

/// Takes out all items at and below a node, which is then empty.
std::vector<TreeEntry> WideTree::take_items(int node) {
  std::vector<TreeEntry> entries;
  std::vector<int> open = {node};
  while (!open.empty()) {
    const int each = open.back();
    open.pop_back();
    for (int slot = 0; slot < kWidth; ++slot) {
      if (nodes_[each].count[slot] == 0) continue;
      const int child = nodes_[each].child[slot];
      if (child >= 0) {
        open.push_back(child);
      } else {
        entries.push_back({slot_box(nodes_[each], slot), ~child});
      }
    }
    if (each != node) free_nodes_.push_back(each);
  }
  for (int slot = 0; slot < kWidth; ++slot) set_slot(node, slot, kEmptyBox, 0, 0);
  return entries;
}

namespace {

/// Calls a kernel until there is room for all it finds.
template <typename Collect>
void collect_all(ItemList& found, const Collect& collect) {
  for (;;) {
    const int count = collect(found.begin(), found.capacity());
    if (count >= 0) {
      found.set_size(count);
      return;
    }
    found.grow();
  }
}

}  // namespace

void WideTree::collect(const Bounds& bounds, ItemList& found) const {
  found.set_size(0);
  if (size_ == 0) return;
  const FloatBox box = to_float(bounds);
  collect_all(found, [&](int* first, int capacity) {
    return kernels().collect(nodes_.data(), box, first, capacity);
  });
}

void WideTree::collect(const Bounds& bounds, std::span<const Slab> slabs, ItemList& found) const {
  found.set_size(0);
  if (size_ == 0) return;
  FloatSlabs asked;
  asked.box = to_float(bounds);
  for (const Slab& slab : slabs) {
    const double middle = slab.middle - slab.axis.dot(origin_);
    // A slab without bound excludes nothing.
    if (asked.count == FloatSlabs::kMost || !std::isfinite(middle) || !(slab.half < kUnbounded)) {
      continue;
    }
    const int j = asked.count++;
    for (int axis = 0; axis < 3; ++axis) {
      asked.axis[j][axis] = static_cast<float>(slab.axis[axis]);
    }
    asked.middle[j] = static_cast<float>(middle);
    const double rounding = kFloatRounding * (farthest_ + std::fabs(middle) + slab.half);
    asked.half[j] = static_cast<float>(slab.half + rounding);
  }
  collect_all(found, [&](int* first, int capacity) {
    return kernels().collect_between(nodes_.data(), asked, first, capacity);
  });
}

double WideTree::distance(const Bounds& bounds, double range) const {
  if (size_ == 0 || !(range > 0)) return range;
  double least = range * range;
  const Vec3 lower = bounds.lower - origin_;
  const Vec3 upper = bounds.upper - origin_;
  struct Open {
    int node;
    double squared;
  };
  std::array<Open, kMaxOpen> open;
  int count = 0;
  open[count++] = {0, 0};
  while (count > 0) {
    const Open next = open[--count];
    if (next.squared >= least) continue;
    const WideNode& node = nodes_[next.node];
    const int first = count;
    for (int slot = 0; slot < kWidth; ++slot) {
      if (node.count[slot] == 0) continue;
      double squared = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double gap = std::max({0.0, static_cast<double>(node.lower[axis][slot]) - upper[axis],
                                     lower[axis] - static_cast<double>(node.upper[axis][slot])});
        squared += gap * gap;
      }
      if (!(squared < least)) continue;
      if (node.child[slot] < 0) {
        least = squared;
        continue;
      }
      // The nearest last, so that it is looked at first.
      int at = count++;
      while (at > first && open[at - 1].squared < squared) {
        open[at] = open[at - 1];
        --at;
      }
      open[at] = {node.child[slot], squared};
    }
  }
  return std::sqrt(least) * kSafeShare;
}

}  // namespace rubicon::collision
