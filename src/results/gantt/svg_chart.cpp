#include "src/results/gantt/svg_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "src/results/gantt/svg_bars.hpp"
#include "src/results/gantt/svg_style.hpp"
#include "src/results/gantt/svg_text.hpp"
#include "src/results/gantt/time_axis.hpp"

namespace rubicon::gantt {

namespace {

// Lengths are pixels, as in svg_style.hpp.
constexpr double kLaneHeight = 46;
constexpr double kLaneBar = 20;
/// Of more lanes the labels are left out.
constexpr std::size_t kMostTallLanes = 20;
constexpr double kRowHeight = 17;
constexpr double kRowBar = 10;
constexpr double kTextSize = 12;
constexpr int kMostMarks = 25;
constexpr std::size_t kMostNotDone = 60;

class SvgWriter {
 public:
  explicit SvgWriter(const Chart& chart)
      : chart_(chart),
        // A plan without extent gets an axis all the same.
        end_(chart.end > 0 ? chart.end : schedule::kHour),
        axis_(make_axis(chart.start, end_, kMostMarks)),
        bars_(end_) {}

  std::string write() {
    write_head();
    write_legend();
    const double top = y_ + 44;
    y_ = top;
    const bool many = chart_.resources.size() > kMostTallLanes;
    write_lanes("Machines and crews", chart_.resources, many ? kRowHeight : kLaneHeight,
                many ? kRowBar : kLaneBar);
    write_lanes("Timetables", chart_.movings, kRowHeight, kRowBar);
    if (!chart_.rows.empty()) {
      write_off(chart_.nobody, y_ + 24, kRowHeight * static_cast<double>(chart_.rows.size()));
      write_lanes(chart_.rows_title, chart_.rows, kRowHeight, kRowBar);
    }
    if (chart_.resources.empty() && chart_.rows.empty() && chart_.movings.empty()) {
      text(kLeft, y_ + 20, kTextSize, kColours.muted, "Nothing was planned.");
      y_ += 40;
    }
    write_axis(top);
    write_not_done();
    y_ += kMargin;
    return begin() + grid_ + body_ + "</svg>\n";
  }

 private:
  std::string begin() const {
    std::string all;
    for (const std::string& fact : chart_.facts) all += (all.empty() ? "" : ". ") + fact;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" "
        "role=\"img\">\n<title>{2}</title>\n<desc>{3}</desc>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"{4}\"/>\n",
        length_text(kWidth), length_text(y_), xml_text(chart_.title), xml_text(all),
        kColours.panel);
  }

  void text(double x, double y, double size, std::string_view colour, std::string_view words,
            std::string_view more = "") {
    body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"{}>{}</text>\n",
                         length_text(x), length_text(y), length_text(size), colour, more,
                         xml_text(words));
  }

