#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "src/motion/math/index.hpp"
#include "src/results/comparison/cover_way.hpp"
#include "src/results/palette/palette.hpp"

namespace rubicon::comparison {

namespace {

using coverage::CoverageWay;
using coverage::Place;
using math::at;

// Lengths of the sheet are pixels.
constexpr double kSheetWidth = 1120;
constexpr double kSheetMargin = 20;
constexpr double kPanelGap = 24;
constexpr double kHeading = 26;  ///< above each picture
constexpr double kMostPanelHeight = 700;
constexpr double kTitle = 40;

/// The steps of one way, drawn one beside the other, each in a panel of the same scale.
class StepsPicture {
 public:
  StepsPicture(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task)
      : area_(plan.areas[at(task.cover->area)].name),
        task_(task.name),
        cover_(*task.cover),
        way_(*cover_.way) {
    low_ = high_ = cover_.floor->outline.front();
    for (const Place& p : cover_.floor->outline) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    const double width = (kSheetWidth - 2 * kSheetMargin - kPanelGap) / 2;
    scale_ = std::min(width / (high_.x - low_.x), kMostPanelHeight / (high_.y - low_.y));
    width_ = width;
    height_ = scale_ * (high_.y - low_.y);
  }

  std::string draw() {
    if (cover_.holes > 0) {
      panel("Holes and the way between them", [&] { draw_holes(); });
    } else {
      if (!way_.hypergraph.pieces.empty()) {
        panel("Beams and edges, cut where they meet", [&] { draw_hypergraph(); });
      }
      panel(fmt::format("Cells: {}", way_.cells.size()), [&] { draw_cells(true); });
      panel("Which cells touch, and along what", [&] { draw_doors(); });
      panel("Order of the cells", [&] { draw_order(); });
      panel(fmt::format("Lines at work: {}", way_.lines.size()), [&] { draw_lines(); });
      panel(fmt::format("The way: {:.1f} m, travel dashed", cover_.length), [&] { draw_way(); });
    }
    const double rows = std::ceil(panels_ / 2.0);
    const double height =
        kTitle + rows * (kHeading + height_) + (rows - 1) * kPanelGap + kSheetMargin;
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
               "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\">\n"
               "<title>{2} covers {3}, step by step</title>\n"
               "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
               "<text x=\"{4:.0f}\" y=\"26\" font-size=\"17\" fill=\"{5}\">{2} covers "
               "{3}</text>\n",
               kSheetWidth, height, task_, area_, kSheetMargin, colours_.text) +
           text_ + "</svg>\n";
  }

 private:
  template <typename Draw>
  void panel(const std::string& heading, const Draw& draw_it) {
    const int column = panels_ % 2;
    const int row = panels_ / 2;
    left_ = kSheetMargin + column * (width_ + kPanelGap);
    top_ = kTitle + row * (kHeading + height_ + kPanelGap) + kHeading;
    ++panels_;
    text_ += fmt::format(
        "<g id=\"step_{}\">\n<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" fill=\"{}\">{}. "
        "{}</text>\n",
        panels_, left_, top_ - 9, colours_.text, panels_, heading);
    draw_floor();
    draw_things();
    draw_it();
    text_ += "</g>\n";
  }

  std::string point(const Place& p) const {
    return fmt::format("{:.1f} {:.1f}", left_ + scale_ * (p.x - low_.x),
                       top_ + scale_ * (high_.y - p.y));
  }
  std::string path(const std::vector<Place>& places, bool closed) const {
    std::string d;
    for (const Place& p : places) d += (d.empty() ? "M" : "L") + point(p);
    return closed ? d + "Z" : d;
  }
  void stroke(const std::string& d, std::string_view colour, double width,
              std::string_view more = {}) {
    text_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", d,
                         colour, width, more);
  }
  void fill(const std::string& d, std::string_view colour, std::string_view more = {}) {
    text_ += fmt::format("<path d=\"{}\" fill=\"{}\"{}/>\n", d, colour, more);
  }

