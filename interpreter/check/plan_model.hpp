#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "interpreter/check/charts_spec.hpp"
#include "interpreter/check/check.hpp"
#include "interpreter/check/explore_spec.hpp"
#include "interpreter/check/rare.hpp"
#include "interpreter/expand/expand.hpp"
#include "src/earth/hauling/hauling.hpp"
#include "src/earth/soil/terrain.hpp"
#include "src/fleets/lanes/lane_network.hpp"
#include "src/motion/coverage/coverage.hpp"
#include "src/motion/geometry/shape.hpp"
#include "src/motion/geometry/timetable.hpp"
#include "src/motion/guides/guide_spec.hpp"
#include "src/simulation/sampling/duration_law.hpp"
#include "src/simulation/schedule/calendar_rules.hpp"
#include "src/simulation/schedule/civil_time.hpp"
#include "src/simulation/schedule/link.hpp"

namespace rubicon::interpreter {

/// A goal as a plan gives it: parameter values (file units), or a frame for the tool in the world.
struct GoalSpec {
  std::vector<std::pair<int, double>> values;  ///< parameter index, value
  std::optional<math::Pose> X_WG;              ///< with values both hold
  Span span;
  /// Of a task that covers a floor: whether the tool works on the way to it, or goes on to where it
  /// works next.
  enum class Work : std::uint8_t { none, travelling, working };
  Work work = Work::none;
  double pace = 0;  ///< m/s of the tool on the way to it, at most; 0: as fast as the machine goes
};

/// How near is near enough. Negative: not given (0 + epsilon for values; 1e-6 m and rad for
/// frames).
struct Within {
  double length = -1;                          ///< m
  std::vector<std::pair<int, double>> values;  ///< per parameter (file units)
};

/// What a motion asks beside its goals.
struct MotionClauses : robot::GoalClauses {
  std::optional<robot::LineDeviation> deviation = {};  ///< of `line`; nothing: the robot's
  /// Bodies of the robot and components that they may cut into.
  std::vector<std::pair<int, int>> entered = {};
};

/// A calendar and where its name stands.
struct CalendarSpec : schedule::CalendarRules {
  Span span;
};

/// What a plan says of a thing only to hand it on: `storey "0"` has the key storey,
/// `attribute fire "60 min"` the key fire. No two of a thing have the same key.
struct Attribute {
  std::string key;
  std::string text;  ///< UTF-8 on one line, not empty, without control characters
  bool operator==(const Attribute&) const = default;
};
/// In the order of the file.
using Attributes = std::vector<Attribute>;

/// The text of the attribute `key`; null if there is none.
const std::string* find_attribute(const Attributes& attributes, std::string_view key);

/// Something that stands on the site at the beginning, or a crew that holds it.
struct ThingRef {
  enum class Kind { component, robot, site, crew };
  Kind kind = Kind::component;
  int index = -1;  ///< into components, robots, crews; of the site -1: all its shapes
  auto operator<=>(const ThingRef&) const = default;
};

/// What a component is fixed to: a component or the site.
struct Fixing {
  ThingRef to;
  int after = -1;  ///< the task that must be done first; -1: it holds wherever they touch
};

struct ComponentSpec {
  std::string name;  ///< unique in the plan, placed modules' as PLACE.NAME
  std::vector<geometry::Shape> shapes;
  math::Pose X_WO = math::Pose::Identity();  ///< where it stands at first
  math::Pose X_OG = math::Pose::Identity();  ///< grip: where the tool frame takes hold, in {O}
  double mass = 0;                           ///< kg
  Span span;
  Attributes attributes = {};
  std::optional<double> cost = {};       ///< of its material
  std::vector<Fixing> fixed_to = {};     ///< what of it the component touches carries it
  std::vector<ThingRef> braced_by = {};  ///< components, crews: keep it from turning over
  bool people = false;                   ///< people are in or on it
};

/// What a machine, or all of a crew, burns.
struct FuelUse {
  double working = 0;           ///< l per h while it moves or works
  double idling = 0;            ///< l per h in the rest of the time in which a task has it
  std::optional<double> price;  ///< of a litre
};

/// What a robot or a crew costs besides its hours.
struct Charges {
  std::optional<double> rental_per_day;
  std::optional<std::pair<schedule::Date, schedule::Date>> rental_days = {};  ///< first and last
  std::optional<double> mobilisation = {};
  double overtime = 1;      ///< factor for what it is held outside of `normal`
  std::string normal = {};  ///< name of a calendar; "": its own
  std::optional<FuelUse> fuel = {};
};

/// When a machine breaks down, by the hours that it moved or worked, and how long a repair takes in
/// its working hours. A duration that is certain is a sequence of one.
struct BreakdownSpec {
  sampling::DurationLaw every;
  sampling::DurationLaw takes;
};

struct RobotSpec {
  std::string name;
  std::shared_ptr<const CheckedRobot> robot;
  math::Pose X_WM = math::Pose::Identity();
  std::vector<double> start;  ///< all parameters: the robot's start values overridden by the plan's
  std::optional<double> cost_per_hour;
  std::string calendar;
  std::optional<std::vector<std::pair<int, double>>> park;
  Span span;
  Charges charges = {};
  int fleet = -1;  ///< index into fleets, -1: it is in none
  std::optional<BreakdownSpec> breakdown = {};
};

struct CrewSpec {
  std::string name;
  double size = 1;  ///< people, a whole number
  std::optional<double> cost_per_hour;
  std::string calendar;
  Span span;
  Charges charges = {};
};

/// Robots, or crews, of which a task has one.
struct PoolSpec {
  enum class Choice { first, nearest, least_used };
  std::string name;
  bool of_robots = true;
  std::vector<int> members;  ///< indices into robots or crews, as listed
  Choice choice = Choice::first;
  Span span;
};

/// Nodes and lanes that the vehicles of fleets drive on (world frame).
struct NetworkSpec {
  std::string name;
  Span span;
  lanes::NetworkDescription description;
  std::vector<math::Pose> X_WN;  ///< by node
};

/// Vehicles alike that drive on a network; a pool of the same name gives one of them to a task.
struct FleetSpec {
  std::string name;
  Span span;
  int network = -1;
  std::vector<int> robots;              ///< indices into robots
  std::vector<lanes::NodeIndex> nodes;  ///< to each: where it begins, and parks
  double speed = 1;                     ///< m/s, of each at most
  double width = 0;                     ///< m, between the sides of each, without a load
  guides::GuideSpec guide;              ///< by which each drives
};

/// So many people of a crew.
struct NeedSpec {
  int crew = -1;
  int people = 0;
};

/// A member that a task may have of a pool.
struct PoolMember {
  int pool = -1;
  int member = -1;  ///< index into the members of the pool
};

using schedule::LinkType;

struct LinkSpec {
  int task = -1;  ///< index into PlanModel::tasks
  LinkType type = LinkType::FS;
  schedule::Ticks lag = 0;
  Span span;
};

struct WorkSpec {
  double duration = 0;  ///< s
  int crew = -1;        ///< index into crews; -1: whoever holds the task
  Span span;
  bool turning = false;  ///< people turn the load about the vertical, to how it is to stand
  /// Of one that is not certain; then `duration` is its mean, or what was drawn.
  std::optional<sampling::DurationLaw> law = {};
  int draw = -1;  ///< its number among what is drawn (`Draws`), -1: it is certain
};

/// When a client or a schedule of others wants a task: ticks after the beginning of the plan.
struct Baseline {
  schedule::Ticks start = 0;
  schedule::Ticks finish = 0;
};

/// A floor in the plan view, or any plane that a tool works over.
struct AreaSpec {
  std::string name;
  Span span;
  /// Its frame {A}: the area lies in its x-y plane, the tool works from where z points.
  math::Pose X_WA = math::Pose::Identity();
  coverage::FloorDescription floor;
};

/// How a task covers a floor. Where its tool goes is in `via` and `go`.
struct CoverSpec {
  int area = 0;
  double width = 1;      ///< m
  double thickness = 0;  ///< m; 0: not given
  double pace = 0;     ///< m/s of the tool where it works, at most; 0: as fast as the machine goes
  double volume = 0;   ///< m3 of what it lays, 0: not known
  double covered = 0;  ///< share of what the tool can reach
  double covered_area = 0;  ///< m2
  double length = 0;        ///< m, the way of the tool
  int turns = 0;
  double turn_radius = 0;  ///< m; 0: the machine turns on the spot
  double clearance = 0;    ///< m
  double above = 0;        ///< m, of the tool over the area
  int holes = 0;           ///< of a pattern that is drilled; 0: it works along lines
  int holes_left_out = 0;  ///< of the pattern: where the tool may not be
  double depth = 0;        ///< m, of holes
  /// The floor with all that stands on it, what its way does, and how it was found, in {A}; of
  /// holes the last only has its points. Shared: they are large, and tasks are copied.
  std::shared_ptr<const coverage::FloorDescription> floor;
  std::shared_ptr<const coverage::CoverageWay> way;
  coverage::Measures measures;
  schedule::Ticks cold_after = 0;  ///< a joint between strips is cold after this; 0: not asked
};

/// The ground as a height field. What is never dug of it is part of the site; what a task digs is a
/// component that leaves with it.
struct EarthSpec {
  std::string name;
  Span span;
  math::Pose X_WE = math::Pose::Identity();  ///< upright; see soil::Terrain for {E}
  soil::Terrain before;                      ///< as it is at the beginning
  soil::Terrain after;                       ///< when all that is to be dug of it is dug
  double stands_deg = 90;                    ///< undisturbed soil stands so steep
  double swell = 0;
  std::optional<double> density = {};     ///< kg/m3, as it lies
  std::optional<double> repose_deg = {};  ///< loose soil lies no steeper
  int heap = -1;                          ///< the component that is tipped on it, -1: nothing is
};

/// How a task digs, loads and hauls soil by the durations of its stages. How long that takes is its
/// work in `takes`.
struct DigSpec {
  hauling::Operation operation;
  double swell = 0;  ///< loose volume is (1 + swell) x bank volume
  int trucks = -1;   ///< index into crews
  int earth = -1;    ///< index into earths, -1: only a volume is given
  int soil = -1;     ///< then the component that it takes away
  /// Then the ground of the earth without the digs before this one, and without this one, too.
  std::shared_ptr<const soil::Terrain> before = {}, after = {};  // shared: they are large
  hauling::Result result;  ///< with the means, or as its durations were drawn
  int draw = -1;           ///< its number among the digs that are drawn (`Draws`)
};

/// How a robot digs a pit bucket by bucket, with its own body. How long that takes comes out of its
/// motions. The tool is held to the heading frame {H}: the way from where the robot stands to the
/// tool, level, is its x, up its z.
struct MotionDigSpec {
  int earth = -1;
  int soil = -1;  ///< the component that is dug away
  /// The ground without the digs that are over before it by the links; without this one, too.
  std::shared_ptr<const soil::Terrain> before, after;  // shared: they are large, and tasks copied
  soil::CubicMillimetres volume = 0;                   ///< bank volume, all of the task
  soil::CubicMillimetres bucket = 0;                   ///< bank volume that a bucket takes at most
  double swell = 0;
  soil::Millimetres layer = 0;      ///< of the depth of a layer
  soil::Millimetres tolerance = 0;  ///< what is left so little above the bottom comes away with it
  double clearance = 0.5;           ///< m above the soil, before a cut and after it
  math::Pose X_HT_cut = math::Pose::Identity();    ///< rotations
  math::Pose X_HT_carry = math::Pose::Identity();  ///< as it comes to the place where it is emptied
  std::optional<math::Pose> X_HT_open = {};
  math::Vec3 p_WD = math::Vec3::Zero();  ///< where it is emptied
  WorkSpec fill, dump;                   ///< of no duration where the plan gives none
  int trucks = -1;                       ///< index into crews, -1: the soil vanishes where it falls
  hauling::Operation hauls;              ///< with trucks: their loads and stages
  // with trucks that have bodies
  std::optional<math::Pose> X_WL = {};  ///< where the tool frame of one that is loaded stands
  std::vector<math::Pose> queue = {};   ///< where others wait for that, in this order
  std::vector<int> haulers = {};        ///< the tasks that haul what it digs
  std::optional<double> density = {};   ///< kg/m3 as it lies: its own, else that of the earth
  bool loads_bodies() const { return X_WL.has_value(); }
};

/// How a truck with a body hauls what robots dig: it goes to one of them, is loaded, goes to where
/// it tips, and comes back, until all of them are done. Places are those of its tool frame.
struct HaulSpec {
  std::vector<int> digs;                           ///< tasks
  std::vector<soil::CubicMillimetres> loads = {};  ///< bank volume that it takes, to each of them
  double bed = 0;                                  ///< m3, loose; 0: not given
  double payload = 0;                              ///< kg; 0: not given
  std::vector<math::Pose> out = {}, back = {};     ///< waypoints, loaded and empty
  std::vector<math::Pose> tips = {};
  WorkSpec tip = {};                                ///< of no duration where the plan gives none
  std::vector<std::pair<int, double>> raised = {};  ///< parameters while it tips
  int earth = -1;  ///< on which its loads lie in a heap, -1: they leave the site
  math::Vec3 p_TH = math::Vec3::Zero();  ///< where they fall, in its tool frame
};

/// The dynamic workspace of a machine is what it would sweep until it stands if it had to stop now,
/// in the plan view. No two of those of these machines overlap.
struct WorkspacesSpec {
  std::vector<int> robots;                ///< those named first go first
  double reaction = 1;                    ///< s until it brakes
  double braking = 2;                     ///< m/s2
  double turn_braking = 30;               ///< deg/s2
  std::optional<double> look_ahead = {};  ///< s, by which the risk has fallen to kRiskAhead
  double risk = 0.8;                      ///< from which on what is foreseen counts
  bool watch = false;                     ///< where they overlap it is only told
  Span span = {};

