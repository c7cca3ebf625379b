#pragma once

#include <string_view>

#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

/// Reads the week and the exceptions of a calendar from the cell clndr_data of a XER file: a tree
/// written as (0||NAME(KEY|VALUE|...)(children)), days of the week from 1 (Sunday), exceptions by
/// the day number of a spreadsheet (0 is 1899-12-30). False if the text is not of that form; what
/// was read until then stays.
bool read_xer_calendar(std::string_view data, Calendar& calendar);

}  // namespace rubicon::project_io
