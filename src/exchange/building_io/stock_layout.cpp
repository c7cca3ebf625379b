#include "src/exchange/building_io/stock_layout.hpp"

#include <algorithm>

#include "src/exchange/building_io/element_frame.hpp"

namespace rubicon::building_io {

namespace {

bool is_flat(const Vec3& size) { return size.z() <= size.y() / 2; }

/// The free part of an area: rows run along its shorter side, things point along its longer one.
class AreaFiller {
 public:
  explicit AreaFiller(const StockArea& area)
      : area_(area),
        along_(area.box.upper.x() - area.box.lower.x() >= area.box.upper.y() - area.box.lower.y()
                   ? 0
                   : 1),
        row_begin_(area.box.lower[along_]),
        next_(area.box.lower[1 - along_]) {}

  const StockArea& area() const { return area_; }

  /// Room for a footprint; nothing if there is none left. Its middle, on the floor.
  std::optional<StockPlace> take(double length, double width) {
    const double end = area_.box.upper[1 - along_];
    if (next_ + width > end && next_ > area_.box.lower[1 - along_]) {
      row_begin_ += row_length_ + area_.gap;
      row_length_ = 0;
      next_ = area_.box.lower[1 - along_];
    }
    if (next_ + width > end || row_begin_ + length > area_.box.upper[along_]) return std::nullopt;
    StockPlace place;
    place.origin[along_] = row_begin_ + length / 2;
    place.origin[1 - along_] = next_ + width / 2;
    place.origin.z() = area_.box.lower.z();
    place.turn_deg = along_ == 0 ? 0 : 90;
    next_ += width + area_.gap;
    row_length_ = std::max(row_length_, length);
    return place;
  }

 private:
  const StockArea& area_;
  int along_;
  double row_begin_;
  double row_length_ = 0;
  double next_;
};

/// Heights are sums of rounded numbers (m).
constexpr double kHeightRounding = 1e-6;

bool is_low_enough(double height, const StockArea& area) {
  return height <= area.box.upper.z() - area.box.lower.z() + kHeightRounding;
}

/// How many of the items from `first` on go onto one pile.
std::size_t pile_size(const std::vector<StockItem>& items, std::size_t first,
                      const StockArea& area) {
  if (!is_flat(items[first].size)) return 1;
  std::size_t count = 1;
  double height = items[first].size.z();
  while (first + count < items.size() && count < static_cast<std::size_t>(area.stack)) {
    const StockItem& item = items[first + count];
    height += kBearer + item.size.z();
    const bool fits = item.group == items[first].group && item.stock == items[first].stock &&
                      is_flat(item.size) && is_low_enough(height, area);
    if (!fits) break;
    ++count;
  }
  return count;
}

}  // namespace

std::vector<std::optional<StockPlace>> lay_out(const std::vector<StockItem>& items,
                                               const std::vector<StockArea>& areas) {
  std::vector<AreaFiller> fillers(areas.begin(), areas.end());
  std::vector<std::optional<StockPlace>> places(items.size());
  for (std::size_t first = 0; first < items.size();) {
    std::size_t done = 1;
    for (AreaFiller& filler : fillers) {
      if (!items[first].stock.empty() && items[first].stock != filler.area().name) continue;
      if (!is_low_enough(items[first].size.z(), filler.area())) continue;
      const std::size_t count = pile_size(items, first, filler.area());
      double length = 0;
      double width = 0;
      for (std::size_t i = first; i < first + count; ++i) {
        length = std::max(length, items[i].size.x());
        width = std::max(width, items[i].size.y());
      }
      std::optional<StockPlace> place = filler.take(length, width);
      if (!place) continue;
      // The last one lies lowest.
      for (std::size_t i = first + count; i-- > first;) {
        places[i] = StockPlace{
            {on_grid(place->origin.x()), on_grid(place->origin.y()), on_grid(place->origin.z())},
            place->turn_deg};
        place->origin.z() += items[i].size.z() + kBearer;
      }
      done = count;
      break;
    }
    first += done;
  }
  return places;
}

}  // namespace rubicon::building_io