  void draw_floor() {
    fill(path(cover_.floor->outline, true), colours_.panel,
         fmt::format(" stroke=\"{}\" stroke-width=\"1\"", colours_.muted));
  }
  /// Shafts and columns.
  void draw_things() {
    for (const auto& shaft : cover_.floor->shafts) {
      fill(path(shaft.corners, true), "#ffffff",
           fmt::format(" stroke=\"{}\" stroke-width=\"1\"", colours_.muted));
      if (shaft.corners.size() != 4) continue;
      for (const std::size_t i : {0u, 1u}) {
        stroke(path({shaft.corners[i], shaft.corners[i + 2]}, false), colours_.line, 1);
      }
    }
    for (const auto& column : cover_.floor->columns) {
      const double half = column.size / 2;
      const Place& c = column.centre;
      if (column.round) {
        text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>\n",
                             left_ + scale_ * (c.x - low_.x), top_ + scale_ * (high_.y - c.y),
                             scale_ * half, colours_.muted);
        continue;
      }
      fill(path({{c.x - half, c.y - half},
                 {c.x + half, c.y - half},
                 {c.x + half, c.y + half},
                 {c.x - half, c.y + half}},
                true),
           colours_.muted);
    }
  }

  void draw_hypergraph() {
    const coverage::Hypergraph& graph = way_.hypergraph;
    for (const coverage::BeamPiece& piece : graph.pieces) {
      stroke(path({coverage::metres(graph.nodes[at(piece.from)]),
                   coverage::metres(graph.nodes[at(piece.to)])},
                  false),
             piece.columns.empty() ? colours_.machines[0] : colours_.bad, 2);
    }
    for (const coverage::Point& node : graph.nodes) dot(coverage::metres(node), 3, colours_.text);
  }

  void dot(const Place& p, double radius, std::string_view colour) {
    text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n",
                         left_ + scale_ * (p.x - low_.x), top_ + scale_ * (high_.y - p.y), radius,
                         colour);
  }

  void draw_cells(bool strong) {
    for (const coverage::CoverageCell& cell : way_.cells) {
      fill(path(cell.outline, true), colours_.machines[0],
           fmt::format(" fill-opacity=\"{}\" stroke=\"{}\" stroke-width=\"{}\"",
                       strong ? 0.14 : 0.06, colours_.machines[0], strong ? 1.5 : 0.75));
    }
  }

  /// The centre of gravity of a cell.
  static Place middle_of(const coverage::CoverageCell& cell) {
    double area = 0, x = 0, y = 0;
    const Place& o = cell.outline.front();
    for (std::size_t i = 1; i + 1 < cell.outline.size(); ++i) {
      const Place& a = cell.outline[i];
      const Place& b = cell.outline[i + 1];
      const double part = (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
      area += part;
      x += part * (o.x + a.x + b.x) / 3;
      y += part * (o.y + a.y + b.y) / 3;
    }
    return area > 0 ? Place{x / area, y / area} : o;
  }

  void draw_doors() {
    draw_cells(false);
    for (const coverage::CoverageDoor& door : way_.doors) {
      const Place middle{(door.from.x + door.to.x) / 2, (door.from.y + door.to.y) / 2};
      const std::string_view colour = door.columns.empty() ? colours_.machines[2] : colours_.bad;
      stroke(path({middle_of(way_.cells[at(door.a)]), middle, middle_of(way_.cells[at(door.b)])},
                  false),
             colours_.muted, 1.2);
      stroke(path({door.from, door.to}, false), colour, 3);
    }
    for (const coverage::CoverageCell& cell : way_.cells) dot(middle_of(cell), 3, colours_.text);
  }

  void draw_order() {
    draw_cells(false);
    std::vector<Place> middles;
    for (const int cell : way_.order) middles.push_back(middle_of(way_.cells[at(cell)]));
    if (middles.size() > 1) stroke(path(middles, false), colours_.machines[1], 1.5);
    for (std::size_t i = 0; i < middles.size(); ++i) {
      dot(middles[i], 10, "#ffffff");
      text_ += fmt::format(
          "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" text-anchor=\"middle\" "
          "fill=\"{}\">{}</text>\n",
          left_ + scale_ * (middles[i].x - low_.x), top_ + scale_ * (high_.y - middles[i].y) + 4.5,
          colours_.text, i + 1);
    }
  }

  void draw_lines() {
    draw_cells(false);
    for (const coverage::CoverageLine& line : way_.lines) {
      stroke(path(line.points, false), line.is_pass ? colours_.machines[2] : colours_.machines[1],
             1.5);
    }
  }

  void draw_way() {
    std::string working, travelling;
    for (std::size_t i = 1; i < way_.points.size(); ++i) {
      (way_.points[i].working ? working : travelling) +=
          path({way_.points[i - 1].place, way_.points[i].place}, false);
    }
    stroke(working, colours_.machines[1], 1.2);
    stroke(travelling, colours_.bad, 1.5, " stroke-dasharray=\"4 3\"");
    ends();
  }
  void ends() {
    if (way_.points.empty()) return;
    dot(way_.points.front().place, 5, colours_.crew);
    dot(way_.points.back().place, 5, colours_.text);
  }

  void draw_holes() {
    std::vector<Place> places;
    for (const coverage::WayPoint& each : way_.points) places.push_back(each.place);
    stroke(path(places, false), colours_.bad, 1);
    for (const coverage::CoverageLine& hole : way_.lines) {
      dot(hole.points.front(), 3, colours_.text);
    }
    ends();
  }

  std::string area_, task_;
  const interpreter::CoverSpec& cover_;
  const CoverageWay& way_;
  const palette::Drawing& colours_ = palette::kDrawing;
  Place low_, high_;
  double scale_ = 1, width_ = 0, height_ = 0;
  double left_ = 0, top_ = 0;
  int panels_ = 0;
  std::string text_;
};

}  // namespace

std::string cover_steps_svg(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task) {
  return StepsPicture(plan, task).draw();
}

}  // namespace rubicon::comparison
