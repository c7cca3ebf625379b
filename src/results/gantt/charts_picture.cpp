#include "src/results/gantt/charts_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "src/results/gantt/svg_style.hpp"
#include "src/results/gantt/svg_text.hpp"
#include "src/results/gantt/time_axis.hpp"

namespace rubicon::gantt {

namespace {

using charts::Leg;
using charts::Nanoseconds;
using charts::NodeIndex;
using charts::Record;
using charts::RecordKind;
using charts::Visit;

constexpr std::size_t kMostRobotsDrawn = 30;
constexpr std::size_t kMostNodesDrawn = 200;
constexpr std::size_t kMostConflictsDrawn = 200;
constexpr std::size_t kMostTold = 40;
constexpr double kNodeRow = 26;
/// Of more rows than this each is lower.
constexpr std::size_t kManyNodes = 36;
constexpr double kLowNodeRow = 16;
constexpr double kClosedRow = 20;
/// Shares of a row: where a robot in a lane is drawn, at its beginning and how much more at its
/// end.
constexpr double kNextToRow = 0.25;
constexpr double kWithinRow = 0.5;
constexpr double kWordSize = 12;
constexpr double kLeastLeft = 70;
constexpr double kMostLeft = 260;
/// Room on the right for the name of a robot.
constexpr double kNameRoom = 110;
/// Up to here the axis counts in seconds.
constexpr Nanoseconds kLongestInSeconds = 3600 * charts::kSecond;
constexpr std::array<Nanoseconds, 12> kSecondSteps = {1,  2,   5,   10,  20,  30,
                                                      60, 120, 300, 600, 900, 1800};
constexpr int kMostSecondMarks = 16;

const std::array<std::string_view, 6> kRobotColours = {kColours.machine, kColours.bad,
                                                       kColours.crew,    kColours.critical,
                                                       kColours.wait,    kColours.muted};

std::size_t nth(std::int32_t i) { return static_cast<std::size_t>(i); }

/// The order of rows: nodes that follow each other on a way lie together where they can.
class NodeRows {
 public:
  void add(const std::vector<NodeIndex>& way) {
    // Before the first node that has a row already stands what leads to it.
    std::size_t first_known = 0;
    while (first_known < way.size() && !has(way[first_known])) ++first_known;
    std::size_t place = first_known < way.size() ? row_of(way[first_known]) : order_.size();
    for (std::size_t i = 0; i < way.size(); ++i) {
      if (has(way[i])) {
        place = row_of(way[i]) + 1;
        continue;
      }
      if (order_.size() >= kMostNodesDrawn) continue;
      order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(place), way[i]);
      ++place;
    }
  }
  bool has(NodeIndex node) const {
    return std::find(order_.begin(), order_.end(), node) != order_.end();
  }
  std::size_t row_of(NodeIndex node) const {
    return static_cast<std::size_t>(std::find(order_.begin(), order_.end(), node) - order_.begin());
  }
  const std::vector<NodeIndex>& order() const { return order_; }

 private:
  std::vector<NodeIndex> order_;
};

class ChartsPicture {
 public:
  explicit ChartsPicture(const report::ChartsResult& result)
      : result_(result), robots_(result.spec.robots) {
    drawn_ = std::min(robots_.size(), kMostRobotsDrawn);
    planned_ = charts_before_yields(result_.course.steps.front().plan);
    for (std::size_t i = 0; i < drawn_; ++i) {
      std::vector<NodeIndex> way;
      for (const Visit& visit : result_.course.journeys[i].visits) {
        if (visit.node != charts::kNone) way.push_back(visit.node);
        end_ = std::max(end_, visit.departure);
      }
      rows_.add(way);
    }
    for (std::size_t i = 0; i < drawn_; ++i) {
      std::vector<NodeIndex> way;
      for (const charts::Stop& stop : planned_[i].stops) {
        way.push_back(stop.node);
        end_ = std::max(end_, stop.arrival);
      }
      rows_.add(way);
    }
    for (const charts::CourseStep& step : result_.course.steps) end_ = std::max(end_, step.time);
    end_ = std::max<Nanoseconds>(end_, charts::kSecond);
    for (const NodeIndex node : rows_.order()) {
      left_ = std::max(left_, text_width(result_.network.node(node).name, kWordSize) + 12);
    }
    left_ = kMargin + std::min(left_, kMostLeft);
    row_height_ = rows_.order().size() > kManyNodes ? kLowNodeRow : kNodeRow;
  }

