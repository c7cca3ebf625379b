#include "src/results/report/columns.hpp"

#include <algorithm>

namespace rubicon::report {

std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
  }));
}

std::string columns(const std::vector<TableRow>& rows, const std::vector<std::size_t>& right) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const TableRow& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width(row[c]));
  }
  std::string text;
  for (const TableRow& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string padding(widths[c] - width(row[c]), ' ');
      const bool to_the_right = std::find(right.begin(), right.end(), c) != right.end();
      const bool last = c + 1 == row.size();
      text += to_the_right ? padding + row[c] : row[c] + (last ? "" : padding);
      text += last ? "\n" : "  ";
    }
  }
  return text;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char byte : text) {
    quoted += byte;
    if (byte == '"') quoted += '"';
  }
  return quoted + "\"";
}

}  // namespace rubicon::report
