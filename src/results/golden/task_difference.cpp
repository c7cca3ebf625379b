#include "src/results/golden/task_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "src/results/golden/difference.hpp"
#include "src/results/golden/golden_case.hpp"

namespace rubicon::golden {

namespace {

using nlohmann::ordered_json;

bool is_cost(std::string_view what) { return what.starts_with("cost"); }
bool is_time(std::string_view what) {
  return what == "start" || what == "duration" || what == "process_time";
}

std::string value_text(std::string_view what, const ordered_json& value) {
  if (!value.is_number()) return value.is_string() ? value.get<std::string>() : value.dump();
  if (is_cost(what)) return fmt::format("{:.2f}", value.get<double>());
  return fmt::format("{:.10g}{}", value.get<double>(), is_time(what) ? " s" : "");
}

/// "duration: expected 90 s, found 95 s (5 s more)"; empty if the two agree.
std::string value_difference(const std::string& what, const std::string& task,
                             const ordered_json& expected, const ordered_json* found,
                             const Tolerance& tolerance) {
  if (found == nullptr) {
    return fmt::format("{}: expected {}, found nothing", what, value_text(what, expected));
  }
  if (agrees(expected, *found)) return {};
  std::string more;
  if (expected.is_number() && found->is_number() && (is_time(what) || is_cost(what))) {
    const double wanted = expected.get<double>();
    const double off = found->get<double>() - wanted;
    const Allowance allowed = tolerance.of(is_cost(what) ? "cost" : "time", task);
    const double rounding = kNumberTolerance * std::max(1.0, std::fabs(wanted));
    if (std::fabs(off) <= allowed.of(wanted) + rounding) return {};
    more = fmt::format(" ({} {}{})", value_text(what, std::fabs(off)), off > 0 ? "more" : "less",
                       allowed.of(wanted) > 0
                           ? fmt::format(", allowed {}", value_text(what, allowed.of(wanted)))
                           : "");
  }
  return fmt::format("{}: expected {}, found {}{}", what, value_text(what, expected),
                     value_text(what, *found), more);
}

std::string line_of(const ordered_json& expected, const ordered_json& found,
                    const Tolerance& tolerance) {
  const std::string name = task_name(expected);
  std::vector<std::string> parts;
  for (const auto& [what, value] : expected.items()) {
    const auto other = found.find(what);
    std::string part =
        value_difference(what, name, value, other == found.end() ? nullptr : &*other, tolerance);
    if (!part.empty()) parts.push_back(std::move(part));
  }
  return parts.empty() ? std::string() : fmt::format("{}: {}\n", name, fmt::join(parts, "; "));
}

/// What became of a task, for a line: "done after 90 s".
std::string told(const ordered_json& task) {
  const std::string result = task.value("result", std::string("?"));
  const std::string reason = task.value("reason", std::string());
  return reason.empty() ? result : result + ": " + reason;
}

}  // namespace

std::string task_name(const ordered_json& task) {
  const auto name = task.find("task");
  return name != task.end() && name->is_string() ? name->get<std::string>() : std::string();
}

std::string task_difference(const ordered_json& expected, const ordered_json& found,
                            const Tolerance& tolerance) {
  // Several may have one name: a machine is asked out of the way more than once.
  std::map<std::string, std::vector<const ordered_json*>> left;
  for (const ordered_json& task : found) left[task_name(task)].push_back(&task);
  std::string text;
  std::vector<std::string> order;
  for (const ordered_json& task : expected) {
    std::vector<const ordered_json*>& same = left[task_name(task)];
    if (same.empty()) {
      text += fmt::format("{}: expected ({}), not found\n", task_name(task), told(task));
      continue;
    }
    text += line_of(task, *same.front(), tolerance);
    order.push_back(task_name(task));
    same.erase(same.begin());
  }
  for (const ordered_json& task : found) {
    std::vector<const ordered_json*>& same = left[task_name(task)];
    if (same.empty() || same.front() != &task) continue;
    text += fmt::format("{}: found ({}), not expected\n", task_name(task), told(task));
    same.erase(same.begin());
  }
  // Starts within a tolerance may change places.
  const Allowance time = tolerance.of("time", "");
  if (!text.empty() || time.absolute > 0 || time.share > 0) return text;
  for (std::size_t i = 0; i < order.size() && i < found.size(); ++i) {
    if (order[i] == task_name(found[i])) continue;
    return fmt::format("{}: expected at place {}, found {} there\n", order[i], i + 1,
                       task_name(found[i]));
  }
  return text;
}

std::string total_difference(const std::string& what, const ordered_json& expected,
                             const ordered_json& found, const Tolerance& tolerance) {
  std::vector<std::string> parts;
  const auto add = [&](const std::string& name, const ordered_json& wanted,
                       const ordered_json& values, const std::string& key) {
    const auto got = values.find(key);
    std::string part =
        value_difference(name, "", wanted, got == values.end() ? nullptr : &*got, tolerance);
    if (!part.empty()) parts.push_back(std::move(part));
  };
  if (expected.is_object()) {
    const ordered_json none = ordered_json::object();
    const auto got = found.find(what);
    for (const auto& [name, value] : expected.items()) {
      add("cost of " + name, value, got == found.end() ? none : *got, name);
    }
  } else {
    add(what, expected, found, what);
  }
  std::string text;
  for (const std::string& part : parts) text += part + "\n";
  return text;
}

}  // namespace rubicon::golden
