#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rubicon::report {

/// A JSON value whose numbers keep the digits they are written with: a time of whole nanoseconds
/// over months has more of them than a double. Every access throws std::invalid_argument, with a
/// message for the user, if the value is not of the kind that is asked for.
class ExactJson {
 public:
  /// Of several members of one name the last counts. Throws std::invalid_argument for what is no
  /// JSON, or is nested deeper than any file of ours.
  static ExactJson parse(std::string_view text);

  bool has(std::string_view name) const;             ///< there, and not null
  const ExactJson& at(std::string_view name) const;  ///< a member
  const std::vector<ExactJson>& elements() const;    ///< of a list
  const std::vector<std::string>& names() const;     ///< of an object: of its members
  const ExactJson& member(std::size_t index) const;  ///< by its place among them
  const std::string& text() const;
  bool truth() const;
  double number() const;
  int integer() const;
  /// Seconds, exactly, as whole nanoseconds (digits beyond are cut off).
  std::int64_t ticks() const;

 private:
  friend class ExactJsonBuilder;
  enum class Kind { null, truth, number, text, list, object };
  [[noreturn]] void fail(std::string_view expected) const;

  Kind kind_ = Kind::null;
  bool truth_ = false;
  std::string text_;  ///< of a text; of a number as it is written
  std::vector<ExactJson> elements_;
  std::vector<std::string> names_;  ///< of an object: of its elements
  std::string place_;               ///< its name as a member, for messages
};

}  // namespace rubicon::report