  /// A text that is cut to a width, its whole as a title if it is cut.
  void clipped_text(double x, double y, double width, double size, std::string_view words,
                    std::string_view more = "") {
    const std::string shown = clipped(words, width, size);
    const std::string title =
        shown == words ? std::string() : "<title>" + xml_text(words) + "</title>";
    body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"{}>{}{}</text>\n",
                         length_text(x), length_text(y), length_text(size), kColours.text, more,
                         title, xml_text(shown.empty() ? "\u2026" : shown));
  }

  void write_head() {
    y_ = 44;
    clipped_text(kMargin, y_, kWidth - 2 * kMargin, 24, chart_.title, " font-weight=\"bold\"");
    std::string facts;
    for (const std::string& fact : chart_.facts) {
      facts += (facts.empty() ? "" : "   \u00B7   ") + fact;
    }
    y_ += 24;
    clipped_text(kMargin, y_, kWidth - 2 * kMargin, 14, facts);
  }

  void write_legend() {
    y_ += 26;
    double x = kMargin;
    const auto entry = [&](std::string_view box, std::string_view words) {
      body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"18\" height=\"11\" {}/>\n",
                           length_text(x), length_text(y_ - 10), box);
      text(x + 24, y_, kTextSize, kColours.text, words);
      x += 24 + text_width(words, kTextSize) + 20;
    };
    entry(fmt::format("fill=\"{}\"", kColours.machine), "machine moves");
    entry(fmt::format("fill=\"{}\"", kColours.crew), "crew works");
    entry(fmt::format("fill=\"{}\"", kColours.wait), "waiting");
    entry(fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"", kColours.critical),
          "critical path");
    if (chart_.has_baselines) {
      entry(fmt::format("fill=\"{}\"", kColours.muted), "baseline");
    }
    if (chart_.has_milestones) {
      body_ += fmt::format("<path d=\"M{} {}l6 6l-6 6l-6 -6z\" fill=\"{}\"/>\n", length_text(x + 9),
                           length_text(y_ - 10.5), kColours.text);
      text(x + 24, y_, kTextSize, kColours.text, "milestone");
      x += 24 + text_width("milestone", kTextSize) + 20;
    }
    if (chart_.has_shifts) {
      entry(fmt::format("fill=\"{}\" stroke=\"{}\"", kColours.off, kColours.line), "out of shift");
    }
  }

  // ---- lanes

  void write_lanes(const std::string& title, const std::vector<Lane>& lanes, double height,
                   double bar) {
    if (lanes.empty()) return;
    text(kMargin, y_ + 16, 13, kColours.text, title, " font-weight=\"bold\"");
    y_ += 24;
    for (const Lane& lane : lanes) {
      write_off(lane.off, y_, height);
      write_name(lane, height);
      const double top = y_ + (lane_is_tall(height) ? 6 : (height - bar) / 2);
      body_ += bars_.bars(lane.bars, top, bar);
      if (lane_is_tall(height)) body_ += bars_.labels(lane.bars, top + bar + 12);
      y_ += height;
      grid_ += fmt::format("<path d=\"M{} {}H{}\" stroke=\"{}\" stroke-width=\"0.5\"/>\n",
                           length_text(kMargin), length_text(y_), length_text(kWidth - kMargin),
                           kColours.line);
    }
    y_ += 10;
  }

  static bool lane_is_tall(double height) { return height > 30; }

  void write_name(const Lane& lane, double height) {
    constexpr double kRoom = kLeft - kMargin - 12;
    if (lane_is_tall(height)) {
      clipped_text(kMargin, y_ + 19, kRoom, 13, lane.name);
      if (!lane.note.empty()) clipped_text(kMargin, y_ + 34, kRoom, kSmallSize, lane.note);
      return;
    }
    const double note = lane.brief.empty() ? 0 : text_width(lane.brief, kSmallSize) + 8;
    clipped_text(kMargin, y_ + 12.5, kRoom - note, 11, lane.name);
    if (!lane.brief.empty()) {
      text(kLeft - 12, y_ + 12.5, kSmallSize, kColours.muted, lane.brief, " text-anchor=\"end\"");
    }
  }

  void write_off(const std::vector<Span>& off, double top, double height) {
    const std::string path = bars_.boxes(off, top, height);
    if (!path.empty()) grid_ += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path, kColours.off);
  }
  // ---- the axis and what was not done

  void write_axis(double top) {
    std::string lines;
    for (const AxisMark& mark : axis_.marks) {
      const double x = bars_.x_of(mark.time);
      lines += fmt::format("M{} {}V{}", length_text(x), length_text(top), length_text(y_ - 10));
      text(x, top - 6, kSmallSize, kColours.text, mark.label, " text-anchor=\"middle\"");
    }
    grid_ +=
        fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"0.7\"/>\n", lines, kColours.line);
    for (std::size_t i = 0; i < axis_.heads.size(); ++i) {
      const double from = bars_.x_of(axis_.heads[i].time);
      const double to =
          i + 1 < axis_.heads.size() ? bars_.x_of(axis_.heads[i + 1].time) : kWidth - kMargin;
      const std::string shown = clipped(axis_.heads[i].label, to - from - 6, kTextSize);
      if (shown.empty()) continue;
      text(from + 4, top - 20, kTextSize, kColours.text, shown, " font-weight=\"bold\"");
    }
    body_ += fmt::format("<path d=\"M{} {}H{}\" stroke=\"{}\" stroke-width=\"1\"/>\n",
                         length_text(kLeft), length_text(top), length_text(kWidth - kMargin),
                         kColours.text);
  }

  void write_not_done() {
    if (chart_.not_done.empty()) return;
    text(kMargin, y_ + 16, 13, kColours.bad, fmt::format("Not done: {}", chart_.not_done.size()),
         " font-weight=\"bold\"");
    y_ += 24;
    constexpr double kNameRoom = kLeft - kMargin - 12;
    constexpr std::size_t kMostLines = 4;
    for (std::size_t i = 0; i < std::min(chart_.not_done.size(), kMostNotDone); ++i) {
      const NotDone& task = chart_.not_done[i];
      clipped_text(kMargin, y_ + 12, kNameRoom, 11, task.task);
      for (const std::string& line : wrapped(task.why, kPlot, 11, kMostLines)) {
        text(kLeft, y_ + 12, 11, kColours.text, line);
        y_ += 15;
      }
      y_ += 3;
    }
    if (chart_.not_done.size() > kMostNotDone) {
      text(kMargin, y_ + 12, 11, kColours.muted,
           fmt::format("and {} more", chart_.not_done.size() - kMostNotDone));
      y_ += 15;
    }
  }

  const Chart& chart_;
  const Ticks end_;
  const TimeAxis axis_;
  const SvgBars bars_;
  std::string grid_;  ///< behind everything
  std::string body_;
  double y_ = 0;
};

}  // namespace

std::string svg_chart(const Chart& chart) { return SvgWriter(chart).write(); }

}  // namespace rubicon::gantt
