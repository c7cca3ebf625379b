#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/program/world.hpp"
#include "src/earth/soil/terrain.hpp"
#include "src/fleets/traffic/traffic.hpp"
#include "src/motion/collision/swept_query.hpp"
#include "src/simulation/site/load.hpp"
#include "src/simulation/site/moving_thing.hpp"
#include "src/simulation/site/reserved_volume.hpp"
#include "src/simulation/site/site_robot.hpp"
#include "src/simulation/site/workspace.hpp"

namespace rubicon::site {

using interpreter::Ticks;

/// A step a machine is making: its parameters run from `q_from` to `q_to` (cyclic angles unwrapped)
/// until `end`.
struct MachineStep {
  std::vector<double> q_from;
  std::vector<double> q_to;
  Ticks end = 0;
  Ticks duration = 0;
  std::vector<double> q_goal;  ///< where it will stand next; empty: not known
  std::vector<double> q_aim;   ///< where it goes now: the same, or a waypoint before it
};

/// A load that people are turning about the vertical through the origin of the tool.
struct LoadTurn {
  math::Pose X_TO = math::Pose::Identity();  ///< how it hung before
  double angle_deg = 0;
  Ticks end = 0;
};

/// A machine at a moment: where it stands, or will when its step in progress is over.
struct MachineState {
  std::vector<double> q;
  std::optional<Load> load;
  std::optional<MachineStep> step;
  std::optional<LoadTurn> turn;
  bool carries_soil = false;
  int partner = -1;  ///< a machine with which its workspace may overlap
  Ticks changed_at = 0;
};

/// A pit that a robot digs, cell by cell of its earth: `after` is below `before` where it is dug.
/// One that crews dig by durations is open from their beginning.
struct Pit {
  std::string task;
  int component = -1;  ///< its soil
  math::Pose X_WE = math::Pose::Identity();
  std::shared_ptr<const soil::Terrain> before, after;  // shared: they are large, and the plan's
  Eigen::AlignedBox2d around = {};  ///< round the cells that are dug, in the plan view
};

/// What a machine is foreseen to sweep.
struct ForeseenRegion {
  int robot = -1;
  double seconds = 0;  ///< so far ahead
  std::vector<double> q_aim;
  PlanRegion region;
};

/// Where a component stands, or stood at last.
struct ComponentState {
  bool standing = false;
  math::Pose X_WO = math::Pose::Identity();
  std::optional<collision::ObstacleId> id;  ///< its rank among the obstacles while it stands
};

/// Where people work (world), and where no load may hang meanwhile: there and above.
struct PeopleZone {
  const std::vector<geometry::Shape>& shapes;
  const std::vector<geometry::Shape>& overhead;
};

/// Another machine, a zone, or something with a timetable, that a query meets.
struct OtherMet {
  int item = 0;      ///< of the query
  std::string name;  ///< the machine's body or load, or the name of the zone or the thing
  int machine = -1;
  int zone_task = -1;
  int moving = -1;
  bool is_fixed = false;  ///< the part of the machine that no step of it moves

  /// The machine, if it may take the part out of the way; else -1.
  int machine_that_may_leave() const { return is_fixed ? -1 : machine; }
};

/// Something with a timetable stops, or goes on.
struct MovingEvent {
  int moving = 0;
  Ticks time = 0;
  std::optional<MovingStop> stop;  ///< nothing: it goes on,
  Ticks delay = 0;                 ///< so much later than its timetable says
};

/// The site as it stands at a moment: what was built and lies about (the obstacles), the machines
/// and their loads, and the zones where people work. Poses in the world frame {W}, metres. A
/// machine owns where it stands, and all that it sweeps while a step of it lasts; other machines
/// keep out of that and of the zones. For one thread at a time.
class SiteWorld {
 public:
  explicit SiteWorld(double contact_tolerance) : contact_tolerance_(contact_tolerance) {}

