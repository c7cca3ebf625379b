#include "src/exchange/project_io/xer_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rubicon::project_io {

namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t tab = line.find('\t');
    cells.push_back(line.substr(0, tab));
    if (tab == std::string_view::npos) return cells;
    line.remove_prefix(tab + 1);
  }
}

class TableReader {
 public:
  TableReader(std::string_view text, interpreter::FileId file, Listing& listing)
      : text_(text), file_(file), listing_(listing) {}

  XerFile read() {
    for (std::size_t at = 0; at < text_.size() && !result_.complete;) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      std::string_view line = text_.substr(at, end - at);
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (!line.empty()) read_line(line, at);
      at = end + 1;
    }
    return std::move(result_);
  }

 private:
  void read_line(std::string_view line, std::size_t at) {
    const interpreter::Span span{file_, static_cast<std::uint32_t>(at),
                                 static_cast<std::uint32_t>(at + line.size())};
    std::vector<std::string_view> cells = cells_of(line);
    const std::string_view mark = cells.front();
    cells.erase(cells.begin());
    if (mark == "ERMHDR") {
      // Version, date, kind, user, full name, database, module, currency.
      constexpr std::size_t kCurrency = 7;
      if (cells.size() > kCurrency) result_.currency = cells[kCurrency];
      return;
    }
    if (mark == "%E") {
      result_.complete = true;
    } else if (mark == "%T" && !cells.empty()) {
      table_ = &result_.tables[cells.front()];
      table_->span = span;
    } else if (mark == "%F" && table_ != nullptr && table_->rows.empty()) {
      table_->columns = std::move(cells);
      table_->index.clear();
      for (std::size_t i = 0; i < table_->columns.size(); ++i) {
        table_->index.emplace(table_->columns[i], i);
      }
    } else if (mark == "%R" && table_ != nullptr) {
      if (cells.size() > table_->columns.size()) {
        listing_.add(
            "I03", "cells", span,
            fmt::format("this row has {} cells, its table {} columns; the rest is left out",
                        cells.size(), table_->columns.size()));
        cells.resize(table_->columns.size());
      }
      if (cells.size() < table_->columns.size()) {
        listing_.add("I03", "missing cells", span,
                     fmt::format("this row has {} cells, its table {} columns; the last ones are "
                                 "taken to be empty",
                                 cells.size(), table_->columns.size()));
      }
      table_->rows.emplace_back(&table_->index, std::move(cells), span);
    } else {
      listing_.add("I03", "line", span,
                   "expected a line that begins with %T, %F, %R or %E, with a table before its "
                   "columns and rows; left out");
    }
  }

  std::string_view text_;
  interpreter::FileId file_;
  Listing& listing_;
  XerFile result_;
  XerTable* table_ = nullptr;
};

}  // namespace

std::string_view XerRow::operator[](std::string_view column) const {
  const auto found = columns_->find(column);
  if (found == columns_->end() || found->second >= cells_.size()) return {};
  return cells_[found->second];
}

XerFile read_xer_tables(std::string_view text, interpreter::FileId file, Listing& listing) {
  return TableReader(text, file, listing).read();
}

}  // namespace rubicon::project_io
