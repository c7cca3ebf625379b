#include "src/motion/coverage/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rubicon::coverage {

namespace {

/// Units by which the sides of a square may differ: 1 mm.
constexpr std::int64_t kSquare = 10;
constexpr double kRound = 0.03;
constexpr std::size_t kRoundCorners = 8;
constexpr double kSquareUnits =
    static_cast<double>(kUnitsPerMetre) * static_cast<double>(kUnitsPerMetre);

std::string told(const std::string& name) { return name.empty() ? "-" : "'" + name + "'"; }
std::string counted(std::size_t pieces) {
  return fmt::format("{} piece{}", pieces, pieces == 1 ? "" : "s");
}

double square_metres(std::int64_t twice) { return static_cast<double>(twice) / 2 / kSquareUnits; }

std::vector<Place> places_of(const Ring& ring) {
  std::vector<Place> places;
  for (const Point& p : ring) places.push_back(metres(p));
  return places;
}

bool is_clear_of(const Ring& ring, const Ring& border) {
  const Box box = box_of(ring);
  if (!box.meets(box_of(border))) return true;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t k = 0; k < border.size(); ++k) {
      if (segments_meet(ring[i], next_corner(ring, i), border[k], next_corner(border, k))) {
        return false;
      }
    }
  }
  return true;
}

/// Whether a ring lies in a slab and touches none of its borders.
bool stands_in(const Ring& ring, const Region& slab) {
  if (place_in(slab.outline, ring.front()) <= 0 || !is_clear_of(ring, slab.outline)) {
    return false;
  }
  return std::all_of(slab.holes.begin(), slab.holes.end(), [&](const Ring& hole) {
    return place_in(hole, ring.front()) < 0 && place_in(ring, hole.front()) < 0 &&
           is_clear_of(ring, hole);
  });
}

/// The square parallel to the axes around a round thing, or the thing itself.
Ring ring_of(const Standing& thing) {
  if (!thing.round) return thing.ring;
  const double half = thing.diameter / 2;
  const Box box{snap({thing.centre.x - half, thing.centre.y - half}),
                snap({thing.centre.x + half, thing.centre.y + half})};
  return box.ring();
}

std::optional<ColumnDescription> column_of(const Standing& thing) {
  if (thing.round) return ColumnDescription{thing.name, thing.centre, thing.diameter, true};
  if (thing.ring.size() != 4 || !is_orthogonal(thing.ring)) return std::nullopt;
  const Box box = box_of(thing.ring);
  if (std::abs(box.width() - box.height()) > kSquare) return std::nullopt;
  const std::int64_t side = std::max(box.width(), box.height());
  const Place low = metres(box.low);
  const Place high = metres(box.high);
  return ColumnDescription{
      thing.name, {(low.x + high.x) / 2, (low.y + high.y) / 2}, in_metres(side), false};
}

class FloorMaker {
 public:
  FloorMaker(const FloorParts& parts, std::vector<std::string>& notes,
             std::vector<std::size_t>& outside)
      : parts_(parts), notes_(notes), outside_(outside), slabs_(parts.slabs) {}

  std::vector<MadeFloor> run() {
    cut_shafts();
    sort_columns();
    drop_splinters();
    std::stable_sort(slabs_.begin(), slabs_.end(), [](const Region& a, const Region& b) {
      return twice_area(a) > twice_area(b);
    });
    std::vector<MadeFloor> floors;
    for (const Region& slab : slabs_) floors.push_back(floor_of(slab));
    return floors;
  }

 private:
  void cut_shafts() {
    std::vector<Ring> rings;
    for (const ShaftDescription& shaft : parts_.shafts) {
      Ring ring;
      for (const Place& p : shaft.corners) ring.push_back(snap(p));
      if (!meets_a_slab(ring)) {
        notes_.push_back(fmt::format("{} lies outside of every slab", shaft.name));
        continue;
      }
      rings.push_back(std::move(ring));
    }
    if (!rings.empty()) slabs_ = difference(slabs_, rings);
  }

  bool meets_a_slab(const Ring& ring) const {
    return std::any_of(slabs_.begin(), slabs_.end(), [&](const Region& slab) {
      return place_in(slab.outline, ring.front()) > 0 || place_in(ring, slab.outline.front()) > 0 ||
             !is_clear_of(ring, slab.outline);
    });
  }
  bool stands_clear(const Ring& ring) const {
    return std::any_of(slabs_.begin(), slabs_.end(),
                       [&](const Region& slab) { return stands_in(ring, slab); });
  }

