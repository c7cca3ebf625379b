#pragma once

#include <simdjson.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rubicon::film {

/// One object of a trace and its members by name. What is not there or of another type throws
/// std::invalid_argument, with a message for the user. Valid as long as the parser's document.
class Record {
 public:
  explicit Record(simdjson::dom::element element);

  bool has(std::string_view name) const;
  std::string_view text(std::string_view name) const;
  /// "" where it is not there or null.
  std::string_view text_or_empty(std::string_view name) const;
  double number(std::string_view name) const;
  std::optional<double> number_if_any(std::string_view name) const;
  /// A whole number that a double holds exactly.
  std::int64_t whole(std::string_view name) const;
  bool truth(std::string_view name) const;
  Record object(std::string_view name) const;
  simdjson::dom::array array(std::string_view name) const;
  simdjson::dom::element element(std::string_view name) const;
  const simdjson::dom::object& members() const { return object_; }

 private:
  simdjson::dom::object object_;
};

/// A number of an array; throws as above.
double as_number(simdjson::dom::element element);
std::int64_t as_whole(simdjson::dom::element element);
std::string_view as_text(simdjson::dom::element element);

}  // namespace rubicon::film
