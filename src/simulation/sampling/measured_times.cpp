#include "src/simulation/sampling/measured_times.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace rubicon::sampling {

namespace {

/// A field of a line, without blanks and quotes round it, and where it stands in the text.
struct TableField {
  std::string_view text;
  std::size_t at = 0;
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

TableField trimmed(TableField field) {
  while (!field.text.empty() && is_blank(field.text.front())) {
    field.text.remove_prefix(1);
    ++field.at;
  }
  while (!field.text.empty() && is_blank(field.text.back())) field.text.remove_suffix(1);
  return field;
}

TableField unquoted(TableField field) {
  field = trimmed(field);
  if (field.text.size() < 2 || field.text.front() != '"' || field.text.back() != '"') return field;
  return trimmed({field.text.substr(1, field.text.size() - 2), field.at + 1});
}

void split(std::string_view line, std::size_t at, char separator, std::vector<TableField>& fields) {
  fields.clear();
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (line[i] != separator || quoted)) continue;
    fields.push_back(unquoted({line.substr(begin, i - begin), at + begin}));
    begin = i + 1;
  }
}

std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = end == text.data() + text.size();
  if (whole && error == std::errc::result_out_of_range) return HUGE_VAL;
  return whole && error == std::errc() ? std::optional(value) : std::nullopt;
}

/// What was found, short enough for a message and without what is not printed.
std::string shown(std::string_view text) {
  constexpr std::size_t kMost = 20;
  std::string result;
  for (const char c : text.substr(0, kMost)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte >= 0x7f ? '?' : c;
  }
  return text.size() > kMost ? result + "..." : result;
}

class TableReader {
 public:
  TableReader(std::string_view text, const MeasuredColumn& wanted) : text_(text), wanted_(wanted) {}

  std::variant<MeasuredTimes, MeasuredFault> run() {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // a mark of UTF-8
    bool is_first = true;
    while (at_ < text_.size() && !fault_) {
      const std::size_t begin = at_;
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      at_ = end + 1;
      const TableField line = trimmed({text_.substr(begin, end - begin), begin});
      if (line.text.empty() || line.text.front() == '#') continue;
      // Blanks at the ends may be empty fields.
      std::string_view whole = text_.substr(begin, end - begin);
      if (whole.ends_with('\r')) whole.remove_suffix(1);
      if (is_first) set_separator(whole);
      split(whole, begin, separator_, fields_);
      if (is_first && !take_first(line)) break;
      if (is_first) columns_ = fields_.size();
      if (!(is_first && has_heading_)) take_line(line);
      is_first = false;
    }
    if (!fault_ && result_.times.empty()) {
      fail({text_.substr(0, 0), 0}, "there is no time in this file",
           "one time a line, such as 12.5");
    }
    if (fault_) return *std::move(fault_);
    finish();
    return std::move(result_);
  }

 private:
  void fail(const TableField& place, std::string message, std::string hint = {}) {
    if (!fault_)
      fault_ = {place.at, place.at + place.text.size(), std::move(message), std::move(hint)};
  }

  void set_separator(std::string_view line) {
    for (const char each : {';', '\t', ','}) {
      if (line.find(each) == std::string_view::npos) continue;
      separator_ = each;
      return;
    }
  }

