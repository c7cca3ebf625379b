#include "src/exchange/area_io/floor_drawing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "src/exchange/area_io/line_work.hpp"
#include "src/exchange/building_io/component_text.hpp"
#include "src/exchange/building_io/glob.hpp"
#include "src/exchange/building_io/names.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::area_io {

namespace {

using building_io::counted;
using building_io::number_text;

/// m: a drawing whose outline begins farther out gets an origin of its own, on the grid.
constexpr double kFarFromOrigin = 1000;
constexpr double kOriginGrid = 100;
/// Open ends that are named one by one.
constexpr std::size_t kNamedEnds = 10;

class DrawingReader {
 public:
  DrawingReader(const Drawing& drawing, const DrawingTerms& terms, std::vector<std::string>& notes,
                interpreter::Diagnostics& diagnostics)
      : drawing_(drawing), terms_(terms), notes_(notes), diagnostics_(diagnostics) {}

  std::vector<ImportedArea> run() {
    if (!find_unit()) return {};
    find_lines();
    if (lines_["outline"].empty()) {
      error(fmt::format("'{}' has no line on a layer '{}'; it has {}", terms_.file,
                        terms_.layers.at("outline"), told_layers()),
            "name the layer: --layer outline=NAME");
      return {};
    }
    find_origin();
    if (diagnostics_.has_errors()) return {};
    coverage::FloorParts parts;
    parts.slabs = coverage::nested(closed("outline"));
    for (const Ring& ring : closed("shafts")) parts.shafts.push_back(shaft_of(ring));
    for (Ring& ring : closed("columns"))
      parts.columns.push_back(coverage::standing_of("", std::move(ring)));
    for (const DrawnLine* circle : circles_["columns"]) {
      coverage::Standing column;
      column.round = true;
      column.centre = in_plan(circle->points.front());
      column.diameter = circle->diameter * unit_;
      parts.columns.push_back(std::move(column));
    }
    parts.beams = beams(parts.slabs);
    tell_rest();
    if (diagnostics_.has_errors()) return {};
    std::vector<std::string> made;
    std::vector<std::size_t> outside;
    std::vector<ImportedArea> areas;
    for (coverage::MadeFloor& each : make_floors(parts, made, outside)) {
      areas.push_back({terms_.height, std::move(each.floor), each.slab});
    }
    for (const std::size_t i : outside) made.push_back(text_of_outside(parts.columns[i]));
    for (const std::string& note : made) warning(note, "");
    if (areas.empty()) {
      error(fmt::format("the lines of '{}' on the layer '{}' enclose no floor", terms_.file,
                        terms_.layers.at("outline")),
            "look whether the unit is right: --unit mm");
    }
    return areas;
  }

 private:
  void error(const std::string& message, const std::string& hint) {
    diagnostics_.error("I19", {}, message, hint);
  }
  void warning(const std::string& message, const std::string& hint) {
    notes_.push_back(message);
    diagnostics_.warning("I19", {}, message, hint);
  }

  bool find_unit() {
    const double declared = metres_in(drawing_.units);
    unit_ = terms_.unit > 0 ? terms_.unit : declared;
    if (!(unit_ > 0)) {
      error(
          fmt::format("'{}' says no unit of length ($INSUNITS is {})", terms_.file, drawing_.units),
          "give --unit mm, cm or m");
      return false;
    }
    if (terms_.unit > 0 && declared > 0 && terms_.unit != declared) {
      warning(fmt::format("the drawing says that it is in {}; taken as told by --unit",
                          unit_name(drawing_.units)),
              "");
    }
    return true;
  }

  void find_lines() {
    for (const DrawnLine& line : drawing_.lines) {
      bool used = false;
      for (const auto& [part, pattern] : terms_.layers) {
        if (!building_io::matches_glob(pattern, line.layer)) continue;
        (line.round && part == "columns" ? circles_ : lines_)[part].push_back(&line);
        used = true;
        break;
      }
      if (!used) ++unused_[line.layer];
    }
  }

  std::string told_layers() const {
    std::set<std::string> layers;
    for (const DrawnLine& line : drawing_.lines) layers.insert(building_io::clean(line.layer));
    if (layers.empty()) return "no lines at all";
    constexpr std::size_t kShown = 12;
    std::vector<std::string> names(layers.begin(), layers.end());
    const std::size_t more = names.size() > kShown ? names.size() - kShown : 0;
    names.resize(names.size() - more);
    return fmt::format("lines on '{}'{}", fmt::join(names, "', '"),
                       more > 0 ? fmt::format(" and {} more layers", more) : "");
  }

