#pragma once

#include <simdjson.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::trace {

/// A value of a JSON document as a message may show it: short, and nothing that a terminal obeys.
std::string shown(simdjson::dom::element element);
/// The same of any text.
std::string shown_text(std::string_view text);

/// Whether a matrix is a rotation, as near as a trace writes one.
bool is_rotation(const math::Mat3& R);

/// An element of a list or a member of an object, and where it stands ("'pose' of component 3").
struct JsonValue {
  simdjson::dom::element element;
  std::string place;

  [[noreturn]] void fail(std::string_view expected) const;
  bool is_null() const { return element.is_null(); }
  double number() const;
  /// From 0 to the largest int.
  int whole() const;
  bool truth() const;
  std::string text() const;
  /// Twelve numbers: the upper rows of a rigid transform (m).
  math::Pose pose() const;
  simdjson::dom::array list() const;
  /// A list of so many numbers.
  std::vector<double> numbers(std::size_t count) const;
};

/// The members of one JSON object by name. What is missing, there twice, or of another kind throws
/// std::invalid_argument, with a message for the user. Valid as long as the parser's document.
class JsonObject {
 public:
  /// `what` names it in messages.
  JsonObject(simdjson::dom::element element, std::string what);

  bool has(std::string_view name) const;
  JsonValue at(std::string_view name) const;
  double number(std::string_view name) const { return at(name).number(); }
  std::optional<double> number_or_null(std::string_view name) const;
  int whole(std::string_view name) const { return at(name).whole(); }
  bool truth(std::string_view name) const { return at(name).truth(); }
  std::string text(std::string_view name) const { return at(name).text(); }
  std::string text_or_null(std::string_view name) const;
  std::vector<std::string> texts(std::string_view name) const;
  math::Pose pose(std::string_view name) const { return at(name).pose(); }
  math::Vec3 point(std::string_view name) const;
  JsonObject object(std::string_view name) const;
  /// Calls `take` with each element of a list.
  void each(std::string_view name, const std::function<void(const JsonValue&)>& take) const;
  void each_object(std::string_view name, const std::function<void(const JsonObject&)>& take) const;
  const simdjson::dom::object& members() const { return object_; }
  const std::string& what() const { return what_; }

 private:
  simdjson::dom::object object_;
  std::string what_;
};

}  // namespace rubicon::trace
