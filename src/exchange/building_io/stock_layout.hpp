#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "src/exchange/building_io/element.hpp"
#include "src/exchange/building_io/match_file.hpp"

namespace rubicon::building_io {

/// Height of the bearers between things that lie on each other in a stock (metres).
inline constexpr double kBearer = 0.1;

/// Something that needs a place in the stock.
struct StockItem {
  Vec3 size = Vec3::Zero();  ///< m, as ElementFrame::size
  std::string stock;         ///< name of the area; empty: any
  std::size_t group = 0;     ///< only things of one group lie on each other
};

/// Where it lies: the pose of its frame {O}.
struct StockPlace {
  Vec3 origin = Vec3::Zero();  ///< m
  double turn_deg = 0;
};

/// Places in the order of use: rows across each area, beginning at its lower corner, things side by
/// side with the area's gap between them and their longer sides along the longer side of the area.
/// Flat things (not higher than half their width) of one group lie on each other where the area
/// says so, the one that is used first on top, with bearers of 0.1 m between. Nothing is higher
/// than its area. Areas are filled one after the other. Nothing for things that found no room.
std::vector<std::optional<StockPlace>> lay_out(const std::vector<StockItem>& items,
                                               const std::vector<StockArea>& areas);

}  // namespace rubicon::building_io
