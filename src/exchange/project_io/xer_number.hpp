#pragma once

#include <string_view>

#include "src/exchange/project_io/xer_table.hpp"

namespace rubicon::project_io {

/// The row of CURRTYPE with the currency of a XER file: the one that its header names, else the
/// first; null if there is none.
const XerRow* currency_of(const XerFile& xer);

/// The decimal symbol of a currency, as P6 writes it in all numbers of the file, durations and lags
/// too: a comma in most of Europe. A point where the currency says none.
std::string_view decimal_symbol(const XerRow* currency);

/// Reads a number with this decimal symbol. P6 parts no thousands. Other programs leave the symbol
/// of the currency and write points: a point is one as well, unless it may part thousands (1.500).
/// Gives false for any other text.
bool read_xer_number(std::string_view text, std::string_view decimal, double& value);

}  // namespace rubicon::project_io
