#include "src/results/debug/recording.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rubicon::debug {

namespace {

/// "hook of low" for low.hook, a body of a robot; all else by its name.
std::string body_text(const std::map<std::string, std::vector<std::string>>& robots,
                      const std::string& name) {
  for (std::size_t dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1)) {
    const auto robot = robots.find(name.substr(0, dot));
    if (robot == robots.end()) continue;
    const std::string body = name.substr(dot + 1);
    const auto& bodies = robot->second;
    if (std::find(bodies.begin(), bodies.end(), body) != bodies.end()) {
      return body + " of " + robot->first;
    }
  }
  return name;
}

}  // namespace

const PlannedTask* Recording::task_of(const TaskRun& run) const {
  const std::string& name = texts[run.name()];
  const auto found = std::find_if(tasks.begin(), tasks.end(),
                                  [&](const PlannedTask& task) { return task.name == name; });
  return found == tasks.end() ? nullptr : &*found;
}

const Place* Recording::place_of(const Event& event) const {
  return event.place < places.size() ? &places[event.place] : nullptr;
}

const std::string* Recording::line(const Place& place) const {
  if (place.file >= files.size() || place.line < 1) return nullptr;
  const auto& lines = files[place.file].lines;
  const auto number = static_cast<std::size_t>(place.line);
  return number <= lines.size() ? &lines[number - 1] : nullptr;
}

std::string Recording::place_text(const Place& place) const {
  return fmt::format("{}:{}", files[place.file].name, place.line);
}

std::string Recording::refusal_text(const Refusal& refusal) const {
  if (!refusal.met.empty()) {
    return fmt::format("{} meets {}", body_text(robots, refusal.moved),
                       body_text(robots, refusal.met));
  }
  if (refusal.reason == "at goal") return "it is there already";
  if (refusal.reason == "no direction") return "it has no direction";
  if (refusal.reason.starts_with("limit ")) return "limit of " + refusal.reason.substr(6);
  return refusal.reason;
}

}  // namespace rubicon::debug
