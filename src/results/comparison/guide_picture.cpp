#include "src/results/comparison/guide_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "interpreter/machine/world_tests.hpp"
#include "src/motion/guides/forbidden_grid.hpp"
#include "src/motion/guides/guide.hpp"
#include "src/motion/guides/potential.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/turns.hpp"
#include "src/results/comparison/first_way.hpp"
#include "src/results/comparison/slider_page.hpp"
#include "src/results/gantt/svg_text.hpp"
#include "src/results/palette/palette.hpp"

namespace rubicon::comparison {

namespace {

using guides::Point;
using math::at;

/// Cells along the longer side.
constexpr int kPictureCells = 120;
/// Pixels of the longer side, and round the picture.
constexpr double kPictureSide = 640;
constexpr double kLeftMargin = 64, kTopMargin = 44, kBottomMargin = 76, kRightMargin = 24;
/// Bands of the field, and nodes of a lattice whose minima are looked for, at most.
constexpr int kBands = 14;
/// Intervals of the range of a third parameter.
constexpr int kPictureLayers = 24;
constexpr std::size_t kMostNodes = 40000;

/// One of the two parameters of the picture.
struct PictureAxis {
  std::size_t coordinate = 0;
  std::string title;
  double low = 0, high = 1;
  double pixels = kPictureSide;
};

/// A round step of an axis that has some five to ten of them.
double tick_step(double range) {
  double step = 1;
  while (step * 10 < range) step *= 10;
  while (step > range) step /= 10;
  if (range / step < 3) return step / 2;
  return range / step > 8 ? step * 2 : step;
}

class Picture {
 public:
  explicit Picture(const FirstWay& way)
      : model_(way.program.robot->model),
        spec_(way.spec),
        report_(way.report),
        cause_(way.cause),
        tests_(model_, way.world),
        space_(model_, way.motion.mounting, way.motion.q, unbounded(spec_), tests_,
               way.motion.clauses),
        start_(space_.point(way.motion.q)),
        goal_(space_.point(way.report.goal.empty() ? way.motion.q : way.report.goal)),
        shown_(start_) {}

