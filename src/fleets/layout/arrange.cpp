#include "src/fleets/layout/arrange.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace rubicon::layout {

namespace {

using lanes::NodeIndex;

/// m: places nearer to each other are one.
constexpr double kSamePlace = 1e-6;
/// m: how far a row goes on where a wall is in its way.
constexpr double kRowStep = 0.1;
/// m: a gate that is nearer to a lane lies on it.
constexpr double kOnLane = 1e-3;

/// An aisle or a cross aisle, from side to side.
struct Passage {
  double from = 0;
  double to = 0;
};

/// A lane or both lanes of a shared one, through all the hall; where it is broken is known by
/// asking.
struct Line {
  bool is_cross = false;
  double at = 0;      ///< y of an aisle, x of a cross aisle
  int direction = 0;  ///< +1, -1, 0: both
  struct Stop {
    double place = 0;
    NodeIndex node = lanes::kNone;
  };
  std::vector<Stop> stops;
};

class Arranger {
 public:
  Arranger(const HallSpace& space, const Sizes& sizes, const Choice& choice)
      : space_(space), bounds_(space.bounds()), sizes_(sizes), choice_(choice) {}

  Arrangement run() {
    for (const Gate& gate : space_.hall().gates) add_node(gate.place, 0, false);
    made_.gates = static_cast<int>(made_.nodes.size());
    lay_passages();
    lay_lines();
    lay_crossings();
    join_gates();
    for (Line& line : lines_) {
      if (!line.is_cross) add_stops(line);
    }
    for (const Line& line : lines_) add_lanes(line);
    for (std::size_t i = 0; i < aisles_.size(); ++i) add_rows(aisles_[i], i);
    made_.aisles = static_cast<int>(aisles_.size());
    if (choice_.along_y) turn_back();
    return std::move(made_);
  }

 private:
  double half(bool is_cross) const { return sizes_.width(is_cross) / 2; }
  /// Along a lane, at its nodes: a vehicle fits into the narrower of both.
  double half_along() const { return std::min(half(false), half(true)); }
  double passage(bool is_cross) const {
    return (choice_.ways == Ways::two_lanes ? 2 : 1) * sizes_.width(is_cross);
  }

  NodeIndex add_node(Point place, double heading_deg, bool is_crossing) {
    made_.nodes.push_back({"", place.x, place.y, heading_deg, true});
    made_.is_crossing.push_back(is_crossing);
    return static_cast<NodeIndex>(made_.nodes.size() - 1);
  }

  void lay_passages() {
    const double period = period_of(sizes_, choice_.ways);
    for (int i = 0;; ++i) {
      const double from = bounds_.y0 + choice_.shift + i * period;
      if (from + passage(false) > bounds_.y1 + kSamePlace) break;
      aisles_.push_back({from, from + passage(false)});
    }
    for (const HallSpace::Wall& wall : space_.walls_along_y()) {
      add_cross(wall.inside_is_right ? wall.x : wall.x - passage(true));
    }
    const double width = bounds_.x1 - bounds_.x0;
    for (int i = 1; i <= choice_.cross_aisles; ++i) {
      add_cross(bounds_.x0 + i * width / (choice_.cross_aisles + 1) - passage(true) / 2);
    }
    std::sort(crosses_.begin(), crosses_.end(),
              [](const Passage& a, const Passage& b) { return a.from < b.from; });
  }

  /// Unless one that is there already has some of its place.
  void add_cross(double from) {
    const double to = from + passage(true);
    for (const Passage& each : crosses_) {
      if (from < each.to - kSamePlace && each.from < to - kSamePlace) return;
    }
    if (from < bounds_.x0 - kSamePlace || to > bounds_.x1 + kSamePlace) return;
    crosses_.push_back({from, to});
  }

