#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_obstacles.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "src/motion/coverage/coverage.hpp"
#include "src/motion/coverage/holes.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

constexpr double kMostWidth = 100;       // m
constexpr double kMostThickness = 10;    // m
constexpr double kMostRate = 1e6;        // m3 per h
constexpr double kMostTurnRadius = 100;  // m
constexpr double kMostDepth = 100;       // m
constexpr double kMostFeed = 10;         // m/s
constexpr double kSecondsPerHour = 3600;
/// m; the thinnest coat of paint.
constexpr double kLeastThickness = 1e-5;
/// Clauses that holes have, and those of strips; all others are of both.
constexpr const char* kOfHoles[] = {"depth", "feed"};
constexpr const char* kOfStrips[] = {"width", "thickness",   "rate",  "partition", "order", "lines",
                                     "inlet", "turn_radius", "guide", "cold_joint"};
/// Waypoints of one task.
constexpr std::size_t kMostPoints = 20'000;

std::optional<double> length(Subject& subject, const syntax::Number& number,
                             const std::string& what, double least, double most) {
  return bounded(subject, number, syntax::UnitKind::length, what, least, most);
}

std::optional<coverage::Place> place_of(Subject& subject, const syntax::FloorPlace& place,
                                        const std::string& what) {
  const auto x = length(subject, place.x, "x of " + what, -kMaxLength, kMaxLength);
  const auto y = length(subject, place.y, "y of " + what, -kMaxLength, kMaxLength);
  if (!x || !y) return std::nullopt;
  return coverage::Place{*x, *y};
}

class AreaCheck {
 public:
  AreaCheck(Subject& subject, const syntax::AreaItem& item)
      : subject_(subject), item_(item), who_("area '" + item.name.text + "'") {}

  /// Nothing after an error.
  std::optional<AreaSpec> run() {
    const int errors = subject_.diagnostics.errors();
    area_.name = item_.name.text;
    area_.span = item_.name.span;
    if (item_.height.size() > 1) {
      subject_.twice(item_.height[1].span, "the height of " + who_ + " is given twice",
                     item_.height[0].span);
    }
    if (!item_.height.empty()) {
      const auto height =
          length(subject_, item_.height.front(), "the height of " + who_, -kMaxLength, kMaxLength);
      if (height) area_.X_WA.translation() = math::Vec3(0, 0, *height);
    }
    take_frame();
    for (const syntax::AreaItem::Part& each : item_.parts) add(each);
    if (outline_ == nullptr) {
      subject_.error("P53", item_.name.span, who_ + " has no outline",
                     "outline (0, 0), (8, 0), (8, 5), (0, 5);");
    }
    if (subject_.diagnostics.errors() != errors) return std::nullopt;
    // What the floor is by itself; the tool comes with the task.
    coverage::CoverageOptions narrow;
    narrow.width = 1e-3;
    for (const std::string& each : faults_of(area_.floor, narrow)) {
      subject_.error("P53", item_.name.span, who_ + ": " + each);
    }
    if (subject_.diagnostics.errors() != errors) return std::nullopt;
    return std::move(area_);
  }

 private:
  void take_frame() {
    if (item_.at.empty()) return;
    if (item_.at.size() > 1) {
      subject_.twice(item_.at[1].span, "the frame of " + who_ + " is given twice",
                     item_.at[0].span);
    }
    if (!item_.height.empty()) {
      subject_.error("P53", item_.at.front().span, who_ + " has a frame and a height as well",
                     "at trans(0, 0, 3); is all of it");
    }
    area_.X_WA = resolve_frame_or_identity(subject_, item_.at.front());
  }

