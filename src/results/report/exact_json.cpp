#include "src/results/report/exact_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rubicon::report {

namespace {

/// A schedule is nested less than this; deeper text is hostile and would cost stack.
constexpr std::size_t kDeepest = 32;

/// s, 126 years: nanoseconds of the sum of two still fit.
constexpr std::int64_t kLongest = 4'000'000'000;
constexpr std::size_t kDigitsOfNanoseconds = 9;

}  // namespace

/// Takes what the parser finds and keeps the open lists and objects on a stack.
class ExactJsonBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return add({}); }
  bool boolean(bool truth) override {
    ExactJson value = of(ExactJson::Kind::truth);
    value.truth_ = truth;
    return add(std::move(value));
  }
  bool number_integer(number_integer_t number) override {
    return add(of(ExactJson::Kind::number, std::to_string(number)));
  }
  bool number_unsigned(number_unsigned_t number) override {
    return add(of(ExactJson::Kind::number, std::to_string(number)));
  }
  bool number_float(number_float_t, const string_t& written) override {
    return add(of(ExactJson::Kind::number, written));
  }
  bool string(string_t& text) override { return add(of(ExactJson::Kind::text, std::move(text))); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(ExactJson::Kind::object); }
  bool key(string_t& name) override {
    names_.back() = std::move(name);
    return true;
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(ExactJson::Kind::list); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string&,
                   const nlohmann::json::exception& error) override {
    throw std::invalid_argument(fmt::format("expected JSON: {}", error.what()));
  }

  ExactJson take() { return std::move(root_); }

 private:
  static ExactJson of(ExactJson::Kind kind, std::string text = {}) {
    ExactJson value;
    value.kind_ = kind;
    value.text_ = std::move(text);
    return value;
  }

  bool add(ExactJson value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return true;
    }
    ExactJson& parent = open_.back();
    if (parent.kind_ == ExactJson::Kind::object) {
      value.place_ = names_.back();
      parent.names_.push_back(names_.back());
    } else {
      value.place_ = parent.place_;
    }
    parent.elements_.push_back(std::move(value));
    return true;
  }

  bool open(ExactJson::Kind kind) {
    if (open_.size() == kDeepest) {
      throw std::invalid_argument("expected JSON, found too many brackets");
    }
    ExactJson value = of(kind);
    if (!open_.empty()) {
      value.place_ =
          open_.back().kind_ == ExactJson::Kind::object ? names_.back() : open_.back().place_;
    }
    open_.push_back(std::move(value));
    names_.emplace_back();
    return true;
  }

  bool close() {
    ExactJson value = std::move(open_.back());
    open_.pop_back();
    names_.pop_back();
    return add(std::move(value));
  }

  ExactJson root_;
  std::vector<ExactJson> open_;
  std::vector<std::string> names_;  ///< of the member that comes next, of each open object
};

ExactJson ExactJson::parse(std::string_view text) {
  ExactJsonBuilder builder;
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

void ExactJson::fail(std::string_view expected) const {
  throw std::invalid_argument(place_.empty()
                                  ? fmt::format("expected {}", expected)
                                  : fmt::format("expected {} as '{}'", expected, place_));
}

bool ExactJson::has(std::string_view name) const {
  const auto found = std::find(names_.rbegin(), names_.rend(), name);
  return found != names_.rend() && at(name).kind_ != Kind::null;
}

const ExactJson& ExactJson::at(std::string_view name) const {
  if (kind_ != Kind::object) fail("an object");
  const auto found = std::find(names_.rbegin(), names_.rend(), name);
  if (found == names_.rend()) {
    throw std::invalid_argument(place_.empty()
                                    ? fmt::format("expected '{}'", name)
                                    : fmt::format("expected '{}' in '{}'", name, place_));
  }
  return elements_[static_cast<std::size_t>(names_.rend() - found) - 1];
}

const std::vector<ExactJson>& ExactJson::elements() const {
  if (kind_ != Kind::list) fail("a list");
  return elements_;
}

const std::vector<std::string>& ExactJson::names() const {
  if (kind_ != Kind::object) fail("an object");
  return names_;
}

const ExactJson& ExactJson::member(std::size_t index) const {
  if (kind_ != Kind::object) fail("an object");
  return elements_.at(index);
}

const std::string& ExactJson::text() const {
  if (kind_ != Kind::text) fail("a text");
  return text_;
}

bool ExactJson::truth() const {
  if (kind_ != Kind::truth) fail("true or false");
  return truth_;
}

double ExactJson::number() const {
  if (kind_ != Kind::number) fail("a number");
  double value = 0;
  const char* end = text_.data() + text_.size();
  const auto [rest, error] = std::from_chars(text_.data(), end, value);
  if (error != std::errc() || rest != end) fail("a number");
  return value;
}

int ExactJson::integer() const {
  if (kind_ != Kind::number) fail("a whole number");
  int value = 0;
  const char* end = text_.data() + text_.size();
  const auto [rest, error] = std::from_chars(text_.data(), end, value);
  if (error != std::errc() || rest != end) fail("a whole number");
  return value;
}

std::int64_t ExactJson::ticks() const {
  if (kind_ != Kind::number) fail("a time");
  std::string_view digits = text_;
  const bool negative = digits.starts_with('-');
  if (negative) digits.remove_prefix(1);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  std::string decimals(digits.substr(std::min(point + 1, digits.size())));
  decimals.resize(std::max(decimals.size(), kDigitsOfNanoseconds), '0');
  std::int64_t seconds = 0;
  std::int64_t nanoseconds = 0;
  const auto read = [this](std::string_view from, std::int64_t& to) {
    const auto [rest, error] = std::from_chars(from.data(), from.data() + from.size(), to);
    if (error != std::errc() || rest != from.data() + from.size()) fail("a time");
  };
  read(digits.substr(0, point), seconds);
  read(std::string_view(decimals).substr(0, kDigitsOfNanoseconds), nanoseconds);
  if (seconds > kLongest || decimals.find_first_not_of("0123456789") != std::string::npos) {
    fail("a time");
  }
  const std::int64_t ticks = seconds * 1'000'000'000 + nanoseconds;
  return negative ? -ticks : ticks;
}

}  // namespace rubicon::report
