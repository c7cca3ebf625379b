#include "src/exchange/building_io/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/exchange/project_io/decode_text.hpp"

namespace rubicon::building_io {

namespace {

/// Longest name in a remark, in bytes; the table has the whole one.
constexpr std::size_t kLongestRemark = 80;

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

std::string clean(std::string_view name) {
  std::string text = project_io::clean_text(name);
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  return text;
}

bool can_be_quoted(std::string_view text) {
  return text == clean(text) && text.find('"') == std::string_view::npos;
}

std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string joined(const std::vector<std::string>& names, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

std::string remark_name(std::string_view name) {
  if (name.empty()) return "-";
  std::string text = clean(name);
  if (text.size() <= kLongestRemark) return "'" + text + "'";
  std::size_t end = kLongestRemark;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end;
  return "'" + text.substr(0, end) + "...'";
}

}  // namespace rubicon::building_io
