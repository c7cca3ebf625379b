#pragma once

#include <memory>
#include <vector>

#include "bench/swept_scene.hpp"

namespace rubicon::bench {

/// How closely FCL's tree is told where things stand. FCL gives a rotated object a cube around its
/// sphere; kTight puts the exact bounds there, which no user of its interface gets.
enum class FclBounds { kAsItComes, kTight };

/// What continuousCollide makes of a rotation. Its default request drops it: the body goes along
/// the chord and does not turn (kDropped). Asked for a screw it answers the question.
enum class FclRotation { kScrew, kDropped };

/// What most people would use instead: FCL 0.7 as Debian ships it, its dynamic tree built in one
/// go, libccd for single poses.
class FclWorld {
 public:
  /// An empty world for bodies of these forms.
  explicit FclWorld(const std::vector<geometry::Solid>& solids);
  /// The standing bodies of a scene.
  FclWorld(const SweptScene& scene, FclBounds bounds = FclBounds::kAsItComes);
  ~FclWorld();

  /// registerObjects of many into an empty tree, then setup.
  void insert_all(const std::vector<Standing>& standing);
  /// registerObject and unregisterObject; `index` counts what was inserted.
  void insert(const Standing& standing);
  void remove(std::size_t index);

  /// A load, made ready once.
  struct Load;
  using LoadPtr = std::shared_ptr<const Load>;
  static LoadPtr make_load(const geometry::Solid& solid);

  /// A step of a load, made ready outside of what is timed: the exact bounds of what it sweeps,
  /// both end poses and, if wanted, a pose every 10 mm of its longest way, each with its exact
  /// bounds.
  struct Step;
  using StepPtr = std::shared_ptr<const Step>;
  static StepPtr make_step(const LoadPtr& load, const geometry::ScrewMotion& motion,
                           bool with_poses);

  /// The tree, then continuousCollide with its default request (ten poses); the first hit ends it.
  bool continuous(const Step& step, FclRotation rotation = FclRotation::kScrew) const;
  /// At each pose the tree, then collide; the first hit ends it.
  bool every_10_mm(const Step& step) const;
  /// The tree once, with the bounds of the whole step, then collide at each pose.
  bool every_10_mm_one_tree_query(const Step& step) const;
  /// A single pose.
  bool blocked_at(const Load& load, const Pose& X) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rubicon::bench
