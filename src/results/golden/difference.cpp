#include "src/results/golden/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/results/golden/golden_case.hpp"
#include "src/results/golden/observation.hpp"
#include "src/results/golden/task_difference.hpp"
#include "src/results/golden/tolerance.hpp"

namespace rubicon::golden {

namespace {

using nlohmann::ordered_json;

/// Events shown before and after the first one that differs.
constexpr std::size_t kContext = 3;

/// What a document says beside its events; the rest of it (name, note) is for people.
constexpr const char* kCompared[] = {"status",   "period", "tries", "accepted",
                                     "rejected", "end",    "vars",  "warnings"};
/// What it says of the whole plan, in times and money.
constexpr const char* kTotals[] = {"process_time", "cost", "cost_by_kind"};

std::string event_difference(const ordered_json& expected, const ordered_json& found) {
  const std::size_t common = std::min(expected.size(), found.size());
  std::size_t first = 0;
  while (first < common && agrees(expected[first], found[first])) ++first;
  if (first == expected.size() && first == found.size()) return {};
  std::string text = fmt::format("event {} of {} differs ({} happened)\n", first + 1,
                                 expected.size(), found.size());
  for (std::size_t i = first > kContext ? first - kContext : 0; i < first; ++i) {
    text += "    " + describe(expected[i]) + "\n";
  }
  for (std::size_t i = first; i < std::min(expected.size(), first + kContext); ++i) {
    text += "  - " + describe(expected[i]) + "\n";
  }
  if (first >= expected.size()) text += "  - (nothing more expected)\n";
  for (std::size_t i = first; i < std::min(found.size(), first + kContext); ++i) {
    text += "  + " + describe(found[i]) + "\n";
  }
  if (first >= found.size()) text += "  + (nothing more happened)\n";
  return text;
}

}  // namespace

bool agrees(const ordered_json& expected, const ordered_json& found) {
  if (expected.is_number() && found.is_number()) {
    const double a = expected.get<double>();
    const double b = found.get<double>();
    return std::fabs(a - b) <= kNumberTolerance * std::max(1.0, std::fabs(a));
  }
  if (expected.is_object() && found.is_object()) {
    return std::all_of(expected.items().begin(), expected.items().end(), [&](const auto& item) {
      const auto other = found.find(item.key());
      return other != found.end() && agrees(item.value(), *other);
    });
  }
  if (expected.is_array() && found.is_array()) {
    return expected.size() == found.size() &&
           std::equal(expected.begin(), expected.end(), found.begin(), agrees);
  }
  return expected == found;
}

std::string difference(const ordered_json& expected, const ordered_json& found) {
  std::string text;
  for (const char* key : kCompared) {
    const auto wanted = expected.find(key);
    if (wanted == expected.end()) continue;
    const auto got = found.find(key);
    // What a refusal count leaves out is 0; a count that is not expected must not appear.
    const bool same = got != found.end() && agrees(*wanted, *got) &&
                      (!wanted->is_object() || wanted->size() == got->size());
    if (!same) {
      text += fmt::format("{}:\n  - {}\n  + {}\n", key, wanted->dump(),
                          got == found.end() ? "(missing)" : got->dump());
    }
  }
  const Tolerance tolerance(expected);
  for (const char* key : kTotals) {
    if (expected.contains(key)) {
      text += total_difference(key, expected.at(key), found, tolerance);
    }
  }
  if (expected.contains("tasks")) {
    const ordered_json none = ordered_json::array();
    text += task_difference(expected.at("tasks"),
                            found.contains("tasks") ? found.at("tasks") : none, tolerance);
  }
  if (expected.contains("events") && found.contains("events")) {
    text += event_difference(expected.at("events"), found.at("events"));
  }
  return text;
}

}  // namespace rubicon::golden
