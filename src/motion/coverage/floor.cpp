#include "src/motion/coverage/floor.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

std::string called(const char* kind, const std::string& name, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", kind, index + 1) : fmt::format("{} '{}'", kind, name);
}

bool is_placeable(const Place& place) {
  return std::isfinite(place.x) && std::isfinite(place.y) && std::abs(place.x) <= kReach &&
         std::abs(place.y) <= kReach;
}

std::string told(const Place& place) { return fmt::format("({}, {})", place.x, place.y); }

/// The corners of a ring that differ from the one before, and which of the given ones they are.
struct NumberedRing {
  Ring ring;
  std::vector<std::size_t> numbers;
};

NumberedRing numbered(const std::vector<Place>& corners) {
  NumberedRing result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point p = snap(corners[i]);
    if (!result.ring.empty() && result.ring.back() == p) continue;
    result.ring.push_back(p);
    result.numbers.push_back(i + 1);
  }
  while (result.ring.size() > 1 && result.ring.back() == result.ring.front()) {
    result.ring.pop_back();
    result.numbers.pop_back();
  }
  return result;
}

/// Counter-clockwise, without corners on the line of their neighbours.
Ring tidied(Ring ring) {
  if (twice_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& before = result.empty() ? corner_before(ring, i) : result.back();
    if (cross(before, ring[i], next_corner(ring, i)) != 0) result.push_back(ring[i]);
  }
  return result;
}

Buckets buckets_of_edges(const Ring& ring) {
  Buckets buckets(box_of(ring), ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    buckets.add(static_cast<int>(i), ring[i], next_corner(ring, i));
  }
  return buckets;
}

/// Two edges of a ring that meet and should not.
std::optional<std::pair<std::size_t, std::size_t>> self_meeting(const Ring& ring) {
  const Buckets buckets = buckets_of_edges(ring);
  const std::size_t count = ring.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point& a = ring[i];
    const Point& b = next_corner(ring, i);
    std::size_t met = count;
    buckets.any_near(a, b, [&](int item) {
      const auto j = static_cast<std::size_t>(item);
      if (j <= i || j >= met) return false;
      const Point& c = ring[j];
      const Point& d = next_corner(ring, j);
      const bool follows = j == i + 1;
      const bool leads = i == 0 && j == count - 1;
      if (follows || leads) {
        // Neighbours share a corner; more only where one folds back on the other.
        const Point& shared = follows ? b : a;
        const Point& first = follows ? a : b;
        const Point& second = follows ? d : c;
        if (cross(first, shared, second) != 0 || dot(shared, first, second) < 0) return false;
      } else if (!segments_meet(a, b, c, d)) {
        return false;
      }
      met = j;
      return false;
    });
    if (met < count) return std::pair(i, met);
  }
  return std::nullopt;
}

/// Whether edges of two rings meet.
bool rings_meet(const Buckets& edges, const Ring& ring, const Ring& other) {
  for (std::size_t k = 0; k < other.size(); ++k) {
    const Point& a = other[k];
    const Point& b = next_corner(other, k);
    if (edges.any_near(a, b, [&](int item) {
          return segments_meet(a, b, ring[at(item)], next_corner(ring, at(item)));
        })) {
      return true;
    }
  }
  return false;
}

/// Whether two rings have a point in common, inside or on them.
bool rings_overlap(const Ring& a, const Ring& b) {
  if (!box_of(a).meets(box_of(b))) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (segments_meet(a[i], next_corner(a, i), b[j], next_corner(b, j))) return true;
    }
  }
  return place_in(a, b[0]) > 0 || place_in(b, a[0]) > 0;
}

class FloorCheck {
 public:
  FloorCheck(const FloorDescription& floor, const CoverageOptions& options)
      : floor_(floor), options_(options) {}