  /// Taken off what lies far out, so that all of the floor lies near the origin of the plan.
  void find_origin() {
    const Place first = lines_["outline"].front()->points.front();
    if (std::abs(first.x * unit_) > kFarFromOrigin || std::abs(first.y * unit_) > kFarFromOrigin) {
      origin_ = {std::round(first.x * unit_ / kOriginGrid) * kOriginGrid,
                 std::round(first.y * unit_ / kOriginGrid) * kOriginGrid};
      notes_.push_back(fmt::format("The point {}, {} (m) of the drawing is the origin of this plan",
                                   number_text(origin_.x), number_text(origin_.y)));
    }
    for (const auto* all : {&lines_, &circles_}) {
      for (const auto& [part, lines] : *all) {
        for (const DrawnLine* line : lines) {
          if (!is_near(*line)) return;
        }
      }
    }
  }
  bool is_near(const DrawnLine& line) {
    for (const Place& p : line.points) {
      const Place here = in_plan(p);
      const double size = line.diameter * unit_;
      if (std::abs(here.x) + size < coverage::kReach &&
          std::abs(here.y) + size < coverage::kReach) {
        continue;
      }
      error(fmt::format("'{}': line {}: ({}, {}) is more than {} m from the outline", terms_.file,
                        line.line, p.x, p.y, coverage::kReach - kFarFromOrigin),
            "look whether the unit is right: --unit mm");
      return false;
    }
    return true;
  }

  Place in_plan(const Place& drawn) const {
    return {drawn.x * unit_ - origin_.x, drawn.y * unit_ - origin_.y};
  }
  /// A place as the drawing has it.
  std::string told(const Point& p) const {
    const Place here = coverage::metres(p);
    const auto value = [&](double metres) {
      // To a hundredth of a millimetre, in the unit of the drawing.
      const double places = std::max(1.0, 1e5 * unit_);
      return number_text(std::round(metres / unit_ * places) / places);
    };
    return fmt::format("({}, {})", value(here.x + origin_.x), value(here.y + origin_.y));
  }

  std::vector<DrawnPiece> pieces_of(const std::vector<const DrawnLine*>& lines) const {
    std::vector<DrawnPiece> pieces;
    for (const DrawnLine* line : lines) {
      std::vector<Place> points = line->points;
      if (line->round) points = circle(*line);
      const std::size_t count = points.size();
      for (std::size_t i = 0; i + (line->closed ? 0 : 1) < count; ++i) {
        const Point from = coverage::snap(in_plan(points[i]));
        const Point to = coverage::snap(in_plan(points[i + 1 < count ? i + 1 : 0]));
        if (from != to) pieces.push_back({from, to, line->line});
      }
    }
    return pieces;
  }
  /// A circle as a polygon around it, for an outline or a shaft.
  static std::vector<Place> circle(const DrawnLine& line) {
    constexpr int kCorners = 48;
    const double radius = line.diameter / 2 / math::cos_deg(180.0 / kCorners);
    std::vector<Place> points;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 360.0 * i / kCorners;
      points.push_back({line.points.front().x + radius * math::cos_deg(angle),
                        line.points.front().y + radius * math::sin_deg(angle)});
    }
    return points;
  }

  std::int64_t tolerance() const { return coverage::in_units(terms_.tolerance); }

  std::vector<Ring> closed(const std::string& part) {
    ClosedLines lines = close_lines(pieces_of(lines_[part]), tolerance());
    if (lines.too_tangled) {
      error(fmt::format("the lines of '{}' for {} cross more than {} times", terms_.file, part,
                        kMostCrossings),
            "leave hatches and the like on other layers");
      return {};
    }
    tell_open_ends(part, lines);
    if (lines.closed_gaps > 0) {
      warning(fmt::format("{}: {} of lines moved by up to {} mm to meet", part,
                          counted(static_cast<std::size_t>(lines.closed_gaps), "end"),
                          number_text(terms_.tolerance * 1000)),
              "");
    }
    if (lines.overlaps > 0) {
      warning(fmt::format("{}: {} on others, each counted once", part,
                          counted(static_cast<std::size_t>(lines.overlaps), "piece") +
                              (lines.overlaps == 1 ? " lies" : " lie")),
              "");
    }
    return std::move(lines.rings);
  }

