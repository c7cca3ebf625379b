#pragma once

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/site/site_world.hpp"

namespace rubicon::site {

/// Shapes made ready; null without shapes. Throws std::invalid_argument, naming the thing, for
/// shapes without extent.
collision::BodyPtr prepare_named(const std::vector<geometry::Shape>& shapes,
                                 const std::string& name);

/// The site of a plan at its beginning. Indices of components and robots are the plan's. Site
/// shapes are called "site", or "site 1", "site 2" ... where there are several. Throws
/// std::invalid_argument, naming the thing, for shapes without extent.
SiteWorld make_site(const interpreter::PlanModel& plan);

}  // namespace rubicon::site
