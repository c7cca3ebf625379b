#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "src/exchange/area_io/drawing.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::area_io {

namespace {

// Group codes.
constexpr int kKind = 0, kLayer = 8, kVariable = 9, kX = 10, kY = 20, kEndX = 11, kEndY = 21,
              kRadius = 40, kBulge = 42, kFrom = 50, kTo = 51, kSheet = 67, kFlags = 70,
              kNormal = 230, kComment = 999;

/// A chord of an arc is no farther from it than this share of its radius: 2.5 mm of 10 m.
constexpr double kChordShare = 2.5e-4;

struct Group {
  int code = 0;
  std::string_view value;
  std::size_t line = 0;  ///< of the value
};

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// What a message shows of a value.
std::string shown(std::string_view value) {
  std::string text;
  for (const char c : value.substr(0, 40)) text += c >= ' ' && c < 127 ? c : '?';
  return text;
}

class Failure {
 public:
  DrawingError error;
};

class DxfReader {
 public:
  explicit DxfReader(std::string_view text) : text_(text) {}

  Drawing read() {
    refuse_other_formats();
    while (next()) {
      if (group_.code != kKind) {
        fail("expected 0 and SECTION, found group code " + std::to_string(group_.code));
      }
      if (group_.value == "EOF") return std::move(drawing_);
      if (group_.value != "SECTION") {
        fail(fmt::format("expected SECTION or EOF, found '{}'", shown(group_.value)));
      }
      if (!next() || group_.code != 2) fail("expected 2 and the name of the section");
      read_section(std::string(group_.value));
    }
    fail("the file ends without EOF: it may be cut off");
  }

 private:
  [[noreturn]] void fail(std::string message) const { fail_at(line_, std::move(message)); }
  [[noreturn]] static void fail_at(std::size_t line, std::string message) {
    throw Failure{{line, std::move(message)}};
  }

  void refuse_other_formats() const {
    if (text_.starts_with("AutoCAD Binary DXF")) {
      fail_at(0, "is a binary DXF; save it as ASCII DXF");
    }
    if (text_.size() > 6 && text_.starts_with("AC10")) fail_at(0, "is a DWG; save it as ASCII DXF");
    if (text_.find('\0') != std::string_view::npos) {
      fail_at(0, "holds a zero byte: it is no ASCII DXF");
    }
  }

  std::optional<std::string_view> next_line() {
    if (at_ >= text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1;
    ++line_;
    return trimmed(line);
  }

  /// Reads a pair of lines, a code and its value; false at the end of the text.
  bool next() {
    if (held_) {
      held_ = false;
      return true;
    }
    while (true) {
      const auto code = next_line();
      if (!code || (code->empty() && at_ >= text_.size())) return false;
      int number = 0;
      const auto [end, error] = std::from_chars(code->data(), code->data() + code->size(), number);
      if (error != std::errc() || end != code->data() + code->size()) {
        fail(fmt::format("expected a group code, found '{}'", shown(*code)));
      }
      const auto value = next_line();
      if (!value) fail("the file ends behind a group code: it may be cut off");
      if (number == kComment) continue;
      group_ = {number, *value, line_};
      return true;
    }
  }

  double real() const {
    double value = 0;
    const std::string_view text =
        group_.value.starts_with('+') ? group_.value.substr(1) : group_.value;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
      fail(fmt::format("expected a number, found '{}'", shown(group_.value)));
    }
    return value;
  }
  int whole() const {
    const double value = real();
    if (std::abs(value) > 1e9)
      fail(fmt::format("expected a count, found '{}'", shown(group_.value)));
    return static_cast<int>(value);
  }

  void read_section(const std::string& name) {
    const std::size_t begun = line_;
    if (name == "HEADER") return read_header(begun);
    if (name == "ENTITIES") return read_entities(begun);
    while (next()) {
      if (group_.code == kKind && group_.value == "ENDSEC") return;
    }
    fail_at(begun,
            fmt::format("the section {} does not end: the file may be cut off", shown(name)));
  }

  void read_header(std::size_t begun) {
    bool units = false;
    while (next()) {
      if (group_.code == kKind && group_.value == "ENDSEC") return;
      if (group_.code == kVariable) units = group_.value == "$INSUNITS";
      if (units && group_.code == kFlags) drawing_.units = whole();
    }
    fail_at(begun, "the section HEADER does not end: the file may be cut off");
  }

  void read_entities(std::size_t begun) {
    while (next()) {
      if (group_.code != kKind) {
        fail(fmt::format("expected an entity, found group code {}", group_.code));
      }
      if (group_.value == "ENDSEC") return;
      read_entity(std::string(group_.value));
    }
    fail_at(begun, "the section ENTITIES does not end: the file may be cut off");
  }

