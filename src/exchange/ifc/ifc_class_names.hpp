#pragma once

#include <string>
#include <string_view>

namespace rubicon::ifc {

/// The usual spelling of a class: IFCWALLSTANDARDCASE is IfcWallStandardCase. Classes that are not
/// known get one capital: IFCNEWTHING is IfcNewthing.
std::string class_name(std::string_view keyword);

/// Whether products of this class are no things that are built: spaces, openings, grids, and what
/// calculations and drawings consist of.
bool is_no_element(std::string_view keyword);

}  // namespace rubicon::ifc
