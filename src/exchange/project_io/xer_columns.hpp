#pragma once

#include "src/exchange/project_io/xer_table.hpp"

namespace rubicon::project_io {

/// Lists the tables and columns of a XER file that are not read and have something in them (I07),
/// each once, at the first row that has.
void list_unread(const XerFile& xer, Listing& listing);

}  // namespace rubicon::project_io
