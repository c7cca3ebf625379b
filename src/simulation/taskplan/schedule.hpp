#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/check/rare.hpp"
#include "interpreter/machine/machine.hpp"
#include "interpreter/program/world.hpp"
#include "src/earth/hauling/truck_rounds.hpp"
#include "src/motion/coverage/joints.hpp"
#include "src/simulation/schedule/civil_time.hpp"
#include "src/simulation/schedule/task_float.hpp"

namespace rubicon::taskplan {

using interpreter::Ticks;

/// `ended_short`: the motion of a short plan was made and did not get to its goal.
enum class TaskResult { done, ended_short, rejected, not_reached };
/// As tables and traces write it: done, short, rejected, "not reached".
const char* name_of(TaskResult result);

/// What a motion of a task is for.
enum class MotionPurpose { grip, carry, place, go, dig, haul };

/// One motion of a task and how it ended. One whose goal held already has no tries. A motion that
/// waited for another machine and went on is several of these.
struct MotionOutcome {
  MotionPurpose purpose = MotionPurpose::go;
  Ticks start = 0;
  interpreter::MotionEnd end;
};

/// Time in which a task stood still, from the beginning of the plan to its finish.
struct WaitTimes {
  Ticks predecessor = 0;  ///< before its links let it start, and held by a link to its finish
  Ticks resource = 0;     ///< for its robot and crews, before its start and on the way
  Ticks machine = 0;      ///< for another machine or people in the way
  Ticks shift = 0;        ///< out of shift
  Ticks repair = 0;       ///< its robot was under repair, nights between included
};

/// A robot or a crew that a task had.
struct ResourceHold {
  int resource = -1;  ///< robots first, then crews
  Ticks held = 0;     ///< in its shifts, and motions after their end
  Ticks busy = 0;     ///< of that it moved or worked; trucks and who serves them: in their rounds
  Ticks from = 0, to = 0;
  Ticks off = 0;       ///< of `held`: under repair, or nothing goes on out of somebody's shift
  int people = 1;      ///< of a crew, so many of its size
  Ticks overtime = 0;  ///< of `held`, by the plan's `overtime`
  Ticks before = 0;    ///< working time of the task until it was taken
  Ticks after = 0;     ///< and since it was given back
};

/// Part of a task: so much working time, by the hours in which it waits in a queue of the
/// allocator.
struct TaskStretch {
  Ticks work = 0;
  int queue = -1;
  bool whole = false;  ///< a lift: it stays in one shift
};

/// A lift that waited for a shift into which it fits, or that went on after one.
struct LiftOutcome {
  Ticks from = 0;      ///< its hook work began, or it was picked up
  Ticks to = 0;        ///< it was released
  Ticks own = 0;       ///< of that it moved or was worked on
  Ticks overtime = 0;  ///< of that out of the shifts of all that it needs
  std::string why;     ///< "starts 07:00: 23 min do not fit before 12:00"
};

/// One bucket of a robot that digs. Times that are worked, from the beginning of its task.
struct BucketOutcome {
  soil::CubicMillimetres volume = 0;
  int truck = -1;      ///< from 0; -1: none
  Ticks begin = 0;     ///< it sets out for the cut
  Ticks at_cut = 0;    ///< it is above it
  Ticks raised = 0;    ///< it has cut, and is clear of the soil
  Ticks at_truck = 0;  ///< where it is emptied
  Ticks empty = 0;
};

/// What a robot dug by its own motions.
struct MotionDigOutcome {
  std::string earth, trucks;                    ///< names; "": no trucks
  soil::CubicMillimetres volume = 0;            ///< of the task
  soil::CubicMillimetres bucket = 0, load = 0;  ///< that a bucket, a truck takes at most
  Ticks time = 0;                               ///< worked, to the last tip
  Ticks waited = 0;                             ///< of that for trucks
  std::vector<BucketOutcome> buckets;
  std::vector<hauling::Load> loads;    ///< in the order in which they were tipped
  std::vector<hauling::Queue> queues;  ///< of stages that serve
  hauling::TruckRounds::Work hauling;  ///< of the trucks, and of those who serve these
  int bodies = 0;      ///< trucks with bodies that haul for it, in tasks of their own
  int body_loads = 0;  ///< that these took
  int truck_count = 0;
  bool uncertain = false;  ///< stages of the trucks are