  /// An obstacle for good. Obstacles are tested in the order in which they came.
  void add_obstacle(const std::string& name, const collision::BodyPtr& body,
                    const math::Pose& X_WB);
  /// A component that stands at X_WO; its index. `body` null: it has no shape and is in nobody's
  /// way.
  int add_component(std::string name, collision::BodyPtr body, const math::Pose& X_WO, double mass);
  /// People are in or on the component, whose shapes these are.
  void add_people(int component, std::vector<geometry::Shape> shapes);
  /// A robot that stands at q; its index.
  int add_robot(SiteRobot robot, std::vector<double> q);

  /// Something that moves by a timetable, from its first time on; its index. `overhead`: with
  /// people, where no load may hang; else null.
  int add_moving(std::string name, collision::BodyPtr body, collision::BodyPtr overhead,
                 geometry::Timetable timetable);

  /// Steps that end at `now` or before are over: their machines stand.
  void set_time(Ticks now);

  Ticks now() const { return now_; }

  // site_movings.cpp: what keeps a timetable
  int movings() const { return static_cast<int>(movings_.size()); }
  const MovingThing& moving(int index) const { return movings_[static_cast<std::size_t>(index)]; }
  void set_moving_state(int index, MovingState state);
  /// It is there, does not stand before anything, and its window is no stay.
  bool is_on_its_way(int moving) const;
  /// Those whose next second begins now look whether it is free, and stop or go on, in their order.
  /// To be called whenever time went on. Who stopped and who goes on.
  std::vector<MovingEvent> look_at_movings();
  /// When the next of them must look: before that nothing is near its way. The end of time: never,
  /// unless a machine moves.
  Ticks next_moving_look();
  /// Until then it may be of use to wait for things with a timetable: since the last change of a
  /// machine each that repeats has come by once, and all others are gone.
  Ticks movings_worth_waiting() const;
  /// How long they have gone on (ns), each round of a repeating one counted once since the last
  /// change of a machine: who waits longer waits for nothing.
  std::uint64_t movings_gone_on() const;

  /// The component leaves the world and hangs on the tool from now on as it stands to it. It must
  /// stand, and the tool must be free.
  void attach(int robot, int component);
  /// Puts shapes on the tool that never stood in the world; X_TO is the identity.
  void attach_carry(int robot, collision::BodyPtr body);
  /// The load stands in the world where it is. A component must be attached.
  void detach(int robot);
  /// The component leaves the site.
  void remove(int component);

  // site_soil.cpp: soil that is dug bit by bit
  /// From now on the component, which stands, is what lies between two surfaces, in its own frame;
  /// it is in the way as pieces of a few cells, of which only those change that are dug in.
  void open_soil(int component, soil::Terrain surface, std::shared_ptr<const soil::Terrain> bottom);
  /// The soil of a component that was opened; null: it was not.
  const soil::Terrain* surface(int component) const;
  /// What stands where these shapes (world) would be, by name: nothing, where it is free.
  std::optional<std::string> standing_in(const std::vector<geometry::Shape>& shapes) const;
  /// New heights of cells of it.
  void set_surface(int component, const std::map<int, soil::Millimetres>& heights);
  /// As it was before it was opened.
  void close_soil(int component, const ComponentState& before);

  /// The robot makes a step and stands at q (cyclic angles reduced) when it is over; at once where
  /// it takes no time or moves nothing. It takes the place of a step in progress.
  /// `known`: of what it sweeps, from the tests of the step.
  void begin_step(int robot, const interpreter::MotionStep& step, std::vector<double> q,
                  StepVolume known = {});

  /// People turn what hangs on the robot, which stands, until `end`; from now on all that it sweeps
  /// meanwhile belongs to the robot. At the end it hangs as it was turned.
  void begin_turn(int robot, double angle_deg, Ticks end);

  /// The robot carries soil, which is no body: it drives as loaded.
  void set_carries_soil(int robot, bool carries);
  bool carries_soil(int robot) const { return entry(robot).carries_soil; }