  std::vector<std::string> run() {
    check_options();
    const std::optional<Ring> outline = check_ring("the outline", floor_.outline);
    std::vector<std::optional<Ring>> shafts;
    for (std::size_t i = 0; i < floor_.shafts.size(); ++i) {
      shafts.push_back(check_ring(shaft_name(i), floor_.shafts[i].corners));
    }
    for (std::size_t i = 0; i < floor_.columns.size(); ++i) check_column_size(i);
    check_beams();
    if (!outline || !faults_.empty()) return std::move(faults_);
    outline_ = *outline;
    for (const auto& shaft : shafts) shafts_.push_back(*shaft);
    check_shafts();
    check_columns();
    check_place("the start", options_.from, true);
    check_place("the inlet", options_.inlet, false);
    return std::move(faults_);
  }

 private:
  std::string shaft_name(std::size_t i) const { return called("shaft", floor_.shafts[i].name, i); }
  std::string column_name(std::size_t i) const {
    return called("column", floor_.columns[i].name, i);
  }
  template <typename... Values>
  void fault(fmt::format_string<Values...> text, Values&&... values) {
    faults_.push_back(fmt::format(text, std::forward<Values>(values)...));
  }

  void check_options() {
    if (!(options_.width >= 0.001 && options_.width <= kReach)) {
      fault("the width of the tool is {} m; it must be 1 mm or more", options_.width);
    }
    if (!(options_.clearance >= 0 && options_.clearance <= kReach)) {
      fault("the clearance is {} m; it must be 0 or more", options_.clearance);
    }
  }

  std::optional<Ring> check_ring(const std::string& name, const std::vector<Place>& corners) {
    if (corners.size() < 3) {
      fault("{} has {} corners; a polygon has 3 or more", name, corners.size());
      return std::nullopt;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (is_placeable(corners[i])) continue;
      fault("corner {} of {} is {}; places are numbers within {} m of the origin", i + 1, name,
            told(corners[i]), kReach);
      return std::nullopt;
    }
    const NumberedRing ring = numbered(corners);
    if (ring.ring.size() < 3) {
      fault("{} has {} corners that are 0.1 mm apart; a polygon has 3 or more", name,
            ring.ring.size());
      return std::nullopt;
    }
    if (const auto meeting = self_meeting(ring.ring)) {
      const auto number = [&](std::size_t i) { return ring.numbers[i % ring.numbers.size()]; };
      const auto [i, j] = *meeting;
      fault("{} crosses itself: its edge from corner {} to {} meets that from corner {} to {}",
            name, number(i), number(i + 1), number(j), number(j + 1));
      return std::nullopt;
    }
    return tidied(ring.ring);
  }

  void check_column_size(std::size_t i) {
    const ColumnDescription& column = floor_.columns[i];
    if (!is_placeable(column.centre)) {
      fault("{} stands at {}; places are numbers within {} m of the origin", column_name(i),
            told(column.centre), kReach);
    } else if (!(column.size >= 0.001 && column.size <= kReach)) {
      fault("{} has a size of {} m; it must be 1 mm or more", column_name(i), column.size);
    }
  }

  void check_beams() {
    for (std::size_t i = 0; i < floor_.beams.size(); ++i) {
      const BeamDescription& beam = floor_.beams[i];
      const std::string name = called("beam", beam.name, i);
      if (!is_placeable(beam.from) || !is_placeable(beam.to)) {
        fault("{} runs from {} to {}; places are numbers within {} m of the origin", name,
              told(beam.from), told(beam.to), kReach);
        continue;
      }
      const Point from = snap(beam.from);
      const Point to = snap(beam.to);
      if (from == to) {
        fault("{} has no length", name);
      } else if (options_.partition == Partition::kBeams && from.x != to.x && from.y != to.y) {
        fault("{} is parallel to neither x nor y: a floor cannot be parted along it", name);
      }
    }
  }