  std::string write() {
    write_title();
    write_colours();
    top_ = y_ + 34;
    bottom_ = top_ + row_height_ * static_cast<double>(rows_.order().size());
    write_rows();
    write_times();
    write_reports();
    for (std::size_t i = 0; i < drawn_; ++i) write_planned(i);
    for (std::size_t i = 0; i < drawn_; ++i) write_way(i);
    write_conflicts();
    y_ = bottom_ + 12;
    write_closed();
    write_history();
    y_ += kMargin;
    return head() + body_ + "</svg>\n";
  }

 private:
  std::string head() const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" "
        "role=\"img\">\n<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n",
        length_text(kWidth), length_text(y_), xml_text(title()), kColours.panel);
  }

  std::string title() const {
    return fmt::format("Network {}: when robots are where", result_.description.name);
  }

  void word(double x, double y, std::string_view colour, std::string_view words,
            std::string_view more = "", double size = kWordSize) {
    body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"{}>{}</text>\n",
                         length_text(x), length_text(y), length_text(size), colour, more,
                         xml_text(words));
  }

  void line(double x1, double y1, double x2, double y2, std::string_view look) {
    body_ += fmt::format("<path d=\"M{} {}L{} {}\" fill=\"none\" {}/>\n", length_text(x1),
                         length_text(y1), length_text(x2), length_text(y2), look);
  }

  double x_of(Nanoseconds time) const {
    const double share = static_cast<double>(time) / static_cast<double>(end_);
    return left_ + share * (kWidth - kMargin - kNameRoom - left_);
  }
  double y_of(NodeIndex node) const {
    return top_ + row_height_ * (static_cast<double>(rows_.row_of(node)) + 0.5);
  }
  bool has_row(NodeIndex node) const { return rows_.has(node); }
  std::string_view colour_of(std::size_t robot) const {
    return kRobotColours[robot % kRobotColours.size()];
  }

  void write_title() {
    y_ = 42;
    word(kMargin, y_, kColours.text, clipped(title(), kWidth - 2 * kMargin, 22),
         " font-weight=\"bold\"", 22);
    y_ += 22;
    const charts::PlanSettings& settings = result_.spec.settings;
    word(kMargin, y_, kColours.text,
         fmt::format("least {}   \u00B7   tolerance {} s   \u00B7   delay {} s   \u00B7   "
                     "clearance {} s",
                     lanes::name_of(settings.criterion),
                     charts::seconds_told(settings.avoidance.tolerance),
                     charts::seconds_told(settings.avoidance.delay),
                     charts::seconds_told(settings.avoidance.clearance)),
         "", 14);
  }

  void write_colours() {
    y_ += 26;
    double x = kMargin;
    const auto room = [&](double width) {
      if (x + width <= kWidth - kMargin) return;
      x = kMargin;
      y_ += 18;
    };
    for (std::size_t i = 0; i < drawn_; ++i) {
      const std::string words =
          fmt::format("{} (priority {})", robots_[i].name, robots_[i].priority);
      const std::string shown = clipped(words, 300, kWordSize);
      room(52 + text_width(shown, kWordSize));
      line(x, y_ - 4, x + 22, y_ - 4,
           fmt::format("stroke=\"{}\" stroke-width=\"2.5\"", colour_of(i)));
      word(x + 28, y_, kColours.text, shown);
      x += 28 + text_width(shown, kWordSize) + 18;
    }
    if (drawn_ < robots_.size()) {
      word(x, y_, kColours.muted, fmt::format("and {} more, not drawn", robots_.size() - drawn_));
    }
    y_ += 20;
    x = kMargin;
    const auto entry = [&](const std::string& look, std::string_view words) {
      room(52 + text_width(words, kWordSize));
      line(x, y_ - 4, x + 22, y_ - 4, look);
      word(x + 28, y_, kColours.muted, words);
      x += 28 + text_width(words, kWordSize) + 18;
    };
    entry(wait_look(kColours.text), "waits");
    entry(planned_look(kColours.text), "as planned at first");
    entry(against_look(kColours.text), "out of its lane");
    body_ += conflict(x + 11, y_ - 4, "");
    word(x + 28, y_, kColours.muted, "conflict that was resolved");
  }

  static std::string wait_look(std::string_view colour) {
    return fmt::format("stroke=\"{}\" stroke-width=\"6\" stroke-opacity=\"0.35\"", colour);
  }
  static std::string planned_look(std::string_view colour) {
    return fmt::format(
        "stroke=\"{}\" stroke-width=\"1.6\" stroke-opacity=\"0.75\" stroke-dasharray=\"2 4\"",
        colour);
  }
  static std::string against_look(std::string_view colour) {
    return fmt::format("stroke=\"{}\" stroke-width=\"2.5\" stroke-dasharray=\"8 4\"", colour);
  }
  static std::string drive_look(std::string_view colour) {
    return fmt::format("stroke=\"{}\" stroke-width=\"2.5\" stroke-linecap=\"round\"", colour);
  }

  void write_rows() {
    for (const NodeIndex node : rows_.order()) {
      const double y = y_of(node);
      line(left_, y, kWidth - kMargin - kNameRoom, y,
           fmt::format("stroke=\"{}\" stroke-width=\"0.6\"", kColours.line));
      word(left_ - 8, y + 4, kColours.text,
           clipped(result_.network.node(node).name, left_ - kMargin - 8, kWordSize),
           " text-anchor=\"end\"");
    }
  }

  std::vector<AxisMark> marks() const {
    if (end_ > kLongestInSeconds) return make_axis(std::nullopt, end_, kMostSecondMarks).marks;
    Nanoseconds step = kSecondSteps.back() * charts::kSecond;
    for (const Nanoseconds each : kSecondSteps) {
      if (end_ / (each * charts::kSecond) >= kMostSecondMarks) continue;
      step = each * charts::kSecond;
      break;
    }
    std::vector<AxisMark> result;
    for (Nanoseconds time = 0; time <= end_; time += step) {
      result.push_back({time, charts::seconds_told(time) + " s"});
    }
    return result;
  }

  void write_times() {
    for (const AxisMark& mark : marks()) {
      const double x = x_of(mark.time);
      line(x, top_, x, bottom_, fmt::format("stroke=\"{}\" stroke-width=\"0.6\"", kColours.line));
      word(x, top_ - 6, kColours.muted, mark.label, " text-anchor=\"middle\"", kSmallSize + 1);
    }
  }

  void write_reports() {
    double last = -1e9;
    for (const charts::CourseStep& step : result_.course.steps) {
      if (!step.report) continue;
      const double x = x_of(step.time);
      line(x, top_ - 20, x, bottom_,
           fmt::format("stroke=\"{}\" stroke-width=\"1\" stroke-dasharray=\"4 3\"", kColours.bad));
      // Names of reports that follow each other closely would lie on each other.
      if (x - last < 70) continue;
      last = x;
      word(x + 4, top_ - 20, kColours.bad,
           fmt::format("report, {} s", charts::seconds_told(step.time)), "", kSmallSize + 1);
    }
  }

  void write_planned(std::size_t robot) {
    const std::vector<charts::Stop>& stops = planned_[robot].stops;
    for (std::size_t i = 1; i < stops.size(); ++i) {
      if (!has_row(stops[i - 1].node) || !has_row(stops[i].node)) continue;
      line(x_of(stops[i - 1].arrival), y_of(stops[i - 1].node), x_of(stops[i].arrival),
           y_of(stops[i].node), planned_look(colour_of(robot)));
    }
  }

  /// Where a place is drawn: a node in its row, a place in a lane beside the row of the node
  /// before, on the side of the node to come, so that it is in no row.
  std::vector<double> heights_of(const std::vector<Visit>& visits) const {
    std::vector<double> heights;
    for (std::size_t i = 0; i < visits.size(); ++i) {
      const Visit& visit = visits[i];
      if (visit.node != charts::kNone) {
        heights.push_back(has_row(visit.node) ? y_of(visit.node) : -1);
        continue;
      }
      NodeIndex to = charts::kNone;
      for (std::size_t k = i + 1; k < visits.size() && to == charts::kNone; ++k) {
        to = visits[k].node;
      }
      if (visit.lane != charts::kNone) {
        const lanes::Lane& lane = result_.network.lane(visit.lane);
        to = visit.leg == Leg::kAlong ? lane.to : lane.from;
      }
      const double before = heights.empty() ? -1 : heights.back();
      const double there = to != charts::kNone && has_row(to) ? y_of(to) : before;
      double share = 0.5;
      if (visit.lane != charts::kNone) {
        share = std::clamp(static_cast<double>(visit.travel) /
                               static_cast<double>(result_.network.time(visit.lane)),
                           0.0, 1.0);
      }
      const double beside = row_height_ * (kNextToRow + kWithinRow * share);
      heights.push_back(before < 0 ? there : before + (there < before ? -beside : beside));
    }
    return heights;
  }

  void write_way(std::size_t robot) {
    const std::vector<Visit>& visits = result_.course.journeys[robot].visits;
    const std::vector<double> heights = heights_of(visits);
    const std::string_view colour = colour_of(robot);
    for (std::size_t i = 0; i < visits.size(); ++i) {
      const Visit& visit = visits[i];
      if (heights[i] < 0) continue;
      if (visit.departure > visit.arrival) {
        body_ += "<g>";
        line(x_of(visit.arrival), heights[i], x_of(visit.departure), heights[i], wait_look(colour));
        body_ += fmt::format("<title>{}</title></g>\n",
                             xml_text(fmt::format("{} waits from {} s to {} s", robots_[robot].name,
                                                  charts::seconds_told(visit.arrival),
                                                  charts::seconds_told(visit.departure))));
      }
      if (i + 1 < visits.size() && heights[i + 1] >= 0) {
        line(x_of(visit.departure), heights[i], x_of(visits[i + 1].arrival), heights[i + 1],
             visits[i + 1].leg == Leg::kAlong ? drive_look(colour) : against_look(colour));
      }
      body_ += fmt::format(
          "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"><title>{}</title></circle>\n",
          length_text(x_of(visit.arrival)), length_text(heights[i]),
          visit.node == charts::kNone ? "2" : "3.5", colour,
          xml_text(fmt::format("{} {} {} s", robots_[robot].name,
                               visit.node == charts::kNone
                                   ? std::string("in its lane")
                                   : "at " + result_.network.node(visit.node).name,
                               charts::seconds_told(visit.arrival))));
    }
    const Visit& end = visits.back();
    const bool at_goal = result_.course.steps.back().plan.errands[robot] == charts::Errand::kToGoal;
    if (heights.back() < 0) return;
    word(x_of(end.arrival) + 8, heights.back() + 4, colour,
         clipped(robots_[robot].name + (at_goal ? "" : ", not at its goal"), kNameRoom, kWordSize),
         " font-weight=\"bold\"");
  }

  static std::string conflict(double x, double y, std::string_view title) {
    return fmt::format(
        "<path d=\"M{0} {1}l5 5l-5 5l-5 -5z\" fill=\"{2}\" stroke=\"{3}\" "
        "stroke-width=\"1.5\"><title>{4}</title></path>\n",
        length_text(x), length_text(y - 5), kColours.panel, kColours.bad, title);
  }

  void write_conflicts() {
    std::size_t count = 0;
    for (const charts::CourseStep& step : result_.course.steps) {
      std::vector<charts::Chart> charts = charts_before_yields(step.plan);
      for (const Record& record : step.plan.records) {
        apply_yield(record, charts);
        if (record.kind != RecordKind::kYields || nth(record.robot) >= drawn_) continue;
        if (!has_row(record.node) || ++count > kMostConflictsDrawn) continue;
        body_ += conflict(x_of(record.time), y_of(record.node),
                          xml_text(told(result_.network, robots_, charts, record)));
      }
    }
  }

  /// Lanes and from when to when nobody may enter them.
  void write_closed() {
    struct Closed {
      lanes::LaneIndex lane;
      Nanoseconds from, to;
    };
    std::vector<Closed> all;
    std::map<lanes::LaneIndex, std::size_t> open;
    for (const charts::CourseStep& step : result_.course.steps) {
      const std::vector<lanes::LaneIndex>& closed = step.plan.closed;
      for (const lanes::LaneIndex lane : closed) {
        if (open.emplace(lane, all.size()).second) all.push_back({lane, step.time, end_});
      }
      std::erase_if(open, [&](const auto& each) {
        if (std::binary_search(closed.begin(), closed.end(), each.first)) return false;
        all[each.second].to = step.time;
        return true;
      });
    }
    if (all.empty()) return;
    y_ += 14;
    word(kMargin, y_, kColours.text, "Closed lanes", " font-weight=\"bold\"", 13);
    y_ += 8;
    for (const Closed& each : all) {
      const double x = x_of(each.from);
      body_ += fmt::format(
          "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" "
          "fill-opacity=\"0.3\" stroke=\"{}\"/>\n",
          length_text(x), length_text(y_ + 4), length_text(std::max(1.0, x_of(each.to) - x)),
          length_text(kClosedRow - 8), kColours.bad, kColours.bad);
      const std::string name = result_.network.name_of(each.lane);
      // Left of the bar where there is room.
      const double width = text_width(name, kWordSize);
      const bool is_left = x - width - 8 > kMargin;
      word(is_left ? x - 8 : x + 6, y_ + 14, kColours.text, name,
           is_left ? " text-anchor=\"end\"" : "");
      y_ += kClosedRow;
    }
  }

  void write_history() {
    std::vector<std::pair<std::string, bool>> lines;
    for (const charts::CourseStep& step : result_.course.steps) {
      if (step.report) {
        lines.emplace_back(
            fmt::format("{} s   {}", charts::seconds_told(step.time), report_told(result_, step)),
            true);
      }
      std::vector<charts::Chart> charts = charts_before_yields(step.plan);
      for (const Record& record : step.plan.records) {
        apply_yield(record, charts);
        lines.emplace_back(told(result_.network, robots_, charts, record), false);
      }
    }
    if (lines.empty()) return;
    y_ += 24;
    word(kMargin, y_, kColours.text, "What happened", " font-weight=\"bold\"", 13);
    for (std::size_t i = 0; i < lines.size() && i < kMostTold; ++i) {
      y_ += 17;
      const double x = kMargin + (lines[i].second ? 0 : 20);
      word(x, y_, lines[i].second ? kColours.text : kColours.muted,
           clipped(lines[i].first, kWidth - kMargin - x, kWordSize));
    }
    if (lines.size() <= kMostTold) return;
    y_ += 17;
    word(kMargin + 20, y_, kColours.muted,
         fmt::format("and {} more: charts.json has all", lines.size() - kMostTold));
  }

  const report::ChartsResult& result_;
  const std::vector<charts::Robot>& robots_;
  std::size_t drawn_ = 0;
  std::vector<charts::Chart> planned_;  ///< at first, before anybody yielded
  NodeRows rows_;
  Nanoseconds end_ = 0;
  double left_ = kLeastLeft;
  double row_height_ = kNodeRow;
  double top_ = 0;
  double bottom_ = 0;
  double y_ = 0;
  std::string body_;
};

}  // namespace

std::string charts_picture(const report::ChartsResult& result) {
  return ChartsPicture(result).write();
}

}  // namespace rubicon::gantt