  /// What an entity says; of a polyline its corners too.
  struct Entity {
    DrawnLine drawn;
    std::vector<double> x, y;
    std::vector<std::pair<std::size_t, double>> bulges;  ///< of the corner before
    std::optional<double> end_x, end_y;
    double radius = 0, from = 0, to = 360, normal = 1;
    bool sheet = false;
    int flags = 0;
  };

  void take(Entity& entity) {
    switch (group_.code) {
      case kLayer:
        entity.drawn.layer = std::string(group_.value);
        break;
      case kX:
        entity.x.push_back(real());
        break;
      case kY:
        entity.y.push_back(real());
        break;
      case kEndX:
        entity.end_x = real();
        break;
      case kEndY:
        entity.end_y = real();
        break;
      case kRadius:
        entity.radius = real();
        break;
      case kBulge:
        entity.bulges.emplace_back(entity.x.size(), real());
        break;
      case kFrom:
        entity.from = real();
        break;
      case kTo:
        entity.to = real();
        break;
      case kSheet:
        entity.sheet = whole() != 0;
        break;
      case kFlags:
        entity.flags = whole();
        break;
      case kNormal:
        entity.normal = real();
        break;
      default:
        break;
    }
  }

  /// Reads on to the next entity, which then comes again.
  void read_groups(Entity& entity, bool listens) {
    while (next()) {
      if (group_.code == kKind) {
        held_ = true;
        return;
      }
      if (listens || group_.code == kLayer) take(entity);
    }
    fail("the file ends inside an entity: it may be cut off");
  }

  void read_entity(const std::string& kind) {
    Entity entity;
    entity.drawn.line = line_;
    const bool known = kind == "LINE" || kind == "LWPOLYLINE" || kind == "POLYLINE" ||
                       kind == "CIRCLE" || kind == "ARC";
    read_groups(entity, known);
    bool whole_shape = known;
    if (kind == "POLYLINE") whole_shape = read_corners(entity) && whole_shape;
    // Curves lie in a plane of their own, whose x is mirrored where its normal points down.
    const bool upright = std::abs(std::abs(entity.normal) - 1) < 1e-6;
    if (!whole_shape || entity.sheet || (kind != "LINE" && !upright)) {
      const std::string what = !entity.sheet ? kind : kind + " of a sheet";
      ++drawing_.unread[{what, entity.drawn.layer}];
      return;
    }
    const bool mirrored = kind != "LINE" && entity.normal < 0;
    make(kind, entity);
    if (mirrored) {
      for (Place& p : entity.drawn.points) p.x = -p.x;
    }
    points_ += entity.drawn.points.size();
    if (points_ > kMostDrawnPoints) {
      fail_at(entity.drawn.line,
              fmt::format("the drawing has more than {} points", kMostDrawnPoints));
    }
    drawing_.lines.push_back(std::move(entity.drawn));
  }

  /// The VERTEX records of a POLYLINE up to SEQEND; false if it is a mesh.
  bool read_corners(Entity& entity) {
    const std::size_t begun = entity.drawn.line;
    constexpr int kMeshes = 16 + 64;
    const bool mesh = (entity.flags & kMeshes) != 0;
    entity.x.clear();
    entity.y.clear();
    entity.bulges.clear();
    while (next()) {
      Entity corner;
      if (group_.value == "SEQEND") {
        read_groups(corner, false);
        return !mesh;
      }
      if (group_.value != "VERTEX") {
        fail(fmt::format("expected VERTEX or SEQEND of the POLYLINE of line {}, found '{}'", begun,
                         shown(group_.value)));
      }
      read_groups(corner, true);
      constexpr int kControlPoint = 16;
      if (corner.x.empty() || corner.y.empty() || (corner.flags & kControlPoint) != 0) continue;
      entity.x.push_back(corner.x.front());
      entity.y.push_back(corner.y.front());
      for (const auto& bulge : corner.bulges)
        entity.bulges.emplace_back(entity.x.size(), bulge.second);
    }
    fail_at(begun, "the POLYLINE does not end: the file may be cut off");
  }

