#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "src/motion/math/pose.hpp"
#include "src/results/verify/input/fault.hpp"

namespace rubicon::verify {

using Json = nlohmann::json;

/// m or degrees: more than this is no building site, and its squares would overflow.
inline constexpr double kLargestNumber = 1e12;
/// Rates are at most 1e12 per hour, a plan lasts a million hours, and has some thousand crews.
inline constexpr double kLargestMoney = 1e24;

/// Whether a text is a result without tasks of this format ("rubicon-grid"), by its head: a longer
/// text need not be looked at to know one.
bool has_format(const std::string& text, const std::string& format);

/// Reads JSON text that is not nested deeper than any trace; throws UnreadableInput.
Json parse_json(const std::string& text);

/// The members of a JSON object by name. What is missing or of the wrong type throws
/// UnreadableInput that says what was expected.
class JsonFields {
 public:
  /// `what` names the object in messages.
  JsonFields(const Json& object, std::string what);

  bool has(const char* name) const;  ///< there, and not null
  const Json& any(const char* name) const;
  double number(const char* name) const;
  double money(const char* name) const;
  int integer(const char* name) const;
  bool truth(const char* name) const;
  const std::string& text(const char* name) const;
  const Json& array(const char* name) const;
  JsonFields object(const char* name) const;
  /// Texts by key; none where there is no such member.
  std::map<std::string, std::string> texts(const char* name) const;
  /// Seconds as whole nanoseconds.
  Ticks time(const char* name) const;
  math::Pose pose(const char* name) const;
  math::Vec3 point(const char* name) const;
  std::string text_or(const char* name, const std::string& otherwise) const;
  const Json& json() const { return object_; }

  [[noreturn]] void fail(const std::string& expected) const;

 private:
  const Json& object_;
  std::string what_;
};

/// A number that is not absurdly large, of this element; throws UnreadableInput.
double number_of(const Json& value, const std::string& what, double largest = kLargestNumber);
/// A whole number in a range; throws UnreadableInput.
int integer_of(const Json& value, const std::string& what, int least, int most);
/// A name; throws UnreadableInput.
const std::string& text_of(const Json& value, const std::string& what);
/// Twelve numbers, the upper rows of a rigid transform; throws UnreadableInput.
math::Pose pose_of(const Json& value, const std::string& what);

}  // namespace rubicon::verify
