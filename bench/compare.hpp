#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/swept_scene.hpp"

namespace rubicon::bench {

/// How a scene is asked: our engine, and what it is compared with.
enum class Method {
  kOurs,            ///< CollisionWorld::test, the best instructions of this processor
  kOursBaseline,    ///< the same with the instructions that every x86-64 processor has
  kFclDefault,      ///< FCL: tree, continuousCollide with its default request; rotations as screws
  kFcl10mm,         ///< FCL: at a pose every 10 mm the tree, then collide
  kFcl10mmOneTree,  ///< FCL: the tree once a step, then collide at a pose every 10 mm
  kFclDropped,      ///< as kFclDefault, but with the default motion type, which drops rotations
  kFclTight,        ///< as kFclDefault, with exact bounds of the obstacles put into FCL's objects
};

/// Registers one benchmark a method, named SCENE/KIND/COUNT/METHOD. The scene is built once, when
/// the first of them runs, and lists of steps are made ready outside of what is timed. One
/// iteration is one step; whole rounds of all steps are timed, so that every method answers the
/// same mix. Counters: `hits`, the share of steps called a hit; for FCL also `missed`, the share of
/// our hits it calls free, and `false_hits`, the share of our free steps it calls a hit.
void register_comparison(const std::string& scene, const std::string& kind, int count,
                         const std::function<SweptScene()>& build,
                         const std::vector<Method>& methods);

}  // namespace rubicon::bench