  soil::CubicMillimetres dug() const;
  /// Means over the buckets, s: of a whole cycle and of its parts.
  double mean_cycle() const;
  double mean_dig() const;
  double mean_swing() const;
  double mean_dump() const;
  double mean_return() const;
  /// m3 of bank volume in an hour that is worked.
  double per_hour() const;
};

/// One load of a truck with a body. Times that are worked, from the beginning of its task.
struct HauledLoad {
  std::string dig;                    ///< the task that loaded it
  soil::CubicMillimetres volume = 0;  ///< bank volume
  Ticks arrived = 0;                  ///< in the queue, or at once where it is loaded
  Ticks began = 0;                    ///< it stands there
  Ticks loaded = 0;
  Ticks at_tip = 0;
  Ticks tipped = 0;
};

/// What a truck with a body hauled.
struct HaulOutcome {
  std::vector<HauledLoad> loads;
  Ticks time = 0;  ///< worked

  soil::CubicMillimetres hauled() const;
};

/// One task as it went. A rejected task leaves no mark: it takes no time.
struct TaskOutcome {
  std::string task;
  std::string robot;  ///< "" for crew work
  std::vector<std::string>
      crews;             ///< of `by`, then those that hook, adjust, release, in this order
  bool parking = false;  ///< not a task of the plan: a robot asked out of the way
  Ticks start = 0;
  Ticks duration = 0;     ///< to its finish; nights included
  Ticks motion_time = 0;  ///< of the duration, what motions took
  Ticks thinking = 0;     ///< of `motion_time`, what its guides took to think
  int stops = 0;          ///< how often it waited for other machines
  int foreseen = 0;       ///< how often its way met what others are foreseen to sweep
  int rounds = 0;         ///< and guides found one round that
  int overlaps = 0;       ///< how often it made workspaces overlap, where that is watched
  Ticks work_time = 0;    ///< of the duration, what crews took
  WaitTimes waits;        ///< with motion_time and work_time this adds up to start + duration
  double cost =
      0;  ///< of its robot and crews for the time it had them, of its material; in whole cents
  double fuel = 0;  ///< l, of these robots and crews
  int tried = 0;    ///< attempts of all its motions, accepted or not
  int accepted = 0;
  TaskResult result = TaskResult::done;
  std::string reason;     ///< why not done; of one that ended short how far from its goal
  std::string component;  ///< that it moves; "": none
  interpreter::Attributes attributes;  ///< as the plan gives them
  int motions = 0;                     ///< how many it made; the trace tells of each
  std::vector<ResourceHold> holds;
  std::vector<TaskStretch> parts;  ///< where not all of it goes by the hours of what it holds
  interpreter::Rare<LiftOutcome> lift;
  std::string choice;                             ///< by pools: whom it has and why
  std::optional<Ticks> due;                       ///< after the beginning of the plan
  std::optional<interpreter::Baseline> baseline;  ///< when others planned it
  std::optional<schedule::TaskFloat> floats;      ///< of a task of the plan that is done
  /// Where the plan only warns: what it puts down that does not stand, what does not without what
  /// it takes.
  std::vector<std::string> support;
  std::vector<std::string> missed;  ///< waypoints that its motions left without reaching them
  interpreter::Rare<interpreter::CoverSpec> cover;  ///< of a task that covers a floor
  std::string area;                                 ///< this floor
  /// Where `cover` says when joints are cold: what the tool laid, until the task is done; then the
  /// joints of it.
  std::vector<coverage::LaidStretch> laid;
  interpreter::Rare<coverage::JointFindings> joints;
  interpreter::Rare<interpreter::DigSpec> dig;     ///< of a task that digs by durations
  interpreter::Rare<MotionDigOutcome> motion_dig;  ///< of a task whose robot digs
  interpreter::Rare<HaulOutcome> haul;             ///< of a task whose robot hauls

  /// How much later than `due` it was done; nothing if it is not done or not due.
  std::optional<Ticks> late() const;
};

/// What a task is called by the client; "" if the plan does not say.
std::string client_name(const interpreter::Attributes& attributes);

/// The names of all crews that work on a task, each once: those of `by`, then of its works.
std::vector<std::string> crew_names(const interpreter::PlanModel& plan,
                                    const interpreter::TaskSpec& task);

/// How trucks that haul by durations for a task spent their time, s.
struct TruckWork {
  std::string trucks;  ///< the crew
  double driving = 0;  ///< of all together: neither loaded nor in a queue
  /// Diggers (not a robot), then those who serve a stage: how long they had a truck, all together.
  std::vector<std::pair<std::string, double>> serving;
};
/// Nothing of a task without such trucks.
std::optional<TruckWork> truck_work(const interpreter::PlanModel& plan, const TaskOutcome& task);
/// Of the trucks of a dig, or of those who serve them, all together: how long they are at work.
/// Nothing: the task has no rounds, or the resource no part in them.
std::optional<Ticks> time_in_rounds(const interpreter::PlanModel& plan, const TaskOutcome& task,
                                    int resource);

/// What money is spent on.
enum class CostKind { use, overtime, rental, mobilisation, fuel, material, overhead };
inline constexpr std::size_t kCostKinds = 7;
/// "use", "overtime", ...
const char* name_of(CostKind kind);

/// How much a robot or a crew was used. Of a crew of which tasks took a part, times count by the
/// share they took: half of it for 2 h is 1 h.
struct ResourceUse {
  std::string name;
  bool robot = false;
  double size = 1;             ///< people of a crew
  int tasks = 0;               ///< that had it
  Ticks held = 0;              ///< tasks had it, in its shifts, and motions after their end
  Ticks busy = 0;              ///< of that it moved or worked
  Ticks shift_time = 0;        ///< its shifts from the beginning of the plan to its end
  std::optional<double> rate;  ///< per hour
  double cost = 0;             ///< for the time held, rental, mobilisation, fuel; whole cents
  std::optional<double> fuel;  ///< l; nothing: the plan does not say what it burns

