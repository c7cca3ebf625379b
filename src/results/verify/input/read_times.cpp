#include "src/results/verify/input/read_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace rubicon::verify {

namespace {

/// The field of a line, without quotes and blanks round it; "" where the line ends before.
std::string field_of(const std::string& line, char separator, int column) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == separator && !quoted) {
      fields.emplace_back();
    } else if (c != '"') {
      fields.back() += c;
    }
  }
  if (column > static_cast<int>(fields.size())) return {};
  const std::string& text = fields[static_cast<std::size_t>(column - 1)];
  const std::size_t from = text.find_first_not_of(" \t\r");
  if (from == std::string::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

SceneTimes read(const SceneFile& file, const std::string& unit, int column) {
  SceneTimes result{file.path, unit, column, {}, 0};
  const double seconds = unit == "s" ? 1 : unit == "min" ? 60 : unit == "h" ? 3600 : -1;
  if (seconds < 0) throw UnreadableInput(fmt::format("expected s, min or h, found '{}'", unit));
  std::istringstream lines(file.text.starts_with("\xEF\xBB\xBF") ? file.text.substr(3) : file.text);
  std::string line;
  char separator = 0;
  bool is_heading = false;
  while (std::getline(lines, line)) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    if (separator == 0) {
      separator = line.find(';') != std::string::npos    ? ';'
                  : line.find('\t') != std::string::npos ? '\t'
                                                         : ',';
      is_heading = true;
    }
    const std::string text = field_of(line, separator, column);
    if (!text.empty()) {
      double value = -1;
      const char* const begin = text.c_str() + (text.front() == '+' ? 1 : 0);
      const char* const end = text.c_str() + text.size();
      const auto [last, error] = std::from_chars(begin, end, value);
      if (error == std::errc() && last == end && std::isfinite(value) && value >= 0) {
        result.times.push_back(value * seconds);
      } else if (!is_heading) {
        throw UnreadableInput(fmt::format("'{}' has '{}' for a time", file.path, text));
      }
    }
    is_heading = false;
  }
  if (result.times.empty()) throw UnreadableInput(fmt::format("'{}' has no times", file.path));
  std::sort(result.times.begin(), result.times.end());
  long double sum = 0;
  for (const double each : result.times) sum += each;
  result.mean = static_cast<double>(sum / static_cast<long double>(result.times.size()));
  return result;
}

}  // namespace

int times_of(Scene& scene, const std::string& file, const std::string& unit, int column) {
  for (std::size_t i = 0; i < scene.times.size(); ++i) {
    const SceneTimes& each = scene.times[i];
    if (each.file == file && each.unit == unit && each.column == column) return static_cast<int>(i);
  }
  for (const SceneFile& each : scene.files) {
    if (each.path != file) continue;
    scene.times.push_back(read(each, unit, column));
    return static_cast<int>(scene.times.size()) - 1;
  }
  throw UnreadableInput(fmt::format("expected the text of '{}' among the files", file));
}

bool was_measured(const SceneTimes& times, double seconds) {
  const double slack = 1e-9 * std::fmax(1, seconds);
  const auto next = std::lower_bound(times.times.begin(), times.times.end(), seconds - slack);
  return next != times.times.end() && *next <= seconds + slack;
}

}  // namespace rubicon::verify
