#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using syntax::UnitKind;

/// Largest cost of an hour; more is a slip of the pen.
constexpr double kMaxCost = 1e12;

/// How far a given start value of a derived parameter may be from the computed one, m or degrees:
/// texts round to fewer digits than doubles.
constexpr double kDerivedTolerance = 1e-6;

std::optional<double> resolve_cost(Subject& subject, const std::vector<syntax::Cost>& costs,
                                   const std::string& who) {
  const auto span_of = [](const syntax::Cost& cost) { return cost.span; };
  const syntax::Cost* cost = only_one(subject, costs, "the cost of " + who, span_of);
  if (cost == nullptr) return std::nullopt;
  subject.use("cost", cost->span);
  syntax::Number amount = cost->amount;
  if (amount.unit != UnitKind::per_hour) {
    subject.error("F09", amount.span,
                  fmt::format("the cost of {} needs an amount per h, but the value is {}", who,
                              syntax::dimension_text(amount.dimension)),
                  "write for example 2 * 90 per h");
    return std::nullopt;
  }
  amount.value *= 3600;
  return bounded(subject, amount, UnitKind::per_hour, "the cost of " + who, 0, kMaxCost);
}

std::string resolve_calendar(Subject& subject, const std::vector<syntax::Name>& names,
                             const std::string& who) {
  const auto span_of = [](const syntax::Name& name) { return name.span; };
  const syntax::Name* name = only_one(subject, names, "the calendar of " + who, span_of);
  if (name == nullptr) return {};
  subject.use("calendar", name->span);
  subject.find(subject.calendars, *name, "calendar");
  return name->text;
}

class RobotLoader {
 public:
  RobotLoader(Subject& subject, const std::vector<std::string>& situations)
      : subject_(subject), situations_(situations) {}

  void load(const syntax::RobotUse& item) {
    RobotSpec robot;
    robot.span = item.name ? item.name->span : item.file.span;
    robot.robot = load_file(item);
    const std::string fallback = robot.robot ? robot.robot->model.name : std::string("robot");
    robot.name = item.name ? item.name->text : fallback;
    if (item.at) robot.X_WM = resolve_frame_or_identity(subject_, *item.at);
    const std::string who = "robot '" + robot.name + "'";
    const auto span_of = [](const syntax::Values& values) { return values.span; };
    std::vector<std::pair<int, double>> starts;
    if (const auto* values = only_one(subject_, item.start, "the start of " + who, span_of)) {
      starts = resolve_values(subject_, &robot, *values, ValueUse::start);
    }
    set_starts(subject_, robot, starts, item.start.empty() ? item.span : item.start[0].span);
    robot.cost_per_hour = resolve_cost(subject_, item.cost, who);
    robot.charges = resolve_charges(subject_, item.charges, who);
    robot.calendar = resolve_calendar(subject_, item.calendar, who);
    robot.breakdown = resolve_breakdown(subject_, item.breakdowns, who);
    if (const auto* values = only_one(subject_, item.park, "park of " + who, span_of)) {
      subject_.use("park", values->span);
      robot.park = resolve_values(subject_, &robot, *values, ValueUse::park);
    }
    declare(item, std::move(robot));
  }

 private:
  /// The robot of a file, with the script that the plan gives it, if any.
  std::shared_ptr<const CheckedRobot> load_file(const syntax::RobotUse& item) {
    const std::string path = resolve_path(subject_.model.path, item.file.text);
    const std::string who = item.name ? "robot '" + item.name->text + "'" : std::string("robot");
    const auto span_of = [](const syntax::String& script) { return script.span; };
    const auto* written = only_one(subject_, item.behaviour, "the behaviour of " + who, span_of);
    std::optional<GivenScript> script;
    if (written != nullptr) script = {*written, resolve_path(subject_.model.path, written->text)};
    const auto key = std::pair(path, script ? script->path : std::string());
    const auto known = loaded_.find(key);
    if (known != loaded_.end()) return known->second;
    std::shared_ptr<const CheckedRobot> robot;
    if (const auto file = open_robot(item.file, path)) {
      robot = check_robot(*file, subject_.sources, subject_.files, &situations_,
                          subject_.diagnostics, script ? &*script : nullptr);
    }
    loaded_.emplace(key, robot);
    return robot;
  }

  /// Nothing after reporting why it cannot be read.
  std::optional<FileId> open_robot(const syntax::String& written, const std::string& path) {
    const auto known = files_.find(path);
    if (known != files_.end()) return known->second;
    std::optional<FileId> file;
    std::variant<std::string, FileFailure> text = subject_.files.read_text(path);
    if (const auto* failure = std::get_if<FileFailure>(&text)) {
      subject_.error("F01", written.span,
                     fmt::format("robot file '{}': {}", written.text, failure->message));
    } else {
      file = subject_.sources.add(path, std::get<std::string>(std::move(text)));
    }
    files_.emplace(path, file);
    return file;
  }

