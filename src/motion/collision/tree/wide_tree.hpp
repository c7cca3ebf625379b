#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "src/motion/collision/base/bounds.hpp"
#include "src/motion/collision/tree/tree_groups.hpp"
#include "src/motion/collision/tree/wide_node.hpp"

namespace rubicon::collision {

/// The points p with |axis.p - middle| <= half (m); axis is a unit vector.
struct Slab {
  Vec3 axis = Vec3::UnitZ();
  double middle = 0;
  double half = 0;
};

/// Numbers on the stack, on the heap only where there are many.
class ItemList {
 public:
  ItemList() = default;
  ItemList(const ItemList&) = delete;
  ItemList& operator=(const ItemList&) = delete;

  int* begin() { return data_; }
  int* end() { return data_ + size_; }
  const int* begin() const { return data_; }
  const int* end() const { return data_ + size_; }
  int size() const { return size_; }
  int capacity() const { return capacity_; }
  void set_size(int size) { size_ = size; }
  /// Forgets the contents and makes room for more.
  void grow();

 private:
  static constexpr int kInline = 64;
  int inline_[kInline];
  std::vector<int> heap_;
  int* data_ = inline_;
  int capacity_ = kInline;
  int size_ = 0;
};

/// A bounding volume hierarchy with eight children a node, over items numbered by the caller
/// (small numbers: they index a table). Boxes are kept in single precision, rounded outwards,
/// relative to an origin near the first item, so that a site far from the world's origin loses
/// nothing. Built by the surface area heuristic with bins (Wald 2007); items put in later go where
/// they enlarge the boxes least, and after many changes it is built anew: a change costs O(log n)
/// amortised. Its shape depends on its history, what it finds does not.
class WideTree {
 public:
  WideTree() = default;
  /// The items 0, 1, 2, ... at once.
  explicit WideTree(const std::vector<Bounds>& items);

  /// The item must not be in the tree.
  void insert(int item, const Bounds& bounds);
  /// The item must be in the tree.
  void remove(int item);
  /// Gives the item, which must be in the tree, another box; it stays where it is in the tree if
  /// that is not much larger with its former one.
  void replace(int item, const Bounds& bounds);
  int size() const { return size_; }

  /// Replaces `found` by the items whose boxes meet `bounds`, in no particular order; maybe some
  /// that miss it by rounding, never fewer.
  void collect(const Bounds& bounds, ItemList& found) const;

  /// A box around all items; it may be larger where some were removed. Empty without items.
  const Bounds& around() const { return around_; }

  /// The same as the first, but without those that lie beside one of the slabs; the region asked
  /// for is within `bounds` and between all slabs.
  void collect(const Bounds& bounds, std::span<const Slab> slabs, ItemList& found) const;

  /// A lower bound of the distance (m) between `bounds` and the nearest item's box; `range` or a
  /// little less if none is nearer than that.
  double distance(const Bounds& bounds, double range) const;

 private:
  struct Place {
    std::int32_t node = -1;
    std::int32_t slot = 0;
  };

  void set_origin(const Bounds& first);
  FloatBox to_float(const Bounds& bounds) const;
  void note_extent(const FloatBox& box);
  void build(std::vector<TreeEntry> entries);
  void fill_node(int node, std::vector<TreeEntry>& entries, std::size_t begin, std::size_t end,
                 int depth);
  int add_node(Place parent);
  void set_slot(int node, int slot, const FloatBox& box, int child, int count);
  void note_place(int item, Place place);
  void refresh_above(int node);
  static int cheapest_slot(const WideNode& node, const FloatBox& box);
  void changed();
  void rebuild_part_around(int node, int depth);
  std::vector<TreeEntry> take_items(int node);

  std::vector<WideNode> nodes_;
  std::vector<Place> parents_;  ///< of nodes; the root has none
  std::vector<int> free_nodes_;
  std::vector<Place> places_;  ///< of items
  Vec3 origin_ = Vec3::Zero();
  Bounds around_;
  double farthest_ = 0;  ///< m, greatest distance of a coordinate from the origin's
  int size_ = 0;
  int changes_ = 0;  ///< since the last build
  int depth_ = 0;    ///< levels of what was built last, or reached since by an insertion
};

}  // namespace rubicon::collision
