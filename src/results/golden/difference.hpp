#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace rubicon::golden {

/// Whether `found` has all that `expected` has, with the same values (numbers to kNumberTolerance);
/// what `found` has beyond that does not matter.
bool agrees(const nlohmann::ordered_json& expected, const nlohmann::ordered_json& found);

/// What differs between two documents of goldens: a line for each task, the first event that does
/// with those round it; empty if they agree. Throws std::invalid_argument where the `tolerance` of
/// the expected one cannot be read.
std::string difference(const nlohmann::ordered_json& expected, const nlohmann::ordered_json& found);

}  // namespace rubicon::golden
