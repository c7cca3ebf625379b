#include <fmt/format.h>

#include <stdexcept>

#include "src/results/film/record_simdjson.hpp"

namespace rubicon::film {

namespace {

using Element = simdjson::dom::element;

/// Above it doubles leave out whole numbers.
constexpr std::int64_t kLargestWhole = std::int64_t{1} << 52;

[[noreturn]] void fail(std::string_view name, const char* expected) {
  throw std::invalid_argument(
      fmt::format("this is no line of a trace: '{}' should be {}", name, expected));
}

template <typename T>
T get(const Element& from, std::string_view name, const char* expected) {
  T value;
  if (from.get(value) != simdjson::SUCCESS) fail(name, expected);
  return value;
}

std::int64_t whole_of(const Element& from, std::string_view name) {
  const auto value = get<std::int64_t>(from, name, "a whole number");
  if (value > kLargestWhole || value < -kLargestWhole) fail(name, "a smaller number");
  return value;
}

}  // namespace

Record::Record(Element element)
    : object_(get<simdjson::dom::object>(element, "line", "an object")) {}

Element Record::element(std::string_view name) const {
  Element value;
  if (object_.at_key(name).get(value) != simdjson::SUCCESS) {
    throw std::invalid_argument(fmt::format("this is no line of a trace: it has no '{}'", name));
  }
  return value;
}

bool Record::has(std::string_view name) const {
  return object_.at_key(name).error() == simdjson::SUCCESS;
}

std::string_view Record::text(std::string_view name) const {
  return get<std::string_view>(element(name), name, "a text");
}

std::string_view Record::text_or_empty(std::string_view name) const {
  Element value;
  if (object_.at_key(name).get(value) != simdjson::SUCCESS || value.is_null()) return {};
  return get<std::string_view>(value, name, "a text");
}

double Record::number(std::string_view name) const {
  return get<double>(element(name), name, "a number");
}

std::optional<double> Record::number_if_any(std::string_view name) const {
  Element value;
  if (object_.at_key(name).get(value) != simdjson::SUCCESS) return std::nullopt;
  return get<double>(value, name, "a number");
}

std::int64_t Record::whole(std::string_view name) const { return whole_of(element(name), name); }

bool Record::truth(std::string_view name) const {
  return get<bool>(element(name), name, "true or false");
}

Record Record::object(std::string_view name) const { return Record(element(name)); }

simdjson::dom::array Record::array(std::string_view name) const {
  return get<simdjson::dom::array>(element(name), name, "a list");
}

double as_number(Element element) { return get<double>(element, "element", "a number"); }
std::int64_t as_whole(Element element) { return whole_of(element, "element"); }
std::string_view as_text(Element element) {
  return get<std::string_view>(element, "element", "a text");
}

}  // namespace rubicon::film
