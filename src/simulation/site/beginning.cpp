#include "src/simulation/site/beginning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "src/motion/collision/query/overlap_depth.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/rope_volume.hpp"
#include "src/simulation/site/support.hpp"

namespace rubicon::site {

namespace {

using interpreter::Diagnostic;
using interpreter::Severity;
using interpreter::Span;
using interpreter::ThingRef;

/// So many overlaps are told one by one.
constexpr std::size_t kMostTold = 20;

struct Thing {
  std::string name;
  std::string owner;
  std::optional<ThingRef> ref;  ///< nothing where no waiver can be about it
  Span span;
  collision::BodyPtr body;
  math::Pose X_WB;
};

std::pair<ThingRef, ThingRef> pair_of(const ThingRef& a, const ThingRef& b) {
  return a < b ? std::pair(a, b) : std::pair(b, a);
}

class BeginningSearch {
 public:
  explicit BeginningSearch(const interpreter::PlanModel& plan) : plan_(plan) {
    for (const interpreter::WaiverSpec& waiver : plan.waivers) {
      waived_.insert(pair_of(waiver.first, waiver.second));
    }
  }

  Beginning run() {
    using Kind = ThingRef::Kind;
    for (std::size_t i = 0; i < plan_.site.size(); ++i) {
      const std::string name = site_shape_name(plan_.site_names, i, plan_.site.size());
      stand({name,
             "site",
             ThingRef{Kind::site, -1},
             {},
             prepare_named({plan_.site[i]}, name),
             math::Pose::Identity()});
    }
    for (std::size_t i = 0; i < plan_.components.size(); ++i) {
      const interpreter::ComponentSpec& component = plan_.components[i];
      collision::BodyPtr body = prepare_named(component.shapes, component.name);
      if (!body) continue;
      Thing thing{component.name, component.name,  ThingRef{Kind::component, static_cast<int>(i)},
                  component.span, std::move(body), component.X_WO};
      compare(thing);
      stand(std::move(thing));
    }
    for (std::size_t i = 0; i < plan_.robots.size(); ++i) add_robot(static_cast<int>(i));
    for (const interpreter::MovingSpec& moving : plan_.movings) add_moving(moving);
    add_idle_waivers();
    return std::move(result_);
  }

 private:
  void stand(Thing thing) {
    const collision::ObstacleId id = world_.insert(thing.body, thing.X_WB);
    standing_.emplace(id, std::move(thing));
  }

  /// Against all that stands already.
  void compare(const Thing& thing) {
    collision::SweptQuery query;
    query.contact_tolerance = plan_.contact;
    query.items.push_back({{thing.body.get(), geometry::stationary(thing.X_WB)}, true});
    if (!world_.test(query).hit) return;
    for (const collision::BlockingPair& pair : world_.explain(query)) {
      const Thing& other = standing_.at(*pair.hit.obstacle);
      if (thing.ref) {
        const auto both = pair_of(*other.ref, *thing.ref);
        met_.insert(both);
        if (waived_.contains(both)) continue;
      }
      const double depth =
          collision::overlap_depth(*other.body, other.X_WB, *thing.body, thing.X_WB);
      result_.overlaps.push_back(
          {{other.name, thing.name, depth}, other.owner, thing.owner, other.span, thing.span});
    }
  }

  /// One of a module or a loop is idle if it is about nothing in any copy.
  void add_idle_waivers() {
    std::map<std::pair<interpreter::FileId, std::uint32_t>, bool> needed;
    const auto place_of = [](const Span& span) { return std::pair(span.file, span.begin); };
    for (const interpreter::WaiverSpec& waiver : plan_.waivers) {
      needed[place_of(waiver.span)] |= met_.contains(pair_of(waiver.first, waiver.second));
    }
    for (const interpreter::WaiverSpec& waiver : plan_.waivers) {
      const auto found = needed.find(place_of(waiver.span));
      if (found == needed.end() || found->second) continue;
      result_.idle_waivers.push_back(waiver.span);
      needed.erase(found);
    }
  }

  void add_robot(int index) {
    const interpreter::RobotSpec& spec = plan_.robots[static_cast<std::size_t>(index)];
    const auto [machine, q] = make_starting_robot(spec, prepared_);
    std::vector<math::Pose> X_WB;
    robot::body_poses(*machine.model, machine.mounting, q, X_WB);
    std::vector<Thing> parts;
    const ThingRef ref{ThingRef::Kind::robot, index};
    for (const int part : machine.ropes) {
      RopeVolume rope = standing_rope(machine, part, q);
      const math::Pose X_WR = rope.motion.pose(0);
      parts.push_back({machine.body_names[static_cast<std::size_t>(part)], spec.name, ref,
                       spec.span, std::move(rope.body), X_WR});
    }
    for (std::size_t i = 0; i < machine.bodies.size(); ++i) {
      if (!machine.bodies[i]) continue;
      parts.push_back(
          {machine.body_names[i], spec.name, ref, spec.span, machine.bodies[i], X_WB[i]});
    }
    if (index == 0 && !plan_.carry.empty()) {
      parts.push_back({"the load", spec.name, ref, spec.span,
                       prepare_named(plan_.carry, "the load"),
                       robot::tool_pose(*machine.model, machine.mounting, q)});
    }
    for (const Thing& part : parts) compare(part);
    for (Thing& part : parts) stand(std::move(part));
  }