  void check_shafts() {
    const Buckets edges = buckets_of_edges(outline_);
    for (std::size_t i = 0; i < shafts_.size(); ++i) {
      const Ring& shaft = shafts_[i];
      if (rings_meet(edges, outline_, shaft)) {
        fault("{} touches or crosses the outline", shaft_name(i));
      } else if (place_in(outline_, shaft[0]) < 0) {
        fault("{} lies outside the outline", shaft_name(i));
      }
    }
    if (shafts_.empty()) return;
    Buckets boxes(box_of(outline_), shafts_.size());
    for (std::size_t i = 0; i < shafts_.size(); ++i) {
      const Box box = box_of(shafts_[i]);
      std::vector<std::size_t> met;
      boxes.any_in(box, [&](int item) {
        if (rings_overlap(shafts_[at(item)], shafts_[i])) met.push_back(at(item));
        return false;
      });
      if (!met.empty()) {
        fault("{} and {} touch or overlap", shaft_name(*std::min_element(met.begin(), met.end())),
              shaft_name(i));
      }
      boxes.add(static_cast<int>(i), box);
    }
  }

  Box column_box(std::size_t i) const {
    const ColumnDescription& column = floor_.columns[i];
    const double half = column.size / 2;
    return {snap({column.centre.x - half, column.centre.y - half}),
            snap({column.centre.x + half, column.centre.y + half})};
  }

