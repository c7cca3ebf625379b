#pragma once

#include <memory>
#include <vector>

#include "src/motion/guides/guide.hpp"
#include "src/motion/guides/plan_memory.hpp"

namespace rubicon::guides {

/// Plans a way once, with what was learnt before and may be of use after.
PlanReport plan_way(const GuideSpec& spec, const GuideTask& task, std::span<const double> q,
                    MotionTests& tests, PlanMemory& memory);

/// Plans a whole way, hands out its points, and plans again from where the robot stands when the
/// script ends short of one.
class PlannedGuide : public Guide {
 public:
  PlannedGuide(GuideSpec spec, GuideTask task) : spec_(std::move(spec)), task_(std::move(task)) {}

  std::unique_ptr<Guide> copy() const override { return std::make_unique<PlannedGuide>(*this); }
  GuideAnswer begin(std::span<const double> q, MotionTests& tests) override;
  GuideAnswer reached(std::span<const double> q, MotionTests& tests) override;
  GuideAnswer ended_short(std::span<const double> q, MotionTests& tests) override;

 private:
  GuideAnswer way_point() const;

  GuideSpec spec_;
  GuideTask task_;
  /// Where it begins, its waypoints, the goal last; shared: it does not change.
  std::shared_ptr<const std::vector<std::vector<double>>> way_;
  std::size_t next_ = 0;  ///< index of the waypoint that was given last
  int planned_ = 0;
  PlanMemory memory_;
};

}  // namespace rubicon::guides
