#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "src/results/gantt/charts_page.hpp"
#include "src/results/gantt/svg_style.hpp"
#include "src/results/gantt/svg_text.hpp"

namespace rubicon::gantt {

namespace {

/// More lanes than these are not drawn, more nodes than these have no names.
constexpr std::size_t kMostLanesDrawn = 5000;
constexpr std::int32_t kMostNodesNamed = 120;
constexpr double kTallestMap = 1000;
constexpr double kFlattestMap = 160;
constexpr double kMapTop = 92;
constexpr double kNodeName = 10;
/// How far a lane is drawn from its axis, so that the two directions of a way are told apart.
constexpr double kBesideAxis = 2.5;

struct ClassLook {
  std::string_view colour;
  double width;
};
const std::array<ClassLook, 4> kClassLooks = {
    {{kColours.machine, 4.5}, {kColours.crew, 3}, {kColours.critical, 2}, {kColours.wait, 2}}};

class NetworkPicture {
 public:
  explicit NetworkPicture(const report::ChartsResult& result)
      : result_(result), network_(result.network) {
    for (std::int32_t i = 0; i < network_.node_count(); ++i) {
      const lanes::Node& node = network_.node(i);
      if (i == 0) west_ = east_ = node.x, south_ = north_ = node.y;
      west_ = std::min(west_, node.x);
      east_ = std::max(east_, node.x);
      south_ = std::min(south_, node.y);
      north_ = std::max(north_, node.y);
    }
    const double wide = std::max(east_ - west_, 1e-9), high = std::max(north_ - south_, 1e-9);
    scale_ = std::min((kWidth - 4 * kMargin) / wide, kTallestMap / high);
    height_ = std::max(kFlattestMap, kMapTop + scale_ * (north_ - south_) + 2 * kMargin);
  }

  std::string write() {
    write_classes();
    write_lanes();
    write_nodes();
    write_robots();
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
               "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', "
               "sans-serif\" role=\"img\">\n<title>{2}</title>\n<rect width=\"{0}\" "
               "height=\"{1}\" fill=\"{3}\"/>\n",
               length_text(kWidth), length_text(height_), xml_text(title()), kColours.panel) +
           body_ + "</svg>\n";
  }

 private:
  struct Point {
    double x, y;
  };

  std::string title() const { return fmt::format("Network {}", result_.description.name); }

  Point point(lanes::NodeIndex index) const {
    const lanes::Node& node = network_.node(index);
    return {2 * kMargin + (node.x - west_) * scale_,
            kMapTop + kMargin + (north_ - node.y) * scale_};
  }

  static const ClassLook& look_of(std::int32_t lane_class) {
    return kClassLooks[static_cast<std::size_t>(lane_class) % kClassLooks.size()];
  }

  void word(double x, double y, std::string_view colour, std::string_view words,
            std::string_view more, double size) {
    body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"{}>{}</text>\n",
                         length_text(x), length_text(y), length_text(size), colour, more,
                         xml_text(words));
  }

  void line(Point a, Point b, std::string_view colour, double width, std::string_view told) {
    body_ += fmt::format(
        "<path d=\"M{} {}L{} {}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\">"
        "<title>{}</title></path>\n",
        length_text(a.x), length_text(a.y), length_text(b.x), length_text(b.y), colour,
        length_text(width), xml_text(told));
  }

  void write_classes() {
    word(kMargin, 42, kColours.text, clipped(title(), kWidth - 2 * kMargin, 22),
         " font-weight=\"bold\"", 22);
    double x = kMargin;
    const auto entry = [&](std::string_view colour, double width, const std::string& words) {
      if (x + 40 + text_width(words, 12) > kWidth - kMargin) return;
      line({x, 62}, {x + 22, 62}, colour, width, words);
      word(x + 28, 66, kColours.text, words, "", 12);
      x += 46 + text_width(words, 12);
    };
    for (std::size_t i = 0; i < network_.classes().size(); ++i) {
      const lanes::LaneClass& each = network_.classes()[i];
      const ClassLook& look = look_of(static_cast<std::int32_t>(i));
      entry(look.colour, look.width, fmt::format("{}: {:.4g} m/s", each.name, each.speed));
    }
    for (const charts::CourseStep& step : result_.course.steps) {
      closed_.insert(step.plan.closed.begin(), step.plan.closed.end());
    }
    if (!closed_.empty()) entry(kColours.bad, 6, "closed at times");
    word(kMargin, 86, kColours.muted,
         "a lane lies to the right of the line between its nodes; filled: a robot begins there; "
         "ring: its goal",
         "", 12);
  }

  void write_lanes() {
    const std::size_t count = static_cast<std::size_t>(network_.lane_count());
    for (std::size_t i = 0; i < std::min(count, kMostLanesDrawn); ++i) {
      const auto index = static_cast<lanes::LaneIndex>(i);
      const lanes::Lane& lane = network_.lane(index);
      Point a = point(lane.from), b = point(lane.to);
      const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
      if (length <= 0) continue;
      // To the right of the direction; y grows downwards.
      const double right_x = -dy / length * kBesideAxis, right_y = dx / length * kBesideAxis;
      a = {a.x + right_x, a.y + right_y};
      b = {b.x + right_x, b.y + right_y};
      const ClassLook& look = look_of(lane.lane_class);
      const std::string told = fmt::format("{}, {}, {:.4g} m", network_.name_of(index),
                                           network_.class_of(index).name, network_.length(index));
      if (closed_.count(index) != 0) line(a, b, kColours.bad, 6, told + ", closed at times");
      line(a, b, look.colour, look.width, told);
    }
    if (count > kMostLanesDrawn) {
      word(kWidth - kMargin, 42, kColours.muted,
           fmt::format("and {} more lanes, not drawn", count - kMostLanesDrawn),
           " text-anchor=\"end\"", 12);
    }
  }

  void write_nodes() {
    for (std::int32_t i = 0; i < network_.node_count(); ++i) {
      if (static_cast<std::size_t>(i) >= kMostLanesDrawn) return;
      const Point at = point(i);
      body_ += fmt::format(
          "<circle cx=\"{}\" cy=\"{}\" r=\"2.5\" fill=\"{}\"><title>{}</title>"
          "</circle>\n",
          length_text(at.x), length_text(at.y), kColours.text, xml_text(network_.node(i).name));
      if (network_.node_count() > kMostNodesNamed) continue;
      word(at.x + 5, at.y - 5, kColours.muted, clipped(network_.node(i).name, 120, kNodeName), "",
           kNodeName);
    }
  }

  void write_robots() {
    for (const charts::Robot& robot : result_.spec.robots) {
      for (const bool begins : {true, false}) {
        const Point at = point(begins ? robot.from : robot.goal);
        body_ += fmt::format(
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" stroke=\"{}\" "
            "stroke-width=\"2\"><title>{}</title></circle>\n",
            length_text(at.x), length_text(at.y), begins ? "4.5" : "8",
            begins ? kColours.text : std::string_view("none"), kColours.text,
            xml_text(robot.name + (begins ? " begins here" : ": its goal")));
      }
    }
  }

  const report::ChartsResult& result_;
  const lanes::LaneNetwork& network_;
  std::set<lanes::LaneIndex> closed_;
  double west_ = 0, east_ = 0, south_ = 0, north_ = 0;
  double scale_ = 1;
  double height_ = 0;
  std::string body_;
};

}  // namespace

std::string network_picture(const report::ChartsResult& result) {
  return NetworkPicture(result).write();
}

}  // namespace rubicon::gantt
