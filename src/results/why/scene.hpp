#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "src/motion/collision/swept_query.hpp"
#include "src/results/replay/replay.hpp"
#include "src/results/why/engine_answer.hpp"
#include "src/simulation/site/step_query.hpp"

namespace rubicon::why {

using replay::Ticks;

/// A place in a run: a time, and the line of the trace that tells of it.
struct Moment {
  Ticks time = 0;
  int line = 0;
};

/// A step of the task's robot: all values before and after it (m or degrees, turns not reduced).
struct AskedStep {
  std::span<const double> q_from;
  std::span<const double> q_to;
};

/// What stands so near to a part of a machine that it touches it, or is about to: part (a body of
/// the machine, or after the last of them the load) and name.
using Touches = std::set<std::pair<int, std::string>>;

/// A pair that blocks a step.
struct Blocked {
  std::string moved;
  std::string met;
  ContactAnswer contact;
};

/// What a task's robot meets, rebuilt from a trace: the site, what stands at a moment, the loads,
/// the other machines that stand still, and the zones of people. The collision engine is asked as
/// it was in the run. Of a task that was rejected its own pick-ups and set-downs count; what others
/// did is that of the run that happened. Machines that make a step at the moment are left out.
class Scene {
 public:
  /// The replay must outlive it. Throws std::invalid_argument for shapes without extent.
  Scene(const replay::Replay& replay, const replay::TaskRun& run);

  /// From now on the scene is that of the moment.
  void set_moment(const Moment& moment);

  /// All pairs that block the step: obstacles, own bodies, zones, machines.
  std::vector<Blocked> blocking(const AskedStep& step) const;

  /// Takes a step into account: `nearest` becomes nearer if this one comes nearer to anything, the
  /// machine itself and what is excepted left out; whether it did.
  bool look_for_miss(const AskedStep& step, const Touches& except, NearestMiss& nearest) const;
  /// Adds all that is within `gap` (m) of parts of the robot where it stands at q.
  void add_touches(std::span<const double> q, double gap, Touches& touches) const;

  /// Since when the thing of this name stands where it is; nothing for other names.
  std::optional<Origin> origin_of(const std::string& name) const;

  const replay::Machine& machine() const { return replay_.machines[index(run_.robot)]; }
  /// Parts of the robot: its bodies, and one for the load.
  int part_count() const { return static_cast<int>(robots_[index(run_.robot)].bodies.size()) + 1; }
  double contact_tolerance() const { return replay_.header.contact; }

 private:
  struct Change {
    const replay::Event* event = nullptr;
    const replay::TaskRun* run = nullptr;
  };
  struct Standing {
    bool stands = false;
    math::Pose X_WO = math::Pose::Identity();
    std::optional<collision::ObstacleId> id;
    const Change* change = nullptr;  ///< that put it there
  };
  /// Bodies that stand, and how they are called.
  struct World {
    struct Thing {
      std::string name;
      collision::BodyPtr body;
      math::Pose X_WB = math::Pose::Identity();
    };
    collision::CollisionWorld bodies;
    std::map<collision::ObstacleId, Thing> things;

    std::optional<collision::ObstacleId> insert(const std::string& name,
                                                const collision::BodyPtr& body,
                                                const math::Pose& X_WB);
    void remove(collision::ObstacleId id);
    /// What a part need not look at.
    std::vector<collision::ObstacleId> excepted(int part, const Touches& touches) const;
  };

  std::array<const World*, 2> worlds() const { return {&obstacles_, &others_}; }
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  void add_machines();
  void add_changes();
  bool is_past(const Change& change) const;
  void stand_components();
  void hang_load();
  void stand_others();
  void stand_machine(std::size_t robot);
  const collision::BodyPtr& component_body(std::size_t component);
  std::optional<site::Load> load_of(const replay::Hanging& hanging);
  const std::string& part_name(int part) const;
  const replay::Leg* leg_at(std::size_t robot) const;
  const std::string& task_name(const replay::TaskRun& run) const;
  std::optional<Origin> machine_origin(std::size_t robot) const;

  const replay::Replay& replay_;
  const replay::TaskRun& run_;
  std::vector<site::SiteRobot> robots_;
  std::vector<std::optional<collision::BodyPtr>> component_bodies_;
  std::vector<Change> changes_;  ///< by time, then by line
  std::vector<Standing> components_;
  Moment moment_;
  World obstacles_;
  World others_;
  World buffers_;      ///< of other machines that stand still: not for buffers of this one
  World over_people_;  ///< what loads meet, and nothing else does
  std::optional<site::Load> load_;
};

}  // namespace rubicon::why