  /// One way: the first aisle goes to the right, the last back, and the cross aisles at the ends
  /// close the ring; those between go there and back in turn.
  void lay_lines() {
    const auto lay = [&](const std::vector<Passage>& all, bool is_cross) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        const double middle = (all[i].from + all[i].to) / 2;
        const bool goes_back = i + 1 == all.size() || i % 2 == 1;
        if (choice_.ways == Ways::one_way) {
          lines_.push_back({is_cross, middle, goes_back == is_cross ? 1 : -1, {}});
        } else if (choice_.ways == Ways::shared) {
          lines_.push_back({is_cross, middle, 0, {}});
        } else {
          // On the right: below when going to the right, to the right when going up. A hall that is
          // turned is seen in a mirror.
          const int below = is_cross == choice_.along_y ? 1 : -1;
          lines_.push_back({is_cross, middle - half(is_cross), below, {}});
          lines_.push_back({is_cross, middle + half(is_cross), -below, {}});
        }
      }
    };
    lay(aisles_, false);
    lay(crosses_, true);
  }

  static Rectangle about(Point place, double x, double y) {
    return {place.x - x, place.y - y, place.x + x, place.y + y};
  }
  /// What a node on a line needs.
  Rectangle about(const Line& line, double place) const {
    const Point on = place_on(line, place);
    return line.is_cross ? about(on, half(true), half_along())
                         : about(on, half_along(), half(false));
  }
  static Point place_on(const Line& line, double place) {
    return line.is_cross ? Point{line.at, place} : Point{place, line.at};
  }
  static double heading_of(const Line& line) {
    return (line.is_cross ? 90 : 0) + (line.direction < 0 ? 180 : 0);
  }

  void lay_crossings() {
    for (Line& aisle : lines_) {
      if (aisle.is_cross) continue;
      for (Line& cross : lines_) {
        if (!cross.is_cross) continue;
        const Point place{cross.at, aisle.at};
        if (!space_.is_free(about(place, half(true), half(false)))) continue;
        const NodeIndex node = add_node(place, heading_of(aisle), true);
        aisle.stops.push_back({place.x, node});
        cross.stops.push_back({place.y, node});
      }
    }
    for (Line& line : lines_) sort_stops(line);
  }

  static void sort_stops(Line& line) {
    std::sort(line.stops.begin(), line.stops.end(),
              [](const Line::Stop& a, const Line::Stop& b) { return a.place < b.place; });
  }

  /// The stop of a line that is next to a place; of two as near the first.
  static const Line::Stop* nearest(const Line& line, double place) {
    const Line::Stop* best = nullptr;
    for (const Line::Stop& each : line.stops) {
      if (best == nullptr ||
          std::abs(each.place - place) < std::abs(best->place - place) - kSamePlace) {
        best = &each;
      }
    }
    return best;
  }

  /// Whether a stop is nearer to a place than the spacing; exactly so far away it is not.
  bool is_beside(const Line::Stop& stop, double place) const {
    return std::abs(stop.place - place) < sizes_.spacing - kSamePlace;
  }

  /// How a gate may be joined to a line: where, and the corridor that must be free.
  struct Landing {
    double place = 0;  ///< on the line
    NodeIndex node = lanes::kNone;
    Rectangle corridor;
    double distance = 0;
  };

  std::optional<Landing> landing(const Line& line, Point gate) const {
    Landing found;
    found.place = line.is_cross ? gate.y : gate.x;
    if (const Line::Stop* const stop = nearest(line, found.place)) {
      if (is_beside(*stop, found.place)) {
        found.place = stop->place;
        found.node = stop->node;
      }
    }
    const Point on = place_on(line, found.place);
    if (!space_.is_free(about(line, found.place))) return std::nullopt;
    // A gate may be in the wall or outside: its line crosses the outline once at most.
    const Point last{gate.x + (on.x - gate.x) * 1e-6, gate.y + (on.y - gate.y) * 1e-6};
    if (space_.crossings(on, last) > 1) return std::nullopt;
    found.corridor = {std::min(on.x, gate.x), std::min(on.y, gate.y), std::max(on.x, gate.x),
                      std::max(on.y, gate.y)};
    // As wide as a lane, across the line.
    (line.is_cross ? found.corridor.y0 : found.corridor.x0) -= half(true);
    (line.is_cross ? found.corridor.y1 : found.corridor.x1) += half(true);
    if (space_.is_obstructed(found.corridor)) return std::nullopt;
    const double x = on.x - gate.x;
    const double y = on.y - gate.y;
    found.distance = std::sqrt(x * x + y * y);
    return found;
  }

  void join_gates() {
    for (std::size_t i = 0; i < space_.hall().gates.size(); ++i) {
      const Point gate = space_.hall().gates[i].place;
      std::optional<Landing> best;
      Line* on = nullptr;
      for (Line& line : lines_) {
        const auto found = landing(line, gate);
        if (!found || (best && found->distance >= best->distance - kSamePlace)) continue;
        best = found;
        on = &line;
      }
      if (!best) {
        made_.gates_joined = false;
        continue;
      }
      const auto node = static_cast<NodeIndex>(i);
      corridors_.push_back(best->corridor);
      if (best->distance < kOnLane && best->node == lanes::kNone) {
        on->stops.push_back({best->place, node});
        sort_stops(*on);
        continue;
      }
      if (best->node == lanes::kNone) {
        best->node = add_node(place_on(*on, best->place), heading_of(*on), true);
        on->stops.push_back({best->place, best->node});
        sort_stops(*on);
      }
      add_lane(node, best->node, 1);
      add_lane(best->node, node, 1);
      if (choice_.ways == Ways::two_lanes) join_beside(*on, *best);
    }
  }

  /// From a gate both lanes of a passage are reached: the lane beside has a node there too.
  void join_beside(const Line& line, const Landing& landing) {
    const auto index = static_cast<std::size_t>(&line - lines_.data());
    Line& beside = lines_[index ^ 1U];
    const Line::Stop* const stop = nearest(beside, landing.place);
    NodeIndex node = lanes::kNone;
    if (stop != nullptr && std::abs(stop->place - landing.place) < kOnLane) {
      node = stop->node;
    } else if (stop == nullptr || !is_beside(*stop, landing.place)) {
      const Point place = place_on(beside, landing.place);
      if (!space_.is_free(about(beside, landing.place))) return;
      node = add_node(place, heading_of(beside), true);
      beside.stops.push_back({landing.place, node});
      sort_stops(beside);
    } else {
      return;  // no room for a node
    }
    const Point a = place_on(line, landing.place);
    const Point b = place_on(beside, landing.place);
    // As wide as there is room between the two.
    for (const int lane_class : {1, 0}) {
      Rectangle box{std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
      (line.is_cross ? box.y0 : box.x0) -= half(lane_class == 1);
      (line.is_cross ? box.y1 : box.x1) += half(lane_class == 1);
      if (space_.is_obstructed(box)) continue;
      add_lane(landing.node, node, lane_class);
      add_lane(node, landing.node, lane_class);
      return;
    }
  }

  /// Unless it is there: between the lanes of a passage another may lie across.
  void add_lane(NodeIndex from, NodeIndex to, int lane_class) {
    if (!laid_.insert({from, to}).second) return;
    made_.lanes.push_back({from, to, lane_class, std::nullopt, lanes::kNone});
  }

  /// Evenly between the nodes that are there, as many as the spacing allows; behind the last ones
  /// up to the wall.
  void add_stops(Line& line) {
    std::vector<double> places;
    if (line.stops.empty()) return;
    for (std::size_t i = 0; i + 1 < line.stops.size(); ++i) {
      const double from = line.stops[i].place;
      const double gap = line.stops[i + 1].place - from;
      const int parts = static_cast<int>(gap / sizes_.spacing + kSamePlace);
      for (int k = 1; k < parts; ++k) places.push_back(from + k * gap / parts);
    }
    for (double at = line.stops.back().place + sizes_.spacing;
         at + half_along() <= bounds_.x1 + kSamePlace; at += sizes_.spacing) {
      places.push_back(at);
    }
    for (double at = line.stops.front().place - sizes_.spacing;
         at - half_along() >= bounds_.x0 - kSamePlace; at -= sizes_.spacing) {
      places.push_back(at);
    }
    for (const double place : places) {
      const Point on = place_on(line, place);
      if (!space_.is_free(about(line, place))) continue;
      line.stops.push_back({place, add_node(on, heading_of(line), false)});
    }
    sort_stops(line);
  }

  void add_lanes(const Line& line) {
    for (std::size_t i = 0; i + 1 < line.stops.size(); ++i) {
      const Line::Stop& a = line.stops[i];
      const Line::Stop& b = line.stops[i + 1];
      Rectangle box = about(line, a.place);
      (line.is_cross ? box.y1 : box.x1) = b.place + half_along();
      if (!space_.is_free(box)) continue;
      const int lane_class = line.is_cross ? 1 : 0;
      if (line.direction >= 0) add_lane(a.node, b.node, lane_class);
      if (line.direction <= 0) add_lane(b.node, a.node, lane_class);
    }
  }

  /// The rows on both sides of an aisle. Each is served from the lane that is next to it.
  void add_rows(const Passage& aisle, std::size_t index) {
    const std::size_t lanes_each = choice_.ways == Ways::two_lanes ? 2 : 1;
    const Line& below = lines_[index * lanes_each];
    const Line& above = lines_[index * lanes_each + lanes_each - 1];
    add_row(below, aisle.from - sizes_.depth, aisle.from);
    add_row(above, aisle.to, aisle.to + sizes_.depth);
  }

  void add_row(const Line& line, double y0, double y1) {
    if (line.stops.empty()) return;
    double x = bounds_.x0;
    while (x + sizes_.length <= bounds_.x1 + kSamePlace) {
      const Rectangle box{x, y0, x + sizes_.length, y1};
      if (const auto behind = in_the_way(box)) {
        x = std::max(x + kSamePlace, *behind);
        continue;
      }
      const Line::Stop* const stop = nearest(line, x + sizes_.length / 2);
      if (is_beside(*stop, x + sizes_.length / 2)) {
        made_.modules.push_back({box, stop->node});
      }
      x += sizes_.length;
    }
  }

  /// Where a row goes on if something is in the way of a module.
  std::optional<double> in_the_way(const Rectangle& box) const {
    const auto meets = [&](const Rectangle& other) {
      return box.x0 < other.x1 - kSamePlace && other.x0 < box.x1 - kSamePlace &&
             box.y0 < other.y1 - kSamePlace && other.y0 < box.y1 - kSamePlace;
    };
    for (const Passage& cross : crosses_) {
      if (meets({cross.from, box.y0, cross.to, box.y1})) return cross.to;
    }
    for (const Rectangle& corridor : corridors_) {
      if (meets(corridor)) return corridor.x1;
    }
    const Meeting meeting = space_.meeting(box);
    if (meeting.what == Meets::obstacle) return meeting.box.x1;
    if (meeting.what == Meets::outline) return box.x0 + kRowStep;
    return std::nullopt;
  }

  void turn_back() {
    for (lanes::Node& node : made_.nodes) {
      std::swap(node.x, node.y);
      node.heading_deg = std::fmod(450 - node.heading_deg, 360);
    }
    for (Module& module : made_.modules) {
      std::swap(module.box.x0, module.box.y0);
      std::swap(module.box.x1, module.box.y1);
    }
  }

  const HallSpace& space_;
  Rectangle bounds_;
  Sizes sizes_;
  Choice choice_;
  std::vector<Passage> aisles_;
  std::vector<Passage> crosses_;
  std::vector<Line> lines_;  ///< those of aisles first
  std::vector<Rectangle> corridors_;
  std::set<std::pair<NodeIndex, NodeIndex>> laid_;
  Arrangement made_;
};

}  // namespace

std::string_view name_of(Ways ways) {
  switch (ways) {
    case Ways::one_way:
      return "one way";
    case Ways::shared:
      return "shared";
    case Ways::two_lanes:
      return "two lanes";
  }
  return "";
}

double period_of(const Sizes& sizes, Ways ways) {
  return 2 * sizes.depth + (ways == Ways::two_lanes ? 2 : 1) * sizes.lane;
}

Arrangement arrange(const HallSpace& space, const Sizes& sizes, const Choice& choice) {
  return Arranger(space, sizes, choice).run();
}

}  // namespace rubicon::layout