  /// What keeps a timetable that begins at 0 s, where it then is.
  void add_moving(const interpreter::MovingSpec& moving) {
    if (moving.timetable.begin() > 0) return;
    collision::BodyPtr body = prepare_named(moving.shapes, moving.name);
    if (!body) return;
    compare({moving.name,
             {},
             {},
             moving.span,
             std::move(body),
             geometry::pose_at(moving.timetable, 0)});
  }

  const interpreter::PlanModel& plan_;
  std::set<std::pair<ThingRef, ThingRef>> waived_, met_;
  PreparedRobots prepared_;
  collision::CollisionWorld world_;
  std::map<collision::ObstacleId, Thing> standing_;
  Beginning result_;
};

std::string depth_text(double depth) {
  const double millimetres = depth * 1000;
  return millimetres < 10 ? fmt::format("{:.2f} mm", millimetres)
                          : fmt::format("{:.0f} mm", millimetres);
}

Diagnostic warning(const char* code, Span span, std::string message, std::string hint) {
  return {Severity::warning, code, span, std::move(message), {}, std::move(hint)};
}

/// What helps a component that does not stand.
std::string hint_for(const interpreter::ComponentSpec& component) {
  const auto& fixings = component.fixed_to;
  if (fixings.empty()) {
    return "set it down, or say what holds it: fixed to NAME; or braced by NAME; in the component, "
           "or support off; in the plan";
  }
  const bool all_wait =
      std::all_of(fixings.begin(), fixings.end(), [](const auto& each) { return each.after >= 0; });
  return all_wait ? "say what holds it until then: fixed to NAME; without after, or braced by "
                    "NAME;, or set it down, or support off; in the plan"
                  : "what it is fixed to does not touch it: bring them together, or support off; "
                    "in the plan";
}

}  // namespace

Beginning look_at_beginning(const interpreter::PlanModel& plan) {
  Beginning beginning = BeginningSearch(plan).run();
  if (plan.support.mode != interpreter::SupportRules::Mode::off) {
    const PreparedSite prepared = prepare_site(plan);
    const SiteWorld site = make_site(plan, prepared);
    beginning.floating = Support(plan, site, prepared.surfaces).find_floating();
  }
  return beginning;
}

std::vector<Diagnostic> warnings_of(const interpreter::PlanModel& plan,
                                    const Beginning& beginning) {
  std::vector<Diagnostic> all;
  for (const BeginningOverlap& each : beginning.overlaps) {
    if (all.size() == kMostTold) {
      all.push_back(warning("P33", each.second,
                            fmt::format("{} more pairs overlap at the beginning",
                                        beginning.overlaps.size() - kMostTold),
                            {}));
      break;
    }
    const std::string hint =
        each.second_owner.empty()
            ? std::string("let it begin later than 0 s: then it comes when there is room")
            : fmt::format(
                  "move one of them, or, if it is meant, write touching {} {}; or, for "
                  "an embedded part, within {} {};",
                  each.first_owner, each.second_owner, each.second_owner, each.first_owner);
    Diagnostic told = warning("P33", each.second,
                              fmt::format("at the beginning {} is {} deep in {}", each.pair.second,
                                          depth_text(each.pair.depth), each.pair.first),
                              hint);
    if (each.first.end > each.first.begin) told.notes.push_back({each.first, "the other one"});
    all.push_back(std::move(told));
  }
  for (const Span& span : beginning.idle_waivers) {
    all.push_back(warning("P34", span, "the two do not overlap at the beginning", "leave it out"));
  }
  for (std::size_t i = 0; i < beginning.floating.size(); ++i) {
    const auto& [index, reason] = beginning.floating[i];
    const interpreter::ComponentSpec& component = plan.components[static_cast<std::size_t>(index)];
    if (i == kMostTold) {
      all.push_back(warning("P45", component.span,
                            fmt::format("{} more components do not stand at the beginning",
                                        beginning.floating.size() - kMostTold),
                            {}));
      break;
    }
    all.push_back(
        warning("P45", component.span,
                fmt::format("at the beginning {} does not stand: {}", component.name, reason),
                hint_for(component)));
  }
  return all;
}

}  // namespace rubicon::site
