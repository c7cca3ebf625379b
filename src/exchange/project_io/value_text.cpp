#include "src/exchange/project_io/value_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "src/simulation/schedule/civil_time.hpp"

namespace rubicon::project_io {

namespace {

/// Largest whole number that is read: still exact as a double, and sums of many stay in 64 bits.
constexpr std::int64_t kMaxWhole = std::int64_t{1} << 52;
/// Longest duration, in seconds: 300 years. Longer ones are damage, not schedules.
constexpr double kMaxSeconds = 1e10;
constexpr double kMaxNumber = 1e15;

constexpr std::array<const char*, 6> kUnits = {"m", "h", "d", "w", "mo", "%"};
/// DurationFormat of the units above; one more for elapsed, 32 more for estimated.
constexpr std::array<int, 6> kCodes = {3, 5, 7, 9, 11, 19};
constexpr int kEstimated = 32;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

template <typename Number>
bool read_number(std::string_view text, Number& value) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  Number result{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return false;
  value = result;
  return true;
}

template <typename Enum>
bool read_enum(std::string_view text, Enum& value, int last) {
  int number = 0;
  if (!read_number(text, number) || number < 0 || number > last) return false;
  value = static_cast<Enum>(number);
  return true;
}

std::string time_text(int minutes) {
  return fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
}

/// The seconds of one part of a duration, "8H"; nothing for another letter.
std::optional<double> part_seconds(double amount, char letter, bool in_time) {
  if (!in_time) return letter == 'D' ? std::optional(amount * 86400) : std::nullopt;
  switch (letter) {
    case 'H':
      return amount * 3600;
    case 'M':
      return amount * 60;
    case 'S':
      return amount;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::string text_of(const std::string& value) { return value; }
std::string text_of(const Moment& value) { return value.text; }
std::string text_of(const Duration& value) {
  const std::int64_t s = value.seconds;
  return fmt::format("PT{}H{}M{}S", s / 3600, s / 60 % 60, s % 60);
}
std::string text_of(const TimeFormat& value) {
  return fmt::format("{}{}{}", value.elapsed ? "e" : "",
                     kUnits[static_cast<std::size_t>(value.unit)], value.estimated ? "?" : "");
}
std::string text_of(std::int64_t value) { return fmt::format("{}", value); }
std::string text_of(int value) { return fmt::format("{}", value); }
std::string text_of(double value) { return fmt::format("{}", value); }
std::string text_of(bool value) { return value ? "1" : "0"; }
std::string text_of(Constraint value) { return text_of(static_cast<int>(value)); }
std::string text_of(ResourceType value) { return text_of(static_cast<int>(value)); }
std::string text_of(const DayTimes& value) {
  if (value.empty()) return "off";
  std::string text;
  for (const Interval& interval : value) {
    if (!text.empty()) text += ',';
    text += time_text(interval.from) + '-' + time_text(interval.to);
  }
  return text;
}

bool read(std::string_view text, std::string& value) {
  value = trimmed(text).empty() ? std::string() : std::string(text);
  return true;
}

bool read(std::string_view text, Moment& value) {
  text = trimmed(text);
  if (text.size() < 16 || (text[10] != 'T' && text[10] != ' ')) return false;
  std::string moment(text.substr(0, 16));
  moment[10] = ' ';
  if (!schedule::parse_civil_time(moment)) return false;
  if (text.size() >= 19) {
    const std::string_view seconds = text.substr(17, 2);
    const bool digits = seconds[0] >= '0' && seconds[0] <= '5' && seconds[1] >= '0' &&
                        seconds[1] <= '9' && text[16] == ':';
    // Fractions of a second and a time zone may follow; the clock of a site has neither.
    if (!digits || (text.size() > 19 && text[19] != '.' && text[19] != 'Z' && text[19] != '+' &&
                    text[19] != '-')) {
      return false;
    }
    if (seconds != "00") moment += std::string(text.substr(16, 3));
  } else if (text.size() != 16) {
    return false;
  }
  value.text = std::move(moment);
  return true;
}

namespace {

/// Of a duration, however long.
std::optional<double> seconds_in(std::string_view text) {
  text = trimmed(text);
  if (text.size() < 3 || text[0] != 'P') return std::nullopt;
  double seconds = 0;
  bool in_time = false;
  const char* at = text.data() + 1;
  const char* const end = text.data() + text.size();
  while (at != end) {
    if (*at == 'T' && !in_time) {
      in_time = true;
      ++at;
      continue;
    }
    double amount = 0;
    const auto [stop, error] = std::from_chars(at, end, amount, std::chars_format::fixed);
    if (error != std::errc() || stop == end || !(amount >= 0)) return std::nullopt;
    const std::optional<double> part = part_seconds(amount, *stop, in_time);
    if (!part) return std::nullopt;
    seconds += *part;
    at = stop + 1;
  }
  return seconds;
}

}  // namespace

bool read(std::string_view text, Duration& value) {
  const std::optional<double> seconds = seconds_in(text);
  if (!seconds || !(*seconds <= kMaxSeconds)) return false;
  value.seconds = std::llround(*seconds);
  return true;
}

std::string expected_for(std::string_view text, const Duration& value) {
  if (!seconds_in(text)) return expected(value);
  return fmt::format("a duration of at most {:.0f} h", std::floor(kMaxSeconds / 3600));
}

bool read(std::string_view text, TimeFormat& value) {
  TimeFormat format;
  if (!text.empty() && text.back() == '?') {
    format.estimated = true;
    text.remove_suffix(1);
  }
  if (!text.empty() && text.front() == 'e') {
    format.elapsed = true;
    text.remove_prefix(1);
  }
  const auto unit = std::find(kUnits.begin(), kUnits.end(), text);
  if (unit == kUnits.end()) return false;
  format.unit = static_cast<TimeUnit>(unit - kUnits.begin());
  value = format;
  return true;
}

bool read(std::string_view text, std::int64_t& value) {
  std::int64_t number = 0;
  if (!read_number(text, number) || number > kMaxWhole || number < -kMaxWhole) return false;
  value = number;
  return true;
}

bool read(std::string_view text, int& value) {
  std::int64_t number = 0;
  if (!read(text, number) || number > 1000000000 || number < -1000000000) return false;
  value = static_cast<int>(number);
  return true;
}

bool read(std::string_view text, double& value) {
  double number = 0;
  if (!read_number(text, number) || !(std::abs(number) <= kMaxNumber)) return false;
  value = number == 0 ? 0 : number;  // one zero: -0 would be written as "-0"
  return true;
}

bool read(std::string_view text, bool& value) {
  text = trimmed(text);
  if (text != "0" && text != "1" && text != "true" && text != "false") return false;
  value = text == "1" || text == "true";
  return true;
}

bool read(std::string_view text, Constraint& value) { return read_enum(text, value, 7); }
bool read(std::string_view text, ResourceType& value) { return read_enum(text, value, 2); }

bool read(std::string_view text, DayTimes& value) {
  DayTimes times;
  if (text != "off") {
    while (true) {
      const std::string_view one = text.substr(0, text.find(','));
      if (one.size() != 11 || one[5] != '-') return false;
      const auto from = schedule::parse_minute_of_day(one.substr(0, 5));
      const auto to = schedule::parse_minute_of_day(one.substr(6));
      if (!from || !to || *to <= *from) return false;
      times.push_back({*from, *to});
      if (one.size() == text.size()) break;
      text.remove_prefix(one.size() + 1);
    }
  }
  value = tidy(std::move(times));
  return true;
}

int mspdi_code(const TimeFormat& format) {
  return kCodes[static_cast<std::size_t>(format.unit)] + (format.elapsed ? 1 : 0) +
         (format.estimated ? kEstimated : 0);
}

std::optional<TimeFormat> format_of_code(std::int64_t code) {
  TimeFormat format;
  for (std::size_t i = 0; i < kCodes.size(); ++i) {
    format.unit = static_cast<TimeUnit>(i);
    for (const bool estimated : {false, true}) {
      for (const bool elapsed : {false, true}) {
        format.estimated = estimated;
        format.elapsed = elapsed;
        if (mspdi_code(format) == code) return format;
      }
    }
  }
  return std::nullopt;
}

DayTimes tidy(DayTimes times) {
  std::sort(times.begin(), times.end(), [](const Interval& a, const Interval& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  DayTimes result;
  for (const Interval& each : times) {
    if (each.to <= each.from) continue;
    if (!result.empty() && each.from <= result.back().to) {
      result.back().to = std::max(result.back().to, each.to);
    } else {
      result.push_back(each);
    }
  }
  return result;
}

}  // namespace rubicon::project_io
