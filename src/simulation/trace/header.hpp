#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/motion/geometry/shape.hpp"
#include "src/motion/geometry/timetable.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::trace {

/// The version of the format that is written and read.
inline constexpr int kTraceVersion = 1;

/// A text that was read for the run.
struct HeaderFile {
  std::string path;
  std::string sha256;
  std::string text;
};

/// Hours of the week, and days off.
struct HeaderCalendar {
  struct Shift {
    int first_day = 0;  ///< 0 Monday ... 6 Sunday
    int last_day = 0;
    std::vector<std::pair<int, int>> minutes;  ///< of the day: from, to
  };
  std::string name;
  std::vector<Shift> shifts;
  std::vector<std::string> off;  ///< YYYY-MM-DD
  bool carry_over = false;
};

/// Values by the names of parameters (m or degrees).
using HeaderValues = std::vector<std::pair<std::string, double>>;

/// What a motion goes to: values by parameter, or a frame in {W}.
struct HeaderGoal {
  std::optional<math::Pose> pose;
  HeaderValues values;
};

/// Texts by name, as the plan gives them.
using HeaderAttributes = std::vector<std::pair<std::string, std::string>>;

struct HeaderComponent {
  std::string name;
  math::Pose X_WO = math::Pose::Identity();  ///< at first
  math::Pose X_OG = math::Pose::Identity();
  double mass = 0;                      ///< kg
  std::vector<geometry::Shape> shapes;  ///< in {O}
  HeaderAttributes attributes;
};

/// A rope: from a point of a body to a point of its parent, each in the frame of that body.
struct HeaderRope {
  double radius = 0;  ///< m
  std::string from;
  math::Vec3 p_from = math::Vec3::Zero();  ///< m
  math::Vec3 p_to = math::Vec3::Zero();    ///< m
};

struct HeaderBody {
  std::string name;
  std::string parent;  ///< "": it stands on the mounting frame
  std::string frame;   ///< text, such as "trans(x, 0, z) * rotz(theta)"
  std::vector<geometry::Shape> shapes;
  double buffer = 0;  ///< m: so far it keeps from all that is not of its robot; 0: none
  std::optional<HeaderRope> rope = {};
};

/// A control parameter, m or degrees.
struct HeaderParameter {
  std::string name;
  std::string body;
  bool rotation = false;
  bool cyclic = false;
  std::optional<double> lower;
  std::optional<double> upper;
  double step = 0;
  double speed = 0;
  double loaded_speed = 0;
  double acceleration = 0;  ///< 0: none
  double start = 0;
  int prefer = 1;
  bool derived = false;
  std::string formula;  ///< text: its rule, or of a derived one its value
};

struct HeaderRobot {
  std::string name;
  std::string type;
  std::string path;
  math::Pose X_WM = math::Pose::Identity();
  std::vector<double> start;  ///< by parameter, in their order
  std::optional<double> cost_per_hour;
  std::string calendar;  ///< "": none
  std::optional<HeaderValues> park;
  double time_step = 1;  ///< s
  double sensor = 0;     ///< m
  std::vector<HeaderBody> bodies;
  std::vector<HeaderParameter> parameters;
  std::string tool_body;
  std::string tool_frame;
  std::vector<std::pair<std::string, std::string>> touching;
  std::vector<std::pair<double, double>> capacity;  ///< radius (m), mass (kg)
};

struct HeaderCrew {
  std::string name;
  double size = 0;
  std::optional<double> cost_per_hour;
  std::string calendar;  ///< "": none
};

struct HeaderWork {
  double duration = 0;   ///< s
  std::string crew;      ///< "": whoever holds the task
  bool turning = false;  ///< people turn the load about the vertical
};

struct HeaderLink {
  std::string task;
  std::string type;  ///< FS, SS, FF, SF
  double lag = 0;    ///< s
};

struct HeaderTask {
  std::string name;
  std::string robot;  ///< "": crew work
  std::vector<std::string> crews;
  std::optional<std::string> move;  ///< a component
  math::Pose X_WO_goal = math::Pose::Identity();
  std::optional<HeaderGoal> go;
  std::vector<HeaderGoal> via;
  HeaderValues within;  ///< `length` (m), values by parameter
  std::vector<std::string> situations;
  std::optional<HeaderWork> hook, adjust, release;
  std::vector<HeaderWork> takes;
  std::vector<std::string> remove;
  double priority = 0;
  std::vector<geometry::Shape> zones;                ///< in {W}
  std::vector<geometry::Shape> zones_overhead = {};  ///< they and the air above them, in {W}
  std::vector<HeaderLink> after;
  HeaderAttributes attributes;
};

/// Where components lie until they are taken, in {W}.
struct HeaderStorage {
  std::string name;
  std::vector<geometry::Shape> shapes;
};

struct HeaderNode {
  std::string name;
  math::Pose X_WN = math::Pose::Identity();
};

/// A network of lanes: of it only its nodes.
struct HeaderNetwork {
  std::string name;
  std::vector<HeaderNode> nodes;
};

struct HeaderFleet {
  std::string name;
  std::string network;
  std::vector<std::string> robots;
};

/// What moves by a timetable (times in ns, poses X_WO).
struct HeaderMoving {
  std::string name;
  geometry::Timetable timetable;
  std::vector<geometry::Shape> shapes;    ///< in {O}
  std::vector<geometry::Shape> overhead;  ///< with people: they and the air above them, in {O}
};

/// The first line of a trace (docs/trace.md): the whole scene. Names that it refers to are there
/// where this says so: meshes of shapes, bodies and parameters of a robot.
struct TraceHeader {
  std::string plan;
  std::string path;
  bool short_form = false;
  std::string detail;  ///< steps, tasks, none
  double contact = 0;  ///< m
  double budget = 0;
  std::vector<std::string> situations;
  std::optional<std::string> start_at;
  std::string currency;
  std::vector<HeaderCalendar> calendars;
  std::vector<HeaderFile> files;
  std::vector<std::pair<std::string, std::string>> set;  ///< parameters of the plan, if given
  std::vector<geometry::Shape> site;                     ///< in {W}
  std::vector<std::string> site_names;                   ///< whose they are, as in the plan
  std::vector<HeaderStorage> storages;
  std::vector<HeaderNetwork> networks;
  std::vector<HeaderFleet> fleets;
  std::vector<HeaderMoving> movings;
  std::vector<HeaderComponent> components;
  std::vector<HeaderRobot> robots;
  std::vector<geometry::Shape> carry;  ///< in {T}
  std::vector<HeaderCrew> crews;
  std::vector<HeaderGoal> via;     ///< of a short plan
  std::optional<HeaderGoal> goal;  ///< of a short plan
  std::vector<HeaderTask> tasks;
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> meshes;
};

}  // namespace rubicon::trace