  /// The risk that a machine is where it is foreseen falls evenly from 1 now.
  static constexpr double kRiskAhead = 0.8;
  /// s: so far ahead what is foreseen counts; 0: nothing is foreseen.
  double foreseen() const { return look_ahead.value_or(0) * (1 - risk) / (1 - kRiskAhead); }
};

struct TaskSpec {
  std::string name;
  int robot = -1;                                 ///< index into robots, -1 none
  std::vector<int> crews;                         ///< from `by`, in order
  std::optional<int> move;                        ///< component index
  math::Pose X_WO_goal = math::Pose::Identity();  ///< where the component's frame {O} shall stand
  std::optional<GoalSpec> go;
  Rare<CoverSpec> cover = {};  ///< then `via` and `go` are its way
  Rare<DigSpec> dig = {};
  Rare<MotionDigSpec> motion_dig = {};
  Rare<HaulSpec> haul = {};
  std::vector<int> remove;  ///< component indices
  std::optional<WorkSpec> hook, adjust, release;
  std::vector<WorkSpec> takes;
  std::vector<GoalSpec> via;
  std::vector<guides::GuideSpec> guides;  ///< of its motions, tried in this order
  std::vector<std::string> situations;
  Within within;
  MotionClauses clauses;
  std::optional<double> budget;
  double priority = 0;
  bool whole = true;                   ///< what it moves is lifted whole: see `held_whole`
  schedule::Ticks not_before = 0;      ///< after the beginning of the plan, as the next two
  std::optional<schedule::Ticks> due;  ///< it is late if it finishes later
  std::optional<Baseline> baseline;    ///< to compare with; it holds nobody
  std::vector<geometry::Shape> zones;
  /// The zones and the air above them, where no load may hang (world).
  std::vector<geometry::Shape> zones_overhead;
  std::vector<LinkSpec> after;
  Span span;                                 ///< its name token
  Span move_span, zone_span, priority_span;  ///< where these items stand, if they do
  Attributes attributes = {};
  std::vector<NeedSpec> needs = {};      ///< of crews of which it does not take all
  std::vector<int> also_robots = {};     ///< `by all of` robots: held, and not moved
  std::vector<PoolMember> members = {};  ///< of a choice: whom it has of the pools
  /// By pools: the task with each choice of their members, those of the last pool first to change.
  /// The task itself then has only who is named besides.
  std::vector<TaskSpec> choices = {};
  std::optional<int> same_as = {};  ///< the task whose members it has
};

/// Two things that may overlap at the beginning: `touching`, or the first embedded in the second.
struct WaiverSpec {
  ThingRef first, second;
  Span span;
};

/// Two things that overlap at the beginning deeper than the contact tolerance.
struct OverlapSpec {
  std::string first, second;  ///< as in messages: a component, a robot's body, the load, the site
  double depth = 0;           ///< m
};

/// Whether what stands must be carried by what is below it.
struct SupportRules {
  enum class Mode { off, warn, on };
  /// Friction where things rest on each other, when forces have to balance: of concrete and timber
  /// on each other, dry, about the least.
  static constexpr double kFriction = 0.5;
  Mode mode = Mode::off;
  bool equilibrium = false;  ///< forces between all that stands must be able to balance
  double gap = 0.01;         ///< m: what is no farther below carries
};
/// "off", "warn", "on".
const char* name_of(SupportRules::Mode mode);

/// Where components lie until they are taken, or wait on their way (world frame).
struct StorageSpec {
  std::string name;
  std::vector<geometry::Shape> shapes;
};

/// What moves by itself by a timetable, in the way of every machine (shapes in its own frame {O}).
struct MovingSpec {
  std::string name;
  Span span;
  std::vector<geometry::Shape> shapes;
  geometry::Timetable timetable;
  std::vector<geometry::Shape> overhead;  ///< with people: the shapes and the air above them, where
                                          ///< no load may hang; else empty
};

/// What draws are made by.
struct SampleSpec {
  std::uint64_t seed = 1;
  std::uint64_t run = 0;
};

/// A plan that was read and checked, modules placed and every name resolved.
struct PlanModel {
  std::string name;
  std::optional<SampleSpec> sample = {};  ///< by which its durations were drawn
  std::string path;
  bool short_form = false;
  double contact = 1e-3;                ///< m
  double budget = 20000;                ///< attempts of a motion
  std::vector<std::string> situations;  ///< switched on for the whole plan
  std::vector<geometry::Shape> site;    ///< obstacles that are always there (world frame)
  /// To each shape of the site whose it is, "" by itself; may be shorter. The earths are at its
  /// end.
  std::vector<std::string> site_names = {};
  std::vector<StorageSpec> storages;
  std::vector<MovingSpec> movings;
  std::vector<AreaSpec> areas;
  std::vector<EarthSpec> earths;
  std::vector<ComponentSpec> components;
  std::vector<RobotSpec> robots;
  std::vector<CrewSpec> crews;
  std::vector<PoolSpec> pools;
  std::vector<NetworkSpec> networks;
  std::vector<FleetSpec> fleets;
  std::optional<ChartsSpec> charts = {};    ///< with policy charts: the plan has nothing else
  std::optional<ExploreSpec> explore = {};  ///< with policy tarry or fraenkel: likewise
  std::optional<double> overhead_per_day;
  std::vector<CalendarSpec> calendars;
  std::vector<TaskSpec> tasks;  ///< file order
  std::vector<WaiverSpec> waivers;
  /// What overlaps at the beginning and is not waived; nothing: nobody has looked.
  std::optional<std::vector<OverlapSpec>> overlaps;
  SupportRules support;
  std::optional<WorkspacesSpec> workspaces = {};
  /// Components that do not stand at the beginning; nothing: nobody has looked.
  std::optional<std::vector<int>> floating;
  std::optional<schedule::CivilTime> start_at;
  std::string currency;
  bool whole = true;   ///< of tasks that do not say it themselves
  ParameterTexts set;  ///< parameters that were given from outside, with which all this was made

