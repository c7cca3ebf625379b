#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "src/results/report/columns.hpp"
#include "src/results/report/earthwork.hpp"
#include "src/results/report/schedule_text.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::report {

namespace {

using interpreter::Attributes;
using taskplan::ComponentAttributes;
using taskplan::CriticalTask;
using taskplan::ResourceUse;
using taskplan::Schedule;
using taskplan::TaskOutcome;
using taskplan::TimetableOutcome;

/// Nothing where there are none, so that results without attributes stay as they were.
void write_attributes(trace::JsonBuilder& json, const Attributes& attributes) {
  if (attributes.empty()) return;
  json.key("attributes").begin_object();
  for (const auto& [key, text] : attributes) json.field(key, std::string_view(text));
  json.end_object();
}

void write_dates(trace::JsonBuilder& json, const Schedule& schedule, const TaskOutcome& task) {
  if (!schedule.start_at) return;
  json.field("begins", date_text(*schedule.start_at, task.start));
  json.field("ends", date_text(*schedule.start_at, task.start + task.duration));
}

void write_lift(trace::JsonBuilder& json, const taskplan::LiftOutcome& lift) {
  json.key("lift").begin_object();
  json.key("from").seconds(lift.from).key("to").seconds(lift.to).key("own").seconds(lift.own);
  json.key("overtime").seconds(lift.overtime).field("why", std::string_view(lift.why));
  json.end_object();
}

/// When it should have been, and how much later it could have been.
void write_plan_dates(trace::JsonBuilder& json, const Schedule& schedule, const TaskOutcome& task) {
  if (task.due) json.key("due").seconds(*task.due);
  if (const auto late = task.late()) json.key("late").seconds(*late);
  if (task.baseline) {
    json.key("baseline").begin_object();
    json.key("start").seconds(task.baseline->start).key("finish").seconds(task.baseline->finish);
    if (schedule.start_at) {
      json.field("begins", date_text(*schedule.start_at, task.baseline->start));
      json.field("ends", date_text(*schedule.start_at, task.baseline->finish));
    }
    json.end_object();
  }
  if (!task.floats) return;
  json.key("float").begin_object();
  json.key("total").seconds(task.floats->total).key("free").seconds(task.floats->free);
  json.key("latest_start").seconds(task.floats->latest_start);
  json.key("latest_finish").seconds(task.floats->latest_finish);
  json.end_object();
}

void write_place(trace::JsonBuilder& json, const char* name, const coverage::Place& place) {
  json.key(name).begin_array().value(place.x).value(place.y).end_array();
}

/// The joints between strips of a floor, and each place of those that are over the limit.
void write_joints(trace::JsonBuilder& json, const TaskOutcome& task) {
  const coverage::JointFindings& joints = *task.joints;
  json.key("cold_joints").begin_object().key("after").seconds(task.cover->cold_after);
  json.field("count", static_cast<int>(joints.cold.size())).field("length", joints.cold_length);
  json.field("all_joints", joints.joint_length).key("oldest").seconds(joints.oldest);
  if (joints.oldest > 0) write_place(json, "oldest_at", joints.oldest_at);
  json.key("places").begin_array();
  for (const coverage::ColdJoint& each : joints.cold) {
    json.begin_object();
    write_place(json, "from", each.from);
    write_place(json, "to", each.to);
    json.key("age").seconds(each.age).key("late").seconds(each.age - task.cover->cold_after);
    json.key("laid").seconds(each.laid).key("joined").seconds(each.joined).end_object();
  }
  json.end_array().end_object();
}

std::string task_json(const Schedule& schedule, const TaskOutcome& task) {
  trace::JsonBuilder json;
  json.begin_object();
  json.field("task", std::string_view(task.task)).field("robot", std::string_view(task.robot));
  json.field("crew", std::string_view(crew_text(task)));
  json.key("start").seconds(task.start).key("duration").seconds(task.duration);
  write_dates(json, schedule, task);
  json.key("motion").seconds(task.motion_time).key("work").seconds(task.work_time);
  json.key("waited").begin_object();
  json.key("predecessor").seconds(task.waits.predecessor);
  json.key("resource").seconds(task.waits.resource);
  json.key("machine").seconds(task.waits.machine).key("shift").seconds(task.waits.shift);
  if (schedule.breaks_down) json.key("repair").seconds(task.waits.repair);
  json.end_object();
  if (task.thinking > 0) json.key("thinking").seconds(task.thinking);
  if (schedule.costed) json.field("cost", task.cost);
  if (schedule.burns_fuel) json.field("fuel", task.fuel);
  json.field("tried", task.tried).field("accepted", task.accepted);
  json.field("result", name_of(task.result)).field("reason", std::string_view(task.reason));
  if (task.parking) json.field("parking", true);
  if (!task.component.empty()) json.field("component", std::string_view(task.component));
  write_attributes(json, task.attributes);
  write_plan_dates(json, schedule, task);
  if (task.lift) write_lift(json, *task.lift);
  if (!task.support.empty()) json.key("support").strings(task.support);
  if (!task.missed.empty()) json.key("missed").strings(task.missed);
  if (task.cover) {
    json.key("cover").begin_object().field("area", std::string_view(task.area));
    if (task.cover->holes > 0) {
      json.field("holes", task.cover->holes).field("left_out", task.cover->holes_left_out);
      json.field("depth", task.cover->depth).field("length", task.cover->length);
    } else {
      json.field("covered_area", task.cover->covered_area).field("covered", task.cover->covered);
      if (task.cover->thickness > 0) json.field("volume", task.cover->volume);
      json.field("length", task.cover->length).field("turns", task.cover->turns);
    }
    if (task.joints) write_joints(json, task);
    json.end_object();
  }
  if (task.dig && task.result == taskplan::TaskResult::done) {
    write_dig(json, schedule, task);
  }
  if (task.motion_dig && task.result == taskplan::TaskResult::done) {
    write_motion_dig(json, schedule, task);
  }
  if (task.haul && task.result == taskplan::TaskResult::done) write_haul(json, task);
  write_workspaces(json, schedule, task);
  if (!task.choice.empty()) json.field("choice", std::string_view(task.choice));
  json.end_object();
  return json.take();
}

std::string use_json(const Schedule& schedule, const ResourceUse& use) {
  trace::JsonBuilder json;
  json.begin_object().field("name", std::string_view(use.name));
  json.field("kind", use.robot ? "robot" : "crew");
  if (!use.robot) json.field("size", use.size);
  json.field("tasks", use.tasks).key("held").seconds(use.held).key("busy").seconds(use.busy);
  json.key("shifts").seconds(use.shift_time).field("utilisation", use.utilisation());
  if (schedule.costed) {
    json.key("cost_per_hour");
    if (use.rate) {
      json.value(*use.rate);
    } else {
      json.null();
    }
    json.field("cost", use.cost);
  }
  if (use.fuel) json.field("fuel", *use.fuel);
  json.end_object();
  return json.take();
}

std::string critical_json(const CriticalTask& task) {
  trace::JsonBuilder json;
  json.begin_object().field("task", std::string_view(task.task));
  json.field("work_counts", task.work_counts).field("text", std::string_view(task.text));
  json.end_object();
  return json.take();
}

std::string component_json(const ComponentAttributes& component) {
  trace::JsonBuilder json;
  json.begin_object().field("component", std::string_view(component.component));
  write_attributes(json, component.attributes);
  json.end_object();
  return json.take();
}

std::string timetable_json(const TimetableOutcome& timetable) {
  trace::JsonBuilder json;
  json.begin_object().field("name", std::string_view(timetable.name));
  json.field("stops", timetable.stops).key("late").seconds(timetable.late);
  json.field("stands_before", std::string_view(timetable.stands)).end_object();
  return json.take();
}

/// The attributes that have a column of their own.
constexpr std::array<std::string_view, 4> kOwnColumns = {"name", "storey", "type", "guid"};

/// All others, as `key=text; key=text`.
std::string free_attributes(const Attributes& of_task, const Attributes& of_component) {
  std::string text;
  for (const Attributes* attributes : {&of_task, &of_component}) {
    for (const auto& [key, value] : *attributes) {
      if (std::find(kOwnColumns.begin(), kOwnColumns.end(), key) != kOwnColumns.end()) continue;
      text += fmt::format("{}{}={}", text.empty() ? "" : "; ", key, value);
    }
  }
  return text;
}

/// The last columns: what the plan says of the task and of the component it moves. Where the task
/// says nothing of a storey, a type or a guid those of the component stand.
class AttributeColumns {
 public:
  static constexpr const char* kNames = "name,component,component_name,storey,type,guid,attributes";

