#include "src/results/comparison/way_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "src/motion/guides/leg.hpp"
#include "src/motion/guides/way_metrics.hpp"
#include "src/motion/math/index.hpp"
#include "src/results/comparison/first_way.hpp"
#include "src/results/gantt/svg_text.hpp"
#include "src/results/palette/palette.hpp"

namespace rubicon::comparison {

namespace {

using math::at;

constexpr double kChartWidth = 640, kStripHeight = 90, kStripGap = 22;
constexpr double kChartLeft = 120, kChartTop = 44, kChartBelow = 44, kChartRight = 24;

/// A value at a time, s.
struct ChartPoint {
  double time = 0;
  double value = 0;
};

/// One parameter on the way.
struct ChartStrip {
  std::string title;
  std::vector<ChartPoint> driven;  ///< all arrive together
  std::vector<ChartPoint> alone;   ///< at its full speed, then it stands
};

class WayChart {
 public:
  explicit WayChart(const FirstWay& way) : way_(way) {
    const robot::RobotModel& model = way.program.robot->model;
    const guides::Leg leg(model, way.motion.mounting, way.motion.clauses, way.spec.turn_radius);
    const bool loaded = way.world.loaded();
    for (const int i : leg.parameters()) {
      const robot::Parameter& p = model.parameters[at(i)];
      strips_.push_back({fmt::format("{}, {}", p.display_name, p.rotation ? "deg" : "m"), {}, {}});
      parameters_.push_back(i);
    }
    std::vector<double> now = way.report.way.front();
    add(now, now, 0, model, loaded);
    for (std::size_t k = 1; k < way.report.way.size(); ++k) {
      // Angles run on over corners; those of a way are reduced.
      for (std::vector<double>& corner : leg.corners(now, way.report.way[k])) {
        const double time = guides::leg_time(model, leg, now, corner, loaded);
        add(now, corner, time, model, loaded);
        now = std::move(corner);
      }
    }
    std::erase_if(strips_, [](const ChartStrip& strip) { return span(strip).second <= 0; });
  }

  std::string svg() const {
    const palette::Drawing& colours = palette::kDrawing;
    const double count = static_cast<double>(strips_.size());
    const double width = kChartLeft + kChartWidth + kChartRight;
    const double height = kChartTop + count * (kStripHeight + kStripGap) + kChartBelow;
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\" "
        "fill=\"{2}\">\n<rect width=\"100%\" height=\"100%\" fill=\"{3}\"/>\n",
        width, height, colours.text, colours.panel);
    text += fmt::format(
        "<text x=\"16\" y=\"20\" font-weight=\"bold\">{}</text>\n<text x=\"16\" y=\"36\" "
        "fill=\"{}\">thick: as driven, all arrive together; thin: each by itself at its full "
        "speed</text>\n",
        gantt::xml_text(fmt::format("{}: {} waypoints, {:.1f} s", guides::full_name(way_.spec),
                                    way_.report.way.size() - 1, time_)),
        colours.muted);
    double top = kChartTop + kStripGap / 2;
    for (const ChartStrip& strip : strips_) {
      draw(strip, top, text);
      top += kStripHeight + kStripGap;
    }
    const double step = time_ > 60 ? 10 * std::ceil(time_ / 100) : time_ > 12 ? 5 : 1;
    for (double t = 0; t <= time_; t += step) {
      text += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">{:g}</text>\n",
                          pixel(t), top + 4, t);
    }
    text += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">s</text>\n",
                        kChartLeft + kChartWidth / 2, top + 24);
    return text + "</svg>\n";
  }

 private:
  void add(const std::vector<double>& from, const std::vector<double>& to, double time,
           const robot::RobotModel& model, bool loaded) {
    for (std::size_t s = 0; s < strips_.size(); ++s) {
      const robot::Parameter& p = model.parameters[at(parameters_[s])];
      const double a = from[at(parameters_[s])];
      const double b = to[at(parameters_[s])];
      const double speed = loaded ? p.loaded_speed : p.speed;
      const double alone = speed > 0 ? std::min(std::fabs(b - a) / speed, time) : time;
      strips_[s].driven.push_back({time_ + time, b});
      strips_[s].alone.push_back({time_, a});
      strips_[s].alone.push_back({time_ + alone, b});
    }
    time_ += time;
  }

  static std::pair<double, double> span(const ChartStrip& strip) {
    const auto less = [](const ChartPoint& a, const ChartPoint& b) { return a.value < b.value; };
    const auto [low, high] = std::minmax_element(strip.driven.begin(), strip.driven.end(), less);
    return {low->value, high->value - low->value};
  }

  double pixel(double time) const {
    return kChartLeft + (time_ > 0 ? time / time_ : 0) * kChartWidth;
  }

  void draw(const ChartStrip& strip, double top, std::string& text) const {
    const palette::Drawing& colours = palette::kDrawing;
    const auto [low, range] = span(strip);
    const auto path = [&](const std::vector<ChartPoint>& points, const std::string& style) {
      std::string line;
      for (const ChartPoint& point : points) {
        line += fmt::format("{}{:.2f} {:.2f}", line.empty() ? "M" : "L", pixel(point.time),
                            top + kStripHeight - (point.value - low) / range * kStripHeight);
      }
      text += fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", line, style);
    };
    text += fmt::format(
        "<rect x=\"{}\" y=\"{:.2f}\" width=\"{}\" height=\"{}\" fill=\"none\" "
        "stroke=\"{}\"/>\n",
        kChartLeft, top, kChartWidth, kStripHeight, colours.line);
    path(strip.alone, fmt::format("stroke=\"{}\" stroke-width=\"1\"", colours.muted));
    path(strip.driven, fmt::format("stroke=\"{}\" stroke-width=\"2.2\"", colours.machine));
    text += fmt::format("<text x=\"16\" y=\"{:.2f}\">{}</text>\n", top + kStripHeight / 2 + 4,
                        gantt::xml_text(strip.title));
    for (const double share : {0.0, 1.0}) {
      text += fmt::format(
          "<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"end\" font-size=\"10\">{:.4g}"
          "</text>\n",
          kChartLeft - 6, top + (1 - share) * kStripHeight + 4, low + share * range);
    }
  }

  const FirstWay& way_;
  std::vector<ChartStrip> strips_;
  std::vector<int> parameters_;
  double time_ = 0;
};

}  // namespace

std::string way_chart(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                      const std::string& task, const std::string& kind) {
  std::string svg;
  with_first_way(plan, sources, task, kind, [&](const FirstWay& way) {
    if (!way.report.found()) throw std::invalid_argument(way.cause);
    svg = WayChart(way).svg();
  });
  return svg;
}

}  // namespace rubicon::comparison
