#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "src/motion/collision/swept_query.hpp"
#include "src/simulation/site/load.hpp"
#include "src/simulation/site/rope_volume.hpp"
#include "src/simulation/site/site_robot.hpp"

namespace rubicon::site {

/// The motions of a robot's bodies, and last of its load (of its tool where it has none), while q
/// runs from `q_from` to `q_to`.
std::vector<geometry::Motion> part_motions(const SiteRobot& robot, const std::optional<Load>& load,
                                           std::span<const double> q_from,
                                           std::span<const double> q_to);

/// One step of a robot as a question to the collision world. Its parts are the robot's bodies, the
/// load, and the robot's buffers. A rope is one item or several, each for a part of the step.
/// Robot, load and values must outlive it.
class StepQuery {
 public:
  /// With `against_world` what moves is tested against the obstacles; own pairs always are.
  StepQuery(const SiteRobot& robot, const std::optional<Load>& load, std::span<const double> q_from,
            std::span<const double> q_to, double contact_tolerance, bool against_world);

  const collision::SweptQuery& query() const { return query_; }
  /// Only what moves, without own pairs: for the reserved volumes of others.
  collision::SweptQuery against_others() const;
  /// The part behind an item of `query`.
  int part_of(int item) const { return part_of_[static_cast<std::size_t>(item)]; }
  /// The same of `against_others`, and of all its items.
  int part_of_mover(int item) const { return part_of(movers_[static_cast<std::size_t>(item)]); }
  std::vector<int> parts_of_movers() const;
  /// Of all parts but the buffers, as `part_motions` makes them. Last of all: the query has copies.
  std::vector<geometry::Motion> take_motions() { return std::move(motions_); }
  /// What stands while the rest moves, but for ropes and buffers.
  collision::SweptQuery standing() const;
  /// Of a body or the load.
  bool moves(int part) const { return moves_[static_cast<std::size_t>(part)]; }

 private:
  /// The items of a rope begin at `first`.
  struct RopeItems {
    int first = 0;
    std::vector<RopeVolume> volumes;
  };

  int item(int part);
  int add_item(const collision::Body* body, geometry::Motion motion, int part, bool against_world,
               bool moves);
  /// An index into `ropes_`.
  std::size_t add_rope(int part);
  std::size_t rope_items(int part);
  void add_pair(int first, int second);
  const collision::Body* body(int part) const;
  void add_pairs(const std::vector<OwnPair>& pairs, bool of_load);

  const SiteRobot& robot_;
  const std::optional<Load>& load_;
  std::span<const double> q_from_, q_to_;
  int load_part_;
  bool against_world_;
  std::vector<geometry::Motion> motions_;
  std::vector<bool> moves_;
  std::vector<int> item_of_;  ///< per part: its item in the query (of a rope: its place in
                              ///< `ropes_`), or -1
  std::vector<int> part_of_;
  std::vector<int> movers_;  ///< items of what moves, but for copies over a part of the step
  std::vector<RopeItems> ropes_;
  std::vector<collision::BodyPtr> kept_;  // shared: of ropes, whose bodies change
  collision::SweptQuery query_;
};

}  // namespace rubicon::site