  /// Finds the column; whether the line is a heading.
  bool take_first(const TableField& line) {
    if (wanted_.name) {
      const auto found = std::find_if(fields_.begin(), fields_.end(), [&](const TableField& each) {
        return each.text == *wanted_.name;
      });
      if (found == fields_.end()) {
        std::string names;
        for (std::size_t i = 0; i < fields_.size() && i < 10; ++i) {
          names += (i == 0 ? "" : ", ") + shown(fields_[i].text);
        }
        fail(line,
             "there is no column '" + shown(*wanted_.name) + "'; the first line has: " + names);
        for (const TableField& each : fields_) fault_->headings.push_back(shown(each.text));
        return false;
      }
      column_ = static_cast<std::size_t>(found - fields_.begin());
      const bool again = std::any_of(found + 1, fields_.end(), [&](const TableField& each) {
        return each.text == *wanted_.name;
      });
      if (again) {
        fail(line, "two columns are called '" + shown(*wanted_.name) + "'", "give its number");
        return false;
      }
      has_heading_ = true;
      return true;
    }
    column_ = static_cast<std::size_t>(wanted_.number.value_or(1) - 1);
    if (column_ >= fields_.size()) {
      fail(line, "there is no column " + std::to_string(column_ + 1) + "; the first line has " +
                     std::to_string(fields_.size()));
      return false;
    }
    const std::string_view text = fields_[column_].text;
    has_heading_ = !text.empty() && !number_of(text) && begins_like_a_name(text);
    return true;
  }

  /// A heading, and no number that is misspelt.
  static bool begins_like_a_name(std::string_view text) {
    return !(text.front() >= '0' && text.front() <= '9') && text.front() != '-' &&
           text.front() != '+' && text.front() != '.' && text != "nan" && text != "NaN" &&
           text != "inf";
  }

  void take_line(const TableField& line) {
    const bool chosen = wanted_.name || wanted_.number;
    if (!chosen && fields_.size() > 1) {
      const bool comma = separator_ == ',' && fields_.size() == 2;
      fail(line, "this line has " + std::to_string(fields_.size()) + " fields; expected one time",
           comma ? "column 1 or column \"NAME\" says which; a decimal point is a point"
                 : "column 1 or column \"NAME\" says which");
      return;
    }
    // A decimal comma cuts a number in two, which makes one field more than there are columns.
    while (fields_.size() > columns_ && fields_.back().text.empty()) fields_.pop_back();
    if (separator_ == ',' && fields_.size() > columns_) {
      fail(line,
           "this line has " + std::to_string(fields_.size()) + " fields, the first line has " +
               std::to_string(columns_),
           "a decimal point is a point: 2.5");
      return;
    }
    if (column_ >= fields_.size() || fields_[column_].text.empty()) return;  // nothing was measured
    const TableField& field = fields_[column_];
    const std::optional<double> value = number_of(field.text);
    if (!value || std::isnan(*value)) {
      const bool comma = field.text.find(',') != std::string_view::npos;
      fail(field, "expected a time, found '" + shown(field.text) + "'",
           comma ? "a decimal point is a point: 2.5" : "");
      return;
    }
    if (*value < 0) {
      fail(field, "a time is not below 0, found " + shown(field.text));
      return;
    }
    const double seconds = *value * wanted_.seconds_per_unit;
    if (!(seconds <= kLongestMeasured)) {
      fail(field, "a time is up to 126 years, found " + shown(field.text));
      return;
    }
    if (result_.times.size() == kMostMeasured) {
      fail(field, "there are more than " + std::to_string(kMostMeasured) + " times");
      return;
    }
    result_.times.push_back(seconds);
  }

  void finish() {
    result_.column = static_cast<int>(column_) + 1;
    double sum = 0;
    for (const double each : result_.times) sum += each;
    result_.mean = sum / static_cast<double>(result_.times.size());
    const auto [least, most] = std::minmax_element(result_.times.begin(), result_.times.end());
    result_.least = *least;
    result_.most = *most;
  }

  std::string_view text_;
  const MeasuredColumn& wanted_;
  std::size_t at_ = 0;
  char separator_ = ',';
  std::size_t column_ = 0;
  std::size_t columns_ = 0;  ///< of the first line
  bool has_heading_ = false;
  std::vector<TableField> fields_;
  MeasuredTimes result_;
  std::optional<MeasuredFault> fault_;
};

}  // namespace

std::variant<MeasuredTimes, MeasuredFault> read_measured(std::string_view text,
                                                         const MeasuredColumn& column) {
  return TableReader(text, column).run();
}

}  // namespace rubicon::sampling
