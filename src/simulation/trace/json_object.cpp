#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "src/simulation/trace/json_object_simdjson.hpp"

namespace rubicon::trace {

namespace {

using Element = simdjson::dom::element;

/// Characters of what was found that a message shows.
constexpr std::size_t kLongestShown = 40;

/// How far a matrix may be from a rotation. Poses are written to the last digit.
constexpr double kRotationSlack = 1e-6;

}  // namespace

bool is_rotation(const math::Mat3& R) {
  return (R * R.transpose() - math::Mat3::Identity()).cwiseAbs().maxCoeff() <= kRotationSlack &&
         !(R.determinant() < 0);
}

std::string shown_text(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, kLongestShown)) result += c >= ' ' && c <= '~' ? c : '?';
  return text.size() > kLongestShown ? result + "..." : result;
}

std::string shown(Element element) {
  if (element.is_array()) return "a list";
  if (element.is_object()) return "an object";
  return shown_text(simdjson::minify(element));
}

void JsonValue::fail(std::string_view expected) const {
  throw std::invalid_argument(
      fmt::format("expected {} as {}, found {}", expected, place, shown(element)));
}

double JsonValue::number() const {
  double value = 0;
  if (element.get(value) != simdjson::SUCCESS || !std::isfinite(value)) fail("a number");
  return value;
}

int JsonValue::whole() const {
  std::int64_t value = 0;
  if (element.get(value) != simdjson::SUCCESS) fail("a whole number");
  if (value < 0 || value > std::numeric_limits<int>::max()) {
    fail(fmt::format("a whole number from 0 to {}", std::numeric_limits<int>::max()));
  }
  return static_cast<int>(value);
}

bool JsonValue::truth() const {
  bool value = false;
  if (element.get(value) != simdjson::SUCCESS) fail("true or false");
  return value;
}

std::string JsonValue::text() const {
  std::string_view value;
  if (element.get(value) != simdjson::SUCCESS) fail("a text");
  return std::string(value);
}

simdjson::dom::array JsonValue::list() const {
  simdjson::dom::array value;
  if (element.get(value) != simdjson::SUCCESS) fail("a list");
  return value;
}

std::vector<double> JsonValue::numbers(std::size_t count) const {
  std::vector<double> values;
  for (const Element each : list()) values.push_back(JsonValue{each, place}.number());
  if (values.size() != count) {
    throw std::invalid_argument(
        fmt::format("expected {} numbers as {}, found {}", count, place, values.size()));
  }
  return values;
}

math::Pose JsonValue::pose() const {
  const std::vector<double> values = numbers(12);
  math::Pose X = math::Pose::Identity();
  for (int i = 0; i < 12; ++i) X.matrix()(i / 4, i % 4) = values[static_cast<std::size_t>(i)];
  if (!is_rotation(X.linear())) {
    throw std::invalid_argument(
        fmt::format("expected a rotation and a translation as {}, found another matrix", place));
  }
  return X;
}

JsonObject::JsonObject(Element element, std::string what) : what_(std::move(what)) {
  if (element.get(object_) != simdjson::SUCCESS) {
    throw std::invalid_argument(fmt::format("{} is no object", what_));
  }
  // Some readers of JSON take the first of two members of one name, others the last.
  std::set<std::string_view> names;
  for (const auto member : object_) {
    if (!names.insert(member.key).second) {
      throw std::invalid_argument(fmt::format("{} has two '{}'", what_, shown_text(member.key)));
    }
  }
}

bool JsonObject::has(std::string_view name) const {
  return object_.at_key(name).error() == simdjson::SUCCESS;
}

JsonValue JsonObject::at(std::string_view name) const {
  Element value;
  if (object_.at_key(name).get(value) != simdjson::SUCCESS) {
    throw std::invalid_argument(fmt::format("it has no '{}' in {}", name, what_));
  }
  return {value, fmt::format("'{}' of {}", name, what_)};
}

std::optional<double> JsonObject::number_or_null(std::string_view name) const {
  const JsonValue value = at(name);
  if (value.is_null()) return std::nullopt;
  return value.number();
}

std::string JsonObject::text_or_null(std::string_view name) const {
  const JsonValue value = at(name);
  return value.is_null() ? std::string() : value.text();
}

std::vector<std::string> JsonObject::texts(std::string_view name) const {
  std::vector<std::string> texts;
  each(name, [&](const JsonValue& value) { texts.push_back(value.text()); });
  return texts;
}

math::Vec3 JsonObject::point(std::string_view name) const {
  const std::vector<double> p = at(name).numbers(3);
  return {p[0], p[1], p[2]};
}

JsonObject JsonObject::object(std::string_view name) const {
  JsonValue value = at(name);
  return {value.element, std::move(value.place)};
}

void JsonObject::each(std::string_view name,
                      const std::function<void(const JsonValue&)>& take) const {
  const JsonValue value = at(name);
  for (const Element element : value.list()) take({element, value.place});
}

void JsonObject::each_object(std::string_view name,
                             const std::function<void(const JsonObject&)>& take) const {
  int number = 0;
  each(name, [&](const JsonValue& value) {
    take(JsonObject(value.element, fmt::format("element {} of {}", ++number, value.place)));
  });
}

}  // namespace rubicon::trace
