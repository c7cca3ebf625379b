#include "src/exchange/project_io/xer_number.hpp"

#include <algorithm>
#include <string>

#include "src/exchange/project_io/value_text.hpp"

namespace rubicon::project_io {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool same_code(std::string_view a, std::string_view b) {
  const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return upper(x) == upper(y); });
}

/// Whether the only point may part thousands: 1.500, -12.000, but neither 0.125 nor 1.5.
bool may_part_thousands(std::string_view text) {
  const std::size_t begin = text.find_first_of("0123456789");
  const std::size_t point = text.find('.');
  if (begin == std::string_view::npos || point == std::string_view::npos || point <= begin) {
    return false;
  }
  const auto digits = std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(point) + 1,
                                       text.end(), is_digit) -
                      (text.begin() + static_cast<std::ptrdiff_t>(point) + 1);
  return text[begin] != '0' && point - begin <= 3 && digits == 3;
}

}  // namespace

const XerRow* currency_of(const XerFile& xer) {
  const auto table = xer.tables.find("CURRTYPE");
  if (table == xer.tables.end() || table->second.rows.empty()) return nullptr;
  for (const XerRow& row : table->second.rows) {
    if (same_code(row["curr_short_name"], xer.currency)) return &row;
  }
  return &table->second.rows.front();
}

std::string_view decimal_symbol(const XerRow* currency) {
  const std::string_view symbol = currency == nullptr ? "" : (*currency)["decimal_symbol"];
  const bool is_symbol = !symbol.empty() && std::none_of(symbol.begin(), symbol.end(), [](char c) {
    return is_digit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '+' ||
           c == '-' || c == ' ';
  });
  return is_symbol ? symbol : ".";
}

bool read_xer_number(std::string_view text, std::string_view decimal, double& value) {
  if (decimal == ".") return read(text, value);
  std::string plain(text);
  const std::size_t at = plain.find(decimal);
  if (at == std::string::npos) return !may_part_thousands(text) && read(text, value);
  if (plain.find('.') != std::string::npos) return false;
  plain.replace(at, decimal.size(), ".");
  return read(plain, value);
}

}  // namespace rubicon::project_io
