#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/collision/swept_query.hpp"
#include "src/site/site_robot.hpp"

namespace rubicon::site {

/// What hangs on a robot's tool.
struct Load {
  std::string name;  ///< the component's, or "load"
  collision::BodyPtr body;
  math::Pose X_TO = math::Pose::Identity();
  double mass = 0;     ///< kg
  int component = -1;  ///< index, -1: the `carry` of a short plan
};

/// The site as it stands at a moment: what was built and lies about, the machines and their loads.
/// Poses in the world frame {W}, metres. Robots that are not at work stand in the world as
/// obstacles; one is at work at a time (`activate`).
class SiteWorld {
 public:
  explicit SiteWorld(double contact_tolerance) : contact_tolerance_(contact_tolerance) {}

  /// An obstacle for good. Obstacles are tested in the order in which they came.
  void add_obstacle(std::string name, collision::BodyPtr body, const math::Pose& X_WB);
  /// A component that stands at X_WO; its index. `body` null: it has no shape and is in nobody's
  /// way.
  int add_component(std::string name, collision::BodyPtr body, const math::Pose& X_WO, double mass);
  /// A robot that stands at q; its index.
  int add_robot(SiteRobot robot, std::vector<double> q);

  /// Takes the robot's bodies out of the obstacles: it is the one that moves now.
  void activate(int robot);

  /// The component leaves the world and hangs on the tool from now on as it stands to it. It must
  /// stand, and the tool must be free.
  void attach(int robot, int component);
  /// Puts shapes on the tool that never stood in the world; X_TO is the identity.
  void attach_carry(int robot, collision::BodyPtr body);
  /// The load stands in the world where it is. A component must be attached.
  void detach(int robot);
  /// The component leaves the site.
  void remove(int component);

  /// The robot's configuration after a step of its own.
  void set_configuration(int robot, std::vector<double> q);

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

  /// Changes whenever anything but `robot`'s own steps changed what it may do.
  std::uint64_t version(int robot) const;

  /// What can be gone back to: components, configurations and loads.
  struct Snapshot {
    struct Place {
      bool standing = false;
      math::Pose X_WO = math::Pose::Identity();
    };
    struct Machine {
      std::vector<double> q;
      std::optional<Load> load;
    };
    std::vector<Place> components;
    std::vector<Machine> robots;
  };
  Snapshot snapshot() const;
  void restore(const Snapshot& snapshot);

 private:
  struct Component {
    std::string name;
    collision::BodyPtr body;
    math::Pose X_WO = math::Pose::Identity();
    double mass = 0;
    bool standing = false;
    std::optional<collision::ObstacleId> id;
  };
  struct RobotEntry {
    SiteRobot robot;
    std::vector<double> q;
    std::optional<Load> load;
    std::vector<collision::ObstacleId> ids;  ///< its bodies and load, while it is not at work
    std::uint64_t steps = 0;
  };

  RobotEntry& entry(int index) { return robots_[static_cast<std::size_t>(index)]; }
  const RobotEntry& entry(int index) const { return robots_[static_cast<std::size_t>(index)]; }
  collision::ObstacleId insert(const std::string& name, const collision::BodyPtr& body,
                               const math::Pose& X_WB);
  void erase(collision::ObstacleId id);
  void stand(Component& component, const math::Pose& X_WO);
  void lift(Component& component);
  void set_down(RobotEntry& robot);
  void pick_up(RobotEntry& robot);

  double contact_tolerance_;
  collision::CollisionWorld obstacles_;
  std::map<collision::ObstacleId, std::string> names_;
  std::vector<Component> components_;
  std::vector<RobotEntry> robots_;
  int active_ = -1;
  std::uint64_t changes_ = 0;
};

}  // namespace rubicon::site