  void choose_axes(const std::vector<std::string>& names) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < space_.size(); ++i) all.push_back(space_.parameter(i).display_name);
    if (all.size() < 2)
      throw std::invalid_argument("a picture needs two parameters that a leg moves");
    std::vector<std::size_t> chosen;
    for (const std::string& name : names) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const std::string& each) {
        return each == name || each.ends_with("." + name);
      });
      if (found == all.end()) {
        throw std::invalid_argument(
            fmt::format("'{}' is no parameter that a leg of the robot "
                        "moves; these are {}",
                        name, fmt::join(all, ", ")));
      }
      chosen.push_back(static_cast<std::size_t>(found - all.begin()));
    }
    for (std::size_t i = 0; i < all.size() && names.empty() && chosen.size() < 2; ++i) {
      const std::vector<int>& over = spec_.over;
      const bool spanned = over.size() < 2 || std::find(over.begin(), over.end(),
                                                        space_.leg().parameters()[i]) != over.end();
      if (spanned) chosen.push_back(i);
    }
    const std::set<std::size_t> different(chosen.begin(), chosen.end());
    if (chosen.size() < 2 || chosen.size() > 3 || different.size() != chosen.size()) {
      throw std::invalid_argument(
          "--axes takes two different parameters, such as boom.phi,stick.phi, or three for a page");
    }
    if (chosen.size() == 3) third_ = axis(chosen[2]);
    for (std::size_t k = 0; k < 2; ++k) axes_[k] = axis(chosen[k]);
    fit_scales();
  }

  bool has_third() const { return third_.has_value(); }

  /// Of a third parameter: its value in the picture.
  void stand_at(double value) {
    const robot::Parameter& p = space_.parameter(third_->coordinate);
    const double low = space_.lower(third_->coordinate);
    const double high = space_.upper(third_->coordinate);
    if (!(value >= low && value <= high)) {
      throw std::invalid_argument(fmt::format("--at: {} is from {:g} to {:g}, found {:g}",
                                              p.display_name, low, high, value));
    }
    shown_[third_->coordinate] = value;
  }

  std::string page() {
    SliderPage page;
    const robot::Parameter& p = space_.parameter(third_->coordinate);
    std::set<double> values{start_[third_->coordinate], goal_[third_->coordinate]};
    // Of an angle that turns freely the last is the first.
    for (int k = 0; k < kPictureLayers + (p.cyclic ? 0 : 1); ++k) {
      values.insert(third_->low + (third_->high - third_->low) * k / kPictureLayers);
    }
    page.first = static_cast<std::size_t>(
        std::distance(values.begin(), values.find(start_[third_->coordinate])));
    layers_.assign(values.begin(), values.end());
    shown_layer_ = page.first;
    page.svg = svg();
    page.title = title();
    page.name = p.display_name;
    for (const double value : values) {
      page.values.push_back(fmt::format("{:.4g} {}", value, p.rotation ? "degrees" : "m"));
    }
    return slider_page(page);
  }

  std::string svg() {
    const palette::Drawing& colours = palette::kDrawing;
    const double width = kLeftMargin + axes_[0].pixels + kRightMargin;
    const double height = kTopMargin + axes_[1].pixels + kBottomMargin;
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\" "
        "fill=\"{2}\">\n<rect width=\"100%\" height=\"100%\" fill=\"{3}\"/>\n",
        width, height, colours.text, colours.panel);
    forbidden();
    text_ += "<g>\n";
    tree();
    way();
    if (spec_.kind == guides::GuideKind::potential && !third_) minima();
    rings();
    mark(start_, colours.machine, "start");
    mark(goal_, colours.critical, "goal");
    text_ += "</g>\n";
    frame(width, height);
    return text_ + "</svg>\n";
  }

 private:
  /// The picture asks as often as it has to.
  static const guides::GuideSpec& unbounded(guides::GuideSpec& spec) {
    spec.checks = std::numeric_limits<double>::infinity();
    return spec;
  }

  PictureAxis axis(std::size_t coordinate) const {
    const robot::Parameter& p = space_.parameter(coordinate);
    PictureAxis axis;
    axis.coordinate = coordinate;
    axis.title = fmt::format("{}, {}", p.display_name, p.rotation ? "degrees" : "m");
    axis.low = space_.lower(coordinate);
    axis.high = space_.upper(coordinate);
    if (p.rotation) return axis;
    double low = std::min(start_[coordinate], goal_[coordinate]);
    double high = std::max(start_[coordinate], goal_[coordinate]);
    for (const std::vector<double>& q : report_.way) {
      low = std::min(low, space_.point(q)[coordinate]);
      high = std::max(high, space_.point(q)[coordinate]);
    }
    // Of a wide range what lies about the way.
    constexpr double kAbout = 0.35;
    constexpr double kLeastAbout = 2;
    const double about = std::max(kLeastAbout, kAbout * extent());
    axis.low = std::max(axis.low, low - about);
    axis.high = std::min(axis.high, high + about);
    return axis;
  }

  /// m, of start, goal and way along the longest of the parameters.
  double extent() const {
    double most = 0;
    for (std::size_t i = 0; i < space_.size(); ++i) {
      if (space_.parameter(i).rotation) continue;
      double low = std::min(start_[i], goal_[i]);
      double high = std::max(start_[i], goal_[i]);
      for (const std::vector<double>& q : report_.way) {
        low = std::min(low, space_.point(q)[i]);
        high = std::max(high, space_.point(q)[i]);
      }
      most = std::max(most, high - low);
    }
    return most;
  }

  /// The same metres or degrees are as long on both axes.
  void fit_scales() {
    const bool same = space_.parameter(axes_[0].coordinate).rotation ==
                      space_.parameter(axes_[1].coordinate).rotation;
    double ranges[2] = {axes_[0].high - axes_[0].low, axes_[1].high - axes_[1].low};
    if (!same) ranges[1] = ranges[0];
    const double most = std::max(ranges[0], ranges[1]);
    for (std::size_t k = 0; k < 2; ++k) {
      constexpr double kLeastSide = 160;
      axes_[k].pixels = std::max(kLeastSide, kPictureSide * ranges[k] / most);
    }
  }

  double pixel_x(double value) const {
    return kLeftMargin + (value - axes_[0].low) / (axes_[0].high - axes_[0].low) * axes_[0].pixels;
  }
  double pixel_y(double value) const {
    return kTopMargin + axes_[1].pixels -
           (value - axes_[1].low) / (axes_[1].high - axes_[1].low) * axes_[1].pixels;
  }
  double value(const Point& point, std::size_t k) const { return point[axes_[k].coordinate]; }
  bool is_shown(const Point& point) const {
    for (std::size_t k = 0; k < 2; ++k) {
      if (value(point, k) < axes_[k].low || value(point, k) > axes_[k].high) return false;
    }
    return true;
  }

  /// Where the robot may not stand, and the bands of the field: as they are shown, or a layer for
  /// each value of the third parameter.
  void forbidden() {
    if (layers_.empty()) return cells(cell_values(shown_));
    std::vector<std::vector<double>> grids;
    Point point = shown_;
    for (const double value : layers_) {
      point[third_->coordinate] = value;
      grids.push_back(cell_values(point));
    }
    for (std::size_t k = 0; k < grids.size(); ++k) {
      text_ += layer_begin(k == shown_layer_);
      cells(grids[k]);
      text_ += "</g>\n";
    }
  }

  /// Where the way has the value of the third parameter, by layers too.
  void rings() {
    if (!third_) return;
    if (layers_.empty()) return rings_at(shown_[third_->coordinate]);
    for (std::size_t k = 0; k < layers_.size(); ++k) {
      text_ += layer_begin(k == shown_layer_);
      rings_at(layers_[k]);
      text_ += "</g>\n";
    }
  }

  void rings_at(double there) {
    // A vehicle that turns on the spot has no straight legs.
    if (space_.leg().drive() >= 0 && !space_.leg().steers()) return;
    for (std::size_t k = 1; k < report_.way.size(); ++k) {
      const Point from = space_.point(report_.way[k - 1]);
      const Point to = space_.point(report_.way[k]);
      const double all = way_to(*third_, from, to[third_->coordinate]);
      const double part = way_to(*third_, from, there);
      if (all == 0 || part / all < 0 || part / all > 1) continue;
      const double share = part / all;
      text_ += fmt::format(
          "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"6\" fill=\"none\" stroke=\"{}\" "
          "stroke-width=\"2\"/>\n",
          pixel_x(value(from, 0) + share * way_on(from, to, 0)),
          pixel_y(value(from, 1) + share * way_on(from, to, 1)), palette::kDrawing.bad);
    }
  }

  /// Row by row from below; also finds the highest of the field.
  std::vector<double> cell_values(Point point) {
    const double most = std::max(axes_[0].pixels, axes_[1].pixels);
    columns_ = static_cast<int>(std::ceil(kPictureCells * axes_[0].pixels / most));
    rows_ = static_cast<int>(std::ceil(kPictureCells * axes_[1].pixels / most));
    const std::array<guides::GridAxis, 2> axes = {grid_axis(0, columns_), grid_axis(1, rows_)};
    std::vector<double> values;
    if (spec_.kind != guides::GuideKind::potential) {
      for (const bool blocked : guides::blocked_cells(space_, point, axes)) {
        values.push_back(blocked ? guides::PotentialField::kBlocked : 0);
      }
      return values;
    }
    guides::PotentialField potential(space_, start_, goal_);
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i) {
        point[axes[0].coordinate] = axes[0].middle(i);
        point[axes[1].coordinate] = axes[1].middle(j);
        values.push_back(potential.value(point));
        if (std::isfinite(values.back())) highest_ = std::max(highest_, values.back());
      }
    }
    return values;
  }

  guides::GridAxis grid_axis(std::size_t k, int cells) const {
    return {axes_[k].coordinate, axes_[k].low, axes_[k].high, cells};
  }

  /// Runs of equal cells are one rectangle; of a layer all of a colour are one path.
  void cells(const std::vector<double>& values) {
    text_ += "<g shape-rendering=\"crispEdges\">\n";
    const double w = axes_[0].pixels / columns_;
    const double h = axes_[1].pixels / rows_;
    const double below = kTopMargin + axes_[1].pixels;
    std::map<std::string, std::string> paths;
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_;) {
        const std::string fill = colour(values[at(j * columns_ + i)]);
        int end = i + 1;
        while (end < columns_ && colour(values[at(j * columns_ + end)]) == fill) ++end;
        if (!fill.empty() && layers_.empty()) {
          text_ += fmt::format(
              "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
              kLeftMargin + i * w, below - (j + 1) * h, (end - i) * w, h, fill);
        } else if (!fill.empty()) {
          paths[fill] += fmt::format("M{} {}H{}v1H{}z", i, j, end, i);
        }
        i = end;
      }
    }
    for (const auto& [fill, path] : paths) {
      text_ += fmt::format(
          "<path transform=\"translate({:.2f} {:.2f}) scale({:.4f} {:.4f})\" d=\"{}\" "
          "fill=\"{}\"/>\n",
          kLeftMargin, below, w, -h, path, fill);
    }
    text_ += "</g>\n";
  }

  /// "": the ground.
  std::string colour(double value) const {
    if (!std::isfinite(value)) return std::string(palette::kDrawing.forbidden);
    if (spec_.kind != guides::GuideKind::potential || !(highest_ > 0)) return {};
    // Close to obstacles the field is many times what it is elsewhere.
    const double share = std::sqrt(std::sqrt(value / highest_));
    const int band = std::min(static_cast<int>(share * kBands), kBands - 1);
    const double tone = static_cast<double>(band) / (kBands - 1);
    const auto mixed = [tone](int light, int dark) {
      return static_cast<int>(std::floor(light + (dark - light) * tone + 0.5));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", mixed(0xf4, 0x2c), mixed(0xf8, 0x6a),
                       mixed(0xfb, 0x9c));
  }

  /// A leg that turns an angle past the end of its range leaves the picture, and comes in on the
  /// other side.
  void line(const std::vector<Point>& points, const std::string& style) {
    std::string path;
    const auto go = [&](char how, double x, double y) {
      path += fmt::format("{}{:.2f} {:.2f}", how, pixel_x(x), pixel_y(y));
    };
    go('M', value(points.front(), 0), value(points.front(), 1));
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double x = way_on(points[i - 1], points[i], 0);
      const double y = way_on(points[i - 1], points[i], 1);
      go('L', value(points[i - 1], 0) + x, value(points[i - 1], 1) + y);
      const bool comes_in = value(points[i - 1], 0) + x != value(points[i], 0) ||
                            value(points[i - 1], 1) + y != value(points[i], 1);
      if (!comes_in) continue;
      go('M', value(points[i], 0) - x, value(points[i], 1) - y);
      go('L', value(points[i], 0), value(points[i], 1));
    }
    text_ += fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", path, style);
  }

  /// From one point to the next along an axis, the short way round.
  double way_on(const Point& a, const Point& b, std::size_t k) const {
    return way_to(axes_[k], a, b[axes_[k].coordinate]);
  }
  double way_to(const PictureAxis& axis, const Point& from, double to) const {
    const double off = to - from[axis.coordinate];
    if (!space_.parameter(axis.coordinate).cyclic) return off;
    return off > 180 ? off - 360 : off < -180 ? off + 360 : off;
  }

  void tree() {
    text_ += fmt::format("<g clip-path=\"url(#frame)\" stroke=\"{}\" stroke-width=\"0.6\">\n",
                         palette::kDrawing.muted);
    for (const auto& [from, to] : report_.tree) {
      line(space_.with_chords({space_.point(from), space_.point(to)}), "");
    }
    text_ += "</g>\n";
  }

  void way() {
    if (report_.way.empty()) return;
    std::vector<Point> points;
    for (const std::vector<double>& q : report_.way) points.push_back(space_.point(q));
    line(points, fmt::format("clip-path=\"url(#frame)\" stroke=\"{}\" stroke-width=\"2.4\"",
                             palette::kDrawing.bad));
  }

  /// Of a lattice over these two parameters: nodes below which none lies that a free leg leads to.
  void minima() {
    guides::FieldOnLattice field(space_, start_, goal_);
    const guides::Lattice& lattice = field.lattice();
    std::vector<guides::Lattice::Node> nodes = lattice.at_goal();
    std::set<guides::Lattice::Node> seen(nodes.begin(), nodes.end());
    for (std::size_t i = 0; i < nodes.size() && nodes.size() < kMostNodes; ++i) {
      const guides::Lattice::Node node = nodes[i];
      for (const guides::Lattice::Node& next : lattice.next_to(node)) {
        if (is_shown(lattice.point(next)) && seen.insert(next).second) nodes.push_back(next);
      }
      const double here = field.value(node);
      if (lattice.is_at_goal(node) || !std::isfinite(here) || field.below(node)) continue;
      ++minima_;
      const Point point = lattice.point(node);
      text_ += fmt::format(
          "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3.5\" fill=\"none\" stroke=\"{}\" "
          "stroke-width=\"1.6\"><title>{}</title></circle>\n",
          pixel_x(value(point, 0)), pixel_y(value(point, 1)), palette::kDrawing.bad,
          minimum_text(field.field().nearest(point)));
    }
  }

  static std::string minimum_text(const guides::Nearness& near) {
    if (!std::isfinite(near.distance)) return "minimum";
    return gantt::xml_text(
        fmt::format("minimum: {} is {:.2f} m from {}", near.moved, near.distance, near.met));
  }

  void mark(const Point& point, std::string_view fill, const char* name) {
    text_ += fmt::format(
        "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\" fill=\"{}\" stroke=\"#ffffff\"/>\n"
        "<text x=\"{:.2f}\" y=\"{:.2f}\" paint-order=\"stroke\" stroke=\"#ffffff\" "
        "stroke-width=\"3\">{}</text>\n",
        pixel_x(value(point, 0)), pixel_y(value(point, 1)), fill, pixel_x(value(point, 0)) + 8,
        pixel_y(value(point, 1)) - 6, name);
  }

  void frame(double width, double height) {
    const palette::Drawing& colours = palette::kDrawing;
    text_ += fmt::format(
        "<clipPath id=\"frame\"><rect x=\"{0}\" y=\"{1}\" width=\"{2:.2f}\" "
        "height=\"{3:.2f}\"/></clipPath>\n<rect x=\"{0}\" y=\"{1}\" width=\"{2:.2f}\" "
        "height=\"{3:.2f}\" fill=\"none\" stroke=\"{4}\"/>\n",
        kLeftMargin, kTopMargin, axes_[0].pixels, axes_[1].pixels, colours.line);
    ticks(0);
    ticks(1);
    const double below = kTopMargin + axes_[1].pixels;
    text_ +=
        fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">{}</text>\n",
                    kLeftMargin + axes_[0].pixels / 2, below + 36, gantt::xml_text(axes_[0].title));
    text_ += fmt::format(
        "<text transform=\"translate(14 {:.2f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
        kTopMargin + axes_[1].pixels / 2, gantt::xml_text(axes_[1].title));
    text_ += fmt::format("<text x=\"{}\" y=\"20\" font-weight=\"bold\">{}</text>\n", kLeftMargin,
                         gantt::xml_text(title()));
    text_ += fmt::format("<text x=\"{}\" y=\"36\" fill=\"{}\">{}</text>\n", kLeftMargin,
                         colours.muted, gantt::xml_text(legend()));
    const std::string others = others_text();
    if (!others.empty()) {
      text_ += fmt::format("<text x=\"{}\" y=\"{:.2f}\" fill=\"{}\">{}</text>\n", kLeftMargin,
                           height - 12, colours.muted, gantt::xml_text(others));
    }
    static_cast<void>(width);
  }

  std::string title() const {
    return fmt::format(
        "{}: {}", guides::full_name(spec_),
        report_.found()
            ? fmt::format("a way of {} waypoint{}, {:.1f} s", report_.way.size() - 1,
                          report_.way.size() == 2 ? "" : "s", report_.metrics.motion_time)
            : cause_);
  }

  std::string legend() const {
    if (spec_.kind == guides::GuideKind::potential && third_) {
      return "dark: forbidden; blue: the field; red: the way";
    }
    if (spec_.kind == guides::GuideKind::potential) {
      return fmt::format("dark: forbidden; blue: the field; rings: minima but the goal ({})",
                         minima_);
    }
    const std::string rings = third_
                                  ? fmt::format("; rings: where it is at that {}",
                                                space_.parameter(third_->coordinate).display_name)
                                  : "";
    return "dark: forbidden; thin: what was tried; red: the way" + rings;
  }

  /// What stands still in the picture.
  std::string others_text() const {
    std::string text;
    for (std::size_t i = 0; i < space_.size(); ++i) {
      if (i == axes_[0].coordinate || i == axes_[1].coordinate) continue;
      if (!layers_.empty() && i == third_->coordinate) continue;
      text += fmt::format("{}{} {:.4g}", text.empty() ? "forbidden with " : ", ",
                          space_.parameter(i).display_name, shown_[i]);
    }
    return text;
  }

  void ticks(std::size_t k) {
    const PictureAxis& axis = axes_[k];
    const double step = tick_step(axis.high - axis.low);
    for (double n = std::ceil(axis.low / step); n * step <= axis.high; ++n) {
      const double value = n * step;
      const double x = k == 0 ? pixel_x(value) : kLeftMargin;
      const double y = k == 0 ? kTopMargin + axes_[1].pixels : pixel_y(value);
      text_ += fmt::format("<path d=\"M{:.2f} {:.2f}{}\" stroke=\"{}\"/>\n", x, y,
                           k == 0 ? "v5" : "h-5", palette::kDrawing.line);
      text_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{:g}</text>\n",
                           k == 0 ? x : x - 8, k == 0 ? y + 18 : y + 4, k == 0 ? "middle" : "end",
                           value == 0 ? 0.0 : value);
    }
  }

  const robot::RobotModel& model_;
  guides::GuideSpec spec_;
  const guides::PlanReport& report_;
  std::string cause_;
  interpreter::WorldTests tests_;
  guides::Space space_;
  Point start_;
  Point goal_;
  Point shown_;  ///< has the values of what is on no axis
  std::array<PictureAxis, 2> axes_;
  std::optional<PictureAxis> third_;  ///< what a slider changes
  std::vector<double> layers_;        ///< its values, of a page; else none
  std::size_t shown_layer_ = 0;
  int columns_ = 0, rows_ = 0;  ///< of cells
  double highest_ = 0;
  int minima_ = 0;
  std::string text_;
};

}  // namespace

std::string guide_picture(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                          const std::string& task, const PictureQuery& query) {
  std::string svg;
  with_first_way(plan, sources, task, query.kind, [&](const FirstWay& way) {
    Picture picture(way);
    picture.choose_axes(query.axes);
    if (query.at && !picture.has_third()) {
      throw std::invalid_argument("--at is the value of a third parameter in --axes");
    }
    if (query.at) picture.stand_at(*query.at);
    svg = picture.svg();
  });
  return svg;
}

std::string guide_picture_page(const interpreter::PlanModel& plan,
                               const interpreter::SourceMap& sources, const std::string& task,
                               const PictureQuery& query) {
  std::string page;
  with_first_way(plan, sources, task, query.kind, [&](const FirstWay& way) {
    Picture picture(way);
    picture.choose_axes(query.axes);
    if (!picture.has_third()) {
      throw std::invalid_argument(
          "--page needs three parameters in --axes; the slider changes the third");
    }
    page = picture.page();
  });
  return page;
}

}  // namespace rubicon::comparison
