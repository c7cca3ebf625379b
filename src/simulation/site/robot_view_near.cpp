#include <algorithm>
#include <limits>

#include "src/simulation/site/robot_view.hpp"

namespace rubicon::site {

namespace {

/// m: how exactly the distance to the nearest thing is found.
constexpr double kNearestResolution = 1e-3;

/// Steps by which the parameters of a robot are moved to see which bodies that moves: all are
/// different, so that none takes back what another does.
double nudge(std::size_t parameter) { return 1 + 0.137 * static_cast<double>(parameter); }

}  // namespace

bool RobotView::is_ever_moved(int part) const {
  const SiteRobot& machine = robot();
  const robot::RobotModel& model = *machine.model;
  if (moved_bodies_.empty()) {
    std::vector<double> q = site_.configuration(index_);
    std::vector<math::Pose> before;
    std::vector<math::Pose> after;
    robot::body_poses(model, machine.mounting, q, before);
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (model.parameters[i].free && !model.parameters[i].derived) q[i] += nudge(i);
    }
    robot::update_derived(model, machine.mounting, q);
    robot::body_poses(model, machine.mounting, q, after);
    constexpr double kSame = 1e-9;
    for (std::size_t i = 0; i < before.size(); ++i) {
      moved_bodies_.push_back((before[i].matrix() - after[i].matrix()).cwiseAbs().maxCoeff() >
                              kSame);
    }
  }
  return moved_bodies_[static_cast<std::size_t>(machine.body_of(part))];
}

guides::Nearness RobotView::nearest(std::span<const double> q, double range,
                                    const guides::PairsLeftOut& left_out) const {
  guides::Nearness best;
  best.distance = std::numeric_limits<double>::infinity();
  double reach = range;
  const std::vector<SiteWorld::NamedPart> others = site_.parts_of_others(index_);
  const auto is_left_out = [&](const std::string& moved, const std::string& met) {
    return std::find(left_out.begin(), left_out.end(), std::pair(moved, met)) != left_out.end();
  };
  for (const ReservedPart& part : parts_at(q)) {
    if (part.is_buffer || !is_ever_moved(part.part)) continue;
    const std::string& name = part_name(part.part);
    collision::SweptQuery query;
    query.contact_tolerance = site_.contact_tolerance();
    query.items.push_back({{part.body.get(), part.motion}, true});
    std::vector<const std::string*> names{&name};
    for (const SiteWorld::NamedPart& other : others) {
      if (is_left_out(name, other.name)) continue;
      query.pairs.emplace_back(0, static_cast<int>(query.items.size()));
      query.items.push_back({{other.part.body.get(), other.part.motion}, false});
      names.push_back(&other.name);
    }
    while (reach >= 0) {
      const collision::Clearance near =
          site_.obstacles().clearance(query, reach, kNearestResolution);
      if (!near.pair || near.upper_bound > reach) break;
      const bool stands = near.pair->obstacle.has_value();
      const int met = std::max(near.pair->item, near.pair->other_item.value_or(0));
      const std::string& met_name = stands ? site_.obstacle_name(*near.pair->obstacle)
                                           : *names[static_cast<std::size_t>(met)];
      if (stands && is_left_out(name, met_name)) {
        query.ignore.push_back(*near.pair->obstacle);
        continue;
      }
      if (near.upper_bound < best.distance) best = {near.upper_bound, name, met_name};
      reach = std::min(reach, near.upper_bound);
      break;
    }
  }
  return best;
}

}  // namespace rubicon::site