  explicit AttributeColumns(const Schedule& schedule) {
    for (const ComponentAttributes& each : schedule.components) {
      components_.emplace(each.component, &each.attributes);
    }
  }

  std::string of(const TaskOutcome& task) const {
    static const Attributes kNone;
    const auto found = components_.find(task.component);
    const Attributes& component = found == components_.end() ? kNone : *found->second;
    const auto either = [&](std::string_view key) {
      const std::string* own = interpreter::find_attribute(task.attributes, key);
      if (own == nullptr) own = interpreter::find_attribute(component, key);
      return own == nullptr ? std::string() : csv_field(*own);
    };
    return fmt::format("{},{},{},{},{},{},{}", csv_field(taskplan::client_name(task.attributes)),
                       csv_field(task.component), csv_field(taskplan::client_name(component)),
                       either("storey"), either("type"), either("guid"),
                       csv_field(free_attributes(task.attributes, component)));
  }

 private:
  std::map<std::string_view, const Attributes*> components_;
};

std::string lost_days_json(const taskplan::LostDaysOutcome& lost) {
  trace::JsonBuilder json;
  json.begin_object().field("calendar", std::string_view(lost.calendar));
  json.field("working_days", lost.working_days);
  json.field("lost", static_cast<int>(lost.dates.size())).key("dates").strings(lost.dates);
  return json.end_object().take();
}

std::string breakdown_json(const taskplan::BreakdownOutcome& breakdown) {
  trace::JsonBuilder json;
  json.begin_object().field("robot", std::string_view(breakdown.robot));
  json.field("during", std::string_view(breakdown.during));
  json.key("worked").seconds(breakdown.worked).key("repair").seconds(breakdown.repair);
  json.key("from").seconds(breakdown.from).key("to").seconds(breakdown.to);
  return json.end_object().take();
}

/// `"name":[` and one element a line.
template <typename List, typename Write>
std::string list_text(const char* name, const List& list, const Write& write) {
  std::string text = fmt::format("\"{}\":[", name);
  const char* separator = "\n";
  for (const auto& each : list) {
    text += separator + write(each);
    separator = ",\n";
  }
  return text + "\n]";
}

}  // namespace

