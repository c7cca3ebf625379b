#include "src/earth/soil/blocks.hpp"

namespace rubicon::soil {

std::vector<Block> blocks_between(const Terrain& under, const Terrain& above) {
  std::vector<Block> blocks;
  std::vector<bool> taken(above.heights.size(), false);
  above.heights.for_each_difference(under.heights, [&](std::size_t first) {
    const auto column = static_cast<int>(first % static_cast<std::size_t>(above.columns));
    const auto row = static_cast<int>(first / static_cast<std::size_t>(above.columns));
    Block block{column, column, row, row, under.heights[first], above.heights[first]};
    if (taken[first] || block.top <= block.bottom) return;
    const auto fits = [&](int c, int r) {
      const std::size_t at = above.index(c, r);
      return !taken[at] && under.heights[at] == block.bottom && above.heights[at] == block.top;
    };
    while (block.end_column < above.columns && fits(block.end_column, row)) ++block.end_column;
    const auto row_fits = [&](int r) {
      for (int c = block.first_column; c < block.end_column; ++c) {
        if (!fits(c, r)) return false;
      }
      return true;
    };
    while (block.end_row < above.rows && row_fits(block.end_row)) ++block.end_row;
    for (int r = block.first_row; r < block.end_row; ++r) {
      for (int c = block.first_column; c < block.end_column; ++c) taken[above.index(c, r)] = true;
    }
    blocks.push_back(block);
  });
  return blocks;
}

}  // namespace rubicon::soil
