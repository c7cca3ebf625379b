#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "interpreter/check/check_plan_parts.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

/// Most choices of members for one task: each is checked and waited for.
constexpr std::size_t kMaxChoices = 1000;

/// Longest chain of `by same as`.
constexpr int kMaxSame = 1000;

using math::at;

void add_member(Subject& subject, const syntax::Name& name, std::set<std::string>& seen,
                PoolSpec& pool) {
  if (!seen.insert(name.text).second) {
    subject.error("P02", name.span, fmt::format("'{}' is named twice", name.text));
    return;
  }
  const auto robot = subject.robots.find(name.text);
  const auto crew = subject.crews.find(name.text);
  if (robot == subject.robots.end() && crew == subject.crews.end()) {
    subject.unknown(name.span, "robot or crew", name.text, {&subject.robots, &subject.crews});
    return;
  }
  const bool is_robot = robot != subject.robots.end();
  if (pool.members.empty()) pool.of_robots = is_robot;
  if (is_robot != pool.of_robots) {
    subject.error(
        "P40", name.span,
        fmt::format("a pool is of robots or of crews; '{}' is a {}, and those before it "
                    "are {}",
                    name.text, is_robot ? "robot" : "crew", pool.of_robots ? "robots" : "crews"),
        "make it two pools, and name both in by");
    return;
  }
  pool.members.push_back(is_robot ? robot->second : crew->second);
}

void set_choice(Subject& subject, const syntax::PoolItem& item, PoolSpec& pool) {
  const auto span_of = [](const syntax::Name& name) { return name.span; };
  const syntax::Name* rule =
      only_one(subject, item.choose, "choose of pool '" + pool.name + "'", span_of);
  if (rule == nullptr || rule->text == "first") return;
  if (rule->text == "least_used") {
    pool.choice = PoolSpec::Choice::least_used;
  } else if (rule->text == "nearest") {
    pool.choice = PoolSpec::Choice::nearest;
    if (!pool.of_robots && !pool.members.empty()) {
      subject.error(
          "P40", rule->span,
          fmt::format("the plan does not say where crews are: pool '{}' has no nearest", pool.name),
          "write choose first; or choose least_used;");
    }
  } else {
    static const std::map<std::string, int> kRules = {
        {"first", 0}, {"nearest", 0}, {"least_used", 0}};
    subject.unknown(rule->span, "rule of choice", rule->text, {&kRules},
                    "; expected first, nearest or least_used");
  }
}

/// The item of the task that `name` means in `scope`; null if there is none.
const syntax::TaskItem* task_item(const Subject& subject, const Scope& scope,
                                  const syntax::QualifiedName& name) {
  const ModuleInfo* module = scope.module;
  if (name.body) {
    const auto imported = subject.task_items.find(name.text());
    if (imported != subject.task_items.end()) return imported->second;
    const auto place = subject.places.find(name.body->text);
    if (place == subject.places.end()) return nullptr;
    const int index = subject.place_infos[at(place->second)].module;
    if (index < 0) return nullptr;
    module = &subject.module_infos[at(index)];
  }
  if (module != nullptr) {
    const auto found = module->task_index.find(name.name.text);
    if (found != module->task_index.end()) return module->tasks[at(found->second)];
    if (name.body) return nullptr;
  }
  const auto found = subject.task_items.find(name.name.text);
  return found == subject.task_items.end() ? nullptr : found->second;
}

/// The pools that a task names, or those of the task whose members it has.
std::vector<int> pools_of(Subject& subject, const Scope& scope, const syntax::TaskItem& item,
                          int depth) {
  std::vector<int> pools;
  for (const syntax::TaskPart& part : item.parts) {
    const auto* by = std::get_if<syntax::ByItem>(&part);
    if (by == nullptr) continue;
    for (const syntax::Name& name : by->names) {
      const auto found = subject.pools.find(name.text);
      if (found != subject.pools.end()) pools.push_back(found->second);
    }
    for (const syntax::QualifiedName& name : by->same_as) {
      const syntax::TaskItem* other = task_item(subject, scope, name);
      if (other == nullptr || depth > kMaxSame) continue;
      for (const int pool : pools_of(subject, scope, *other, depth + 1)) pools.push_back(pool);
      if (depth == 0 && pools.empty()) {
        subject.error("P40", name.span, fmt::format("'{}' is not done by a pool", name.text()),
                      "name its robot or crew in by");
      }
    }
  }
  return pools;
}

}  // namespace