  /// Pits, and robots that drive on the ground: these do not drive over what is dug. The tool frame
  /// of such a robot is on the ground.
  void add_pit(Pit pit);
  bool has_pits() const { return !pits_.empty(); }
  /// Crews begin to dig the soil away, or have not begun.
  void set_being_dug(int component, bool is_dug);
  void set_drives(int robot);
  /// The task whose pit the robot would be over in the step; nothing where there is ground.
  std::optional<std::string> pit_met(int robot, const interpreter::MotionStep& step) const;

  // site_workspaces.cpp: dynamic workspaces, which do not overlap
  void set_workspaces(WorkspaceRules rules);
  /// The machine that is loaded by the other, or loads it: their workspaces may overlap; -1: none.
  void set_partner(int robot, int other);
  /// The machine, or the people with a timetable, whose workspace that of the robot would overlap
  /// in the step; or that of a machine that goes first, and would in its next step.
  std::optional<OtherMet> workspace_met(int robot, const interpreter::MotionStep& step) const;
  /// Where nobody stops before workspaces overlap: notes that the step makes some overlap that did
  /// not before.
  void watch_workspaces(int robot, const interpreter::MotionStep& step);
  /// How often that was since it was asked last.
  int take_overlaps(int robot) { return std::exchange(entry(robot).overlaps, 0); }
  /// Whether the robot looks at what others are foreseen to sweep, and what that is now: of those
  /// that are in a step and go first.
  bool foresees(int robot) const {
    return workspaces_.foreseen > 0 && workspaces_.rank_of(robot) > 0;
  }
  std::vector<ForeseenRegion> foreseen_regions(int robot) const;
  /// What a robot whose workspace is kept apart sweeps from one configuration to the other.
  PlanRegion region_of(int robot, std::span<const double> q_from,
                       std::span<const double> q_to) const {
    return swept_region(entry(robot).robot, entry(robot).corners, q_from, q_to);
  }
  /// What the robot's workspace is now; empty where it has none.
  const PlanRegion& workspace(int robot) const;

  /// Bodies of the robot and components that they may cut into, from now on; what was said before
  /// is forgotten.
  void let_enter(int robot, std::vector<std::pair<int, int>> entered);
  /// The obstacles, of components that stand, which the body of the robot may cut into.
  std::vector<collision::ObstacleId> entered_by(int robot, int body) const;
  bool may_enter(int robot) const { return !entry(robot).entered.empty(); }

  bool is_in_step(int robot) const { return entry(robot).stepping; }
  /// When the robot last began or ended a step, or a turn of its load.
  Ticks changed_at(int robot) const { return entry(robot).changed_at; }

  MachineState machine_state(int robot) const;
  void set_machine_state(int robot, MachineState state);
  ComponentState component_state(int component) const;
  /// To a state that it had: it takes its old rank among the obstacles again.
  void set_component_state(int component, const ComponentState& state);

  /// People work in the zone until `release_zone`: machines keep out but for `exempt_robot` (-1:
  /// none is exempt). A task has one zone: the last one. Throws std::invalid_argument for shapes
  /// without extent.
  void hold_zone(int task, const std::string& task_name, const PeopleZone& zone, int exempt_robot);
  void release_zone(int task);
  /// The first machine but the exempt one that stands in the zone or sweeps it in a step in
  /// progress, or whose load hangs over it.
  std::optional<int> machine_in(const PeopleZone& zone, int exempt_robot) const;

  /// The zone, by task, that the component stands in and the robot has to keep out of.
  std::optional<OtherMet> zone_around(int component, int robot) const;

