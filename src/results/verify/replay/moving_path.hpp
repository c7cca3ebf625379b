#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "src/results/verify/geometry/pair_sweep.hpp"
#include "src/results/verify/input/record.hpp"

namespace rubicon::verify {

/// A stretch of the way of something with a timetable, straight and even, or a stay.
struct MovingStretch {
  Ticks from = 0;
  Ticks to = 0;
  Pose X_from = Pose::Identity();
  Vec3 way = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  ///< of its turn, in the world
  double angle_deg = 0;

  /// From a share of it to another.
  MovingStretch part(double s0, double s1) const;
};

/// Something with a timetable through the whole plan: what the timetable and the stops of the trace
/// say.
class MovingPath {
 public:
  /// Reports stops and starts that contradict each other. `until` is the end of the plan.
  MovingPath(const SceneMoving& moving, const std::vector<MovingRecord>& records,
             const std::vector<MeshData>& meshes, Ticks until, Faults& faults);

  const std::string& name() const { return moving_.name; }
  const Solid* solid() const { return solid_.get(); }
  /// What is above people; null: there are none.
  const Solid* overhead() const { return overhead_.get(); }

  /// Its stretches between two times, cut to these. With `once`, no more than one round of those
  /// between two stops: where what it is compared with stands, the others are as that one.
  void stretches(Ticks from, Ticks to, bool once,
                 const std::function<void(const MovingStretch&)>& visit) const;

 private:
  /// A time in which it goes by its timetable, or stands.
  struct Run {
    Ticks from = 0;
    Ticks to = 0;
    Ticks own = 0;  ///< the time of its timetable at `from`
    bool stands = false;
  };

  Ticks begin() const { return moving_.path.front().time; }
  Ticks end() const { return moving_.path.back().time; }
  void visit_run(const Run& run, Ticks from, Ticks to,
                 const std::function<void(const MovingStretch&)>& visit) const;

  const SceneMoving& moving_;
  std::shared_ptr<const Solid> solid_, overhead_;
  std::vector<Run> runs_;
};

/// A solid of it while a stretch lasts.
class MovingPart : public PartMotion {
 public:
  MovingPart(const Solid& solid, const MovingStretch& stretch);
  PartState state(double u0, double u1) const override;

 private:
  const MovingStretch& stretch_;
  double radius_ = 0;  ///< m; of the points, from the axis of the turn
};

}  // namespace rubicon::verify