  /// What can be a column, and what must be cut out of the slab.
  void sort_columns() {
    std::vector<Box> boxes;
    for (const Standing& thing : parts_.columns) boxes.push_back(box_of(ring_of(thing)));
    std::vector<Ring> cut;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Standing& thing = parts_.columns[i];
      const Ring ring = ring_of(thing);
      if (!meets_a_slab(ring)) {
        outside_.push_back(i);
        continue;
      }
      const bool alone = std::none_of(boxes.begin(), boxes.end(), [&](const Box& other) {
        return &other != &boxes[i] && other.meets(boxes[i]);
      });
      const auto column = column_of(thing);
      if (column && alone && stands_clear(ring)) {
        columns_.emplace_back(*column, ring);
      } else {
        cut.push_back(ring);
      }
    }
    if (!cut.empty()) slabs_ = difference(slabs_, cut);
    if (!cut.empty()) {
      const bool has_walls =
          std::any_of(parts_.columns.begin(), parts_.columns.end(),
                      [](const Standing& thing) { return thing.kind != "column"; });
      notes_.push_back(
          fmt::format("{} of the {} cut out of the slab: not square along x and y, or at a border",
                      cut.size(), has_walls ? "columns and walls" : "columns"));
    }
  }

  void drop_splinters() {
    const std::size_t before = slabs_.size();
    std::erase_if(slabs_,
                  [](const Region& slab) { return square_metres(twice_area(slab)) < kLeastSlab; });
    if (slabs_.size() != before) {
      notes_.push_back(
          fmt::format("{} left out: below {} m2", counted(before - slabs_.size()), kLeastSlab));
    }
  }

  MadeFloor floor_of(const Region& slab) const {
    MadeFloor made;
    made.slab = square_metres(twice_area(slab));
    made.floor.outline = places_of(slab.outline);
    for (const Ring& hole : slab.holes) made.floor.shafts.push_back({"", places_of(hole)});
    for (const auto& [column, ring] : columns_) {
      if (stands_in(ring, slab)) made.floor.columns.push_back(column);
    }
    for (const BeamDescription& beam : parts_.beams) {
      const Point middle = snap({(beam.from.x + beam.to.x) / 2, (beam.from.y + beam.to.y) / 2});
      if (place_in(slab.outline, middle) >= 0) made.floor.beams.push_back(beam);
    }
    return made;
  }

  const FloorParts& parts_;
  std::vector<std::string>& notes_;
  std::vector<std::size_t>& outside_;
  std::vector<Region> slabs_;
  std::vector<std::pair<ColumnDescription, Ring>> columns_;
};

}  // namespace

Standing standing_of(std::string name, Ring ring) {
  Standing thing;
  thing.name = std::move(name);
  if (ring.size() >= kRoundCorners) {
    // The middle of the box: corners need not be spread evenly.
    const Box box = box_of(ring);
    const Place middle{in_metres(box.low.x + box.high.x) / 2,
                       in_metres(box.low.y + box.high.y) / 2};
    double least = HUGE_VAL;
    double most = 0;
    for (const Point& p : ring) {
      const Place corner = metres(p);
      const double x = corner.x - middle.x;
      const double y = corner.y - middle.y;
      least = std::min(least, std::sqrt(x * x + y * y));
      most = std::max(most, std::sqrt(x * x + y * y));
    }
    if (least >= most * (1 - kRound)) {
      thing.round = true;
      thing.centre = middle;
      // Rounded up to the grid: the column is never smaller than what stands there.
      thing.diameter =
          std::ceil(2 * most * kUnitsPerMetre - 1e-6) / static_cast<double>(kUnitsPerMetre);
    }
  }
  thing.ring = std::move(ring);
  return thing;
}

std::vector<MadeFloor> make_floors(const FloorParts& parts, std::vector<std::string>& notes,
                                   std::vector<std::size_t>& outside) {
  return FloorMaker(parts, notes, outside).run();
}

std::vector<MadeFloor> make_floors(const FloorParts& parts) {
  std::vector<std::string> notes;
  std::vector<std::size_t> outside;
  return make_floors(parts, notes, outside);
}

std::string text_of_outside(const Standing& thing) {
  return fmt::format("{} {} lies outside of every slab", thing.kind, told(thing.name));
}

}  // namespace rubicon::coverage
