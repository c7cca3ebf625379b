#include "src/fleets/grid/grid_map.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace rubicon::grid {

namespace {

/// Most characters of the text that a message repeats.
constexpr std::size_t kShown = 24;

/// The lines of a text, without their ends; "\r\n" too.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  std::optional<std::string_view> next() {
    if (at_ >= text_.size()) return std::nullopt;
    begin_ = at_;
    std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) end = text_.size();
    at_ = end + 1;
    if (end > begin_ && text_[end - 1] == '\r') --end;
    end_ = end;
    return text_.substr(begin_, end - begin_);
  }
  std::size_t begin() const { return begin_; }
  std::size_t end() const { return end_; }
  std::size_t size() const { return text_.size(); }

 private:
  std::string_view text_;
  std::size_t at_ = 0, begin_ = 0, end_ = 0;
};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The next word of `text`, which loses it.
std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  std::size_t end = 0;
  while (end < text.size() && !is_blank(text[end])) ++end;
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end);
  return word;
}

/// What a message shows of a text of strangers.
std::string shown(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, kShown)) result += c >= ' ' && c <= '~' ? c : '?';
  if (text.size() > kShown) result += "...";
  return "'" + result + "'";
}

std::optional<std::int64_t> whole_number(std::string_view word) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

bool is_open_terrain(char c) { return c == '.' || c == 'G' || c == 'S'; }
bool is_wall(char c) { return c == '@' || c == 'O' || c == 'T' || c == 'W'; }

class MapReader {
 public:
  explicit MapReader(std::string_view text) : lines_(text) {}

  std::variant<GridMap, TextFault> read() {
    if (!read_head() || !read_rows()) return std::move(fault_);
    return std::move(map_);
  }

 private:
  bool wrong(std::string message, std::string hint = {}) {
    fault_ = {lines_.begin(), lines_.end(), std::move(message), std::move(hint)};
    return false;
  }
  bool ends(std::string message) {
    fault_ = {lines_.size(), lines_.size(), std::move(message), "is the file cut off?"};
    return false;
  }

  bool read_head() {
    bool has_type = false;
    while (const auto line = lines_.next()) {
      std::string_view rest = *line;
      const std::string_view key = take_word(rest);
      if (key.empty()) continue;
      if (key == "map" && has_type) {
        if (map_.rows == 0 || map_.columns == 0) return wrong("map comes after height and width");
        const std::int64_t cells = std::int64_t{map_.rows} * map_.columns;
        if (cells <= kMostCells) return true;
        return wrong(fmt::format("a map of {} x {} cells; expected up to {} cells", map_.columns,
                                 map_.rows, kMostCells));
      }
      if (key == "type" && !has_type) {
        has_type = true;
      } else if (has_type && (key == "height" || key == "width")) {
        if (!read_size(key, rest)) return false;
      } else {
        return wrong(
            fmt::format("expected {}, found {}",
                        has_type ? "height, width or map" : "'type octile'", shown(*line)),
            "a map of the MovingAI format begins with type octile, height N, width N, map");
      }
    }
    return ends("the map ends before its rows");
  }

  bool read_size(std::string_view key, std::string_view rest) {
    const auto value = whole_number(trimmed(rest));
    if (!value || *value < 1 || *value > kMostCells) {
      return wrong(fmt::format("the {} of a map is a whole number of 1 to {}, found {}", key,
                               kMostCells, shown(trimmed(rest))));
    }
    (key == "height" ? map_.rows : map_.columns) = static_cast<int>(*value);
    return true;
  }

  bool read_rows() {
    const auto columns = static_cast<std::size_t>(map_.columns);
    for (int row = 0; row < map_.rows; ++row) {
      const auto line = lines_.next();
      if (!line) {
        return ends(fmt::format("the map ends after {} of {} rows", row, map_.rows));
      }
      if (line->size() != columns) {
        return wrong(fmt::format("row {} has {} cells; expected {}", row, line->size(), columns));
      }
      for (std::size_t column = 0; column < columns; ++column) {
        const char terrain = (*line)[column];
        if (is_open_terrain(terrain) || is_wall(terrain)) {
          map_.open.push_back(is_wall(terrain) ? 0 : 1);
          continue;
        }
        wrong(fmt::format("unknown terrain {}", shown(std::string_view(&terrain, 1))),
              "'.', 'G' and 'S' are open; '@', 'O', 'T' and 'W' are walls");
        fault_.begin += column;
        fault_.end = fault_.begin + 1;
        return false;
      }
    }
    while (const auto line = lines_.next()) {
      if (!trimmed(*line).empty()) {
        return wrong(fmt::format("the map has {} rows, and more follow", map_.rows));
      }
    }
    return true;
  }

  Lines lines_;
  GridMap map_;
  TextFault fault_;
};

}  // namespace

std::variant<GridMap, TextFault> read_map(std::string_view text) { return MapReader(text).read(); }

std::variant<std::vector<Trip>, TextFault> read_scenario(std::string_view text, const GridMap& map,
                                                         std::size_t most) {
  Lines lines(text);
  const auto fault = [&](std::string message, std::string hint = {}) {
    return TextFault{lines.begin(), lines.end(), std::move(message), std::move(hint)};
  };
  const auto head = lines.next();
  std::string_view rest = head.value_or("");
  if (take_word(rest) != "version") {
    return fault(fmt::format("expected 'version 1', found {}", shown(head.value_or(""))),
                 "a scenario of the MovingAI format begins with version 1");
  }
  constexpr const char* kNames[] = {"the width of the map", "the height of the map",
                                    "the start x",          "the start y",
                                    "the goal x",           "the goal y"};
  std::vector<Trip> trips;
  while (trips.size() < most) {
    const auto line = lines.next();
    if (!line) break;
    rest = *line;
    if (trimmed(rest).empty()) continue;
    take_word(rest);  // the bucket
    take_word(rest);  // the map
    std::int64_t values[6] = {};
    for (std::size_t i = 0; i < 6; ++i) {
      const std::string_view word = take_word(rest);
      const auto value = whole_number(word);
      if (!value || *value < 0 || *value > kMostCells) {
        return fault(fmt::format("expected {}, found {}", kNames[i], shown(word)),
                     "a line has bucket, map, width, height, start x, start y, goal x, goal y, "
                     "length");
      }
      values[i] = *value;
    }
    if (values[0] != map.columns || values[1] != map.rows) {
      return fault(fmt::format("a trip on a map of {} x {} cells; this one has {} x {}", values[0],
                               values[1], map.columns, map.rows));
    }
    trips.push_back({{static_cast<int>(values[2]), static_cast<int>(values[3])},
                     {static_cast<int>(values[4]), static_cast<int>(values[5])},
                     lines.begin(),
                     lines.end()});
  }
  return trips;
}

}  // namespace rubicon::grid