  // short form
  std::vector<GoalSpec> via;
  std::optional<GoalSpec> goal;
  std::vector<guides::GuideSpec> guides;
  std::vector<geometry::Shape> carry;  ///< tool coordinates
  Within within;
  MotionClauses clauses;

  /// What the plan uses, with its place, that `run` may not execute yet: e.g. {"calendar", span}.
  struct Use {
    std::string what;
    Span span;
  };
  std::vector<Use> uses;  ///< calendar, cost, park, zone, import, priority, start_at,
                          ///< currency, parallel links ...
};

/// Whether nothing may hang on the hook of the task out of working time: from its hook work (or the
/// pick-up, where there is none) to its release it fits into the working time of all that the lift
/// needs. So for a task that moves something and says `whole` (by itself, by its plan or by
/// default), if somebody whom the lift needs has a calendar and none of these carries over.
bool held_whole(const PlanModel& plan, const TaskSpec& task);

/// The crews that a lift needs from hook to release: those of `by`, then of hook, adjust, release.
std::vector<int> crews_of_lift(const TaskSpec& task);

/// Draws all durations that are not certain, each by the name of its place ("set_3.hook",
/// "pour.takes", of several "pour.takes_2"): the same place has the same draw whatever else the
/// plan has.
void draw_durations(PlanModel& plan, const SampleSpec& sample);

/// What is drawn for a run, apart from the plan: threads that run one plan share it.
struct Draws {
  std::optional<SampleSpec> sample = {};   ///< nothing: all is as the plan has it
  std::vector<double> durations = {};      ///< s, by `WorkSpec::draw`; empty: as the plan has them
  std::vector<hauling::Result> digs = {};  ///< by `DigSpec::draw`, likewise