  void declare(const syntax::RobotUse& item, RobotSpec robot) {
    if (item.name) {
      const auto [place, is_new] =
          subject_.robots.emplace(robot.name, static_cast<int>(subject_.model.robots.size()));
      if (!is_new) {
        const auto first = static_cast<std::size_t>(place->second);
        subject_.twice(item.name->span, fmt::format("robot '{}' is declared twice", robot.name),
                       subject_.model.robots[first].span);
        return;
      }
    }
    subject_.model.robots.push_back(std::move(robot));
  }

  Subject& subject_;
  const std::vector<std::string>& situations_;
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const CheckedRobot>>
      loaded_;                                          ///< by robot file and given script
  std::map<std::string, std::optional<FileId>> files_;  ///< robot files by path
};

}  // namespace

void set_starts(Subject& subject, RobotSpec& robot,
                const std::vector<std::pair<int, double>>& values, Span span) {
  if (!robot.robot || !robot.robot->usable) return;
  const robot::RobotModel& model = robot.robot->model;
  robot.start = model.start_values();
  for (const auto& [index, value] : values) {
    const auto i = static_cast<std::size_t>(index);
    const robot::Parameter& parameter = model.parameters[i];
    if (!parameter.derived) {
      robot.start[i] = robot::reduced(parameter, value);
    }
  }
  const robot::Mounting mounting{robot.X_WM, robot.start};
  robot::update_derived(model, mounting, robot.start);
  for (const auto& [index, value] : values) {
    const auto i = static_cast<std::size_t>(index);
    const robot::Parameter& parameter = model.parameters[i];
    if (!parameter.derived) continue;
    const double off = robot::reduced(parameter, robot.start[i] - value);
    if (std::fabs(off) <= kDerivedTolerance) continue;
    subject.error("P13", span,
                  fmt::format("'{}' of robot '{}' is computed from other parameters: it starts at "
                              "{}, not at {}",
                              parameter.display_name, robot.name, robot.start[i], value));
  }
}

void check_robots(Subject& subject, const std::vector<std::string>& situations) {
  RobotLoader loader(subject, situations);
  for (const syntax::PlanItem& each : subject.plan.items) {
    if (const auto* item = std::get_if<syntax::RobotUse>(&each)) loader.load(*item);
    const auto* fleet = std::get_if<syntax::FleetItem>(&each);
    if (fleet == nullptr) continue;
    const int errors = subject.diagnostics.errors();
    for (const syntax::RobotUse& member : members_of(subject, *fleet)) {
      // What is wrong with one is wrong with all.
      if (subject.diagnostics.errors() == errors) loader.load(member);
    }
  }
}

void check_crews(Subject& subject) {
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::CrewItem>(&each);
    if (item == nullptr) continue;
    CrewSpec crew;
    crew.name = item->name.text;
    crew.span = item->name.span;
    const std::string who = "crew '" + crew.name + "'";
    const auto span_of = [](const syntax::Number& number) { return number.span; };
    if (const auto* size = only_one(subject, item->size, "the size of " + who, span_of)) {
      subject.use("size", size->span);
      const auto value = bounded(subject, *size, UnitKind::none, "the size of " + who, 1, 1000000);
      if (value && std::floor(*value) != *value) {
        subject.error(
            "P09", size->span,
            fmt::format("the size of {} is a whole number of people, found {}", who, *value));
      } else if (value) {
        crew.size = *value;
      }
    }
    crew.cost_per_hour = resolve_cost(subject, item->cost, who);
    crew.charges = resolve_charges(subject, item->charges, who);
    crew.calendar = resolve_calendar(subject, item->calendar, who);
    const auto robot = subject.robots.find(crew.name);
    if (robot != subject.robots.end()) {
      subject.twice(crew.span, fmt::format("'{}' is the name of a robot already", crew.name),
                    subject.model.robots[static_cast<std::size_t>(robot->second)].span);
      continue;
    }
    const auto [place, is_new] =
        subject.crews.emplace(crew.name, static_cast<int>(subject.model.crews.size()));
    if (!is_new) {
      subject.twice(crew.span, fmt::format("crew '{}' is declared twice", crew.name),
                    subject.model.crews[static_cast<std::size_t>(place->second)].span);
      continue;
    }
    subject.model.crews.push_back(std::move(crew));
  }
}

}  // namespace rubicon::interpreter::plan_check
