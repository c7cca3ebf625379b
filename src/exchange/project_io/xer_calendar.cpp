#include "src/exchange/project_io/xer_calendar.hpp"

#include <charconv>
#include <string>

#include "src/exchange/project_io/dates.hpp"
#include "src/exchange/project_io/value_text.hpp"
#include "src/simulation/schedule/civil_time.hpp"

namespace rubicon::project_io {

namespace {

/// Deepest tree that is read; real ones have five levels.
constexpr int kMaxDepth = 16;

struct Node {
  std::string_view name;
  std::string_view values;  ///< "s|08:00|f|16:00"
  std::vector<Node> children;
};

class TreeReader {
 public:
  explicit TreeReader(std::string_view text) : text_(text) {}

  bool read(Node& root) { return read_node(root, 0); }

 private:
  void skip_blank() {
    // Line ends inside a cell are written as 0x7f.
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\x7f' || text_[at_] == '\r' ||
                                  text_[at_] == '\n')) {
      ++at_;
    }
  }

  bool take(char c) {
    skip_blank();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  bool at(char c) {
    skip_blank();
    return at_ < text_.size() && text_[at_] == c;
  }

  std::string_view until(std::string_view stops) {
    const std::size_t end = std::min(text_.find_first_of(stops, at_), text_.size());
    const std::string_view result = text_.substr(at_, end - at_);
    at_ = end;
    return result;
  }

  bool read_node(Node& node, int depth) {
    if (depth > kMaxDepth || !take('(')) return false;
    until("|");
    if (!take('|') || !take('|')) return false;
    node.name = until("()");
    if (!take('(')) return false;
    node.values = until("()");
    if (!take(')') || !take('(')) return false;
    while (at('(')) {
      node.children.emplace_back();
      if (!read_node(node.children.back(), depth + 1)) return false;
    }
    return take(')') && take(')');
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The value behind a key of "s|08:00|f|16:00"; empty if it is not there.
std::string_view value_of(std::string_view values, std::string_view key) {
  while (!values.empty()) {
    const std::size_t bar = values.find('|');
    const std::string_view word = values.substr(0, bar);
    values = bar == std::string_view::npos ? "" : values.substr(bar + 1);
    const std::size_t end = values.find('|');
    if (word == key) return values.substr(0, end);
    values = end == std::string_view::npos ? "" : values.substr(end + 1);
  }
  return {};
}

std::optional<int> minutes(std::string_view text) {
  return text.size() == 4 ? schedule::parse_minute_of_day("0" + std::string(text))
                          : schedule::parse_minute_of_day(text);
}

bool read_times(const Node& day, DayTimes& times) {
  bool good = true;
  for (const Node& shift : day.children) {
    const auto from = minutes(value_of(shift.values, "s"));
    auto to = minutes(value_of(shift.values, "f"));
    if (to == 0) to = 24 * 60;
    if (from && to && *from < *to) {
      times.push_back({*from, *to});
    } else {
      good = false;
    }
  }
  times = tidy(std::move(times));
  return good;
}

}  // namespace

bool read_xer_calendar(std::string_view data, Calendar& calendar) {
  Node root;
  bool good = TreeReader(data).read(root);
  for (const Node& part : root.children) {
    for (const Node& day : part.children) {
      DayTimes times;
      if (part.name == "DaysOfWeek") {
        good = read_times(day, times) && good;
        if (day.name.size() != 1 || day.name[0] < '1' || day.name[0] > '7') {
          good = false;
          continue;
        }
        calendar.week[static_cast<std::size_t>((day.name[0] - '1' + 6) % 7)] = std::move(times);
      } else if (part.name == "Exceptions") {
        good = read_times(day, times) && good;
        constexpr int kSpreadsheetEpoch = -25569;  // 1899-12-30
        constexpr int kLastDay = 2958465;          // 9999-12-31
        const std::string_view text = value_of(day.values, "d");
        int number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc() || end != text.data() + text.size() || number < 1 ||
            number > kLastDay) {
          good = false;
          continue;
        }
        const std::string date = date_text(number + kSpreadsheetEpoch);
        calendar.exceptions.push_back({date, date, std::move(times), ""});
      }
    }
  }
  return good;
}

}  // namespace rubicon::project_io
