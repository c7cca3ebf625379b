#include "src/collision/wide_tree.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "src/collision/kernels.hpp"
#include "src/collision/tolerances.hpp"

namespace rubicon::collision {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr FloatBox kEmpty = {{kInfinity, kInfinity, kInfinity},
                             {-kInfinity, -kInfinity, -kInfinity}};
constexpr int kBins = 16;
/// Changes that never cause a new build, however small the tree.
constexpr int kFreeChanges = 64;
/// A child that an additional box enlarges no more than this takes it even where there is a free
/// slot above.
constexpr double kFittingGrowth = 1.2;
/// Beyond this depth a build halves by number, which ends after 20 levels whatever the boxes.
constexpr int kHeuristicDepth = 11;
/// A distance in doubles is certain to this share; more than enough for a dozen roundings.
constexpr double kSafeShare = 1 - 1e-12;

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

void join(FloatBox& box, const FloatBox& other) {
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = std::min(box.lower[axis], other.lower[axis]);
    box.upper[axis] = std::max(box.upper[axis], other.upper[axis]);
  }
}

FloatBox joined(FloatBox box, const FloatBox& other) {
  join(box, other);
  return box;
}

/// Half of the surface; 0 for an empty box. In doubles: infinite boxes give infinity, not NaN.
double area(const FloatBox& box) {
  const double x = static_cast<double>(box.upper[0]) - box.lower[0];
  const double y = static_cast<double>(box.upper[1]) - box.lower[1];
  const double z = static_cast<double>(box.upper[2]) - box.lower[2];
  return x >= 0 && y >= 0 && z >= 0 ? x * y + y * z + z * x : 0;
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
  FloatBox box = kEmpty;
  for (int slot = 0; slot < kWidth; ++slot) join(box, slot_box(node, slot));
  return box;
}

int node_count(const WideNode& node) {
  int count = 0;
  for (int slot = 0; slot < kWidth; ++slot) count += node.count[slot];
  return count;
}

using Entries = std::vector<WideTree::Entry>;

/// A run of entries that one child is made of.
struct Group {
  std::size_t begin = 0;
  std::size_t end = 0;
  double area = 0;

  std::size_t size() const { return end - begin; }
};

Group group_of(const Entries& entries, std::size_t begin, std::size_t end) {
  FloatBox box = kEmpty;
  for (std::size_t i = begin; i < end; ++i) join(box, entries[i].box);
  return {begin, end, area(box)};
}

float twice_centre(const FloatBox& box, int axis) { return box.lower[axis] + box.upper[axis]; }

/// Half of the entries each, along the axis in which their centres differ most.
std::size_t halved(Entries& entries, const Group& group, int axis) {
  const std::size_t middle = group.begin + group.size() / 2;
  const auto at = [&](std::size_t i) { return entries.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(group.begin), at(middle), at(group.end),
                   [axis](const WideTree::Entry& a, const WideTree::Entry& b) {
                     const float first = twice_centre(a.box, axis);
                     const float second = twice_centre(b.box, axis);
                     return first != second ? first < second : a.item < b.item;
                   });
  return middle;
}

