#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rubicon::report {

using TableRow = std::vector<std::string>;

/// How many characters a terminal shows: code points.
std::size_t width(const std::string& text);

/// Columns side by side, two blanks apart; `right` names those that are aligned to the right. The
/// last is not padded. All rows are as long as the first.
std::string columns(const std::vector<TableRow>& rows, const std::vector<std::size_t>& right);

/// A field of CSV (RFC 4180): in quotes where it has to be.
std::string csv_field(const std::string& text);

}  // namespace rubicon::report
