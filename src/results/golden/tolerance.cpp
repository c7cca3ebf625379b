#include "src/results/golden/tolerance.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rubicon::golden {

namespace {

using nlohmann::ordered_json;

constexpr std::array<std::pair<std::string_view, double>, 3> kTimeUnits = {
    {{"s", 1}, {"min", 60}, {"h", 3600}}};

[[noreturn]] void refuse(std::string_view what, const ordered_json& found) {
  throw std::invalid_argument(fmt::format(
      "expected {} as the tolerance of {}, found {}",
      what == "time" ? "\"5 %\", \"30 s\", \"2 min\", \"1 h\" or seconds" : "\"5 %\" or an amount",
      what, found.dump()));
}

Allowance read_allowance(std::string_view what, const ordered_json& json) {
  Allowance allowed;
  if (json.is_number()) {
    allowed.absolute = json.get<double>();
  } else if (json.is_string()) {
    const std::string text = json.get<std::string>();
    std::size_t end = 0;
    double number = 0;
    try {
      number = std::stod(text, &end);
    } catch (const std::exception&) {
      refuse(what, json);
    }
    const std::size_t unit_at = text.find_first_not_of(' ', end);
    const std::string unit = unit_at == std::string::npos ? "" : text.substr(unit_at);
    if (unit == "%") {
      allowed.share = number / 100;
    } else {
      double factor = 0;
      for (const auto& [name, seconds] : kTimeUnits) {
        if (what == "time" && unit == name) factor = seconds;
      }
      if (factor == 0) refuse(what, json);
      allowed.absolute = number * factor;
    }
  } else {
    refuse(what, json);
  }
  const bool is_number = std::isfinite(allowed.absolute) && std::isfinite(allowed.share);
  if (!is_number || allowed.absolute < 0 || allowed.share < 0) refuse(what, json);
  return allowed;
}

void check_members(const ordered_json& members, bool of_task) {
  if (!members.is_object()) {
    throw std::invalid_argument("expected an object with time, cost and tasks as the tolerance");
  }
  for (const auto& [name, value] : members.items()) {
    if (name == "time" || name == "cost") {
      read_allowance(name, value);
    } else if (name == "tasks" && !of_task && value.is_object()) {
      for (const auto& [task, own] : value.items()) check_members(own, true);
    } else {
      throw std::invalid_argument(
          fmt::format("expected time, cost or tasks in the tolerance, found '{}'", name));
    }
  }
}

}  // namespace

double Allowance::of(double expected) const { return absolute + share * std::fabs(expected); }

Tolerance::Tolerance(const ordered_json& document) {
  const auto found = document.find("tolerance");
  if (found == document.end()) return;
  check_members(*found, false);
  members_ = *found;
}

Allowance Tolerance::of(std::string_view what, const std::string& task) const {
  const std::string name(what);
  if (!task.empty() && members_.contains("tasks")) {
    const ordered_json& tasks = members_.at("tasks");
    if (tasks.contains(task) && tasks.at(task).contains(name)) {
      return read_allowance(what, tasks.at(task).at(name));
    }
  }
  return members_.contains(name) ? read_allowance(what, members_.at(name)) : Allowance{};
}

std::vector<std::string> Tolerance::tasks() const {
  std::vector<std::string> names;
  const auto tasks = members_.find("tasks");
  if (tasks == members_.end()) return names;
  for (const auto& [name, own] : tasks->items()) names.push_back(name);
  return names;
}

}  // namespace rubicon::golden