  void tell_open_ends(const std::string& part, const ClosedLines& lines) {
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < lines.open.size(); ++i) {
      const OpenEnd& end = lines.open[i];
      const double gap = coverage::distance(end.at, end.other) / coverage::kUnitsPerMetre;
      if (end.has_other) least = std::min(least, gap);
      if (i >= kNamedEnds) continue;
      std::string text = fmt::format("'{}': line {}: the lines for {} are open at {}", terms_.file,
                                     end.line, part, told(end.at));
      if (end.has_other) {
        text +=
            fmt::format("; the nearest other open end is at {}, {} mm away (line {})",
                        told(end.other), number_text(std::round(gap * 1e4) / 10), end.other_line);
      }
      error(text, i == 0 ? "draw the missing line, or take a larger --tolerance" : "");
    }
    if (lines.open.size() > kNamedEnds) {
      error(fmt::format("'{}': {} more ends of lines for {} are open", terms_.file,
                        lines.open.size() - kNamedEnds, part),
            "");
    }
  }

  static coverage::ShaftDescription shaft_of(const Ring& ring) {
    coverage::ShaftDescription shaft;
    for (const Point& p : ring) shaft.corners.push_back(coverage::metres(p));
    const Place first = shaft.corners.front();
    shaft.name = fmt::format("shaft at ({}, {})", number_text(first.x), number_text(first.y));
    return shaft;
  }

  /// Beams whose ends stop short of the border of the slab, or go past it, by no more than the
  /// tolerance end there; each place once.
  std::vector<coverage::BeamDescription> beams(const std::vector<Region>& slabs) {
    std::vector<coverage::BeamDescription> result;
    std::set<std::pair<Point, Point>> known;
    for (const DrawnPiece& piece : pieces_of(lines_["beams"])) {
      Point from = on_border(piece.from, slabs);
      Point to = on_border(piece.to, slabs);
      // What was drawn along an axis stays so.
      if (piece.from.x == piece.to.x) to.x = from.x = piece.from.x;
      if (piece.from.y == piece.to.y) to.y = from.y = piece.from.y;
      if (from == to || !known.insert({std::min(from, to), std::max(from, to)}).second) continue;
      result.push_back({"", coverage::metres(from), coverage::metres(to)});
    }
    return result;
  }
  Point on_border(const Point& p, const std::vector<Region>& slabs) const {
    for (const Region& slab : slabs) {
      for (std::size_t i = 0; i < slab.outline.size(); ++i) {
        const Point& a = slab.outline[i];
        const Point& b = coverage::next_corner(slab.outline, i);
        const double length = coverage::distance(a, b);
        const double along = static_cast<double>(coverage::dot(a, b, p)) / length;
        const double off = static_cast<double>(coverage::cross(a, b, p)) / length;
        if (std::abs(off) > static_cast<double>(tolerance()) || along < 0 || along > length) {
          continue;
        }
        const auto part = [&](std::int64_t low, std::int64_t high) {
          return low + std::llround(along / length * static_cast<double>(high - low));
        };
        return {part(a.x, b.x), part(a.y, b.y)};
      }
    }
    return p;
  }

  /// What of the drawing is on no layer that counts, or cannot be read.
  void tell_rest() {
    for (const auto& [what, count] : drawing_.unread) {
      const auto& [kind, layer] = what;
      const bool counts = std::any_of(terms_.layers.begin(), terms_.layers.end(),
                                      [&layer = layer](const auto& each) {
                                        return building_io::matches_glob(each.second, layer);
                                      });
      if (!counts) continue;
      warning(fmt::format("{} {} on the layer '{}' not read", count, building_io::clean(kind),
                          building_io::clean(layer)),
              "explode blocks and splines, or draw lines");
    }
    std::size_t lines = 0;
    for (const auto& [layer, count] : unused_) lines += static_cast<std::size_t>(count);
    if (lines > 0) {
      notes_.push_back(
          fmt::format("{} on other layers left out: {}", counted(lines, "line"), told_unused()));
    }
  }
  std::string told_unused() const {
    std::vector<std::string> names;
    for (const auto& [layer, count] : unused_) {
      if (names.size() == 12) break;
      names.push_back("'" + building_io::clean(layer) + "'");
    }
    return fmt::format("{}{}", fmt::join(names, ", "),
                       unused_.size() > names.size() ? ", ..." : "");
  }

  const Drawing& drawing_;
  const DrawingTerms& terms_;
  std::vector<std::string>& notes_;
  interpreter::Diagnostics& diagnostics_;
  double unit_ = 1;
  Place origin_;
  std::map<std::string, std::vector<const DrawnLine*>> lines_, circles_;
  std::map<std::string, int> unused_;
};

}  // namespace

const std::vector<std::string>& parts_of_drawings() {
  static const std::vector<std::string> parts = {"outline", "shafts", "columns", "beams"};
  return parts;
}

std::vector<ImportedArea> floors_of_drawing(const Drawing& drawing, const DrawingTerms& terms,
                                            std::vector<std::string>& notes,
                                            interpreter::Diagnostics& diagnostics) {
  return DrawingReader(drawing, terms, notes, diagnostics).run();
}

}  // namespace rubicon::area_io