  /// Whether there is anyone else to meet for the robot: machines, zones, what keeps a timetable.
  bool has_others(int robot) const;
  /// The first thing with a timetable, by index, that bodies of the robot meet in a step that ends
  /// at `until`; with `overhead` what is above people.
  std::optional<OtherMet> first_moving_met(int robot, collision::MovingBodies& bodies, Ticks until,
                                           bool overhead) const;
  /// The first zone, by task, over which the bodies hang, loads of the robot.
  std::optional<OtherMet> first_zone_below(int robot, collision::MovingBodies& loads) const;
  /// Whether people are under the bodies: in a zone, or in a component that says so.
  bool people_below(int robot, collision::MovingBodies& bodies) const;
  /// Whether there are people anywhere that the robot might be over.
  bool has_people(int robot) const;
  /// The first zone, by task, that bodies of the robot meet.
  std::optional<OtherMet> first_zone_met(int robot, collision::MovingBodies& bodies) const;
  /// The first other machine, by index; with `standing_only` of those that stand. `are_buffers`:
  /// by item, or empty.
  std::optional<OtherMet> first_machine_met(int robot, collision::MovingBodies& bodies,
                                            bool standing_only,
                                            const std::vector<bool>& are_buffers = {}) const;

  /// What guides in the plan view are told: shapes of an obstacle, of a component and of something
  /// with a timetable, in their own frames. They must outlive the site.
  void show_obstacle(std::string name, const std::vector<geometry::Shape>& shapes);
  void show_component(int component, const std::vector<geometry::Shape>& shapes);
  void show_moving(int moving, const std::vector<geometry::Shape>& shapes);
  /// All of it but the robot and what hangs on it, where it is now.
  std::vector<guides::Thing> things(int robot) const;

  /// What belongs to other machines now, by name; buffers left out.
  struct NamedPart {
    std::string name;
    ReservedPart part;
  };
  std::vector<NamedPart> parts_of_others(int robot) const;

  // site_traffic.cpp: the vehicles of fleets
  /// The traffic of a network and the robots that drive there, to each vehicle.
  void add_network(std::string name, traffic::Traffic traffic, std::vector<int> robots);
  /// The next node of the robot, as `World::next_node`.
  guides::LaneAnswer next_node(int robot, const guides::LaneQuestion& question,
                               std::optional<interpreter::HitPair>& before);
  /// How far (m) the robot has from its node over the lanes to the node nearest to a place, and
  /// from there to it; infinite where no lanes lead there. Nothing of a robot on no network.
  std::optional<double> lane_distance(int robot, const Eigen::Vector2d& place) const;
  /// Lets a robot that waits for its turn get by where others stand in the way who wait too or are
  /// idle (`idle`, by robot): those get ways, too. False: there is no way out, or there was none
  /// when it was looked for last and nothing has changed. `places_ahead` of a robot: where its
  /// tasks lead that are not over.
  bool untangle(int robot, const std::vector<bool>& idle,
                const std::function<std::vector<Eigen::Vector2d>(int robot)>& places_ahead);
  /// Of a robot for which there is no way out: who would have to go from where
  /// (`Traffic::who_bars`).
  std::optional<interpreter::HitPair> who_bars(int robot, const std::vector<bool>& idle) const;
  /// All robots of the network of a robot but it; nothing of one on no network.
  std::vector<int> robots_beside(int robot) const;
  /// Where the way of a robot leads that was moved out of the way of others: `Traffic::next_stop`.
  /// Nothing of a robot that has no way ahead.
  std::optional<lanes::Node> next_stop(int robot) const;
  /// Counts what may let vehicles go on that wait for their turn.
  std::uint64_t traffic_changes() const;
  /// The traffic of each network, to go back to.
  std::vector<traffic::Traffic> traffic() const;
  void set_traffic(std::vector<traffic::Traffic> traffic);

  /// Components in the order in which they came to stand or ceased to, going back included: who
  /// follows them remembers how far it has read.
  const std::vector<int>& component_changes() const { return component_changes_; }

