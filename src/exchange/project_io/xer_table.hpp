#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/exchange/project_io/listing.hpp"

namespace rubicon::project_io {

/// One row of a XER table: its cells by the names of the columns.
class XerRow {
 public:
  using Columns = std::map<std::string_view, std::size_t>;

  XerRow(const Columns* columns, std::vector<std::string_view> cells, interpreter::Span span)
      : columns_(columns), cells_(std::move(cells)), span_(span) {}

  /// The cell of a column; empty if the row or the table has none.
  std::string_view operator[](std::string_view column) const;
  const std::vector<std::string_view>& cells() const { return cells_; }
  /// Whether cells are missing; where it is not known.
  bool is_short() const { return cells_.size() < columns_->size(); }
  interpreter::Span span() const { return span_; }

 private:
  const Columns* columns_;
  std::vector<std::string_view> cells_;
  interpreter::Span span_;
};

struct XerTable {
  std::vector<std::string_view> columns;
  XerRow::Columns index;  ///< where a column stands
  std::vector<XerRow> rows;
  interpreter::Span span;
};

/// The tables of a XER text: lines of cells between tabs, %T a table, %F its columns, %R a row, %E
/// the end. Views into `text`. Lines that are none of these, and rows with more or fewer cells than
/// columns, are listed. An end that is missing is told by `complete`.
struct XerFile {
  std::map<std::string_view, XerTable> tables;
  std::string_view currency;  ///< the code of the one that the header names; may be empty
  bool complete = false;
};
XerFile read_xer_tables(std::string_view text, interpreter::FileId file, Listing& listing);

}  // namespace rubicon::project_io
