#include "src/motion/collision/tree/tree_groups.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "src/motion/collision/tree/float_box.hpp"

namespace rubicon::collision {
namespace {

using Entries = std::vector<TreeEntry>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kBins = 16;

TreeGroup group_of(const Entries& entries, std::size_t begin, std::size_t end) {
  FloatBox box = kEmptyBox;
  for (std::size_t i = begin; i < end; ++i) join(box, entries[i].box);
  return {begin, end, area(box)};
}

float twice_centre(const FloatBox& box, int axis) { return box.lower[axis] + box.upper[axis]; }

/// Half of the entries each, along the axis in which their centres differ most.
std::size_t halved(Entries& entries, const TreeGroup& group, int axis) {
  const std::size_t middle = group.begin + group.size() / 2;
  const auto at = [&](std::size_t i) { return entries.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(group.begin), at(middle), at(group.end),
                   [axis](const TreeEntry& a, const TreeEntry& b) {
                     const float first = twice_centre(a.box, axis);
                     const float second = twice_centre(b.box, axis);
                     return first != second ? first < second : a.item < b.item;
                   });
  return middle;
}

/// Where to cut a group in two: the cheapest of the planes between bins by the surface area
/// heuristic.
std::size_t split(Entries& entries, const TreeGroup& group, bool by_number) {
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
  const auto bin_of = [&](const TreeEntry& entry, int axis) {
    const float share =
        (twice_centre(entry.box, axis) - least[axis]) / (greatest[axis] - least[axis]);
    return std::min(static_cast<int>(share * kBins), kBins - 1);
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (!(greatest[axis] > least[axis])) continue;
    std::array<FloatBox, kBins> boxes;
    boxes.fill(kEmptyBox);
    std::array<int, kBins> counts{};
    for (std::size_t i = group.begin; i < group.end; ++i) {
      const int bin = bin_of(entries[i], axis);
      join(boxes[bin], entries[i].box);
      ++counts[bin];
    }
    std::array<double, kBins> cost_above{};
    FloatBox box = kEmptyBox;
    int count = 0;
    for (int bin = kBins - 1; bin > 0; --bin) {
      join(box, boxes[bin]);
      count += counts[bin];
      cost_above[bin] = area(box) * count;
    }
    box = kEmptyBox;
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
  const auto middle = std::partition(
      first, last, [&](const TreeEntry& entry) { return bin_of(entry, best_axis) <= best_bin; });
  return static_cast<std::size_t>(middle - entries.begin());
}

}  // namespace

std::vector<TreeGroup> tree_groups(Entries& entries, std::size_t begin, std::size_t end,
                                   bool by_number) {
  std::vector<TreeGroup> groups = {group_of(entries, begin, end)};
  while (groups.size() < kWidth) {
    TreeGroup* largest = nullptr;
    for (TreeGroup& group : groups) {
      if (group.size() > kWidth && (largest == nullptr || group.area > largest->area)) {
        largest = &group;
      }
    }
    if (largest == nullptr) break;
    const TreeGroup whole = *largest;
    const std::size_t middle = split(entries, whole, by_number);
    *largest = group_of(entries, whole.begin, middle);
    groups.push_back(group_of(entries, middle, whole.end));
  }
  return groups;
}

}  // namespace rubicon::collision
