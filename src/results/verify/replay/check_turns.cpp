#include "src/results/verify/replay/check_turns.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::verify {

namespace {

/// m: waypoints are rounded to 0.1 mm in x and in y.
constexpr double kRounded = 0.3e-3;
/// Degrees by which a frame may be turned otherwise by rounding.
constexpr double kRounded_deg = 1e-6;

double heading_deg(const Pose& X) { return math::atan2_deg(X(1, 0), X(0, 0)); }

void check_way(const SceneTask& task, Faults& faults) {
  std::vector<const Pose*> way;
  for (const SceneGoal& goal : task.via) {
    if (goal.pose) way.push_back(&*goal.pose);
  }
  if (task.go_pose) way.push_back(&*task.go_pose);
  for (std::size_t k = 1; k < way.size(); ++k) {
    const Vec3 gone = way[k]->translation() - way[k - 1]->translation();
    const double length = std::sqrt(gone.x() * gone.x() + gone.y() * gone.y());
    const double before = heading_deg(*way[k - 1]);
    const double turned = math::normalised_deg(heading_deg(*way[k]) - before);
    // The chord of the arc that turns so far.
    const double half_deg = std::fabs(turned) / 2;
    const bool narrow = std::fabs(turned) > kRounded_deg &&
                        length + kRounded < 2 * task.turn_radius * math::sin_deg(half_deg);
    const double middle = before + turned / 2;
    const double aside =
        std::fabs(gone.y() * math::cos_deg(middle) - gone.x() * math::sin_deg(middle));
    const double ahead = gone.x() * math::cos_deg(middle) + gone.y() * math::sin_deg(middle);
    if (!narrow && aside <= kRounded && ahead >= -kRounded) continue;
    faults.push_back(
        {FaultKind::motion, ResultFile::trace, 1, task.name, -1,
         narrow
             ? fmt::format("between waypoints {} and {} its way turns by {:.1f} degrees on "
                           "{:.3f} m, with a radius of {:g} m",
                           k, k + 1, std::fabs(turned), length, task.turn_radius)
             : fmt::format("waypoint {} of its way does not lie ahead of the one before", k + 1)});
    return;
  }
}

}  // namespace

void check_turns(const Trace& trace, Faults& faults) {
  for (const SceneTask& task : trace.scene.tasks) {
    if (task.turn_radius > 0) check_way(task, faults);
  }
}

}  // namespace rubicon::verify
