#include "src/simulation/site/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>
#include <set>

namespace rubicon::site {

using interpreter::ThingRef;

namespace {

std::string list_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNames = 3;
  const std::size_t shown = std::min(names.size(), kMostNames);
  std::string text = fmt::format("{}", fmt::join(names.begin(), names.begin() + shown, ", "));
  if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

/// How a block leaves what stays.
const char* manner_of(const BlockMotion& motion) {
  // A block that turns about an edge moves its centre no farther than the edge is away.
  if (motion.turn.norm() * motion.size > 0.05 * motion.move.norm()) return "turn";
  return motion.move.head<2>().norm() > 0.1 * -motion.move.z() ? "slide" : "come down";
}

/// Adds to what moves what rests on nothing else, directly or through others: the motion with the
/// fewest parts may leave it in the air.
void add_what_rests_on(std::set<int>& moving, const std::vector<BlockContact>& contacts,
                       const std::vector<BlockJoint>& joints) {
  const std::size_t before = moving.size();
  std::map<int, bool> rests_elsewhere;
  for (const BlockContact& contact : contacts) {
    rests_elsewhere[contact.upper] |= !moving.contains(contact.lower);
  }
  for (const BlockJoint& joint : joints) {
    rests_elsewhere[joint.first] |= !moving.contains(joint.second);
    if (!moving.contains(joint.first)) rests_elsewhere[joint.second] = true;
  }
  for (const auto& [block, elsewhere] : rests_elsewhere) {
    if (!elsewhere) moving.insert(block);
  }
  if (moving.size() > before) add_what_rests_on(moving, contacts, joints);
}

}  // namespace

Equilibrium::Equilibrium(Support& support) : support_(support) {
  for (const interpreter::TaskSpec& task : support.plan_.tasks) {
    if (task.dig && task.dig->soil >= 0) soils_.insert(task.dig->soil);
  }
}

const Equilibrium::Holding& Equilibrium::holding_of(Thing component) {
  const auto known = holdings_.find(component);
  if (known != holdings_.end()) return known->second;
  Holding holding;
  const Support::Placed& placed = support_.placed_[Support::at(component)];
  const StandingSurface bottom =
      looking_down(*support_.surfaces_[Support::at(component)], placed.X_WO);
  const auto rest_on = [&](Thing thing, const StandingSurface& top) {
    auto patches =
        contact_patches(bottom, top, support_.gap_, support_.depth_, support_.plan_.contact);
    if (!patches.empty()) holding.bearings.push_back({thing, std::move(patches)});
  };
  for (const Thing thing : support_.near(placed.lower, placed.upper)) {
    const Support::Placed& other = support_.placed_[Support::at(thing)];
    if (thing == component || !other.stands) continue;
    if (other.lower.z() > placed.upper.z() + support_.gap_ ||
        other.upper.z() < placed.lower.z() - support_.gap_) {
      continue;
    }
    rest_on(thing, support_.top_of(thing));
  }
  if (support_.ground_ >= 0)
    rest_on(support_.ground_, support_.ground_under(placed.lower, placed.upper));
  for (const ThingRef& each : support_.fixings_of(component)) {
    if (each.kind == ThingRef::Kind::component) {
      const bool stands = support_.surfaces_[Support::at(each.index)] &&
                          support_.placed_[Support::at(each.index)].stands;
      if (stands && support_.touches(component, placed.X_WO, each.index)) {
        holding.joints.push_back(each.index);
      }
    } else if (support_.holder({each}, component, placed.X_WO, {})) {
      holding.is_fixed = true;
    }
  }
  return holdings_[component] = std::move(holding);
}

/// What cannot move, or is taken to stand as it is.
bool Equilibrium::is_anchored(Thing thing) {
  return !support_.is_component(thing) || soils_.contains(thing) || support_.floats(thing) ||
         holding_of(thing).is_fixed;
}

bool Equilibrium::may_move(Thing thing) {
  return support_.is_component(thing) && support_.placed_[Support::at(thing)].stands &&
         !is_anchored(thing);
}

/// Components that may move and have forces with this one.
std::vector<Equilibrium::Thing> Equilibrium::neighbours(Thing component) {
  std::set<Thing> found;
  const Holding& holding = holding_of(component);
  for (const Holding::Bearing& bearing : holding.bearings) found.insert(bearing.lower);
  found.insert(holding.joints.begin(), holding.joints.end());
  const Support::Placed& placed = support_.placed_[Support::at(component)];
  for (const Thing other : support_.near(placed.lower, placed.upper)) {
    if (other == component || !support_.is_component(other)) continue;
    const Holding& its = holding_of(other);
    const bool rests =
        std::any_of(its.bearings.begin(), its.bearings.end(),
                    [&](const Holding::Bearing& bearing) { return bearing.lower == component; });
    const bool hangs =
        std::find(its.joints.begin(), its.joints.end(), component) != its.joints.end();
    const std::vector<ThingRef>& braces = support_.plan_.components[Support::at(other)].braced_by;
    const bool leans = std::find(braces.begin(), braces.end(),
                                 ThingRef{ThingRef::Kind::component, component}) != braces.end();
    if (rests || hangs || leans) found.insert(other);
  }
  std::erase_if(found, [this](Thing thing) { return !may_move(thing); });
  return {found.begin(), found.end()};
}

/// All that has forces with `first`, directly or through others.
std::set<Equilibrium::Thing> Equilibrium::assembly_of(const std::vector<Thing>& first) {
  std::set<Thing> assembly;
  std::deque<Thing> open;
  for (const Thing thing : first) {
    if (may_move(thing) && assembly.insert(thing).second) open.push_back(thing);
  }
  while (!open.empty()) {
    const Thing thing = open.front();
    open.pop_front();
    for (const Thing next : neighbours(thing)) {
      if (assembly.insert(next).second) open.push_back(next);
    }
  }
  return assembly;
}

/// Whether all that has forces with `first` can balance.
std::optional<Support::Collapse> Equilibrium::collapse_of(const std::vector<Thing>& first) {
  return collapse_in(assembly_of(first));
}

std::optional<Support::Collapse> Equilibrium::collapse_in(const std::set<Thing>& assembly) {
  const std::vector<Thing> things(assembly.begin(), assembly.end());
  std::map<Thing, int> block_of;
  std::vector<RigidBlock> blocks;
  for (const Thing thing : things) {
    block_of[thing] = static_cast<int>(blocks.size());
    const interpreter::ComponentSpec& spec = support_.plan_.components[Support::at(thing)];
    const math::Pose& X_WO = support_.placed_[Support::at(thing)].X_WO;
    blocks.push_back({X_WO * support_.surfaces_[Support::at(thing)]->centre_of_mass, spec.mass,
                      support_.holder(spec.braced_by, thing, X_WO, {}).has_value()});
  }
  std::vector<BlockContact> contacts;
  std::vector<BlockJoint> joints;
  for (const Thing thing : things) {
    const Holding& holding = holding_of(thing);
    for (const Holding::Bearing& bearing : holding.bearings) {
      if (bearing.lower != support_.ground_ && !support_.carries(bearing.lower, {})) continue;
      const auto lower = block_of.find(bearing.lower);
      for (const ContactPatch& patch : bearing.patches) {
        contacts.push_back({block_of[thing], lower == block_of.end() ? -1 : lower->second,
                            patch.corners, patch.normal});
      }
    }
    for (const Thing joint : holding.joints) {
      if (!support_.carries(joint, {})) continue;
      const auto other = block_of.find(joint);
      joints.push_back({block_of[thing], other == block_of.end() ? -1 : other->second});
    }
  }
  const auto moving = find_collapse(blocks, contacts, joints, interpreter::SupportRules::kFriction);
  if (!moving)
    return Support::Collapse{things, "whether the forces balance could not be found out"};
  if (moving->empty()) return std::nullopt;
  return describe(things, contacts, joints, *moving);
}

Support::Collapse Equilibrium::describe(const std::vector<Thing>& things,
                                        const std::vector<BlockContact>& contacts,
                                        const std::vector<BlockJoint>& joints,
                                        const std::vector<BlockMotion>& moving) {
  std::set<int> all;
  for (const BlockMotion& each : moving) all.insert(each.block);
  add_what_rests_on(all, contacts, joints);
  // Those that leave something that stays come first, and what they leave is named.
  std::vector<const BlockMotion*> hinged;
  for (const BlockMotion& each : moving) {
    const bool leaves = std::any_of(contacts.begin(), contacts.end(), [&](const auto& contact) {
      return contact.upper == each.block && !all.contains(contact.lower);
    });
    if (leaves) hinged.push_back(&each);
  }
  if (hinged.empty()) {
    for (const BlockMotion& each : moving) hinged.push_back(&each);
  }
  Support::Collapse collapse;
  std::vector<std::string> names, with, on;
  for (const BlockMotion* each : hinged) {
    collapse.components.push_back(things[Support::at(each->block)]);
    names.push_back(support_.name_of(things[Support::at(each->block)]));
    for (const Holding::Bearing& bearing : holding_of(things[Support::at(each->block)]).bearings) {
      const auto place = std::find(things.begin(), things.end(), bearing.lower);
      const bool moves =
          place != things.end() && all.contains(static_cast<int>(place - things.begin()));
      const std::string name = support_.name_of(bearing.lower);
      const bool carries = bearing.lower == support_.ground_ || support_.carries(bearing.lower, {});
      if (!moves && carries && std::find(on.begin(), on.end(), name) == on.end()) {
        on.push_back(name);
      }
    }
  }
  for (const BlockMotion* each : hinged) all.erase(each->block);
  for (const int each : all) {
    collapse.components.push_back(things[Support::at(each)]);
    with.push_back(support_.name_of(things[Support::at(each)]));
  }
  collapse.text = fmt::format("{} would {}", list_of(names), manner_of(*hinged.front()));
  if (!on.empty()) collapse.text += " on " + list_of(on);
  if (!with.empty()) {
    collapse.text +=
        fmt::format(", and {} with {}", list_of(with), names.size() == 1 ? "it" : "them");
  }
  return collapse;
}

/// At the beginning: what moves is taken not to stand, until the rest can balance.
void Equilibrium::find_collapsing(std::vector<std::pair<int, std::string>>& found) {
  std::set<Thing> open;
  for (int i = 0; i < support_.components(); ++i) {
    if (support_.surfaces_[Support::at(i)] && support_.placed_[Support::at(i)].stands)
      open.insert(i);
  }
  while (!open.empty()) {
    const Thing thing = *open.begin();
    const std::set<Thing> assembly = assembly_of({thing});
    const auto collapse = collapse_in(assembly);
    if (!collapse) {
      // What has forces with it was looked at with it.
      open.erase(thing);
      for (const Thing each : assembly) open.erase(each);
      continue;
    }
    for (const int each : collapse->components) {
      support_.floating_[Support::at(each)] = true;
      found.emplace_back(each, collapse->text);
    }
  }
  std::sort(found.begin(), found.end());
}

std::optional<Support::Collapse> Support::collapse_with(int component, const math::Pose& X_WO) {
  follow();
  if (!plan_.support.equilibrium || !surfaces_[at(component)]) return std::nullopt;
  place(component, X_WO);
  auto collapse = Equilibrium(*this).collapse_of({component});
  const std::vector<Thing> around = Equilibrium(*this).neighbours(component);
  take_away(component);
  return collapse ? only_new(std::move(*collapse), around) : std::nullopt;
}

std::optional<Support::Collapse> Support::collapse_without(int component) {
  follow();
  if (!plan_.support.equilibrium || !surfaces_[at(component)] || !placed_[at(component)].stands) {
    return std::nullopt;
  }
  const math::Pose X_WO = placed_[at(component)].X_WO;
  const std::vector<Thing> around = Equilibrium(*this).neighbours(component);
  take_away(component);
  auto collapse = Equilibrium(*this).collapse_of(around);
  place(component, X_WO);
  return collapse ? only_new(std::move(*collapse), around) : std::nullopt;
}

/// In plans that only warn things go on that do not balance: what did not before is told no more.
std::optional<Support::Collapse> Support::only_new(Collapse collapse,
                                                   const std::vector<Thing>& around) {
  if (plan_.support.mode == interpreter::SupportRules::Mode::on) return collapse;
  const auto before = Equilibrium(*this).collapse_of(around);
  const auto was_moving = [&](int each) {
    return before && std::find(before->components.begin(), before->components.end(), each) !=
                         before->components.end();
  };
  if (std::all_of(collapse.components.begin(), collapse.components.end(), was_moving)) {
    return std::nullopt;
  }
  return collapse;
}

}  // namespace rubicon::site
