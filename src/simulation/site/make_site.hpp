#pragma once

#include <map>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/site/site_world.hpp"
#include "src/simulation/site/support_surface.hpp"

namespace rubicon::site {

/// Shapes made ready; null without shapes. Throws std::invalid_argument, naming the thing, for
/// shapes without extent.
collision::BodyPtr prepare_named(const std::vector<geometry::Shape>& shapes,
                                 const std::string& name);

/// What site shape `i` of `count` is called: whose it is by `names`, which may be shorter and has
/// "" for those of the site itself, which are first; these are "site", or "site 1", "site 2" ...
/// where there are several.
std::string site_shape_name(const std::vector<std::string>& names, std::size_t i,
                            std::size_t count);

/// The bodies of robot files, each made ready once.
using PreparedRobots = std::map<const interpreter::CheckedRobot*, PreparedBodies>;

/// A robot of a plan as it stands at the beginning: derived values computed, cyclic angles reduced.
struct StartingRobot {
  SiteRobot machine;
  std::vector<double> q;
};
StartingRobot make_starting_robot(const interpreter::RobotSpec& spec, PreparedRobots& prepared);

/// What never changes of the things on a site, made ready once for all runs of a plan. By the
/// plan's indices.
struct PreparedSite {
  std::vector<collision::BodyPtr> obstacles, components, movings, air_above_movings;
  collision::BodyPtr carry;
  PreparedRobots robots;
  /// Of components, then of the shapes of the site; none where the plan does not ask for support.
  std::vector<SupportSurfacePtr> surfaces;
};
/// Throws std::invalid_argument, naming the thing, for shapes without extent.
PreparedSite prepare_site(const interpreter::PlanModel& plan);

/// The site of a plan at its beginning. Indices of components and robots are the plan's.
/// `prepared` may come from the same plan with other durations; threads may share it.
SiteWorld make_site(const interpreter::PlanModel& plan, const PreparedSite& prepared);
/// The same, made ready for this site alone.
SiteWorld make_site(const interpreter::PlanModel& plan);

}  // namespace rubicon::site
