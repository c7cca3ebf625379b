#include "src/exchange/mesh_io/near_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

namespace rubicon::mesh_io {

namespace {

using math::Vec3;

/// Corners farther from the origin than this many times their extent are far out. A file has no
/// unit here; what single precision loses of such a mesh is a hundred thousandth of its size.
constexpr double kFarByExtent = 100;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// A line that gives a corner: what stands before its numbers and behind them.
struct Corner {
  Vec3 p = Vec3::Zero();
  std::string_view head, tail;
};

enum class LineKind { corner, other, broken };

LineKind read_line(std::string_view line, std::string_view word, Corner& corner) {
  std::size_t at = 0;
  while (at < line.size() && is_blank(line[at])) ++at;
  const bool is_corner = line.substr(at, word.size()) == word && at + word.size() < line.size() &&
                         is_blank(line[at + word.size()]);
  if (!is_corner) return LineKind::other;
  at += word.size();
  corner.head = line.substr(0, at);
  for (int k = 0; k < 3; ++k) {
    while (at < line.size() && is_blank(line[at])) ++at;
    if (at < line.size() && line[at] == '+') ++at;
    const auto [end, error] =
        std::from_chars(line.data() + at, line.data() + line.size(), corner.p[k]);
    if (error != std::errc() || !std::isfinite(corner.p[k])) return LineKind::broken;
    at = static_cast<std::size_t>(end - line.data());
  }
  corner.tail = line.substr(at);
  const bool ends =
      corner.tail.empty() || is_blank(corner.tail.front()) || corner.tail.front() == '\r';
  return ends ? LineKind::corner : LineKind::broken;
}

/// Calls `take` for each line with its kind; false from it ends the walk.
template <class Take>
bool walk(std::string_view text, std::string_view word, const Take& take) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    Corner corner;
    const LineKind kind = read_line(line, word, corner);
    if (!take(kind, line, corner)) return false;
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return true;
}

}  // namespace

std::optional<NearText> move_near(std::string_view text, std::string_view word) {
  Vec3 low = Vec3::Constant(HUGE_VAL);
  Vec3 high = -low;
  const bool sound = walk(text, word, [&](LineKind kind, std::string_view, const Corner& corner) {
    if (kind == LineKind::corner) {
      low = low.cwiseMin(corner.p);
      high = high.cwiseMax(corner.p);
    }
    return kind != LineKind::broken;
  });
  const double extent = (high - low).maxCoeff();
  const Vec3 middle = (low + high) / 2;
  if (!sound || !(extent > 0) || !(middle.cwiseAbs().maxCoeff() > kFarByExtent * extent)) {
    return std::nullopt;
  }
  NearText moved;
  // Whole numbers, so that taking them off is exact.
  moved.origin = middle.array().round().matrix();
  moved.text.reserve(text.size());
  walk(text, word, [&](LineKind kind, std::string_view line, const Corner& corner) {
    if (kind == LineKind::corner) {
      const Vec3 p = corner.p - moved.origin;
      fmt::format_to(std::back_inserter(moved.text), "{} {} {} {}{}\n", corner.head, p.x(), p.y(),
                     p.z(), corner.tail);
    } else {
      moved.text += line;
      moved.text += '\n';
    }
    return true;
  });
  return moved;
}

}  // namespace rubicon::mesh_io
