#pragma once

#include "src/exchange/project_io/xml_element_pugixml.hpp"

namespace rubicon::project_io {

/// A <Calendar> of MSPDI: week days, exceptions in the old form (a week day of type 0 with a
/// period) and in the new one; exceptions that come again are written out day by day.
Calendar read_mspdi_calendar(const pugi::xml_node& node, XmlReading& reading);

}  // namespace rubicon::project_io
