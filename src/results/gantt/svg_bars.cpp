#include "src/results/gantt/svg_bars.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/results/gantt/svg_style.hpp"
#include "src/results/gantt/svg_text.hpp"

namespace rubicon::gantt {

namespace {

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

/// Half the width of the diamond of a milestone beside bars of a height.
double half_diamond(double height) { return height * 0.55; }

std::vector<Span> spans_of(const std::vector<Bar>& bars, Part::Kind kind) {
  std::vector<Span> spans;
  for (const Bar& bar : bars) {
    for (const Part& part : bar.parts) {
      if (part.kind == kind) spans.push_back(part.span);
    }
  }
  return spans;
}

/// Height of the line of a baseline, right below its bar.
constexpr double kBaseline = 2;

std::vector<Span> baselines_of(const std::vector<Bar>& bars) {
  std::vector<Span> spans;
  for (const Bar& bar : bars) {
    if (bar.baseline) spans.push_back(*bar.baseline);
  }
  return spans;
}

void add_active(std::vector<Span>& spans, const Part& part) {
  if (part.kind != Part::Kind::motion && part.kind != Part::Kind::work) return;
  if (!spans.empty() && spans.back().to == part.span.from) {
    spans.back().to = part.span.to;
  } else {
    spans.push_back(part.span);
  }
}

/// Where something goes on, motion or work, in bars with motion or in those without; what
/// touches is one. Work is drawn over it: were both drawn side by side, thin ones would let the
/// paper show through.
std::vector<Span> active_spans(const std::vector<Bar>& bars, bool with_motion) {
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

}  // namespace

double SvgBars::x_of(Ticks time) const {
  return kLeft + kPlot * (static_cast<double>(time) / static_cast<double>(end_));
}

std::string SvgBars::box(const Span& span, double top, double height) const {
  const std::string width = length_text(x_of(span.to) - x_of(span.from));
  return fmt::format("M{} {}h{}v{}h-{}z", length_text(x_of(span.from)), length_text(top), width,
                     length_text(height), width);
}

std::string SvgBars::boxes(const std::vector<Span>& spans, double top, double height) const {
  std::string path;
  for (const Span& span : spans) path += box(span, top, height);
  return path;
}

std::string SvgBars::bars(const std::vector<Bar>& bars, double top, double height) const {
  using Kind = Part::Kind;
  return filled(widened(active_spans(bars, true)), kColours.machine, top, height) +
         filled(widened(active_spans(bars, false)), kColours.crew, top, height) +
         filled(spans_of(bars, Kind::work), kColours.crew, top, height) +
         filled(spans_of(bars, Kind::wait), kColours.wait, top + height / 5, height * 3 / 5) +
         filled(spans_of(bars, Kind::off), kColours.line, top + height * 2 / 5, height / 5) +
         filled(widened(baselines_of(bars)), kColours.muted, top + height, kBaseline) +
         edges(bars, top, height) + critical(bars, top, height) + milestones(bars, top, height) +
         titles(bars, top, height);
}

/// The same, each at least so wide that it is seen.
std::vector<Span> SvgBars::widened(std::vector<Span> spans) const {
  const auto least = static_cast<Ticks>(static_cast<double>(end_) * (kLeastWidth / kPlot));
  for (Span& span : spans) span.to = std::max(span.to, span.from + least);
  return spans;
}

std::string SvgBars::filled(const std::vector<Span>& spans, std::string_view colour, double top,
                            double height) const {
  if (spans.empty()) return {};
  return fmt::format("<path d=\"{}\" fill=\"{}\" shape-rendering=\"crispEdges\"/>\n",
                     boxes(spans, top, height), colour);
}

/// Thin lines between bars that touch.
std::string SvgBars::edges(const std::vector<Bar>& bars, double top, double height) const {
  std::string path;
  for (const Bar& bar : bars) {
    const double x = x_of(bar.span.from);
    if (x_of(bar.span.to) - x < kLeastOutlined) continue;
    path += fmt::format("M{} {}v{}", length_text(x), length_text(top), length_text(height));
  }
  if (path.empty()) return {};
  return fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"0.8\"/>\n", path, kColours.panel);
}

/// Outlines round what goes on in critical bars.
std::string SvgBars::critical(const std::vector<Bar>& bars, double top, double height) const {
  std::string path;
  for (const Bar& bar : bars) {
    if (!bar.critical) continue;
    std::vector<Span> spans;
    for (const Part& part : bar.parts) add_active(spans, part);
    for (const Span& span : spans) path += outline(span, top, height);
  }
  if (path.empty()) return {};
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>\n", path,
                     kColours.critical);
}

/// A box, or where there is no room for one, lines above and below.
std::string SvgBars::outline(const Span& span, double top, double height) const {
  if (x_of(span.to) - x_of(span.from) >= kLeastOutlined) return box(span, top, height);
  const std::string x = length_text(x_of(span.from));
  const std::string width = length_text(x_of(span.to) - x_of(span.from));
  return fmt::format("M{} {}h{}M{} {}h{}", x, length_text(top), width, x, length_text(top + height),
                     width);
}

/// Diamonds where something is done that takes no time.
std::string SvgBars::milestones(const std::vector<Bar>& bars, double top, double height) const {
  const double half = half_diamond(height);
  const auto diamonds = [&](bool critical) {
    std::string path;
    for (const Bar& bar : bars) {
      if (bar.span.to > bar.span.from || bar.critical != critical) continue;
      path += fmt::format("M{} {}l{h} {h}l-{h} {h}l-{h} -{h}z", length_text(x_of(bar.span.from)),
                          length_text(top + height / 2 - half), fmt::arg("h", length_text(half)));
    }
    return path;
  };
  std::string drawn;
  if (const std::string path = diamonds(false); !path.empty()) {
    drawn += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path, kColours.text);
  }
  if (const std::string path = diamonds(true); !path.empty()) {
    drawn += fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"/>\n", path,
                         kColours.text, kColours.critical);
  }
  return drawn;
}

std::string SvgBars::titles(const std::vector<Bar>& bars, double top, double height) const {
  std::string titles;
  for (const Bar& bar : bars) {
    double from = x_of(bar.span.from);
    double width = x_of(bar.span.to) - from;
    if (bars.size() > kMostTitles && width < 1) continue;
    if (width <= 0) {
      from -= half_diamond(height);
      width = 2 * half_diamond(height);
    }
    titles +=
        fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"><title>{}</title></rect>\n",
                    length_text(from), length_text(top), length_text(width), length_text(height),
                    xml_text(bar.text));
  }
  if (titles.empty()) return {};
  return "<g fill=\"none\" pointer-events=\"all\">\n" + titles + "</g>\n";
}

std::vector<SvgBars::Labelled> SvgBars::labelled(const std::vector<Bar>& bars,
                                                 bool of_places) const {
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

std::string SvgBars::labels(const std::vector<Bar>& bars, double y) const {
  std::vector<Labelled> labels = labelled(bars, false);
  const auto narrow = std::count_if(labels.begin(), labels.end(), [](const Labelled& label) {
    return label.to - label.from < kLeastLabel;
  });
  if (2 * narrow > static_cast<std::ptrdiff_t>(labels.size())) labels = labelled(bars, true);
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
  if (texts.empty()) return {};
  return fmt::format("<g font-size=\"{}\" fill=\"{}\">\n{}</g>\n", length_text(kSmallSize),
                     kColours.text, texts);
}

}  // namespace rubicon::gantt
