#include "src/results/verify/input/json_fields.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace rubicon::verify {

namespace {

/// A trace is nested less than this; deeper text is hostile and would cost stack.
constexpr int kDeepestJson = 32;

/// s, 126 years: in nanoseconds the sum of two still fits.
constexpr double kLongest = 4e9;

constexpr int kLargestInteger = 1'000'000'000;

/// How far a matrix may be from a rotation. Poses are written to the last digit.
constexpr double kRotationSlack = 1e-6;

bool too_deep(const std::string& text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kDeepestJson) return true;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return false;
}

}  // namespace

bool has_format(const std::string& text, const std::string& format) {
  constexpr std::size_t kHead = 200;
  return text.substr(0, kHead).find("\"" + format + "\"") != std::string::npos;
}

Json parse_json(const std::string& text) {
  if (too_deep(text)) throw UnreadableInput("expected JSON, found too many brackets");
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {
    throw UnreadableInput(fmt::format("expected JSON: {}", error.what()));
  }
}

JsonFields::JsonFields(const Json& object, std::string what)
    : object_(object), what_(std::move(what)) {
  if (!object_.is_object()) throw UnreadableInput(fmt::format("expected an object: {}", what_));
}

void JsonFields::fail(const std::string& expected) const {
  throw UnreadableInput(fmt::format("expected {} in {}", expected, what_));
}

bool JsonFields::has(const char* name) const {
  const auto found = object_.find(name);
  return found != object_.end() && !found->is_null();
}

const Json& JsonFields::any(const char* name) const {
  const auto found = object_.find(name);
  if (found == object_.end()) fail(fmt::format("'{}'", name));
  return *found;
}

double JsonFields::number(const char* name) const {
  return number_of(any(name), fmt::format("'{}' of {}", name, what_));
}

double JsonFields::money(const char* name) const {
  return number_of(any(name), fmt::format("'{}' of {}", name, what_), kLargestMoney);
}

int JsonFields::integer(const char* name) const {
  return integer_of(any(name), fmt::format("'{}' of {}", name, what_), -kLargestInteger,
                    kLargestInteger);
}

bool JsonFields::truth(const char* name) const {
  const Json& value = any(name);
  if (!value.is_boolean()) fail(fmt::format("true or false as '{}'", name));
  return value.get<bool>();
}

const std::string& JsonFields::text(const char* name) const {
  return text_of(any(name), fmt::format("'{}' of {}", name, what_));
}

std::string JsonFields::text_or(const char* name, const std::string& otherwise) const {
  return has(name) ? text(name) : otherwise;
}

const Json& JsonFields::array(const char* name) const {
  const Json& value = any(name);
  if (!value.is_array()) fail(fmt::format("a list as '{}'", name));
  return value;
}

std::map<std::string, std::string> JsonFields::texts(const char* name) const {
  std::map<std::string, std::string> found;
  if (!has(name)) return found;
  for (const auto& [key, value] : object(name).json().items()) {
    found[key] = text_of(value, fmt::format("a text of '{}'", name));
  }
  return found;
}

JsonFields JsonFields::object(const char* name) const {
  return {any(name), fmt::format("'{}' of {}", name, what_)};
}

Ticks JsonFields::time(const char* name) const {
  const double seconds = number(name);
  if (!(std::fabs(seconds) <= kLongest)) fail(fmt::format("a time as '{}'", name));
  return static_cast<Ticks>(std::floor(seconds * static_cast<double>(kSecond) + 0.5));
}

math::Pose JsonFields::pose(const char* name) const {
  return pose_of(any(name), fmt::format("'{}' of {}", name, what_));
}

math::Vec3 JsonFields::point(const char* name) const {
  const Json& list = array(name);
  if (list.size() != 3) fail(fmt::format("three numbers as '{}'", name));
  math::Vec3 p;
  for (int i = 0; i < 3; ++i) p[i] = number_of(list[static_cast<std::size_t>(i)], what_);
  return p;
}

double number_of(const Json& value, const std::string& what, double largest) {
  if (!value.is_number()) throw UnreadableInput(fmt::format("expected a number: {}", what));
  const double number = value.get<double>();
  if (!(std::fabs(number) <= largest)) {
    throw UnreadableInput(fmt::format("expected a smaller number: {}", what));
  }
  return number;
}

int integer_of(const Json& value, const std::string& what, int least, int most) {
  const double number = number_of(value, what);
  if (number != std::floor(number) || number < least || number > most) {
    throw UnreadableInput(
        fmt::format("expected a whole number from {} to {}: {}", least, most, what));
  }
  return static_cast<int>(number);
}

const std::string& text_of(const Json& value, const std::string& what) {
  if (!value.is_string()) throw UnreadableInput(fmt::format("expected a text: {}", what));
  return value.get_ref<const std::string&>();
}

math::Pose pose_of(const Json& value, const std::string& what) {
  if (!value.is_array() || value.size() != 12) {
    throw UnreadableInput(fmt::format("expected 12 numbers: {}", what));
  }
  math::Pose X = math::Pose::Identity();
  for (int i = 0; i < 12; ++i) {
    X.matrix()(i / 4, i % 4) = number_of(value[static_cast<std::size_t>(i)], what);
  }
  const math::Mat3 R = X.linear();
  const bool orthonormal =
      (R * R.transpose() - math::Mat3::Identity()).cwiseAbs().maxCoeff() <= kRotationSlack;
  if (!orthonormal || R.determinant() < 0) {
    throw UnreadableInput(fmt::format("expected a rotation and a translation: {}", what));
  }
  return X;
}

}  // namespace rubicon::verify