  /// s
  double duration(const WorkSpec& work) const {
    const auto at = static_cast<std::size_t>(work.draw);
    return work.draw >= 0 && at < durations.size() ? durations[at] : work.duration;
  }
  const hauling::Result& result(const DigSpec& dig) const {
    const auto at = static_cast<std::size_t>(dig.draw);
    return dig.draw >= 0 && at < digs.size() ? digs[at] : dig.result;
  }
};
/// Numbers what is drawn for a run; `load_plan` does it.
void number_draws(PlanModel& plan);
/// The same draws as those of `draw_durations`.
Draws draws_of(const PlanModel& plan, const SampleSpec& sample);
/// How many durations are not certain.
int count_uncertain(const PlanModel& plan);
/// Whether a calendar loses days.
bool loses_days(const PlanModel& plan);
/// Whether a machine breaks down.
bool has_breakdowns(const PlanModel& plan);

/// A duration that is not certain.
struct UncertainDuration {
  std::string place;  ///< "set_3.hook"
  const sampling::DurationLaw* law = nullptr;
};
/// All of a plan, in the order of its tasks.
std::vector<UncertainDuration> uncertain_durations(const PlanModel& plan);

/// "first", "nearest", "least_used".
const char* name_of(PoolSpec::Choice choice);

/// The robots and crews that a choice has of the pools: "low", "low, riggers".
std::string member_names(const PlanModel& plan, const TaskSpec& choice);

/// Reads and checks a plan, its robots and their scripts. `set` gives parameters of the plan other
/// values than the file does. Null if there is an error in any of them.
std::unique_ptr<PlanModel> load_plan(const std::string& path, SourceMap& sources,
                                     FileProvider& files, Diagnostics& diagnostics,
                                     const ParameterTexts& set = {});

}  // namespace rubicon::interpreter
