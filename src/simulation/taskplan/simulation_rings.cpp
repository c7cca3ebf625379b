#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

namespace {

/// So many tasks are looked at for a ring; what waits for more is left until nothing else happens.
/// Reason: in a plan of 100,000 tasks each that begins to wait may hang on all the others.
constexpr std::size_t kMostLookedAt = 10'000;

std::string meeting(const Blocker& blocker) {
  return fmt::format("{} meets {}", blocker.moved, blocker.met);
}

}  // namespace

/// Whether none of those who may bring about what a task waits for ever will.
bool Simulation::never_comes(const Awaited& awaited, const Hopeless& hopeless) {
  return !awaited.by.empty() && std::all_of(awaited.by.begin(), awaited.by.end(),
                                            [&](int task) { return hopeless.contains(task); });
}

/// Whether a task that waits so can never go on.
bool Simulation::is_hopeless(const Waits& waits, const Hopeless& hopeless) {
  const auto never = [&](const Awaited& awaited) { return never_comes(awaited, hopeless); };
  const auto& all = waits.awaited;
  if (waits.for_any) return !all.empty() && std::all_of(all.begin(), all.end(), never);
  return std::any_of(all.begin(), all.end(), never);
}

/// Of the tasks that `roots` wait for, directly or not, and of themselves: those that wait for each
/// other so that nobody outside could help. From any of them a ring is reached.
Simulation::Hopeless Simulation::hopeless_from(std::vector<int> roots) const {
  Hopeless found;
  std::map<int, std::vector<int>> waiters;
  while (!roots.empty()) {
    const int task = roots.back();
    roots.pop_back();
    if (is_over(task) || found.contains(task)) continue;
    if (found.size() >= kMostLookedAt) return {};
    const Waits& waits = found.emplace(task, waits_of(task)).first->second;
    for (const Awaited& awaited : waits.awaited) {
      for (const int by : awaited.by) waiters[by].push_back(task);
      roots.insert(roots.end(), awaited.by.begin(), awaited.by.end());
    }
  }
  std::vector<int> open;
  for (const auto& [task, waits] : found) open.push_back(task);
  while (!open.empty()) {
    const int task = open.back();
    open.pop_back();
    const auto place = found.find(task);
    if (place == found.end() || is_hopeless(place->second, found)) continue;
    found.erase(place);
    const std::vector<int>& hope = waiters[task];
    open.insert(open.end(), hope.begin(), hope.end());
  }
  return found;
}

/// One ring of tasks each of which waits for the next, the last for the first; it begins with the
/// first in the file.
std::vector<Simulation::RingLink> Simulation::ring_in(const Hopeless& hopeless) {
  std::vector<RingLink> ring;
  int task = hopeless.begin()->first;
  while (true) {
    const auto again = std::find_if(ring.begin(), ring.end(),
                                    [&](const RingLink& link) { return link.task == task; });
    if (again != ring.end()) {
      ring.erase(ring.begin(), again);
      break;
    }
    const std::vector<Awaited>& all = hopeless.at(task).awaited;
    const auto awaited = std::find_if(
        all.begin(), all.end(), [&](const Awaited& each) { return never_comes(each, hopeless); });
    ring.push_back({task, *awaited});
    task = awaited->by.front();
  }
  const auto first =
      std::min_element(ring.begin(), ring.end(),
                       [](const RingLink& a, const RingLink& b) { return a.task < b.task; });
  std::rotate(ring.begin(), first, ring.end());
  return ring;
}

/// Tasks that wait for each other, so that none can ever go on: one of them is rejected. Seen as
/// soon as the last of them begins to wait.
bool Simulation::find_ring() {
  if (new_waits_.empty()) return false;
  const Hopeless hopeless = hopeless_from(std::exchange(new_waits_, {}));
  if (hopeless.empty()) return false;
  std::vector<int> tasks;
  for (const auto& [task, waits] : hopeless) tasks.push_back(task);
  if (!lets_one_go_on(tasks)) reject_one_of(ring_in(hopeless));
  return true;
}