std::string schedule_json(const Schedule& schedule) {
  std::string text = "{";
  text += list_text("tasks", schedule.tasks,
                    [&](const TaskOutcome& task) { return task_json(schedule, task); });
  text += fmt::format(",\"process_time\":{}", seconds_text(schedule.process_time));
  if (schedule.start_at) {
    trace::JsonBuilder dates;
    dates.begin_object().field("start_at", schedule::text_of(*schedule.start_at));
    dates.field("ends", date_text(*schedule.start_at, schedule.process_time)).end_object();
    const std::string both = dates.take();
    text += "," + both.substr(1, both.size() - 2);
  }
  if (schedule.uncertain > 0 || schedule.loses_days || schedule.breaks_down) {
    trace::JsonBuilder sample;
    sample.begin_object().field("uncertain", schedule.uncertain);
    if (schedule.sample) {
      sample.key("sample").begin_object();
      sample.field("seed", static_cast<std::int64_t>(schedule.sample->seed));
      sample.field("run", static_cast<std::int64_t>(schedule.sample->run)).end_object();
    }
    sample.end_object();
    const std::string both = sample.take();
    text += "," + both.substr(1, both.size() - 2);
  }
  if (schedule.costed) {
    trace::JsonBuilder cost;
    cost.begin_object().field("cost", schedule.cost);
    cost.field("currency", std::string_view(schedule.currency));
    if (schedule.has_kinds) {
      cost.key("cost_by_kind").begin_object();
      for (const taskplan::CostKind kind : told_kinds(schedule)) {
        cost.field(name_of(kind), schedule.cost_by_kind[static_cast<std::size_t>(kind)]);
      }
      cost.end_object();
    }
    cost.end_object();
    const std::string both = cost.take();
    text += "," + both.substr(1, both.size() - 2);
  }
  if (schedule.burns_fuel) {
    trace::JsonBuilder fuel;
    text += ",\"fuel\":" + fuel.value(schedule.fuel).take();
  }
  if (const std::string hauling = hauling_json(schedule); !hauling.empty()) {
    text += ",\"hauling\":" + hauling;
  }
  text += ",\n" + list_text("resources", schedule.resources,
                            [&](const ResourceUse& use) { return use_json(schedule, use); });
  text += ",\n" + list_text("critical", schedule.critical, critical_json);
  if (!schedule.timetables.empty()) {
    text += ",\n" + list_text("timetables", schedule.timetables, timetable_json);
  }
  if (schedule.loses_days) {
    text += ",\n" + list_text("lost_days", schedule.lost_days, lost_days_json);
  }
  if (schedule.breaks_down) {
    text += ",\n" + list_text("breakdowns", schedule.breakdowns, breakdown_json);
  }
  if (!schedule.components.empty()) {
    text += ",\n" + list_text("components", schedule.components, component_json);
  }
  return text + "}\n";
}

