#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "src/simulation/trace/digit.hpp"
#include "src/simulation/trace/json_object_simdjson.hpp"
#include "src/simulation/trace/record_values_simdjson.hpp"

namespace rubicon::trace {

namespace {

using Value = simdjson::ondemand::value;

constexpr const char* kText = "a text";
constexpr const char* kNames = "a text or a list of texts";
constexpr const char* kPair = "two texts, what moved and what it met";
constexpr const char* kNumbers = "an object of numbers";
constexpr const char* kTime = "a time in seconds, at most 126 years";
constexpr const char* kPose = "a pose, 12 numbers of a rotation and a translation";

/// s, 126 years: nanoseconds of the sum of two still fit.
constexpr std::int64_t kLongest = 4'000'000'000;

template <typename T>
T get(Value& from, const char* expected) {
  T result;
  if (from.get(result) != simdjson::SUCCESS) throw WrongValue{expected};
  return result;
}

/// Calls `take` with each element of a list.
template <typename Take>
void each_element(Value& from, const char* expected, Take take) {
  auto list = get<simdjson::ondemand::array>(from, expected);
  for (auto each : list) {
    Value element;
    if (each.get(element) != simdjson::SUCCESS) throw WrongValue{expected};
    take(element);
  }
}

/// Calls `take` with the name and the value of each member of an object.
template <typename Take>
void each_member(Value& from, Take take) {
  auto object = get<simdjson::ondemand::object>(from, kNumbers);
  for (auto each : object) {
    simdjson::ondemand::field field;
    std::string_view name;
    if (std::move(each).get(field) != simdjson::SUCCESS ||
        field.unescaped_key().get(name) != simdjson::SUCCESS) {
      throw WrongValue{kNumbers};
    }
    take(name, field.value());
  }
}

/// Whole nanoseconds of a decimal number without an exponent; digits beyond are cut off. Nothing
/// for another text.
std::optional<Ticks> plain_ticks(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  std::int64_t whole = 0;
  std::size_t at = 0;
  for (; at < text.size() && is_digit(text[at]) && whole <= kLongest; ++at) {
    whole = 10 * whole + (text[at] - '0');
  }
  if (at == 0 || whole > kLongest || (at > 1 && text[0] == '0')) return std::nullopt;
  Ticks ticks = whole * 1'000'000'000;
  if (at < text.size() && text[at] == '.') {
    const std::size_t point = at++;
    for (Ticks unit = 100'000'000; at < text.size() && is_digit(text[at]); ++at, unit /= 10) {
      ticks += unit * (text[at] - '0');
    }
    if (at == point + 1) return std::nullopt;
  }
  if (at != text.size()) return std::nullopt;
  return negative ? -ticks : ticks;
}

}  // namespace

bool RecordValues::is_null(Value& from) {
  bool null = false;
  return from.is_null().get(null) == simdjson::SUCCESS && null;
}

void RecordValues::read(Value& from, std::string_view& into) {
  into = get<std::string_view>(from, kText);
}

void RecordValues::read(Value& from, bool& into) { into = get<bool>(from, "true or false"); }

void RecordValues::read(Value& from, int& into) {
  const auto whole = get<std::int64_t>(from, "a whole number");
  if (whole < 0 || whole > std::numeric_limits<int>::max()) {
    throw WrongValue{"a whole number from 0 to 2147483647"};
  }
  into = static_cast<int>(whole);
}

void RecordValues::read(Value& from, double& into) { into = get<double>(from, "a number"); }

void RecordValues::read(Value& from, Ticks& into) {
  std::string_view token = from.raw_json_token();
  while (!token.empty() && static_cast<unsigned char>(token.back()) <= ' ') token.remove_suffix(1);
  if (const auto ticks = plain_ticks(token)) {
    into = *ticks;
    return;
  }
  // With an exponent, as other programs may write it.
  const auto number = get<double>(from, kTime);
  if (!(std::fabs(number) <= static_cast<double>(kLongest))) throw WrongValue{kTime};
  into = std::llround(number * interpreter::kTicksPerSecond);
}

void RecordValues::read(Value& from, std::optional<Hit>& into) {
  std::array<std::string_view, 2> pair;
  std::size_t count = 0;
  each_element(from, kPair, [&](Value& element) {
    if (count == pair.size()) throw WrongValue{kPair};
    pair[count++] = get<std::string_view>(element, kPair);
  });
  if (count != pair.size()) throw WrongValue{kPair};
  into = Hit{pair[0], pair[1]};
}

void RecordValues::read(Value& from, Names& into) {
  parameters_.clear();
  simdjson::ondemand::json_type type{};
  if (from.type().get(type) != simdjson::SUCCESS) throw WrongValue{kNames};
  if (type == simdjson::ondemand::json_type::array) {
    each_element(from, kNames, [&](Value& element) {
      parameters_.push_back(get<std::string_view>(element, kNames));
    });
  } else {
    parameters_.push_back(get<std::string_view>(from, kNames));
  }
  into = parameters_;
}

void RecordValues::read(Value& from, Numbers& into) {
  std::vector<double>& values = numbers_[used_numbers_++ % numbers_.size()];
  values.clear();
  each_element(from, "a list of numbers", [&](Value& element) {
    values.push_back(get<double>(element, "a list of numbers"));
  });
  into = values;
}

void RecordValues::read(Value& from, Configuration& into) {
  q_.clear();
  each_member(from, [&](std::string_view name, Value& element) {
    q_.push_back({name, get<double>(element, kNumbers)});
  });
  into = q_;
}

void RecordValues::read(Value& from, NamedValues& into) {
  std::vector<NamedValue>& values = lists_[used_lists_++ % lists_.size()];
  values.clear();
  each_member(from, [&](std::string_view name, Value& element) {
    std::optional<double> value;
    if (!is_null(element)) value = get<double>(element, kNumbers);
    values.push_back({name, value});
  });
  into = values;
}

void RecordValues::read(Value& from, RefusalCounts& into) {
  constexpr std::array<std::pair<std::string_view, int RefusalCounts::*>, 4> kReasons = {
      {{"at goal", &RefusalCounts::at_goal},
       {"no direction", &RefusalCounts::no_direction},
       {"limit", &RefusalCounts::limit},
       {"hit", &RefusalCounts::hit}}};
  unsigned found = 0;
  each_member(from, [&](std::string_view name, Value& element) {
    for (std::size_t i = 0; i < kReasons.size(); ++i) {
      if (kReasons[i].first != name) continue;
      read(element, into.*kReasons[i].second);
      found |= 1U << i;
    }
  });
  if (found != (1U << kReasons.size()) - 1) {
    throw WrongValue{"the numbers of 'at goal', 'no direction', 'limit' and 'hit'"};
  }
}

void RecordValues::read(Value& from, math::Pose& into) {
  std::array<double, 12> rows{};
  std::size_t count = 0;
  each_element(from, kPose, [&](Value& element) {
    if (count == rows.size()) throw WrongValue{kPose};
    rows[count++] = get<double>(element, kPose);
  });
  if (count != rows.size()) throw WrongValue{kPose};
  into = math::Pose::Identity();
  for (int i = 0; i < 12; ++i) into.matrix()(i / 4, i % 4) = rows[static_cast<std::size_t>(i)];
  if (!is_rotation(into.linear())) throw WrongValue{kPose};
}

}  // namespace rubicon::trace
