#include "src/gantt/svg_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "src/gantt/svg_text.hpp"
#include "src/gantt/time_axis.hpp"

namespace rubicon::gantt {

namespace {

// Lengths are pixels, of which 1600 make the width: that of a sheet A3.
constexpr double kWidth = 1600;
constexpr double kMargin = 24;
constexpr double kLeft = 252;  ///< where time begins
constexpr double kPlot = kWidth - kLeft - kMargin;
constexpr double kLaneHeight = 46;
constexpr double kLaneBar = 20;
/// Of more lanes the labels are left out.
constexpr std::size_t kMostTallLanes = 20;
constexpr double kRowHeight = 17;
constexpr double kRowBar = 10;
constexpr double kTextSize = 12;
constexpr double kSmallSize = 10;
constexpr int kMostMarks = 25;
/// A label in less room than this tells nothing.
constexpr double kLeastLabel = 22;
/// Bytes of a longer name that still tell what it is.
constexpr std::size_t kLeastShown = 12;
/// In lanes with more bars those that are narrower than a pixel have no title: they would make the
/// file large, and nobody can point at them.
constexpr std::size_t kMostTitles = 1000;
/// What takes less time is drawn this wide all the same.
constexpr double kLeastWidth = 1;
/// Bars narrower than this have no outline: it would hide them.
constexpr double kLeastOutlined = 4;
constexpr std::size_t kMostNotDone = 60;

// Colours of Okabe and Ito that colour-blind people can tell apart.
constexpr const char* kMotion = "#0072b2";
constexpr const char* kWork = "#e69f00";
constexpr const char* kWait = "#b3b3b8";
constexpr const char* kCritical = "#9b0000";
constexpr const char* kOff = "#eceef2";
constexpr const char* kInk = "#1a1a1a";
constexpr const char* kFaint = "#595959";
constexpr const char* kLine = "#d5d7dc";

class SvgWriter {
 public:
  explicit SvgWriter(const Chart& chart) : chart_(chart) {
    // A plan without extent gets an axis all the same.
    end_ = chart.end > 0 ? chart.end : schedule::kHour;
    axis_ = make_axis(chart.start, end_, kMostMarks);
  }

  std::string write() {
    write_head();
    write_legend();
    const double top = y_ + 44;
    y_ = top;
    const bool many = chart_.resources.size() > kMostTallLanes;
    write_lanes("Machines and crews", chart_.resources, many ? kRowHeight : kLaneHeight,
                many ? kRowBar : kLaneBar);
    if (!chart_.rows.empty()) {
      write_off(chart_.nobody, y_ + 24, kRowHeight * static_cast<double>(chart_.rows.size()));
      write_lanes(chart_.rows_title, chart_.rows, kRowHeight, kRowBar);
    }
    if (chart_.resources.empty() && chart_.rows.empty()) {
      text(kLeft, y_ + 20, kTextSize, kFaint, "Nothing was planned.");
      y_ += 40;
    }
    write_axis(top);
    write_not_done();
    y_ += kMargin;
    return begin() + grid_ + body_ + "</svg>\n";
  }

 private:
  double x_of(Ticks time) const {
    return kLeft + kPlot * (static_cast<double>(time) / static_cast<double>(end_));
  }

  std::string begin() const {
    std::string all;
    for (const std::string& fact : chart_.facts) all += (all.empty() ? "" : ". ") + fact;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" "
        "role=\"img\">\n<title>{2}</title>\n<desc>{3}</desc>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        length_text(kWidth), length_text(y_), xml_text(chart_.title), xml_text(all));
  }

