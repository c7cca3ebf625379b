#include "src/exchange/building_io/matching.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "src/exchange/building_io/glob.hpp"
#include "src/exchange/building_io/names.hpp"
#include "src/exchange/project_io/listing.hpp"
#include "src/exchange/project_io/plan_network.hpp"
#include "src/exchange/project_io/plan_terms.hpp"

namespace rubicon::building_io {

namespace {

using Field = MatchRule::Condition::Field;

/// Elements whose lower sides differ by less (metres) are put up together.
constexpr double kLayer = 0.1;

const std::string& field_of(const Element& element, Field field) {
  switch (field) {
    case Field::storey:
      return element.storey;
    case Field::type:
      return element.type;
    case Field::name:
      return element.name;
    case Field::guid:
      return element.guid;
    case Field::file:
      break;
  }
  return element.model;
}

bool fits(const MatchRule& rule, const Element& element) {
  return std::all_of(rule.conditions.begin(), rule.conditions.end(), [&](const auto& condition) {
    const std::string& text = field_of(element, condition.field);
    // Capital and small letters of a GlobalId are not the same.
    if (condition.field == Field::guid) return condition.pattern == text;
    return matches_glob(condition.pattern, text);
  });
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

class Matcher {
 public:
  Matcher(const std::vector<Element>& elements, const MatchFile& match,
          const project_io::Project& project, interpreter::Diagnostics& diagnostics)
      : elements_(elements), match_(match), project_(project), diagnostics_(diagnostics) {}

  Matching match() {
    project_io::Listing unheard;  // the plan's own writer says it
    const auto network =
        project_io::plan_network(project_, project_io::plan_start(project_), unheard);
    for (const auto& task : network.tasks) {
      result_.plan_names.push_back(task.name);
      is_task_.push_back(task.planned);
    }
    find_tasks();
    std::map<std::size_t, Activity> by_task;
    for (std::size_t i = 0; i < elements_.size(); ++i) place(i, by_task);
    report_idle_rules();
    for (auto& [task, activity] : by_task) {
      sort(activity);
      result_.activities.push_back(std::move(activity));
    }
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      if (is_task_[i] && !by_task.contains(i)) result_.idle_tasks.push_back(i);
    }
    return std::move(result_);
  }

 private:
  /// Which task each rule means.
  void find_tasks() {
    for (const MatchRule& rule : match_.rules) {
      std::optional<std::size_t> task;
      if (rule.action == MatchRule::Action::task) task = find_task(rule);
      task_of_rule_.push_back(task);
    }
  }

  std::optional<std::size_t> find_task(const MatchRule& rule) {
    std::vector<std::size_t> found;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      if (!is_task_[i]) continue;
      const std::string name =
          rule.in_plan ? result_.plan_names[i] : trimmed(project_.tasks[i].name);
      names.push_back(name);
      if (name == (rule.in_plan ? rule.task : trimmed(rule.task))) found.push_back(i);
    }
    if (found.size() == 1) return found.front();
    if (found.empty()) {
      const std::string near = interpreter::did_you_mean(rule.task, names);
      diagnostics_.error("I13", rule.task_span,
                         fmt::format("the schedule has no task {}", remark_name(rule.task)),
                         near.empty() ? "rubicon import SCHEDULE shows its tasks"
                                      : fmt::format("did you mean {}?", near));
    } else {
      std::string list;
      for (const std::size_t i : found) {
        list += (list.empty() ? "" : ", ") + result_.plan_names[i];
      }
      diagnostics_.error("I13", rule.task_span,
                         fmt::format("{} tasks of the schedule are called {}", found.size(),
                                     remark_name(rule.task)),
                         fmt::format("name one as it is in the plan, without marks: {}", list));
    }
    return std::nullopt;
  }

  void place(std::size_t element, std::map<std::size_t, Activity>& by_task) {
    const auto rule =
        std::find_if(match_.rules.begin(), match_.rules.end(),
                     [&](const MatchRule& each) { return fits(each, elements_[element]); });
    if (rule == match_.rules.end()) {
      result_.unmatched.push_back(element);
      return;
    }
    const auto index = static_cast<std::size_t>(rule - match_.rules.begin());
    used_.insert(index);
    switch (rule->action) {
      case MatchRule::Action::stands:
        result_.standing.push_back(element);
        return;
      case MatchRule::Action::leave_out:
        result_.left_out.push_back(element);
        return;
      case MatchRule::Action::task:
        break;
    }
    const std::optional<std::size_t> task = task_of_rule_[index];
    if (!task) return;  // told already
    Activity& activity = by_task[*task];
    activity.task = *task;
    activity.plan_name = result_.plan_names[*task];
    activity.moves.push_back({element, index});
  }

  /// Rules that put no element anywhere: most often a slip in a pattern.
  void report_idle_rules() {
    for (std::size_t i = 0; i < match_.rules.size(); ++i) {
      if (used_.contains(i)) continue;
      const MatchRule& rule = match_.rules[i];
      const bool hidden = std::any_of(elements_.begin(), elements_.end(),
                                      [&](const Element& element) { return fits(rule, element); });
      diagnostics_.warning("I30", rule.span,
                           hidden ? "rules above this one take all elements that it fits"
                                  : "no element fits this rule",
                           hidden ? "the first rule that fits counts"
                                  : "the names of storeys, types and elements stand in "
                                    "PLAN_elements.csv; * stands for anything");
    }
  }

  void sort(Activity& activity) const {
    Vec3 low = Vec3::Constant(HUGE_VAL);
    Vec3 high = -low;
    for (const Activity::Move& move : activity.moves) {
      low = low.cwiseMin(elements_[move.element].frame.origin);
      high = high.cwiseMax(elements_[move.element].frame.origin);
    }
    const int along = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
    const auto key = [&](const Activity::Move& move) {
      const Vec3& p = elements_[move.element].frame.origin;
      return std::tuple(move.rule, std::floor((p.z() - low.z()) / kLayer + 0.5), p[along],
                        p[1 - along], move.element);
    };
    std::sort(activity.moves.begin(), activity.moves.end(),
              [&](const Activity::Move& a, const Activity::Move& b) { return key(a) < key(b); });
  }

  const std::vector<Element>& elements_;
  const MatchFile& match_;
  const project_io::Project& project_;
  interpreter::Diagnostics& diagnostics_;
  std::vector<bool> is_task_;
  std::set<std::size_t> used_;  ///< rules with elements
  std::vector<std::optional<std::size_t>> task_of_rule_;
  Matching result_;
};

}  // namespace

Matching match_elements(const std::vector<Element>& elements, const MatchFile& match,
                        const project_io::Project& project, interpreter::Diagnostics& diagnostics) {
  return Matcher(elements, match, project, diagnostics).match();
}

}  // namespace rubicon::building_io
