#pragma once

#include <string>
#include <vector>

#include "src/exchange/building_io/element.hpp"

namespace rubicon::building_io {

/// A row of the table of elements.
struct ElementRow {
  const Element* element = nullptr;
  std::string fate;      ///< moved, stands, left out, unmatched
  std::string activity;  ///< the line of the schedule that it belongs to, as the plan calls it
  std::string hours;     ///< how long that takes by the schedule, h
  std::string task;      ///< the task of the plan that puts it into place
  std::string mass;
};

/// The table as CSV (RFC 4180): a row an element, places in the coordinates of the plan (`origin`
/// is taken off).
std::string elements_table(const std::vector<ElementRow>& rows, const Vec3& origin);

}  // namespace rubicon::building_io
