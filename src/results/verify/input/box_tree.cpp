#include "src/results/verify/input/box_tree.hpp"

#include <algorithm>

namespace rubicon::verify {

BoxTree::BoxTree(const std::vector<Bounds>& boxes) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    entries.emplace_back(boxes[i], static_cast<int>(i));
  if (!entries.empty()) build(entries, 0, entries.size());
}

int BoxTree::build(std::vector<Entry>& entries, std::size_t begin, std::size_t end) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Bounds all;
  Bounds centres;
  for (std::size_t i = begin; i < end; ++i) {
    all.add(entries[i].first);
    centres.add(entries[i].first.centre());
  }
  nodes_[static_cast<std::size_t>(index)].bounds = all;
  if (end - begin == 1) {
    nodes_[static_cast<std::size_t>(index)].item = entries[begin].second;
    return index;
  }
  int axis = 0;
  (centres.upper - centres.lower).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto place = [&](std::size_t i) {
    return entries.begin() + static_cast<std::vector<Entry>::difference_type>(i);
  };
  // Equal centres are told apart by number: the tree is the same on every machine.
  std::nth_element(place(begin), place(middle), place(end), [&](const Entry& a, const Entry& b) {
    const double one = a.first.centre()[axis];
    const double other = b.first.centre()[axis];
    return one != other ? one < other : a.second < b.second;
  });
  const int left = build(entries, begin, middle);
  const int right = build(entries, middle, end);
  nodes_[static_cast<std::size_t>(index)].left = left;
  nodes_[static_cast<std::size_t>(index)].right = right;
  return index;
}

}  // namespace rubicon::verify