  void text(double x, double y, double size, const char* colour, std::string_view words,
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
                         length_text(x), length_text(y), length_text(size), kInk, more, title,
                         xml_text(shown.empty() ? "\u2026" : shown));
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
      text(x + 24, y_, kTextSize, kInk, words);
      x += 24 + text_width(words, kTextSize) + 20;
    };
    entry(fmt::format("fill=\"{}\"", kMotion), "machine moves");
    entry(fmt::format("fill=\"{}\"", kWork), "crew works");
    entry(fmt::format("fill=\"{}\"", kWait), "waiting");
    entry(fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"", kCritical),
          "critical chain");
    if (chart_.has_shifts) {
      entry(fmt::format("fill=\"{}\" stroke=\"{}\"", kOff, kLine), "out of shift");
    }
  }

  // ---- lanes

  void write_lanes(const std::string& title, const std::vector<Lane>& lanes, double height,
                   double bar) {
    if (lanes.empty()) return;
    text(kMargin, y_ + 16, 13, kInk, title, " font-weight=\"bold\"");
    y_ += 24;
    for (const Lane& lane : lanes) {
      write_off(lane.off, y_, height);
      write_name(lane, height);
      const double top = y_ + (lane_is_tall(height) ? 6 : (height - bar) / 2);
      write_bars(lane.bars, top, bar);
      if (lane_is_tall(height)) write_labels(lane.bars, top + bar + 12);
      y_ += height;
      grid_ +=
          fmt::format("<path d=\"M{} {}H{}\" stroke=\"{}\" stroke-width=\"0.5\"/>\n",
                      length_text(kMargin), length_text(y_), length_text(kWidth - kMargin), kLine);
    }
    y_ += 10;
  }

  static bool lane_is_tall(double height) { return height > 30; }

  void write_name(const Lane& lane, double height) {
    constexpr double kRoom = kLeft - kMargin - 12;
    if (lane_is_tall(height)) {
      clipped_text(kMargin, y_ + 19, kRoom, 13, lane.name);
      clipped_text(kMargin, y_ + 34, kRoom, kSmallSize, lane.note);
      return;
    }
    const double note = lane.brief.empty() ? 0 : text_width(lane.brief, kSmallSize) + 8;
    clipped_text(kMargin, y_ + 12.5, kRoom - note, 11, lane.name);
    if (!lane.brief.empty()) {
      text(kLeft - 12, y_ + 12.5, kSmallSize, kFaint, lane.brief, " text-anchor=\"end\"");
    }
  }

  void write_off(const std::vector<Span>& off, double top, double height) {
    std::string path;
    for (const Span& span : off) add_box(path, span, top, height);
    if (!path.empty()) grid_ += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path, kOff);
  }

  void add_box(std::string& path, const Span& span, double top, double height) const {
    const std::string width = length_text(x_of(span.to) - x_of(span.from));
    path += fmt::format("M{} {}h{}v{}h-{}z", length_text(x_of(span.from)), length_text(top), width,
                        length_text(height), width);
  }

  void write_bars(const std::vector<Bar>& bars, double top, double height) {
    write_path(widened(active_spans(bars, true)), kMotion, top, height);
    write_path(widened(active_spans(bars, false)), kWork, top, height);
    write_path(spans_of(bars, Part::Kind::work), kWork, top, height);
    write_path(spans_of(bars, Part::Kind::wait), kWait, top + height / 5, height * 3 / 5);
    write_path(spans_of(bars, Part::Kind::off), kWait, top + height * 2 / 5, height / 5);
    write_edges(bars, top, height);
    write_critical(bars, top, height);
    std::string titles;
    for (const Bar& bar : bars) {
      if (bars.size() > kMostTitles && x_of(bar.span.to) - x_of(bar.span.from) < 1) continue;
      titles += fmt::format(
          "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"><title>{}</title></rect>\n",
          length_text(x_of(bar.span.from)), length_text(top),
          length_text(x_of(bar.span.to) - x_of(bar.span.from)), length_text(height),
          xml_text(bar.text));
    }
    if (!titles.empty()) {
      body_ += "<g fill=\"none\" pointer-events=\"all\">\n" + titles + "</g>\n";
    }
  }

  static std::vector<Span> spans_of(const std::vector<Bar>& bars, Part::Kind kind) {
    std::vector<Span> spans;
    for (const Bar& bar : bars) {
      for (const Part& part : bar.parts) {
        if (part.kind == kind) spans.push_back(part.span);
      }
    }
    return spans;
  }

  /// Where something goes on, motion or work, in bars with motion or in those without; what
  /// touches is one. Work is drawn over it: were both drawn side by side, thin ones would let the
  /// paper show through.
  static std::vector<Span> active_spans(const std::vector<Bar>& bars, bool with_motion) {
    std::vector<Span> spans;
    for (const Bar& bar : bars) {
      const bool moves = std::any_of(bar.parts.begin(), bar.parts.end(), [](const Part& part) {
        return part.kind == Part::Kind::motion;
      });
      if (moves != with_motion) continue;
      for (const Part& part : bar.parts) add_active(spans, part);
    }
    return spans;
  }

  /// The same, each at least so wide that it is seen.
  std::vector<Span> widened(std::vector<Span> spans) const {
    const auto least = static_cast<Ticks>(static_cast<double>(end_) * (kLeastWidth / kPlot));
    for (Span& span : spans) span.to = std::max(span.to, span.from + least);
    return spans;
  }

  static void add_active(std::vector<Span>& spans, const Part& part) {
    if (part.kind != Part::Kind::motion && part.kind != Part::Kind::work) return;
    if (!spans.empty() && spans.back().to == part.span.from) {
      spans.back().to = part.span.to;
    } else {
      spans.push_back(part.span);
    }
  }

  void write_path(const std::vector<Span>& spans, const char* colour, double top, double height) {
    std::string path;
    for (const Span& span : spans) add_box(path, span, top, height);
    if (!path.empty())
      body_ += fmt::format("<path d=\"{}\" fill=\"{}\" shape-rendering=\"crispEdges\"/>\n", path,
                           colour);
  }

  /// Thin lines between bars that touch.
  void write_edges(const std::vector<Bar>& bars, double top, double height) {
    std::string path;
    for (const Bar& bar : bars) {
      const double x = x_of(bar.span.from);
      if (x_of(bar.span.to) - x < kLeastOutlined) continue;
      path += fmt::format("M{} {}v{}", length_text(x), length_text(top), length_text(height));
    }
    if (path.empty()) return;
    body_ += fmt::format("<path d=\"{}\" stroke=\"#ffffff\" stroke-width=\"0.8\"/>\n", path);
  }

  /// Outlines round what goes on in critical bars, or where they are too narrow for one, lines
  /// above and below them.
  void write_critical(const std::vector<Bar>& bars, double top, double height) {
    std::string path;
    for (const Bar& bar : bars) {
      if (!bar.critical) continue;
      std::vector<Span> spans;
      for (const Part& part : bar.parts) add_active(spans, part);
      for (const Span& span : spans) add_critical(path, span, top, height);
    }
    if (path.empty()) return;
    body_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>\n",
                         path, kCritical);
  }

  void add_critical(std::string& path, const Span& span, double top, double height) const {
    if (x_of(span.to) - x_of(span.from) >= kLeastOutlined) {
      add_box(path, span, top, height);
      return;
    }
    const std::string x = length_text(x_of(span.from));
    const std::string width = length_text(x_of(span.to) - x_of(span.from));
    path += fmt::format("M{} {}h{}M{} {}h{}", x, length_text(top), width, x,
                        length_text(top + height), width);
  }

  // ---- labels below the bars of a lane

  /// Bars that share a label: one bar, or the bars of one place where one has no room.
  struct Labelled {
    std::string name;
    double from = 0;
    double to = 0;
  };

  std::vector<Labelled> labels_of(const std::vector<Bar>& bars, bool of_places) const {
    std::vector<Labelled> labels;
    for (const Bar& bar : bars) {
      const std::size_t point = bar.name.rfind('.');
      const std::string name =
          of_places && point != std::string::npos ? bar.name.substr(0, point) : bar.name;
      if (of_places && !labels.empty() && labels.back().name == name) {
        labels.back().to = x_of(bar.span.to);
      } else {
        labels.push_back({name, x_of(bar.span.from), x_of(bar.span.to)});
      }
    }
    // A label may run on to where the next bar begins.
    for (std::size_t i = 0; i < labels.size(); ++i) {
      labels[i].to = i + 1 < labels.size() ? labels[i + 1].from : kWidth - kMargin;
    }
    return labels;
  }

  void write_labels(const std::vector<Bar>& bars, double y) {
    std::vector<Labelled> labels = labels_of(bars, false);
    const auto narrow = std::count_if(labels.begin(), labels.end(), [](const Labelled& label) {
      return label.to - label.from < kLeastLabel;
    });
    if (2 * narrow > static_cast<std::ptrdiff_t>(labels.size())) labels = labels_of(bars, true);
    std::string texts;
    for (const Labelled& label : labels) {
      const double room = label.to - label.from - 3;
      if (room < kLeastLabel) continue;
      const std::string shown = clipped(label.name, room, kSmallSize);
      if (shown != label.name && shown.size() < kLeastShown) continue;
      const std::string title =
          shown == label.name ? std::string() : "<title>" + xml_text(label.name) + "</title>";
      texts += fmt::format("<text x=\"{}\" y=\"{}\">{}{}</text>\n", length_text(label.from),
                           length_text(y), title, xml_text(shown));
    }
    if (texts.empty()) return;
    body_ += fmt::format("<g font-size=\"{}\" fill=\"{}\">\n{}</g>\n", length_text(kSmallSize),
                         kInk, texts);
  }

  // ---- the axis and what was not done

  void write_axis(double top) {
    std::string lines;
    for (const AxisMark& mark : axis_.marks) {
      const double x = x_of(mark.time);
      lines += fmt::format("M{} {}V{}", length_text(x), length_text(top), length_text(y_ - 10));
      text(x, top - 6, kSmallSize, kInk, mark.label, " text-anchor=\"middle\"");
    }
    grid_ += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"0.7\"/>\n", lines, kLine);
    for (std::size_t i = 0; i < axis_.heads.size(); ++i) {
      const double from = x_of(axis_.heads[i].time);
      const double to =
          i + 1 < axis_.heads.size() ? x_of(axis_.heads[i + 1].time) : kWidth - kMargin;
      const std::string shown = clipped(axis_.heads[i].label, to - from - 6, kTextSize);
      if (shown.empty()) continue;
      text(from + 4, top - 20, kTextSize, kInk, shown, " font-weight=\"bold\"");
    }
    body_ += fmt::format("<path d=\"M{} {}H{}\" stroke=\"{}\" stroke-width=\"1\"/>\n",
                         length_text(kLeft), length_text(top), length_text(kWidth - kMargin), kInk);
  }

  void write_not_done() {
    if (chart_.not_done.empty()) return;
    text(kMargin, y_ + 16, 13, kCritical, fmt::format("Not done: {}", chart_.not_done.size()),
         " font-weight=\"bold\"");
    y_ += 24;
    constexpr double kNameRoom = kLeft - kMargin - 12;
    constexpr std::size_t kMostLines = 4;
    for (std::size_t i = 0; i < std::min(chart_.not_done.size(), kMostNotDone); ++i) {
      const NotDone& task = chart_.not_done[i];
      clipped_text(kMargin, y_ + 12, kNameRoom, 11, task.task);
      for (const std::string& line : wrapped(task.why, kPlot, 11, kMostLines)) {
        text(kLeft, y_ + 12, 11, kInk, line);
        y_ += 15;
      }
      y_ += 3;
    }
    if (chart_.not_done.size() > kMostNotDone) {
      text(kMargin, y_ + 12, 11, kFaint,
           fmt::format("and {} more", chart_.not_done.size() - kMostNotDone));
      y_ += 15;
    }
  }

  const Chart& chart_;
  Ticks end_ = 1;
  TimeAxis axis_;
  std::string grid_;  ///< behind everything
  std::string body_;
  double y_ = 0;
};

}  // namespace

std::string svg_chart(const Chart& chart) { return SvgWriter(chart).write(); }

}  // namespace rubicon::gantt