void add_pool(Subject& subject, const syntax::PoolItem& item) {
  PoolSpec pool;
  pool.name = item.name.text;
  pool.span = item.name.span;
  subject.use("pool", item.span);
  std::set<std::string> seen;
  for (const syntax::Name& name : item.of) add_member(subject, name, seen, pool);
  if (item.of.empty()) {
    subject.error("P40", pool.span, fmt::format("pool '{}' has no members", pool.name),
                  "write of NAME, NAME;");
  }
  set_choice(subject, item, pool);
  const auto other = [&](const std::map<std::string, int>& index, const char* what) {
    if (index.count(pool.name) == 0) return false;
    subject.error("P02", pool.span,
                  fmt::format("'{}' is the name of a {} already", pool.name, what));
    return true;
  };
  if (other(subject.robots, "robot") || other(subject.crews, "crew")) return;
  const auto [place, is_new] =
      subject.pools.emplace(pool.name, static_cast<int>(subject.model.pools.size()));
  if (!is_new) {
    subject.twice(pool.span, fmt::format("pool '{}' is declared twice", pool.name),
                  subject.model.pools[at(place->second)].span);
    return;
  }
  subject.model.pools.push_back(std::move(pool));
}

void check_pools(Subject& subject) {
  for (const syntax::PlanItem& each : subject.plan.items) {
    if (const auto* item = std::get_if<syntax::PoolItem>(&each)) add_pool(subject, *item);
  }
}

std::vector<std::vector<PoolMember>> choices_of(Subject& subject, const Scope& scope,
                                                const syntax::TaskItem& item) {
  std::vector<std::vector<PoolMember>> choices = {{}};
  for (const int pool : pools_of(subject, scope, item, 0)) {
    const std::size_t members = subject.model.pools[at(pool)].members.size();
    if (choices.size() * members > kMaxChoices) {
      subject.error("P40", item.name.span,
                    fmt::format("task '{}' has more than {} choices among the members of its pools",
                                item.name.text, kMaxChoices));
      return {{}};
    }
    std::vector<std::vector<PoolMember>> longer;
    for (const auto& choice : choices) {
      for (int member = 0; member < static_cast<int>(members); ++member) {
        longer.push_back(choice);
        longer.back().push_back({pool, member});
      }
    }
    // Of a pool without members something was said already.
    if (!longer.empty()) choices = std::move(longer);
  }
  return choices;
}

void check_same_as(Subject& subject) {
  const std::vector<TaskSpec>& tasks = subject.model.tasks;
  for (const TaskSpec& task : tasks) {
    if (!task.same_as) continue;
    std::set<int> seen;
    std::vector<const TaskSpec*> open = {&task};
    while (!open.empty() && !seen.contains(*task.same_as)) {
      const TaskSpec& last = *open.back();
      open.pop_back();
      for (const LinkSpec& link : last.after) {
        const bool starts = link.type == LinkType::FS || link.type == LinkType::SS;
        if (starts && seen.insert(link.task).second) open.push_back(&tasks[at(link.task)]);
      }
    }
    if (seen.contains(*task.same_as)) continue;
    const std::string& other = tasks[at(*task.same_as)].name;
    subject.error("P40", task.span,
                  fmt::format("task '{}' has the same as '{}', and does not start after it",
                              task.name, other),
                  fmt::format("add after {};", other));
  }
}

}  // namespace rubicon::interpreter::plan_check

namespace rubicon::interpreter {

const char* name_of(PoolSpec::Choice choice) {
  switch (choice) {
    case PoolSpec::Choice::first:
      return "first";
    case PoolSpec::Choice::nearest:
      return "nearest";
    case PoolSpec::Choice::least_used:
      return "least_used";
  }
  return "";
}

std::string member_names(const PlanModel& plan, const TaskSpec& choice) {
  std::string names;
  for (const PoolMember& member : choice.members) {
    const PoolSpec& pool = plan.pools[static_cast<std::size_t>(member.pool)];
    const auto index =
        static_cast<std::size_t>(pool.members[static_cast<std::size_t>(member.member)]);
    if (!names.empty()) names += ", ";
    names += pool.of_robots ? plan.robots[index].name : plan.crews[index].name;
  }
  return names;
}

}  // namespace rubicon::interpreter