namespace {

/// Whether a guide took time to think.
bool has_thought(const Schedule& schedule) {
  return std::any_of(schedule.tasks.begin(), schedule.tasks.end(),
                     [](const TaskOutcome& task) { return task.thinking > 0; });
}

}  // namespace

std::string schedule_csv(const Schedule& schedule) {
  const AttributeColumns attributes(schedule);
  const bool thinks = has_thought(schedule);
  std::string text = fmt::format(
      "task,robot,crew,start,duration,tried,accepted,result,reason,motion,work,waited_predecessor,"
      "waited_resource,waited_machine,waited_shift,cost,begins,ends,due,late,baseline_start,"
      "baseline_finish,total_float,free_float,{}{}{}\n",
      AttributeColumns::kNames, schedule.breaks_down ? ",waited_repair" : "",
      thinks ? ",thinking" : "");
  for (const TaskOutcome& task : schedule.tasks) {
    const auto date_field = [&](interpreter::Ticks time) {
      return schedule.start_at ? date_text(*schedule.start_at, time) : std::string();
    };
    const auto seconds_field = [](const std::optional<interpreter::Ticks>& time) {
      return time ? seconds_text(*time) : std::string();
    };
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}{}{}\n",
        csv_field(task.task), csv_field(task.robot), csv_field(crew_text(task)),
        seconds_text(task.start), seconds_text(task.duration), task.tried, task.accepted,
        name_of(task.result), csv_field(task.reason), seconds_text(task.motion_time),
        seconds_text(task.work_time), seconds_text(task.waits.predecessor),
        seconds_text(task.waits.resource), seconds_text(task.waits.machine),
        seconds_text(task.waits.shift),
        schedule.costed ? fmt::format("{:.2f}", task.cost) : std::string(), date_field(task.start),
        date_field(task.start + task.duration), seconds_field(task.due), seconds_field(task.late()),
        task.baseline ? seconds_text(task.baseline->start) : std::string(),
        task.baseline ? seconds_text(task.baseline->finish) : std::string(),
        task.floats ? seconds_text(task.floats->total) : std::string(),
        task.floats ? seconds_text(task.floats->free) : std::string(), attributes.of(task),
        schedule.breaks_down ? "," + seconds_text(task.waits.repair) : std::string(),
        thinks ? "," + seconds_text(task.thinking) : std::string());
  }
  return text;
}

}  // namespace rubicon::report