  bool stands(int component) const;
  const math::Pose& X_WO(int component) const;  ///< where it stands, or stood at last
  const std::string& component_name(int component) const;
  const SiteRobot& robot(int index) const { return entry(index).robot; }
  const std::vector<double>& configuration(int robot) const { return entry(robot).q; }
  const std::optional<Load>& load(int robot) const { return entry(robot).load; }
  math::Pose tool_pose(int robot) const;

  const collision::CollisionWorld& obstacles() const { return obstacles_; }
  bool has_obstacles() const { return !names_.empty(); }
  const std::string& obstacle_name(collision::ObstacleId id) const { return names_.at(id); }
  double contact_tolerance() const { return contact_tolerance_; }

  /// Whether no other machine and nothing with a timetable is or may come into the box.
  bool is_alone_in(int robot, const collision::Bounds& bounds) const;
  /// Changes whenever something comes to stand, leaves, or is changed where it stands, a zone is
  /// held or released, or something else hangs on the robot, or hangs otherwise.
  std::uint64_t standing_version(int robot) const { return changes_ + entry(robot).turns; }
  /// Changes whenever anything but `robot`'s own steps changed what it may do.
  std::uint64_t version(int robot) const;

 private:
  struct Component {
    std::string name;
    collision::BodyPtr body;
    math::Pose X_WO = math::Pose::Identity();
    double mass = 0;
    std::vector<geometry::Shape> people;  ///< its shapes, where people are in or on it
    std::shared_ptr<const ReservedVolume> people_above;  ///< these and the air above them
    bool standing = false;
    std::optional<collision::ObstacleId> id;
  };
  struct RobotEntry {
    SiteRobot robot;
    std::vector<double> q;
    std::optional<Load> load;
    bool stepping = false;
    MachineStep step;                          ///< the one in progress, while `stepping`
    std::optional<LoadTurn> turn;              ///< the one in progress
    std::uint64_t turns = 0;                   ///< how often its load was turned
    std::vector<std::pair<int, int>> entered;  ///< body, component
    bool carries_soil = false;
    int partner = -1;
    BodyCorners corners;      ///< of one whose workspace is kept apart
    BodyCorners wheels;       ///< of one that drives on the ground: of its tool's body, no others
    double wheels_reach = 0;  ///< m, of these from the origin of the body
    mutable std::optional<PlanRegion> workspace_now;  ///< made when asked for
    std::set<int> too_near;     ///< robots whose workspaces its own overlaps, where that is watched
    int overlaps = 0;           ///< how often that came about, not yet taken
    std::uint64_t changes = 0;  ///< of what belongs to it
    Ticks changed_at = 0;       ///< when the last of these came about
    mutable bool near_moving = false;  ///< it was where something with a timetable goes
    StepVolume known;                  ///< of what belongs to it now
    mutable std::unique_ptr<ReservedVolume> reserved;  ///< the whole of it; made when asked for

    void forget_volume() {
      known = {};
      reserved.reset();
    }
  };
  struct Zone {
    std::string name;
    ReservedVolume reserved;
    std::string overhead_name;
    ReservedVolume overhead;
    int exempt_robot = -1;
  };

  /// Soil that is dug, as pieces of kPiece x kPiece cells. A piece keeps its rank among the
  /// obstacles.
  struct Soil {
    soil::Terrain surface;
    std::shared_ptr<const soil::Terrain> bottom;  // shared: it is large, and the plan's
    std::vector<std::optional<collision::ObstacleId>> ids;
    std::vector<bool> stands;                     ///< to each piece: there is something of it
    std::vector<collision::ObstacleId> standing;  ///< the ids of these, in the order of the pieces
  };
  static constexpr int kPiece = 3;
  void set_piece(const Component& component, Soil& soil, int piece);
  static void list_standing(Soil& soil);
  static std::set<int> pieces_with_soil(const Soil& soil);
  static int pieces_in_row(const Soil& soil) {
    return (soil.surface.columns + kPiece - 1) / kPiece;
  }
  void show_soil(int component, bool stands);
  bool goes_before(int robot, int other) const;