/// Rejects a task of a ring, one with which the task before it could go on.
void Simulation::reject_one_of(const std::vector<RingLink>& ring) {
  std::vector<int> all;
  std::vector<int> helpful;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    all.push_back(ring[i].task);
    // A robot that nobody has stays where it is without those who would have moved it.
    if (!ring[i].awaited.idle) helpful.push_back(ring[(i + 1) % ring.size()].task);
  }
  const int task = last_of(helpful.empty() ? all : helpful);
  rejection_ = Rejection{task, text_of_ring(ring), std::move(all)};
}

std::string Simulation::text_of_ring(const std::vector<RingLink>& ring) const {
  const bool machines = std::all_of(ring.begin(), ring.end(), [&](const RingLink& link) {
    return link.awaited.kind == Awaited::Kind::way && !link.awaited.idle &&
           look_at_active(link.task)->blockers[index(link.awaited.number)].robot >= 0;
  });
  std::vector<std::string> texts;
  for (const RingLink& link : ring) texts.push_back(text_of_wait(link.task, link.awaited));
  return fmt::format("{} wait for each other: {}", machines ? "machines" : "tasks",
                     fmt::join(texts, machines ? ", " : "; "));
}

std::string Simulation::who_is(int task) const {
  const int robot = spec(task).robot;
  return robot >= 0 ? fmt::format("{} ({})", robot_spec(robot).name, spec(task).name)
                    : spec(task).name;
}

/// For whom a task waits that stands in its way, and where they meet.
std::string Simulation::text_of_way(int task, const Blocker& blocker) const {
  if (blocker.robot < 0) {
    return fmt::format("{} waits for the people of {}: {}", who_is(task),
                       spec(blocker.zone_task).name, meeting(blocker));
  }
  return fmt::format("{} waits for {}: {}", who_is(task), robot_spec(blocker.robot).name,
                     meeting(blocker));
}

/// Who waits for whom, and where.
std::string Simulation::text_of_wait(int task, const Awaited& awaited) const {
  const std::string who = who_is(task);
  const std::string& other = spec(awaited.by.front()).name;
  const auto idle = [&](int which) {
    std::string text = fmt::format(", and {} moves only in {}", robot_spec(which).name, other);
    if (!robot_spec(which).park) text += ": give it a park position";
    return awaited.idle ? text : std::string();
  };
  switch (awaited.kind) {
    case Awaited::Kind::way: {
      const Blocker& blocker = look_at_active(task)->blockers[index(awaited.number)];
      return text_of_way(task, blocker) + (blocker.robot >= 0 ? idle(blocker.robot) : "");
    }
    case Awaited::Kind::zone:
      return fmt::format("{} waits until {} has left its zone{}", who,
                         robot_spec(awaited.number).name, idle(awaited.number));
    case Awaited::Kind::resource:
      return fmt::format("{} waits for {}, which {} holds", who, desk_->name(awaited.number),
                         other);
    case Awaited::Kind::start:
    case Awaited::Kind::finish:
      break;
  }
  const schedule::Link& link = network_.tasks[index(task)].after[index(awaited.number)];
  const bool starts = end_before(link.type) == schedule::TaskEnd::start;
  return fmt::format("{} does not {} until {} has {}", who,
                     awaited.kind == Awaited::Kind::start ? "start" : "finish", other,
                     starts ? "started" : "finished");
}

/// Of several tasks the one that gives way: parking first, then the least priority, of equals the
/// last in the file.
int Simulation::last_of(const std::vector<int>& tasks) const {
  const auto key = [&](int task) { return std::tuple(is_park(task), -spec(task).priority, task); };
  return *std::max_element(tasks.begin(), tasks.end(),
                           [&](int a, int b) { return key(a) < key(b); });
}

}  // namespace rubicon::taskplan
