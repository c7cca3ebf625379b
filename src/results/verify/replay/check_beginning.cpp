#include "src/results/verify/replay/check_beginning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "src/results/verify/input/box_tree.hpp"
#include "src/results/verify/replay/step_rules.hpp"

namespace rubicon::verify {

namespace {

struct StandingThing {
  std::string name;
  std::string owner;  ///< as waivers call it
  const Solid* solid = nullptr;
  Pose X_WS = Pose::Identity();
  bool keeps_timetable = false;
};

using Names = std::pair<std::string, std::string>;

Names pair_of(const std::string& a, const std::string& b) {
  return a < b ? Names(a, b) : Names(b, a);
}

std::vector<StandingThing> standing_things(const Scene& scene, const SiteParts& site,
                                           const std::vector<MovingPath>& movings) {
  std::vector<StandingThing> things;
  for (const Obstacle& each : site.obstacles) {
    if (each.component < 0)
      things.push_back({each.name, "site", each.solid.get(), each.X_WS, false});
  }
  for (std::size_t i = 0; i < scene.components.size(); ++i) {
    const SceneComponent& component = scene.components[i];
    if (!site.components[i]) continue;
    things.push_back(
        {component.name, component.name, site.components[i].get(), component.X_WO, false});
  }
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    Leg leg;
    leg.q0 = start_values(scene.robots[i]);
    const LegFrames frames(*site.robots[i].mechanism, leg);
    for (const RobotPart& part : site.robots[i].bodies) {
      things.push_back({part.name, scene.robots[i].name, part.solid,
                        LegPart(frames, part).state(0, 1).X_WS, false});
    }
  }
  for (std::size_t i = 0; i < movings.size(); ++i) {
    const SceneMoving::Place& first = scene.movings[i].path.front();
    const Solid* const solid = movings[i].solid();
    if (first.time > 0 || solid == nullptr) continue;
    things.push_back({movings[i].name(), movings[i].name(), solid, first.X_WO, true});
  }
  return things;
}

}  // namespace

void check_beginning(const Scene& scene, const SiteParts& site,
                     const std::vector<MovingPath>& movings, Faults& faults) {
  if (!scene.beginning) return;
  std::set<Names> waived, told;
  for (const auto& [first, second] : scene.beginning->waived) waived.insert(pair_of(first, second));
  for (const SceneOverlap& each : scene.beginning->overlaps) {
    told.insert(pair_of(each.first, each.second));
  }
  const std::vector<StandingThing> things = standing_things(scene, site, movings);
  std::vector<Bounds> boxes;
  for (const StandingThing& each : things) {
    boxes.push_back(each.solid->bounds.placed(each.X_WS).grown(kBoundsMargin));
  }
  const BoxTree tree(boxes);
  std::set<Names> near_pairs;
  const auto fault = [&](std::string text) {
    faults.push_back({FaultKind::contact, ResultFile::trace, 1, "", -1, std::move(text)});
  };
  for (std::size_t i = 0; i < things.size(); ++i) {
    std::vector<int> near;
    tree.meeting(boxes[i], [&](int index) {
      if (static_cast<std::size_t>(index) < i) near.push_back(index);
    });
    std::sort(near.begin(), near.end());
    for (const int index : near) {
      const StandingThing& a = things[static_cast<std::size_t>(index)];
      const StandingThing& b = things[i];
      // Of two with a timetable the later one waits.
      if (a.owner == b.owner || (a.keeps_timetable && b.keeps_timetable)) continue;
      const Names names = pair_of(a.name, b.name);
      near_pairs.insert(names);
      const StandingPart still_a(a.X_WS);
      const StandingPart still_b(b.X_WS);
      const auto contact = PairSweep(*a.solid, still_a, *b.solid, still_b, scene.contact).run();
      if (!contact) continue;
      if (told.contains(names) || waived.contains(pair_of(a.owner, b.owner))) continue;
      fault(
          fmt::format("at the beginning {} is at least {:.1f} mm deep in {}, and the header does "
                      "not tell",
                      b.name, contact->depth * 1000, a.name));
    }
  }
  // Of what is near each other it may be that only the run's own means see it (meshes).
  for (const SceneOverlap& each : scene.beginning->overlaps) {
    if (near_pairs.contains(pair_of(each.first, each.second))) continue;
    fault(
        fmt::format("the header tells that {} is {:.1f} mm deep in {} at the beginning: it is not",
                    each.second, each.depth * 1000, each.first));
  }
}

}  // namespace rubicon::verify
