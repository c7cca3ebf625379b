#include "src/simulation/trace/json_builder.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace rubicon::trace {

namespace {

/// Length of the valid UTF-8 sequence at the start of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xc2 && lead < 0xe0   ? 2
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xf0 && lead < 0xf5 ? 4
                                                           : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const unsigned char second = byte(1);
  const bool overlong = (lead == 0xe0 && second < 0xa0) || (lead == 0xf0 && second < 0x90);
  const bool surrogate = lead == 0xed && second >= 0xa0;
  const bool too_large = lead == 0xf4 && second >= 0x90;
  return overlong || surrogate || too_large ? 0 : length;
}

}  // namespace

void append_number(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  fmt::format_to(std::back_inserter(out), "{}", value == 0 ? 0.0 : value);  // -0 is 0
}

void append_seconds(std::string& out, interpreter::Ticks ticks) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  std::uint64_t rest = static_cast<std::uint64_t>(ticks);
  if (ticks < 0) {
    out += '-';
    rest = ~rest + 1;  // the magnitude, also of the smallest value
  }
  fmt::format_to(std::back_inserter(out), "{}", rest / kSecond);
  const std::uint64_t fraction = rest % kSecond;
  if (fraction == 0) return;
  fmt::format_to(std::back_inserter(out), ".{:09}", fraction);
  while (out.back() == '0') out.pop_back();
}

void append_string(std::string& out, std::string_view text) {
  out += '"';
  while (!text.empty()) {
    const char c = text.front();
    const std::size_t length = utf8_length(text);
    if (length == 0) {
      out += "\\ufffd";
      text.remove_prefix(1);
      continue;
    }
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\t':
        out += "\\t";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(c));
        } else {
          out.append(text.substr(0, length));
        }
    }
    text.remove_prefix(length);
  }
  out += '"';
}

void JsonBuilder::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

JsonBuilder& JsonBuilder::open(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
  return *this;
}

JsonBuilder& JsonBuilder::close(char bracket) {
  text_ += bracket;
  first_ = false;
  return *this;
}

JsonBuilder& JsonBuilder::key(std::string_view name) {
  separate();
  append_string(text_, name);
  text_ += ':';
  first_ = true;  // its value follows without a comma
  return *this;
}

JsonBuilder& JsonBuilder::value(double number) {
  separate();
  append_number(text_, number);
  return *this;
}

JsonBuilder& JsonBuilder::value(std::int64_t number) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", number);
  return *this;
}

JsonBuilder& JsonBuilder::value(bool truth) {
  separate();
  text_ += truth ? "true" : "false";
  return *this;
}

JsonBuilder& JsonBuilder::value(std::string_view text) {
  separate();
  append_string(text_, text);
  return *this;
}

JsonBuilder& JsonBuilder::null() {
  separate();
  text_ += "null";
  return *this;
}

JsonBuilder& JsonBuilder::seconds(interpreter::Ticks ticks) {
  separate();
  append_seconds(text_, ticks);
  return *this;
}

JsonBuilder& JsonBuilder::strings(const std::vector<std::string>& texts) {
  begin_array();
  for (const std::string& text : texts) value(std::string_view(text));
  return end_array();
}

JsonBuilder& JsonBuilder::point(const math::Vec3& p) {
  return begin_array().value(p.x()).value(p.y()).value(p.z()).end_array();
}

JsonBuilder& JsonBuilder::pose(const math::Pose& X) {
  begin_array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) value(X.matrix()(row, column));
  }
  return end_array();
}

}  // namespace rubicon::trace
