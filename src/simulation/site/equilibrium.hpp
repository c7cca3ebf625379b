#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/simulation/site/block_equilibrium.hpp"
#include "src/simulation/site/support.hpp"

namespace rubicon::site {

/// The second level of support: whether the forces between all that stands now can balance. Made
/// for one question; what it finds out of contacts is forgotten with it.
class Equilibrium {
 public:
  using Thing = Support::Thing;

  explicit Equilibrium(Support& support);

  /// Components that move and may, with others that they have forces with, directly or through
  /// more; nothing: the forces balance.
  std::optional<Support::Collapse> collapse_of(const std::vector<Thing>& first);
  /// Components that have forces with one that stands, or are braced by it, and may move.
  std::vector<Thing> neighbours(Thing component);
  /// At the beginning: marks what moves as floating, until the rest can balance.
  void find_collapsing(std::vector<std::pair<int, std::string>>& found);

 private:
  /// What holds a component that stands, whether that stands itself or not.
  struct Holding {
    struct Bearing {
      Thing lower = -1;
      std::vector<ContactPatch> patches;
    };
    std::vector<Bearing> bearings;
    std::vector<Thing> joints;  ///< components that it is fixed to
    bool is_fixed = false;      ///< to the site
  };

  const Holding& holding_of(Thing component);
  std::set<Thing> assembly_of(const std::vector<Thing>& first);
  std::optional<Support::Collapse> collapse_in(const std::set<Thing>& assembly);
  bool is_anchored(Thing thing);
  bool may_move(Thing thing);
  Support::Collapse describe(const std::vector<Thing>& things,
                             const std::vector<BlockContact>& contacts,
                             const std::vector<BlockJoint>& joints,
                             const std::vector<BlockMotion>& moving);

  Support& support_;
  std::set<Thing> soils_;  ///< components that are part of the ground
  std::map<Thing, Holding> holdings_;
};

}  // namespace rubicon::site
