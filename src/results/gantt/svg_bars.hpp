#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/results/gantt/chart.hpp"

namespace rubicon::gantt {

/// Writes what stands in lanes as SVG. Lengths are pixels, y runs down.
class SvgBars {
 public:
  /// `end` is where time ends; above 0.
  explicit SvgBars(Ticks end) : end_(end) {}

  double x_of(Ticks time) const;

  /// Bars with their parts, outlines and titles.
  std::string bars(const std::vector<Bar>& bars, double top, double height) const;
  /// The names of bars in the room that they have; of many narrow ones those of their places.
  std::string labels(const std::vector<Bar>& bars, double y) const;
  /// The data of a path round each span.
  std::string boxes(const std::vector<Span>& spans, double top, double height) const;

 private:
  /// Bars that share a label: one bar, or the bars of one place where one has no room.
  struct Labelled {
    std::string name;
    double from = 0;
    double to = 0;
  };

  std::string box(const Span& span, double top, double height) const;
  std::string filled(const std::vector<Span>& spans, std::string_view colour, double top,
                     double height) const;
  std::vector<Span> widened(std::vector<Span> spans) const;
  std::string edges(const std::vector<Bar>& bars, double top, double height) const;
  std::string critical(const std::vector<Bar>& bars, double top, double height) const;
  std::string milestones(const std::vector<Bar>& bars, double top, double height) const;
  std::string outline(const Span& span, double top, double height) const;
  std::string titles(const std::vector<Bar>& bars, double top, double height) const;
  std::vector<Labelled> labelled(const std::vector<Bar>& bars, bool of_places) const;

  Ticks end_;
};

}  // namespace rubicon::gantt