  void add(const syntax::AreaItem::Part& part) {
    const std::string& key = part.key.text;
    if (key == "obstacles") {
      if (obstacles_ != nullptr) {
        subject_.twice(part.span, "obstacles of " + who_ + " are given twice", obstacles_->span);
      }
      obstacles_ = &part;
      return;
    }
    std::vector<coverage::Place> places;
    for (const syntax::FloorPlace& each : part.places) {
      const auto place = place_of(subject_, each, "the " + key + " of " + who_);
      if (!place) return;
      places.push_back(*place);
    }
    if (key == "outline") {
      if (outline_ != nullptr) {
        subject_.twice(part.span, "the outline of " + who_ + " is given twice", outline_->span);
        return;
      }
      outline_ = &part;
      area_.floor.outline = std::move(places);
    } else if (key == "shaft") {
      area_.floor.shafts.push_back({"", std::move(places)});
    } else if (key == "beam") {
      if (places.size() != 2) {
        subject_.error("P53", part.span,
                       fmt::format("a beam goes from one place to another, found {} place{}",
                                   places.size(), places.size() == 1 ? "" : "s"));
        return;
      }
      area_.floor.beams.push_back({"", places[0], places[1]});
    } else {
      const auto size =
          length(subject_, *part.size, "the size of a column of " + who_, 1e-3, kMaxLength);
      if (size) area_.floor.columns.push_back({"", places[0], *size, key == "round_column"});
    }
  }

  Subject& subject_;
  const syntax::AreaItem& item_;
  const std::string who_;
  const syntax::AreaItem::Part* outline_ = nullptr;
  const syntax::AreaItem::Part* obstacles_ = nullptr;
  AreaSpec area_;
};

/// What the clauses of a `cover` say.
class CoverCheck {
 public:
  CoverCheck(Subject& subject, const syntax::CoverItem& item) : subject_(subject), item_(item) {}

  /// Over `floor` instead of that of the area, if it is given.
  std::optional<CoverWay> run(const coverage::FloorDescription* floor = nullptr) {
    const int errors = subject_.diagnostics.errors();
    const AreaSpec* const area = find_area();
    for (const syntax::CoverItem::Clause& each : item_.clauses) take(each);
    check_kind();
    if (given_.count("holes") == 0 && given_.count("width") == 0) {
      wrong(item_.area.span, "cover does not say how wide the tool works", "width 1 m;");
    }
    if (rate_ > 0 && !rate_is_area_ && given_.count("thickness") == 0) {
      wrong(given_["rate"], "a rate needs the thickness of what is laid",
            "thickness 0.25 m; or a rate in m2 per h");
    }
    if (options_.turn_radius > 0 && given_.count("guide") != 0) {
      wrong(given_["guide"], "with a turn_radius the way between strips is one of arcs: no guide");
    }
    if (options_.turn_radius > 0 && options_.whole_cells) {
      wrong(given_["order"],
            "with a turn_radius lines follow each other as turns allow: no order by cells",
            "order shortest;");
    }
    if (area == nullptr || subject_.diagnostics.errors() != errors) return std::nullopt;
    if (floor == nullptr) floor = &area->floor;
    for (const std::string& each : faults_of(*floor, options_)) wrong(item_.area.span, each);
    if (subject_.diagnostics.errors() != errors) return std::nullopt;
    if (given_.count("holes") != 0) return holes_over(*area, *floor);
    try {
      return way_over(*area, *floor, plan_coverage(*floor, options_));
    } catch (const std::invalid_argument& error) {
      wrong(item_.area.span, error.what());
      return std::nullopt;
    }
  }

