#include "src/simulation/taskplan/tip_places.hpp"

#include <algorithm>

namespace rubicon::taskplan {

namespace {

bool has_left(const Stage& stage, int task, const TipClaim& claim) {
  if (!claim.stood) return false;
  const int robot = stage.spec(task).robot;
  const site::SiteRobot& machine = stage.site.robot(robot);
  const site::BodyCorners corners = site::corners_of(stage.robot_spec(robot).robot->model);
  return !site::footprint_of(machine, corners, stage.site.configuration(robot))
              .overlaps(*claim.stood);
}

bool has_soil_on_it(const Stage& stage, int task) {
  if (stage.site.carries_soil(stage.spec(task).robot)) return true;
  const auto truck = stage.haulage.trucks.find(task);
  return truck != stage.haulage.trucks.end() && truck->second.volume > 0;
}

}  // namespace

bool is_same_place(const math::Pose& a, const math::Pose& b) { return a.matrix() == b.matrix(); }

int who_tips_at(const Stage& stage, const math::Pose& X_WL, int task) {
  for (const auto& [other, claim] : stage.haulage.tips) {
    if (stage.spec(other).robot == stage.spec(task).robot) continue;
    if (!is_same_place(claim.X_WL, X_WL)) continue;
    if (!has_left(stage, other, claim)) return other;
  }
  return -1;
}

bool all_is_dug(const Stage& stage, const interpreter::HaulSpec& haul) {
  return std::all_of(haul.digs.begin(), haul.digs.end(), [&](int dig) {
    const auto place = stage.haulage.places.find(dig);
    return stage.is_over(dig) || (place != stage.haulage.places.end() && place->second.is_over);
  });
}

int who_wants_the_tip_of(const Stage& stage, int task, bool for_good) {
  const auto own = stage.haulage.tips.find(task);
  if (own == stage.haulage.tips.end()) return -1;
  for (int other = 0; other < stage.plan_tasks(); ++other) {
    const interpreter::TaskSpec& spec = stage.spec(other);
    if (other == task || !spec.haul || stage.is_over(other)) continue;
    if (spec.robot < 0 || spec.robot == stage.spec(task).robot) continue;
    const auto claim = stage.haulage.tips.find(other);
    if (claim != stage.haulage.tips.end() && !claim->second.stood) continue;
    const std::vector<math::Pose>& tips = spec.haul->tips;
    const bool shares = std::any_of(tips.begin(), tips.end(), [&](const math::Pose& X) {
      return is_same_place(X, own->second.X_WL);
    });
    if (!shares) continue;
    const bool is_to_tip =
        has_soil_on_it(stage, other) || (for_good && !all_is_dug(stage, *spec.haul));
    if (!is_to_tip) continue;
    const bool all_taken = std::all_of(tips.begin(), tips.end(), [&](const math::Pose& X) {
      return who_tips_at(stage, X, other) >= 0;
    });
    if (all_taken) return other;
  }
  return -1;
}

}  // namespace rubicon::taskplan