  /// Whether the inside of a column meets an edge.
  bool enters_column(std::size_t i, const Point& a, const Point& b) const {
    const Box box = column_box(i);
    if (!enters_convex(box.ring(), a, b)) return false;
    if (!floor_.columns[i].round) return true;
    const Point centre{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
    const double radius = static_cast<double>(box.width()) / 2 - 1;  // a unit for the rounding
    const double length = distance(a, b);
    const double along = static_cast<double>(dot(a, b, centre)) / length;
    const double off = std::abs(static_cast<double>(cross(a, b, centre))) / length;
    if (along <= 0) return distance(a, centre) < radius;
    if (along >= length) return distance(b, centre) < radius;
    return off < radius;
  }

  void check_columns() {
    const Buckets edges = buckets_of_edges(outline_);
    Buckets boxes(box_of(outline_), floor_.columns.size() + 1);
    Buckets shaft_boxes(box_of(outline_), shafts_.size() + 1);
    for (std::size_t i = 0; i < shafts_.size(); ++i) {
      shaft_boxes.add(static_cast<int>(i), box_of(shafts_[i]));
    }
    for (std::size_t i = 0; i < floor_.columns.size(); ++i) {
      const Box box = column_box(i);
      const Point centre{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
      const bool crosses = edges.any_in(box, [&](int item) {
        return enters_column(i, outline_[at(item)], next_corner(outline_, at(item)));
      });
      if (crosses || place_in(outline_, centre) < 0) {
        fault("{} at {} does not stand wholly inside the outline", column_name(i),
              told(floor_.columns[i].centre));
        continue;
      }
      std::size_t shaft = shafts_.size();
      shaft_boxes.any_in(box, [&](int item) {
        if (at(item) < shaft && column_meets_shaft(i, centre, shafts_[at(item)])) shaft = at(item);
        return false;
      });
      if (shaft < shafts_.size()) {
        fault("{} at {} stands in {}", column_name(i), told(floor_.columns[i].centre),
              shaft_name(shaft));
      }
      std::size_t other = i;
      boxes.any_in(box, [&](int item) {
        if (column_box(at(item)).overlaps(box)) other = std::min(other, at(item));
        return false;
      });
      if (other < i) fault("{} and {} overlap", column_name(other), column_name(i));
      boxes.add(static_cast<int>(i), box);
    }
  }

  bool column_meets_shaft(std::size_t i, const Point& centre, const Ring& shaft) const {
    if (place_in(shaft, centre) > 0) return true;
    for (std::size_t k = 0; k < shaft.size(); ++k) {
      if (enters_column(i, shaft[k], next_corner(shaft, k))) return true;
    }
    return false;
  }

  void check_place(const char* what, const std::optional<Place>& place, bool with_clearance) {
    if (!place) return;
    if (!is_placeable(*place)) {
      fault("{} is {}; places are numbers within {} m of the origin", what, told(*place), kReach);
      return;
    }
    const Point p = snap(*place);
    if (with_clearance && place_in(outline_, p) < 0) {
      fault("{} {} lies outside the outline", what, told(*place));
    }
    const std::int64_t grown = with_clearance ? in_units(options_.clearance) : 0;
    const Box around{{p.x - grown, p.y - grown}, {p.x + grown, p.y + grown}};
    for (std::size_t i = 0; i < shafts_.size(); ++i) {
      if (place_in(shafts_[i], p) > 0) {
        fault("{} {} lies in {}", what, told(*place), shaft_name(i));
      } else if (with_clearance && is_near(shafts_[i], around)) {
        fault("{} {} lies within the clearance of {}", what, told(*place), shaft_name(i));
      }
    }
    for (std::size_t i = 0; i < floor_.columns.size(); ++i) {
      const Box box = column_box(i);
      if (box.overlaps({p, p})) {
        fault("{} {} lies in {}", what, told(*place), column_name(i));
      } else if (with_clearance && box.overlaps(around)) {
        fault("{} {} lies within the clearance of {}", what, told(*place), column_name(i));
      }
    }
  }

  static bool is_near(const Ring& ring, const Box& around) {
    if (around.width() == 0) return false;
    const Ring square = around.ring();
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (enters_convex(square, ring[k], next_corner(ring, k))) return true;
    }
    return false;
  }

  const FloorDescription& floor_;
  const CoverageOptions& options_;
  Ring outline_;
  std::vector<Ring> shafts_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults_of(const FloorDescription& floor, const CoverageOptions& options) {
  return FloorCheck(floor, options).run();
}

std::int64_t Floor::twice_area_of_slab() const {
  std::int64_t area = twice_area(outline);
  for (const Hole& hole : holes) {
    if (hole.is_shaft) area -= twice_area(hole.ring);
  }
  return area;
}

bool is_sound(const Floor& floor) {
  const auto is_simple = [](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (cross(corner_before(ring, i), ring[i], next_corner(ring, i)) == 0) return false;
    }
    return twice_area(ring) > 0 && !self_meeting(ring);
  };
  if (!is_simple(floor.outline)) return false;
  const Buckets edges = buckets_of_edges(floor.outline);
  std::vector<Ring> shafts;
  for (const Hole& hole : floor.holes) {
    if (!hole.is_shaft) continue;
    if (!is_simple(hole.ring) || rings_meet(edges, floor.outline, hole.ring)) return false;
    for (const Ring& other : shafts) {
      if (rings_overlap(other, hole.ring)) return false;
    }
    shafts.push_back(hole.ring);
  }
  return true;
}

Floor make_floor(const FloorDescription& description, const CoverageOptions& options) {
  const std::vector<std::string> faults = faults_of(description, options);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  Floor floor;
  floor.outline = tidied(numbered(description.outline).ring);
  for (std::size_t i = 0; i < description.shafts.size(); ++i) {
    floor.holes.push_back(
        {tidied(numbered(description.shafts[i].corners).ring), true, false, static_cast<int>(i)});
  }
  for (std::size_t i = 0; i < description.columns.size(); ++i) {
    const ColumnDescription& column = description.columns[i];
    const double half = column.size / 2;
    const Box box{snap({column.centre.x - half, column.centre.y - half}),
                  snap({column.centre.x + half, column.centre.y + half})};
    floor.holes.push_back({box.ring(), false, column.round, static_cast<int>(i)});
  }
  for (std::size_t i = 0; i < description.beams.size(); ++i) {
    floor.beams.push_back(
        {snap(description.beams[i].from), snap(description.beams[i].to), static_cast<int>(i)});
  }
  return floor;
}

}  // namespace rubicon::coverage
