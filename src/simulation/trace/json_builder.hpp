#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/program/world.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::trace {

/// Appends the shortest decimal that reads back as the same double; -0 as 0, what is not finite as
/// null.
void append_number(std::string& out, double value);

/// Appends a time in seconds, exactly: 2.5, 0.333333333.
void append_seconds(std::string& out, interpreter::Ticks ticks);

/// Appends a JSON string with its quotes. Bytes that are not UTF-8 become U+FFFD.
void append_string(std::string& out, std::string_view text);

/// Writes one JSON value piece by piece with the commas where they belong; keys keep their order.
class JsonBuilder {
 public:
  JsonBuilder& begin_object() { return open('{'); }
  JsonBuilder& end_object() { return close('}'); }
  JsonBuilder& begin_array() { return open('['); }
  JsonBuilder& end_array() { return close(']'); }
  JsonBuilder& key(std::string_view name);

  JsonBuilder& value(double number);
  JsonBuilder& value(std::int64_t number);
  JsonBuilder& value(int number) { return value(static_cast<std::int64_t>(number)); }
  JsonBuilder& value(bool truth);
  JsonBuilder& value(std::string_view text);
  JsonBuilder& value(const char* text) { return value(std::string_view(text)); }
  JsonBuilder& null();
  JsonBuilder& seconds(interpreter::Ticks ticks);
  JsonBuilder& strings(const std::vector<std::string>& texts);
  JsonBuilder& point(const math::Vec3& p);
  /// A pose as 12 numbers: the upper three rows of its matrix, row by row (m).
  JsonBuilder& pose(const math::Pose& X);

  template <typename T>
  JsonBuilder& field(std::string_view name, const T& what) {
    return key(name).value(what);
  }

  const std::string& text() const { return text_; }
  std::string take() { return std::move(text_); }

 private:
  JsonBuilder& open(char bracket);
  JsonBuilder& close(char bracket);
  void separate();

  std::string text_;
  bool first_ = true;
};

}  // namespace rubicon::trace
