#include "src/earth/soil/heights.hpp"

#include <algorithm>

namespace rubicon::soil {

Heights::Heights(std::size_t count, Millimetres height) : count_(count) {
  if (count == 0) return;
  const auto whole = std::make_shared<Tile>(std::min(count, kTile), height);
  tiles_.assign(count / kTile, whole);
  if (count % kTile != 0) tiles_.push_back(std::make_shared<Tile>(count % kTile, height));
}

Heights::Heights(const std::vector<Millimetres>& heights) : Heights(heights.size(), 0) {
  for (std::size_t cell = 0; cell < heights.size(); ++cell) set(cell, heights[cell]);
}

void Heights::set(std::size_t cell, Millimetres height) {
  std::shared_ptr<Tile>& tile = tiles_[cell / kTile];
  if (tile.use_count() > 1) tile = std::make_shared<Tile>(*tile);
  (*tile)[cell % kTile] = height;
}

Millimetres Heights::highest() const {
  Millimetres highest = (*this)[0];
  for (const auto& tile : tiles_) {
    highest = std::max(highest, *std::max_element(tile->begin(), tile->end()));
  }
  return highest;
}

Millimetres Heights::lowest() const {
  Millimetres lowest = (*this)[0];
  for (const auto& tile : tiles_) {
    lowest = std::min(lowest, *std::min_element(tile->begin(), tile->end()));
  }
  return lowest;
}

std::size_t Heights::next_difference(const Heights& other, std::size_t from) const {
  for (std::size_t cell = from; cell < count_;) {
    const std::size_t tile = cell / kTile;
    if (tiles_[tile] == other.tiles_[tile]) {
      cell = (tile + 1) * kTile;
      continue;
    }
    if ((*this)[cell] != other[cell]) return cell;
    ++cell;
  }
  return count_;
}

}  // namespace rubicon::soil