  RobotEntry& entry(int index) { return robots_[static_cast<std::size_t>(index)]; }
  const RobotEntry& entry(int index) const { return robots_[static_cast<std::size_t>(index)]; }
  collision::ObstacleId insert(const std::string& name, const collision::BodyPtr& body,
                               const math::Pose& X_WB);
  void erase(collision::ObstacleId id);
  void note_change(const Component& component);
  void stand(Component& component, const math::Pose& X_WO);
  void lift(Component& component);
  void changed(RobotEntry& robot);
  void note_machine_change();
  std::uint64_t all_changes() const { return changes_ + machine_changes_; }
  std::uint64_t changes_of(const MovingStop& stop) const;
  std::optional<MovingStop> what_stops(int moving, int window) const;
  bool is_free_of_obstacles(const MovingThing& thing, int window) const;
  std::optional<MovingStop> machine_on_way(const collision::SweptQuery& query,
                                           bool has_people) const;
  bool has_to_look(int moving, int window) const;
  Ticks find_next_look(int moving) const;
  std::optional<ReservedVolume> load_volume(const RobotEntry& robot) const;
  ReservedVolume standing(const std::vector<geometry::Shape>& shapes_W) const;
  void look_up(Component& component) const;
  static bool is_load(const RobotEntry& robot, int part);
  std::vector<ReservedPart> reserved_parts(const RobotEntry& robot) const;
  const ReservedVolume& reserved_volume(const RobotEntry& robot) const;
  bool is_clear_of(const RobotEntry& robot, const collision::Bounds& bounds) const;
  static const std::string& part_name(const RobotEntry& robot, int part);

  /// A network and who drives there.
  struct Network {
    std::string name;
    traffic::Traffic traffic;
    std::vector<int> robots;  ///< to each vehicle
    /// By vehicle: who was idle, and what had changed, when no way out was found for it last.
    std::map<int, std::pair<std::uint64_t, std::vector<bool>>> tangled = {};
  };
  std::vector<Network> networks_;
  static std::vector<bool> movable_in(const Network& network, const std::vector<bool>& idle);
  static interpreter::HitPair in_the_way(const Network& network, const traffic::Wait& wait);

  double contact_tolerance_;
  collision::CollisionWorld obstacles_;
  std::map<collision::ObstacleId, std::string> names_;
  std::vector<Component> components_;
  std::map<int, Soil> soils_;  ///< by component
  std::vector<Pit> pits_;
  static constexpr std::size_t kPitsTogether = 16;
  std::vector<Eigen::AlignedBox2d> around_pits_;  ///< around so many of them each
  std::set<int> being_dug_;                       ///< soil
  WorkspaceRules workspaces_;
  std::vector<BodyCorners> moving_corners_;  ///< of people with a timetable
  std::vector<int> with_people_;             ///< components in or on which people are
  std::vector<int> component_changes_;
  std::vector<RobotEntry> robots_;
  std::map<int, Zone> zones_;                                          ///< by task
  std::vector<guides::Thing> shown_;                                   ///< obstacles
  std::vector<const std::vector<geometry::Shape>*> shown_components_;  ///< null: not shown
  std::vector<const std::vector<geometry::Shape>*> shown_movings_;
  Ticks now_ = 0;
  std::vector<MovingThing> movings_;
  /// When a machine changed last, and for how long things with a timetable had gone on before (ns).
  Ticks quiet_since_ = 0;
  std::uint64_t moved_before_ = 0;
  std::uint64_t machine_changes_ = 0;
  /// To each thing with a timetable: when it looks next, and at what all changes this was found; if
  /// it stands, at what changes it looked last.
  std::vector<Ticks> looks_;
  std::uint64_t looks_at_ = 0;
  std::vector<std::uint64_t> looked_at_;
  std::uint64_t changes_ = 0;
};

}  // namespace rubicon::site
