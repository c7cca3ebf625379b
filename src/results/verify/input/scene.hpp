#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/motion/math/pose.hpp"
#include "src/results/verify/input/fault.hpp"
#include "src/results/verify/input/formula.hpp"

namespace rubicon::verify {

using math::Pose;
using math::Vec3;

/// The triangles of a mesh shape, metres.
struct MeshData {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  bool closed = false;
};

/// A solid of the trace header in the frame of its body (metres).
struct ShapeData {
  enum class Kind { box, cylinder, sphere, capsule, prism, mesh };
  Kind kind = Kind::box;
  Vec3 a = Vec3::Zero();  ///< box: lower corner; sphere: centre; capsule: one end
  Vec3 b = Vec3::Zero();  ///< box: upper corner; capsule: other end
  double radius = 0;      ///< cylinder, sphere, capsule
  double z0 = 0;          ///< cylinder, prism
  double z1 = 0;
  std::vector<Eigen::Vector2d> polygon;  ///< prism
  int mesh = -1;                         ///< number in Scene::meshes
  Pose X_BS = Pose::Identity();
};

/// How near to its goal a task must come; what is not given is negative.
struct SceneWithin {
  double length = -1;                                  ///< m
  std::vector<std::pair<std::string, double>> values;  ///< by parameter, file units
};

/// From a point of a body to a point of the parent of the one that has it; each in its own frame.
struct SceneRope {
  double radius = 0;  ///< m
  int from = -1;
  Vec3 p_from = Vec3::Zero();
  Vec3 p_to = Vec3::Zero();
};

struct SceneBody {
  std::string name;
  int parent = -1;  ///< -1: the mounting frame
  std::vector<FrameElement> frame;
  std::vector<ShapeData> shapes;
  double buffer = 0;  ///< m; 0: none
  std::optional<SceneRope> rope = {};
};

/// A control parameter; metres or degrees.
struct SceneParameter {
  std::string name;  ///< as it is written in q
  int body = 0;
  bool rotation = false;
  bool cyclic = false;
  bool prefers_less = false;  ///< half a turn, of a cyclic angle, goes down
  std::optional<double> lower;
  std::optional<double> upper;
  double step = 0;
  double speed = 0;
  double loaded_speed = 0;
  double acceleration = 0;  ///< per second squared; 0: none, its speed is there at once
  bool derived = false;     ///< `rule` is its value, of the others after the step
  Formula rule;
};

/// What a robot or crew burns: l per h at work and in the rest of the time it is held.
struct SceneFuel {
  double working = 0, idling = 0;
  std::optional<double> price;  ///< of a litre
};

/// What a robot or crew costs besides its hours.
struct SceneCharges {
  std::optional<double> rental_per_day;
  std::optional<std::pair<std::string, std::string>> rental_days;  ///< YYYY-MM-DD, first and last
  double mobilisation = 0;
  double overtime = 1;
  int normal = -1;  ///< calendar outside of which it is overtime; -1: its own
  std::optional<SceneFuel> fuel;
};

/// How far the tool may be beside a straight way.
struct SceneDeviation {
  double position = 1e-3;    ///< m
  double orientation = 0.1;  ///< degrees
};

/// A duration that is not certain.
struct SceneLaw {
  std::string law;
  std::vector<double> values;
  int times = -1;  ///< of `measured`: number in Scene::times
};

struct SceneRobot {
  std::string name;
  Pose X_WM = Pose::Identity();
  double time_step = 1;  ///< s
  std::vector<SceneBody> bodies;
  std::vector<SceneParameter> parameters;
  std::vector<double> starts;
  int tool_body = 0;
  std::vector<FrameElement> tool_frame;
  std::vector<std::pair<int, int>> touching;
  SceneDeviation deviation;
  std::vector<std::pair<double, double>> capacity;  ///< radius (m), mass (kg)
  int calendar = -1;
  double cost_per_hour = 0;
  std::vector<std::pair<int, double>> park;  ///< parameter, value
  SceneCharges charges;
  std::optional<std::pair<SceneLaw, SceneLaw>> breakdown;  ///< hours of work between; repair
};

/// What the plan says for people: texts by key.
using SceneAttributes = std::map<std::string, std::string>;

struct SceneComponent {
  std::string name;
  Pose X_WO = Pose::Identity();
  Pose X_OG = Pose::Identity();  ///< where the tool takes it
  double mass = 0;
  double cost = 0;
  std::vector<ShapeData> shapes;
  std::vector<std::string> fixed_to = {};  ///< components, site
  /// For each of these the task without which it does not hold yet; "": none. Empty: all of them.
  std::vector<std::string> fixed_after = {};
  std::vector<std::string> braced_by = {};  ///< components
  bool has_brace_crew = false;
  SceneAttributes attributes = {};
};

/// What moves by a timetable: its frame is at each place at its time, in between it goes straight
/// and turns evenly the short way.
struct SceneMoving {
  struct Place {
    Ticks time = 0;
    Pose X_WO = Pose::Identity();
  };
  std::string name;
  std::vector<Place> path;  ///< two or more, times ascending
  bool repeat = false;
  std::vector<ShapeData> shapes;
  std::vector<ShapeData> overhead;  ///< where no load may hang; in its frame, too
};

/// Hours of the week, and days off.
struct SceneCalendar {
  struct Shift {
    int first_day = 0;  ///< 0 Monday ... 6 Sunday
    int last_day = 0;
    std::vector<std::pair<int, int>> minutes;  ///< of the day
  };
  std::string name;
  std::vector<Shift> shifts;
  std::vector<std::string> off;  ///< YYYY-MM-DD
  bool carry_over = false;
  std::vector<double> lost;  ///< share of lost days by month, January first; empty: none
};

struct SceneCrew {
  std::string name;
  int calendar = -1;
  double cost_per_hour = 0;
  int size = 1;
  SceneCharges charges;
};

enum class LinkType { FS, SS, FF, SF };
struct SceneLink {
  int task = -1;
  LinkType type = LinkType::FS;
  Ticks lag = 0;
};

/// Times that were measured: a column of a file, read from its text once more.
struct SceneTimes {
  std::string file, unit;
  int column = 1;
  std::vector<double> times;  ///< s, ascending
  double mean = 0;            ///< s
};

struct SceneWork {
  std::string what;  ///< hook, adjust, release, takes
  Ticks time = 0;
  int crew = -1;                    ///< -1: whoever holds the task
  bool turning = false;             ///< people turn the load about the vertical
  std::string law = {};             ///< of a duration that is not certain; "": it is
  std::vector<double> values = {};  ///< of the law, s
  int times = -1;                   ///< of the law `measured`: number in Scene::times
};

/// A stage of the rounds of trucks: loading, haul, tip, ...
struct SceneStage {
  std::string name;
  double seconds = 0;  ///< the mean of a law
  std::string law = {};
  std::vector<double> values = {};
  int times = -1;
  int servers = 0;
  int crew = -1;  ///< of these
};

/// What is dug: cells of an earth, heights in mm.
struct ScenePit {
  Pose X_WE = Pose::Identity();
  int columns = 1;
  std::int64_t cell = 1;                    ///< mm, its side
  std::vector<int> cells;                   ///< ascending
  std::vector<std::int64_t> before, after;  ///< to each of them
};

/// How a task digs; volumes in whole mm3.
struct SceneDig {
  std::int64_t volume = 0, load = 1, bucket = 0;
  SceneStage loading;
  std::vector<int> diggers;  ///< machines of each crew
  std::vector<int> digger_crews;
  int trucks = 1;
  int hauled_by = -1;  ///< crew of these
  int loaded = 0;
  std::vector<SceneStage> stages;
  std::size_t tip = 0;
  double efficiency = 1;
  Ticks limit = 0;              ///< 0: none
  std::string soil;             ///< the component that it takes away; "": only a volume is given
  std::optional<ScenePit> pit;  ///< where trucks with bodies must not drive over it
  std::int64_t loads = 0, tipped = 0;
  Ticks time = 0;
};

/// How a robot digs with its own body; volumes in whole mm3, heights in mm.
struct SceneMotionDig {
  int soil = -1;  ///< component
  std::int64_t volume = 0, bucket = 1, tolerance = 0;
  Pose X_WE = Pose::Identity();
  int columns = 1;
  std::int64_t cell = 1;                    ///< mm, its side
  std::vector<int> cells;                   ///< that are dug, ascending
  std::vector<std::int64_t> before, after;  ///< to each of them
  Vec3 p_W = Vec3::Zero();                  ///< where buckets are emptied
  std::optional<SceneWork> fill, dump;
  int trucks = 0;      ///< 0: none
  int hauled_by = -1;  ///< crew of these
  std::int64_t load = 0;
  std::vector<SceneStage> stages;
  std::size_t tip = 0;
  double efficiency = 1;
  double swell = 0;
  std::optional<Pose> load_at;  ///< where trucks with bodies stand when they are loaded
};

/// How a truck with a body hauls.
struct SceneHaul {
  std::vector<std::string> digs;    ///< tasks
  std::vector<std::int64_t> loads;  ///< mm3 that it takes of each
  std::vector<Pose> tips;
  std::optional<SceneWork> tip;
  int heap = -1;  ///< component, -1: what is tipped leaves the site
  Vec3 p_TH = Vec3::Zero();
};

/// The ground of an earth on which loads are tipped; heights in mm.
struct SceneHeap {
  int component = -1;
  Pose X_WE = Pose::Identity();
  int columns = 1;
  std::int64_t cell = 1;
  double repose_deg = 0;
  std::vector<std::int64_t> ground;  ///< of all cells
  std::vector<int> dug;              ///< cells of pits
};

/// What a motion is to reach: values by parameter, or a pose X_WT.
struct SceneGoal {
  std::vector<std::pair<int, double>> values;
  std::optional<Pose> pose;
};

/// A text that the run read.
struct SceneFile {
  std::string path;
  std::string text;
  std::string sha256;
};

/// What of a turn is free: an axis of the tool (0 x, 1 y, 2 z), nothing, or all.
inline constexpr int kNothingFree = -1;
inline constexpr int kAllFree = 3;

/// What a guide keeps: the sum of factors times parameters is at most a value.
struct SceneKept {
  std::vector<std::pair<int, double>> terms;  ///< parameter, factor
  double most = 0;
};

/// A guide that keeps something, steers or thinks.
struct SceneGuide {
  std::vector<SceneKept> keep;
  double turn_radius = 0;  ///< m: its way has no narrower turn; 0: anything
  double thinks = 0;       ///< s for each check
};
/// By name.
using SceneGuides = std::map<std::string, SceneGuide>;

/// What a task that covers an area comes to; m and m2.
struct SceneCover {
  std::string area;
  double thickness = 0;  ///< 0: not given
  double covered = 0, covered_area = 0, length = 0, depth = 0;
  int turns = 0, holes = 0;
};

/// A shaft or column of an area, in its frame (m), over which guides lead no tool.
struct FloorHole {
  std::string name;  ///< "shaft 1"
  std::vector<std::pair<double, double>> corners;
};

struct SceneTask {
  std::string name;
  int robot = -1;
  std::vector<int> crews;
  int move = -1;  ///< component
  Pose X_WO_goal = Pose::Identity();
  bool goes = false;
  std::vector<std::pair<int, double>> go;  ///< parameter, value
  std::optional<Pose> go_pose;             ///< X_WT
  std::vector<SceneGoal> via;              ///< before the goal of `go`, or of the carrying motion
  std::optional<SceneWithin> within;
  int free_axis = kNothingFree;  ///< of the tool, about which a goal frame may be turned
  std::vector<int> locked;       ///< parameters that no step changes
  std::optional<SceneDeviation> deviation;
  std::vector<std::pair<std::string, int>> entered;  ///< body, component that it may cut into
  SceneGuides guides = {};
  double pace = 0;   ///< m/s of the tool where it works over a floor, at most; 0: none
  double width = 0;  ///< m of its strips
  std::optional<SceneCover> cover = {};
  std::optional<Pose> area;  ///< of a task that covers an area that is not level: its frame
  std::vector<FloorHole> holes = {};  ///< of one that guides lead from strip to strip
  double turn_radius = 0;             ///< m: its way has no narrower turn; 0: anything
  Ticks cold_after = 0;            ///< a joint between its strips is cold after this; 0: not asked
  std::vector<bool> working = {};  ///< of a task that covers a floor: by waypoint, the goal last
  std::optional<SceneWork> hook, adjust, release;
  bool whole = false;  ///< nothing may hang on its hook out of working time
  std::vector<SceneWork> takes;
  std::optional<SceneDig> dig;
  std::optional<SceneMotionDig> motion_dig;
  std::optional<SceneHaul> haul;
  std::vector<int> remove;
  std::vector<ShapeData> zones;           ///< in {W}
  std::vector<ShapeData> zones_overhead;  ///< where no load may hang, in {W}
  std::vector<SceneLink> after;
  Ticks not_before = 0;  ///< after the beginning of the plan, as the next two
  std::optional<Ticks> due;
  std::optional<std::pair<Ticks, Ticks>> baseline;  ///< start, finish
  std::map<int, int> needs;        ///< people of a crew; of those that are not here all
  std::vector<int> also_robots;    ///< held, and not moved
  std::string members;             ///< of a choice: names
  std::vector<SceneTask> choices;  ///< by pools
  int same_as = -1;                ///< the task whose members it has
  SceneAttributes attributes = {};
};

/// Two things that are in each other at the beginning.
struct SceneOverlap {
  std::string first, second;
  double depth = 0;  ///< m
};

/// What the header tells of the beginning.
struct SceneBeginning {
  std::vector<SceneOverlap> overlaps;
  std::vector<std::pair<std::string, std::string>> waived;
};

/// What must stand, as the header tells.
struct SceneSupport {
  std::string mode;                ///< on, warn, off
  double gap = 0;                  ///< m
  std::optional<double> friction;  ///< given: forces must be able to balance
  std::vector<std::string> floating;
};

/// Machines whose dynamic workspaces are kept apart.
struct SceneWorkspaces {
  std::vector<int> robots;
  double reaction = 0, braking = 1, turn_braking = 1;
  double foreseen = 0;  ///< s; 0: nothing is
  bool watch = false;   ///< nobody stops where they overlap
};

/// The header of a trace: all that stands, moves and is to be done.
struct Scene {
  std::vector<SceneHeap> heaps;
  std::optional<SceneWorkspaces> workspaces;
  std::string plan;
  bool short_form = false;
  bool sampled = false;             ///< durations were drawn
  std::uint64_t seed = 0, run = 0;  ///< by which
  double contact = 0;               ///< m
  std::string start_at;             ///< "": none
  std::string currency;
  double overhead_per_day = 0;
  std::vector<SceneFile> files;
  std::vector<SceneTimes> times;
  std::vector<MeshData> meshes;
  std::vector<ShapeData> site;
  std::vector<std::string> site_names;  ///< whose they are; may be shorter

  /// What a shape of the site is called.
  std::string site_name(std::size_t i) const;
  std::vector<ShapeData> carry;
  std::vector<SceneMoving> movings;
  std::vector<SceneComponent> components;
  std::vector<SceneCalendar> calendars;
  std::vector<SceneRobot> robots;
  std::vector<SceneCrew> crews;
  std::vector<SceneTask> tasks;
  std::optional<SceneBeginning> beginning;
  std::optional<SceneSupport> support;
  std::map<std::string, int> component_index, robot_index, crew_index, task_index;
};

}  // namespace rubicon::verify