  /// Share of its shifts in which tasks had it; 0 without shifts.
  double utilisation() const {
    return shift_time > 0 ? static_cast<double>(held) / static_cast<double>(shift_time) : 0;
  }
};

/// A task that makes the whole as long as it is, and what it waited for.
struct CriticalTask {
  std::string task;
  bool work_counts = false;  ///< shortening the task itself may shorten the whole
  std::string text;          ///< a sentence: what it waited for
};

/// What the plan says of a component only to hand it on.
struct ComponentAttributes {
  std::string component;
  interpreter::Attributes attributes;
};

/// How something with a timetable kept it.
struct TimetableOutcome {
  std::string name;
  int stops = 0;
  Ticks late = 0;      ///< by so much its timetable had shifted when the last task was done
  std::string stands;  ///< what it stood before then; "": it went, or was not on the site
};

/// A machine broke down.
struct BreakdownOutcome {
  std::string robot;
  std::string during;  ///< the task that it had
  Ticks worked = 0;    ///< since it was repaired last
  Ticks repair = 0;    ///< in its working hours
  Ticks from = 0, to = 0;
};

/// What the weather took of a calendar, up to the end of the plan.
struct LostDaysOutcome {
  std::string calendar;
  int working_days = 0;            ///< days with working time, lost or not
  std::vector<std::string> dates;  ///< YYYY-MM-DD of those that are lost
};

/// A plan as it went: tasks in the order in which they started, of several at a moment as in the
/// file.
struct Schedule {
  std::vector<TaskOutcome> tasks;
  std::vector<ResourceUse> resources;  ///< robots, then crews, as in the file
  std::vector<CriticalTask> critical;  ///< the critical path, first to last
  Ticks process_time = 0;
  bool feasible = true;  ///< every task is done
  std::optional<schedule::CivilTime> start_at;
  std::string currency;
  bool costed = false;  ///< the plan says what something costs
  double cost = 0;      ///< whole cents, as all sums: rows are rounded so that they add up
  /// The same by kind. Tasks have use, overtime, fuel and material, robots and crews use, overtime,
  /// rental, mobilisation and fuel.
  std::array<double, kCostKinds> cost_by_kind = {};
  bool burns_fuel = false;                        ///< the plan says what something burns,
  bool pays_fuel = false;                         ///< and what that costs
  double fuel = 0;                                ///< l
  bool has_kinds = false;                         ///< the plan says more than rates for use
  std::vector<ComponentAttributes> components;    ///< those that have attributes, as in the file
  std::vector<TimetableOutcome> timetables;       ///< as in the file
  int uncertain = 0;                              ///< durations of the plan that are not certain
  std::optional<interpreter::SampleSpec> sample;  ///< by which they were drawn; nothing: means
  bool loses_days = false;  ///< the plan has calendars that do; without a sample none is lost
  std::vector<LostDaysOutcome> lost_days;  ///< of these, as in the file
  std::vector<std::string> workspaces;  ///< machines that keep theirs apart, those first in front
  bool foresees = false;                ///< those behind look at what those before will sweep
  bool watches = false;                 ///< where workspaces overlap it is only told
  bool breaks_down = false;  ///< the plan has machines that do; without a sample none does
  std::vector<BreakdownOutcome> breakdowns;  ///< by their begin
};

/// The kinds that are told of a plan that says more than rates for use.
std::vector<CostKind> told_kinds(const Schedule& schedule);

/// Adds what the plan says of tasks and components: what moves, dates, attributes.
void add_attributes(const interpreter::PlanModel& plan, Schedule& schedule);

}  // namespace rubicon::taskplan
