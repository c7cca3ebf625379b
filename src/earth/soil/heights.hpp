#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace rubicon::soil {

using Millimetres = std::int64_t;

/// The heights of the cells of a terrain, in tiles that copies share until one of them is written:
/// a site has one terrain for each pit, and these differ in few cells. Copies may be used on
/// several threads, one object only while nobody writes it.
class Heights {
 public:
  Heights() = default;
  Heights(std::size_t count, Millimetres height);
  explicit Heights(const std::vector<Millimetres>& heights);

  std::size_t size() const { return count_; }
  Millimetres operator[](std::size_t cell) const { return (*tiles_[cell / kTile])[cell % kTile]; }
  void set(std::size_t cell, Millimetres height);
  /// Of some cells at least.
  Millimetres highest() const;
  Millimetres lowest() const;
  /// The first cell from `from` on that has another height there; `size()` if none has. Both of one
  /// size.
  std::size_t next_difference(const Heights& other, std::size_t from) const;
  /// Calls `visit(cell)` for all cells that have another height there, ascending.
  template <typename Visit>
  void for_each_difference(const Heights& other, const Visit& visit) const {
    for (std::size_t cell = next_difference(other, 0); cell < count_;
         cell = next_difference(other, cell + 1)) {
      visit(cell);
    }
  }

 private:
  static constexpr std::size_t kTile = 512;
  using Tile = std::vector<Millimetres>;

  std::size_t count_ = 0;
  std::vector<std::shared_ptr<Tile>> tiles_;  // shared: by terrains that are equal there
};

}  // namespace rubicon::soil
