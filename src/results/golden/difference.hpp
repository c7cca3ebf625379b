#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace rubicon::golden {

/// Whether `found` has all that `expected` has, with the same values (numbers to kNumberTolerance);
/// what `found` has beyond that does not matter.
bool agrees(const nlohmann::ordered_json& expected, const nlohmann::ordered_json& found);

/// The first difference between two documents of goldens, with the events round it; empty if they
/// agree.
std::string difference(const nlohmann::ordered_json& expected, const nlohmann::ordered_json& found);

}  // namespace rubicon::golden
