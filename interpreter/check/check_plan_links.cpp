#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "interpreter/check/bare_seconds.hpp"
#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

std::optional<LinkType> type_of(Subject& subject, const syntax::Name& name) {
  if (const auto type = schedule::parse_link_type(name.text)) return type;
  subject.error(
      "P08", name.span,
      fmt::format("expected FS, SS, FF or SF (finish to start, start to start, ...), found '{}'",
                  name.text));
  return std::nullopt;
}

/// The starts and finishes of all tasks, and which must come before which: 2 t is the start of task
/// t, 2 t + 1 its finish. Links of other types than FS make this finer than tasks alone.
class EventGraph {
 public:
  explicit EventGraph(Subject& subject) : subject_(subject), tasks_(subject.model.tasks) {}

  void report_cycles() {
    const std::size_t count = 2 * tasks_.size();
    state_.assign(count, State::untouched);
    next_.assign(count, 0);
    for (std::size_t root = 0; root < count; ++root) {
      if (state_[root] == State::untouched) walk(root);
    }
  }

 private:
  enum class State : std::uint8_t { untouched, open, done };

  /// Events that come before `event`: its start for a finish, and what its links say.
  std::size_t predecessor_count(std::size_t event) const {
    return tasks_[event / 2].after.size() + (event % 2);
  }

  /// The i-th of them; nothing for a link that holds the other event.
  std::optional<std::size_t> predecessor(std::size_t event, std::size_t i) const {
    const TaskSpec& task = tasks_[event / 2];
    if (i == task.after.size()) return event - 1;
    const LinkSpec& link = task.after[i];
    const bool holds_start = schedule::end_after(link.type) == schedule::TaskEnd::start;
    if (holds_start != (event % 2 == 0)) return std::nullopt;
    const bool from_finish = schedule::end_before(link.type) == schedule::TaskEnd::finish;
    return 2 * static_cast<std::size_t>(link.task) + (from_finish ? 1 : 0);
  }

  // Depth first without recursion: chains of tasks are long.
  void walk(std::size_t root) {
    path_.assign(1, root);
    state_[root] = State::open;
    while (!path_.empty()) {
      const std::size_t at = path_.back();
      if (next_[at] == predecessor_count(at)) {
        state_[at] = State::done;
        path_.pop_back();
        continue;
      }
      const std::size_t i = next_[at]++;
      const std::optional<std::size_t> before = predecessor(at, i);
      if (!before) continue;
      if (state_[*before] == State::open) {
        report(*before);
      } else if (state_[*before] == State::untouched) {
        state_[*before] = State::open;
        path_.push_back(*before);
      }
    }
  }

  void report(std::size_t first) {
    constexpr std::size_t kMostNamed = 12;
    std::vector<std::size_t> members;
    for (auto at = std::find(path_.begin(), path_.end(), first); at != path_.end(); ++at) {
      if (members.empty() || members.back() != *at / 2) members.push_back(*at / 2);
    }
    if (members.size() > 1 && members.back() == first / 2) members.pop_back();
    std::string text;
    for (std::size_t i = 0; i < members.size() && i < kMostNamed; ++i) {
      text += tasks_[members[i]].name + " after ";
    }
    if (members.size() > kMostNamed) {
      text += fmt::format("... ({} more) after ", members.size() - kMostNamed);
    }
    text += tasks_[first / 2].name;
    subject_.error("P08", last_link(),
                   members.size() == 1
                       ? fmt::format("task '{}' waits for itself", tasks_[first / 2].name)
                       : fmt::format("these tasks wait for each other: {}", text));
  }

  /// The last link of the path; a step from a finish to its own start is none.
  Span last_link() const {
    for (auto at = path_.rbegin(); at != path_.rend(); ++at) {
      const TaskSpec& task = tasks_[*at / 2];
      const std::size_t i = next_[*at] - 1;
      if (i < task.after.size()) return task.after[i].span;
    }
    return tasks_[path_.back() / 2].span;
  }

  Subject& subject_;
  const std::vector<TaskSpec>& tasks_;
  std::vector<State> state_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> path_;
};

}  // namespace

std::vector<LinkSpec> resolve_links(Subject& subject, const Scope& scope,
                                    const std::vector<syntax::Link>& links) {
  std::vector<LinkSpec> result;
  for (const syntax::Link& link : links) {
    LinkSpec spec;
    spec.span = link.span;
    const std::optional<int> task = find_task(subject, scope, link.name);
    const std::optional<LinkType> type =
        link.type ? type_of(subject, *link.type) : std::optional(LinkType::FS);
    if (link.lag) {
      const auto lag = bounded(subject, *link.lag, syntax::UnitKind::time, "the lag of a link",
                               -kMaxDuration, kMaxDuration);
      if (lag) {
        warn_of_bare_seconds(subject, *link.lag, "the lag of a link", *lag);
        spec.lag = schedule::ticks_from_seconds(*lag);
      }
    }
    if (scope.records_uses && type && *type != LinkType::FS) {
      subject.use(link.type->text, link.span);
    }
    if (scope.records_uses && spec.lag != 0) subject.use("lag", link.span);
    if (!task || !type) continue;
    spec.task = *task;
    spec.type = *type;
    result.push_back(spec);
  }
  return result;
}

void check_cycles(Subject& subject) { EventGraph(subject).report_cycles(); }

}  // namespace rubicon::interpreter::plan_check