 private:
  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P54", span, std::move(message), std::move(hint));
  }

  /// Clauses of strips where holes are drilled, and of holes where none are.
  void check_kind() {
    const bool drills = given_.count("holes") != 0;
    if (drills) {
      for (const char* key : kOfStrips) {
        if (given_.count(key) == 0) continue;
        wrong(given_[key], fmt::format("a pattern of holes has no strips: {} says nothing", key));
      }
      if (given_.count("depth") == 0) {
        wrong(item_.area.span, "holes do not say how deep they are", "depth 80 mm;");
      }
      return;
    }
    for (const char* key : kOfHoles) {
      if (given_.count(key) == 0) continue;
      wrong(given_[key], fmt::format("{} is of holes, and this cover drills none", key),
            "holes 0.6 m, 0.4 m;");
    }
  }

  const AreaSpec* find_area() {
    area_ = subject_.find(subject_.areas, item_.area, "area");
    return area_ < 0 ? nullptr : &subject_.model.areas[static_cast<std::size_t>(area_)];
  }

  void take(const syntax::CoverItem::Clause& clause) {
    const std::string& key = clause.key.text;
    const auto [first, is_new] = given_.emplace(key, clause.key.span);
    if (!is_new) {
      subject_.twice(clause.key.span, key + " is given twice", first->second);
      return;
    }
    if (key == "cold_joint") {
      take_cold_joint(*clause.number);
    } else if (key == "guide") {
      return;  // who knows the robot resolves it
    } else if (key == "holes") {
      take_holes(clause);
    } else if (clause.number) {
      take_number(key, *clause.number);
    } else if (clause.place) {
      const auto place = place_of(subject_, *clause.place, key);
      (key == "from" ? options_.from : options_.inlet) = place;
    } else if (key == "partition") {
      take_partition(*clause.word);
    } else if (key == "lines") {
      take_lines(*clause.word);
    } else {
      take_order(*clause.word);
    }
  }

  void take_number(const std::string& key, const syntax::Number& number) {
    if (key == "rate") {
      take_rate(number);
      return;
    }
    if (key == "feed") {
      take_feed(number);
      return;
    }
    const bool is_width = key == "width";
    const double most = key == "thickness"     ? kMostThickness
                        : key == "depth"       ? kMostDepth
                        : key == "turn_radius" ? kMostTurnRadius
                                               : kMostWidth;
    const double least = key == "thickness"           ? kLeastThickness
                         : is_width || key == "depth" ? 1e-3
                                                      : 0;
    const auto value = length(subject_, number, key, least, most);
    if (!value) return;
    if (is_width) options_.width = *value;
    if (key == "clearance") options_.clearance = *value;
    if (key == "above") above_ = *value;
    if (key == "thickness") thickness_ = *value;
    if (key == "turn_radius") options_.turn_radius = *value;
    if (key == "depth") depth_ = *value;
  }

  void take_cold_joint(const syntax::Number& number) {
    const auto seconds = resolve_duration(subject_, number, "the age of a cold joint");
    if (!seconds) return;
    cold_after_ = schedule::ticks_from_seconds(*seconds);
    if (cold_after_ > 0) return;
    wrong(number.span, "a joint is cold after some time, found 0", "cold_joint after 90 min;");
  }

  void take_rate(const syntax::Number& number) {
    rate_is_area_ = number.dimension == syntax::Dimension{2, 0, -1, 0};
    const bool is_rate = rate_is_area_ || number.dimension == syntax::Dimension{3, 0, -1, 0};
    const double rate = number.value * kSecondsPerHour;
    if (!is_rate || !(rate > 0 && rate <= kMostRate)) {
      wrong(number.span,
            fmt::format("expected a volume per time up to {:.0f} m3 per h, or an area per time up "
                        "to {:.0f} m2 per h, as rate",
                        kMostRate, kMostRate),
            "rate 40 m3 per h;");
      return;
    }
    rate_ = number.value;
  }

  void take_feed(const syntax::Number& number) {
    const bool is_speed = number.dimension == syntax::Dimension{1, 0, -1, 0};
    if (!is_speed || !(number.value > 0 && number.value <= kMostFeed)) {
      wrong(number.span, fmt::format("expected a speed up to {:g} m/s as feed", kMostFeed),
            "feed 120 mm per min;");
      return;
    }
    feed_ = number.value;
  }

  void take_holes(const syntax::CoverItem::Clause& clause) {
    const auto x = length(subject_, *clause.number, "the distance of holes", 1e-3, kMostWidth);
    const auto y = length(subject_, *clause.second, "the distance of holes", 1e-3, kMostWidth);
    if (x) apart_.x = *x;
    if (y) apart_.y = *y;
  }

  void take_lines(const syntax::Name& word) {
    using coverage::LineRule;
    const std::pair<const char*, LineRule> rules[] = {{"shortest", LineRule::kShortest},
                                                      {"fewest", LineRule::kFewestTurns},
                                                      {"x", LineRule::kAlongX},
                                                      {"y", LineRule::kAlongY}};
    for (const auto& [name, rule] : rules) {
      if (word.text != name) continue;
      options_.lines = rule;
      return;
    }
    wrong(word.span, fmt::format("lines is shortest, fewest, x or y, found '{}'", word.text),
          "x: they run along x of the area");
  }

  void take_partition(const syntax::Name& word) {
    if (word.text == "beams" || word.text == "min") {
      options_.partition =
          word.text == "beams" ? coverage::Partition::kBeams : coverage::Partition::kMinimum;
      return;
    }
    wrong(word.span, fmt::format("partition is beams or min, found '{}'", word.text));
  }

  void take_order(const syntax::Name& word) {
    if (word.text == "cells" || word.text == "shortest") {
      options_.whole_cells = word.text == "cells";
      return;
    }
    wrong(word.span, fmt::format("order is shortest or cells, found '{}'", word.text),
          "cells: each is finished before the next is begun");
  }

  void warn_of_left_out(int lines) {
    subject_.diagnostics.warning(
        "P54", item_.area.span,
        fmt::format("{} strip{} left out: with turns of {:g} m there is no room to come to {} and "
                    "away again",
                    lines, lines == 1 ? " is" : "s are", options_.turn_radius,
                    lines == 1 ? "it" : "them"),
        "a smaller turn_radius, or what is left out as an area of its own");
  }

  std::string no_room() const {
    return options_.turn_radius > 0
               ? fmt::format(
                     "with turns of {:g} m the machine has no room to work anywhere on the "
                     "area",
                     options_.turn_radius)
               : "the tool has no room to work anywhere on the area";
  }

  std::optional<CoverWay> way_over(const AreaSpec& area, const coverage::FloorDescription& floor,
                                   const coverage::CoverageWay& found) {
    if (found.points.size() < 2 || found.points.size() > kMostPoints) {
      wrong(item_.area.span, found.points.size() < 2
                                 ? no_room()
                                 : fmt::format("the way has {} points; a task has up to {}",
                                               found.points.size(), kMostPoints));
      return std::nullopt;
    }
    CoverWay way;
    const coverage::Measures measures = measure(floor, options_, found.points);
    note_way(way.cover, floor, found, measures);
    way.cover.width = options_.width;
    way.cover.thickness = thickness_;
    way.cover.covered = measures.coverage;
    way.cover.covered_area = measures.coverage * measures.reachable_area;
    way.cover.volume = way.cover.covered_area * thickness_;
    way.cover.length = found.arcs ? found.arcs->length : measures.length;
    way.cover.turns = found.arcs ? found.arcs->turns : measures.turns;
    if (found.arcs && found.cut_off > 0) warn_of_left_out(found.cut_off);
    const double pace = !(rate_ > 0)    ? 0
                        : rate_is_area_ ? rate_ / options_.width
                                        : rate_ / (options_.width * thickness_);
    way.cover.pace = pace;
    way.cover.turn_radius = options_.turn_radius;
    way.cover.cold_after = cold_after_;
    const std::size_t count = found.points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const coverage::WayPoint& point = found.points[i];
      // A guide finds its own way from strip to strip.
      const bool is_corner =
          i > 0 && i + 1 < count && !point.working && !found.points[i + 1].working;
      if (is_corner && given_.count("guide") != 0) continue;
      // A machine that turns with a radius stands as its way runs.
      math::Pose X_AG = math::Pose::Identity();
      if (found.arcs) X_AG = math::rotation_z_deg(point.heading_deg);
      X_AG.translation() = math::Vec3(point.place.x, point.place.y, above_);
      // What leads to the first point is no work yet.
      add_goal(way, area.X_WA * X_AG, i > 0 && point.working ? pace : -1);
    }
    return way;
  }

  /// Where the tool goes next; `pace` is negative where it travels.
  void add_goal(CoverWay& way, const math::Pose& X_WG, double pace) const {
    GoalSpec goal;
    goal.span = item_.area.span;
    goal.X_WG = X_WG;
    const bool works = pace >= 0;
    goal.work = works ? GoalSpec::Work::working : GoalSpec::Work::travelling;
    if (works) goal.pace = pace;
    way.goals.push_back(std::move(goal));
  }

  void note_way(CoverSpec& cover, const coverage::FloorDescription& floor,
                const coverage::CoverageWay& found, const coverage::Measures& measures) const {
    cover.area = area_;
    cover.clearance = options_.clearance;
    cover.above = above_;
    cover.floor = std::make_shared<const coverage::FloorDescription>(floor);
    cover.way = std::make_shared<const coverage::CoverageWay>(found);
    cover.measures = measures;
  }

  /// Over each hole, in to its depth, out again, and on to the next.
  std::optional<CoverWay> holes_over(const AreaSpec& area,
                                     const coverage::FloorDescription& floor) {
    const coverage::HolePattern pattern = coverage::plan_holes(floor, options_, apart_);
    const std::size_t points = pattern.way.size() + 2 * static_cast<std::size_t>(pattern.holes);
    if (pattern.holes == 0 || points > kMostPoints) {
      const bool many = pattern.left_out > coverage::kMostHoles;
      wrong(item_.area.span,
            many ? fmt::format("the grid of holes has {} places; a task has up to {}",
                               pattern.left_out, coverage::kMostHoles)
            : pattern.holes == 0
                ? std::string("there is no room for a hole on the area")
                : fmt::format("the way has {} points; a task has up to {}", points, kMostPoints));
      return std::nullopt;
    }
    CoverWay way;
    coverage::CoverageWay drawn;
    coverage::Measures measures;
    const auto go = [&](const coverage::Place& place, double z, double pace) {
      math::Pose X_AG = math::Pose::Identity();
      X_AG.translation() = math::Vec3(place.x, place.y, z);
      add_goal(way, area.X_WA * X_AG, pace);
    };
    for (std::size_t i = 0; i < pattern.way.size(); ++i) {
      const coverage::Place& place = pattern.way[i].place;
      if (i > 0) {
        const coverage::Place& before = pattern.way[i - 1].place;
        const double x = place.x - before.x;
        const double y = place.y - before.y;
        measures.length += std::sqrt(x * x + y * y);
      }
      go(place, above_, -1);
      drawn.points.push_back({place, 0, false});
      if (!pattern.way[i].is_hole) continue;
      go(place, -depth_, feed_);
      go(place, above_, -1);
      drawn.lines.push_back({0, false, {place, place}});
    }
    note_way(way.cover, floor, drawn, measures);
    way.cover.holes = pattern.holes;
    way.cover.holes_left_out = pattern.left_out;
    way.cover.depth = depth_;
    way.cover.pace = feed_;
    way.cover.width = 0;
    way.cover.length = measures.length;
    way.cover.covered = static_cast<double>(pattern.holes) / (pattern.holes + pattern.left_out);
    return way;
  }

  Subject& subject_;
  const syntax::CoverItem& item_;
  int area_ = -1;
  coverage::CoverageOptions options_;
  double above_ = 0;
  double thickness_ = 0;
  double rate_ = 0;  // m3/s, or m2/s
  bool rate_is_area_ = false;
  coverage::Place apart_{1, 1};  // m, of holes
  double depth_ = 0;
  double feed_ = 0;  // m/s; 0: as fast as the machine goes
  schedule::Ticks cold_after_ = 0;
  std::map<std::string, Span> given_;
};

}  // namespace

void check_areas(Subject& subject) {
  std::map<std::string, Span> names;
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::AreaItem>(&each);
    if (item == nullptr) continue;
    const auto [first, is_new] = names.emplace(item->name.text, item->name.span);
    if (!is_new) {
      subject.twice(item->name.span, fmt::format("area '{}' is declared twice", item->name.text),
                    first->second);
      continue;
    }
    auto area = AreaCheck(subject, *item).run();
    subject.areas.emplace(item->name.text,
                          area ? static_cast<int>(subject.model.areas.size()) : -1);
    if (area) subject.model.areas.push_back(*std::move(area));
  }
}

std::optional<CoverWay> resolve_cover(Subject& subject, const syntax::CoverItem& item) {
  return CoverCheck(subject, item).run();
}

std::optional<CoverWay> resolve_cover_over(Subject& subject, const syntax::CoverItem& item,
                                           const coverage::FloorDescription& floor) {
  return CoverCheck(subject, item).run(&floor);
}

}  // namespace rubicon::interpreter::plan_check