  void make(const std::string& kind, Entity& entity) {
    const std::size_t line = entity.drawn.line;
    if (entity.x.empty() || entity.x.size() != entity.y.size()) {
      fail_at(line, fmt::format("{} has {} x and {} y", kind, entity.x.size(), entity.y.size()));
    }
    DrawnLine& drawn = entity.drawn;
    if (kind == "LINE") {
      if (!entity.end_x || !entity.end_y) fail_at(line, "LINE has no end");
      drawn.points = {{entity.x[0], entity.y[0]}, {*entity.end_x, *entity.end_y}};
      return;
    }
    if (kind == "CIRCLE" || kind == "ARC") {
      if (!(entity.radius > 0)) fail_at(line, kind + " has no radius");
      const Place middle{entity.x[0], entity.y[0]};
      if (kind == "CIRCLE") {
        drawn.round = drawn.closed = true;
        drawn.diameter = 2 * entity.radius;
        drawn.points = {middle};
        return;
      }
      double turn = std::fmod(entity.to - entity.from, 360.0);
      if (turn <= 0) turn += 360;
      add_arc(middle, entity.radius, entity.from, turn, drawn.points);
      drawn.points.push_back(on_circle(middle, entity.radius, entity.from + turn));
      return;
    }
    drawn.closed = (entity.flags & 1) != 0;
    const std::size_t count = entity.x.size();
    std::vector<double> bulges(count, 0.0);
    for (const auto& [corner, bulge] : entity.bulges) {
      if (corner > 0) bulges[corner - 1] = bulge;
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (points_ + drawn.points.size() > kMostDrawnPoints) {
        fail_at(line, fmt::format("the drawing has more than {} points", kMostDrawnPoints));
      }
      const Place from{entity.x[i], entity.y[i]};
      const bool last = i + 1 == count;
      const std::size_t next = last ? 0 : i + 1;
      if (bulges[i] == 0 || (last && !drawn.closed)) {
        drawn.points.push_back(from);
      } else {
        add_bulge(from, {entity.x[next], entity.y[next]}, bulges[i], drawn.points);
      }
    }
  }

  static Place on_circle(const Place& middle, double radius, double angle_deg) {
    return {middle.x + radius * math::cos_deg(angle_deg),
            middle.y + radius * math::sin_deg(angle_deg)};
  }

  /// The arc from an angle, by `turn` degrees of either sign, without its end.
  static void add_arc(const Place& middle, double radius, double from_deg, double turn_deg,
                      std::vector<Place>& points) {
    // A chord of the angle 2 a is r (1 - cos a) <= r a^2 / 2 from its arc.
    const double step = 2 * math::degrees(std::sqrt(2 * kChordShare));
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(turn_deg) / step)));
    for (int i = 0; i < count; ++i) {
      points.push_back(on_circle(middle, radius, from_deg + turn_deg * i / count));
    }
  }

  /// An arc between two corners; `bulge` is the tangent of a quarter of its angle, positive where
  /// it turns left.
  static void add_bulge(const Place& from, const Place& to, double bulge,
                        std::vector<Place>& points) {
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    const double chord = std::sqrt(x * x + y * y);
    const double off = (1 - bulge * bulge) / (4 * bulge);  // of the middle, left of the chord
    const double radius = chord * (1 + bulge * bulge) / (4 * std::abs(bulge));
    if (!(chord > 0) || !std::isfinite(off) || !std::isfinite(radius)) {
      points.push_back(from);
      return;
    }
    const Place middle{from.x + x / 2 - y * off, from.y + y / 2 + x * off};
    const double begin = math::atan2_deg(from.y - middle.y, from.x - middle.x);
    const std::size_t first = points.size();
    add_arc(middle, radius, begin, 4 * math::atan2_deg(bulge, 1), points);
    points[first] = from;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  Group group_;
  bool held_ = false;  ///< `group_` comes again
  std::size_t points_ = 0;
  Drawing drawing_;
};

struct Unit {
  double metres;
  const char* name;
};

/// By $INSUNITS from 0.
constexpr std::array<Unit, 16> kUnits = {{{0, ""},
                                          {0.0254, "inch"},
                                          {0.3048, "foot"},
                                          {0, ""},
                                          {0.001, "mm"},
                                          {0.01, "cm"},
                                          {1, "m"},
                                          {1000, "km"},
                                          {0, ""},
                                          {0, ""},
                                          {0.9144, "yard"},
                                          {0, ""},
                                          {0, ""},
                                          {0, ""},
                                          {0.1, "dm"},
                                          {10, "dam"}}};

Unit unit_of(int insunits) {
  const bool known = insunits >= 0 && insunits < static_cast<int>(kUnits.size());
  return known ? kUnits[static_cast<std::size_t>(insunits)] : kUnits[0];
}

}  // namespace

std::variant<Drawing, DrawingError> read_dxf(std::string_view text) {
  try {
    return DxfReader(text).read();
  } catch (const Failure& failure) {
    return failure.error;
  }
}

double metres_in(int insunits) { return unit_of(insunits).metres; }
std::string unit_name(int insunits) { return unit_of(insunits).name; }

}  // namespace rubicon::area_io