/// Where to cut a group in two: the cheapest of the planes between bins by the surface area
/// heuristic.
std::size_t split(Entries& entries, const Group& group, bool by_number) {
  std::array<float, 3> least;
  std::array<float, 3> greatest;
  least.fill(kInfinity);
  greatest.fill(-kInfinity);
  for (std::size_t i = group.begin; i < group.end; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const float centre = twice_centre(entries[i].box, axis);
      least[axis] = std::min(least[axis], centre);
      greatest[axis] = std::max(greatest[axis], centre);
    }
  }
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (greatest[axis] - least[axis] > greatest[longest] - least[longest]) longest = axis;
  }
  const float extent = greatest[longest] - least[longest];
  // Also where boxes are infinite: their centres are no numbers.
  if (by_number || !(extent > 0) || !(extent < kInfinity)) return halved(entries, group, longest);

  double best_cost = std::numeric_limits<double>::infinity();
  int best_axis = -1;
  int best_bin = 0;
  const auto bin_of = [&](const WideTree::Entry& entry, int axis) {
    const float share =
        (twice_centre(entry.box, axis) - least[axis]) / (greatest[axis] - least[axis]);
    return std::min(static_cast<int>(share * kBins), kBins - 1);
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (!(greatest[axis] > least[axis])) continue;
    std::array<FloatBox, kBins> boxes;
    boxes.fill(kEmpty);
    std::array<int, kBins> counts{};
    for (std::size_t i = group.begin; i < group.end; ++i) {
      const int bin = bin_of(entries[i], axis);
      join(boxes[bin], entries[i].box);
      ++counts[bin];
    }
    std::array<double, kBins> cost_above{};
    FloatBox box = kEmpty;
    int count = 0;
    for (int bin = kBins - 1; bin > 0; --bin) {
      join(box, boxes[bin]);
      count += counts[bin];
      cost_above[bin] = area(box) * count;
    }
    box = kEmpty;
    count = 0;
    for (int bin = 0; bin + 1 < kBins; ++bin) {
      join(box, boxes[bin]);
      count += counts[bin];
      const double cost = area(box) * count + cost_above[bin + 1];
      if (count > 0 && count < static_cast<int>(group.size()) && cost < best_cost) {
        best_cost = cost;
        best_axis = axis;
        best_bin = bin;
      }
    }
  }
  if (best_axis < 0) return halved(entries, group, longest);
  const auto first = entries.begin() + static_cast<std::ptrdiff_t>(group.begin);
  const auto last = entries.begin() + static_cast<std::ptrdiff_t>(group.end);
  const auto middle = std::partition(first, last, [&](const WideTree::Entry& entry) {
    return bin_of(entry, best_axis) <= best_bin;
  });
  return static_cast<std::size_t>(middle - entries.begin());
}

/// Up to eight runs: the largest is cut until there are eight or each fits into one node.
std::vector<Group> groups_of(Entries& entries, std::size_t begin, std::size_t end, bool by_number) {
  std::vector<Group> groups = {group_of(entries, begin, end)};
  while (groups.size() < kWidth) {
    Group* largest = nullptr;
    for (Group& group : groups) {
      if (group.size() > kWidth && (largest == nullptr || group.area > largest->area)) {
        largest = &group;
      }
    }
    if (largest == nullptr) break;
    const Group whole = *largest;
    const std::size_t middle = split(entries, whole, by_number);
    *largest = group_of(entries, whole.begin, middle);
    groups.push_back(group_of(entries, middle, whole.end));
  }
  return groups;
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
  Entries entries;
  for (std::size_t i = 0; i < items.size(); ++i) {
    entries.push_back({to_float(items[i]), static_cast<int>(i)});
    note_farthest(entries.back().box);
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

void WideTree::note_farthest(const FloatBox& box) {
  for (int axis = 0; axis < 3; ++axis) {
    farthest_ = std::max({farthest_, static_cast<double>(std::fabs(box.lower[axis])),
                          static_cast<double>(std::fabs(box.upper[axis]))});
  }
}

void WideTree::build(Entries entries) {
  nodes_.clear();
  parents_.clear();
  free_nodes_.clear();
  changes_ = 0;
  depth_ = 0;
  size_ = static_cast<int>(entries.size());
  add_node({});
  if (!entries.empty()) fill_node(0, entries, 0, entries.size(), 1);
}

void WideTree::fill_node(int node, Entries& entries, std::size_t begin, std::size_t end,
                         int depth) {
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
  for (const Group& group : groups_of(entries, begin, end, depth > kHeuristicDepth)) {
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
  for (int slot = 0; slot < kWidth; ++slot) set_slot(index, slot, kEmpty, 0, 0);
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
      set_slot(up.node, up.slot, kEmpty, 0, 0);
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
  note_farthest(box);
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
      break;
    }
    node = here.child[cheapest];
  }
  changed();
}

void WideTree::remove(int item) {
  const Place place = places_[item];
  assert(place.node >= 0 && nodes_[place.node].child[place.slot] == ~item);
  set_slot(place.node, place.slot, kEmpty, 0, 0);
  places_[item] = {};
  --size_;
  refresh_above(place.node);
  changed();
}

void WideTree::changed() {
  ++changes_;
  if (depth_ < kMaxDepth && changes_ <= std::max(kFreeChanges, size_ / 2)) return;
  Entries entries;
  for (std::size_t item = 0; item < places_.size(); ++item) {
    const Place place = places_[item];
    if (place.node < 0) continue;
    entries.push_back({slot_box(nodes_[place.node], place.slot), static_cast<int>(item)});
  }
  build(std::move(entries));
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
