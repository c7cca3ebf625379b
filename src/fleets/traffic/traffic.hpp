#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "src/fleets/traffic/make_way.hpp"
#include "src/fleets/traffic/timed_way.hpp"

namespace rubicon::traffic {

/// A vehicle of a fleet, at the node where it begins.
struct Vehicle {
  double speed = 1;  ///< m/s, at most
  double width = 0;  ///< m; narrower lanes are not for it
  NodeIndex start = lanes::kNone;
};

/// Whom a vehicle waits for.
struct Wait {
  int vehicle = -1;               ///< who has to leave first
  NodeIndex node = lanes::kNone;  ///< where
};

/// What became of the wish to drive somewhere.
struct PlanResult {
  enum class Outcome : std::uint8_t {
    planned,  ///< it has a way, this one or from before
    waits,    ///< somebody stands in the way for good
    no_way    ///< no lanes that are wide enough lead there
  };
  Outcome outcome = Outcome::planned;
  Wait wait = {};  ///< waits
};

/// Who holds which node of a network, who is next at each, and the ways of all vehicles. A vehicle
/// holds the node where it is, and while it drives the next one too. It enters a node when all that
/// are before it there have gone; lateness shifts what follows, and the order at a node stays.
/// So a delay makes neither a meeting at a node nor a ring of waiting: the orders come from times
/// at which nobody met, and are kept.
class Traffic {
 public:
  /// Throws std::invalid_argument for unknown nodes, two vehicles at one node, and speeds that are
  /// not above 0.
  Traffic(std::shared_ptr<const LaneNetwork> network, std::vector<Vehicle> vehicles);

  const LaneNetwork& network() const { return *network_; }
  int vehicles() const { return static_cast<int>(vehicles_.size()); }
  const Vehicle& vehicle(int index) const { return vehicles_[at(index)]; }

  /// The node that it reached last.
  NodeIndex node_of(int vehicle) const { return states_[at(vehicle)].stays.front().node; }
  /// The next node of its way; kNone at the end of it.
  NodeIndex next_of(int vehicle) const;
  /// Whether it has entered the next node and is on its way there.
  bool drives(int vehicle) const { return states_[at(vehicle)].drives; }
  /// Where its way ends.
  NodeIndex end_of(int vehicle) const { return states_[at(vehicle)].stays.back().node; }
  /// Where its way ends; of a way that leads back to where it is, the last node before. kNone at
  /// the end of its way.
  NodeIndex next_stop(int vehicle) const;
  /// From the node that it reached last; times as they were foreseen at `now`.
  std::vector<TimedNode> way_of(int vehicle, Nanoseconds now);

  /// Finds a way to the goal for a vehicle at the end of its way, between the ways of all others.
  /// One that is on its way keeps it, wherever that ends.
  PlanResult plan(int vehicle, NodeIndex goal, Nanoseconds now);
  /// Enters the next node, which must be there; nothing: it may go, or went already.
  std::optional<Wait> enter_next(int vehicle, Nanoseconds now);
  /// It has reached the node that it had entered, and with all its bodies left the one before.
  void arrived(int vehicle, Nanoseconds now);

  /// By vehicle: where the tasks lead that it has yet to do; empty where nobody has any.
  using Ahead = std::vector<std::vector<NodeIndex>>;
  /// Brings a vehicle that waits to its goal where others stand in the way who may be moved: those
  /// get ways, too, out of its way and out of each other's, as `make_way` finds them. `movable`, by
  /// vehicle: it waits itself, or has nothing to do. False and nothing changed if there are none.
  bool untangle(int vehicle, const std::vector<bool>& movable, const Ahead& ahead, Nanoseconds now);
  /// Of a vehicle that waits and that `untangle` does not help: of those who stand on its way, the
  /// first without whom it would get to its goal; if there is none, the first.
  std::optional<Wait> who_bars(int vehicle, const std::vector<bool>& movable) const;
  /// Whether `plan` last found somebody in its way.
  bool waits(int vehicle) const { return wants(vehicle) != lanes::kNone; }
  /// The goal to which `plan` last found no way.
  NodeIndex wants(int vehicle) const { return states_[at(vehicle)].wants; }

  /// Counts what may let others go on: ways that were found, nodes that were left.
  std::uint64_t changes() const { return changes_; }

  bool operator==(const Traffic&) const = default;

 private:
  struct Stay {
    NodeIndex node = lanes::kNone;
    LaneIndex lane = lanes::kNone;
    Nanoseconds enter = 0;   ///< as foreseen last
    Nanoseconds arrive = 0;  ///< as foreseen last
    bool operator==(const Stay&) const = default;
  };
  struct State {
    std::vector<Stay> stays;         ///< where it is, then what is ahead
    std::int64_t first = 0;          ///< number of stays.front(), counted up
    bool drives = false;             ///< it has entered stays[1]
    NodeIndex wants = lanes::kNone;  ///< waits to have a way there
    bool operator==(const State&) const = default;
  };
  /// A stay in the order of its node.
  struct Turn {
    int vehicle = -1;
    std::int64_t number = 0;
    bool operator==(const Turn&) const = default;
  };

  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }
  const Stay& stay_of(const Turn& turn) const;
  Nanoseconds leave_of(const Turn& turn) const;
  void foresee(Nanoseconds now);
  TimedWays ways_from(int vehicle, Nanoseconds now);
  void take(int vehicle, const std::vector<TimedNode>& way);
  std::optional<std::vector<Wait>> standing_before(int vehicle, NodeIndex goal) const;
  PlanResult blocked(int vehicle, NodeIndex goal) const;
  std::vector<int> movers_for(int vehicle, const std::vector<bool>& movable) const;
  MakeWayQuery way_made_by(const std::vector<int>& who, const Ahead& ahead, int left_out) const;

  std::shared_ptr<const LaneNetwork> network_;
  std::vector<Vehicle> vehicles_;
  std::vector<State> states_;
  std::vector<std::vector<Turn>> turns_;  ///< by node: in their order, who holds it first
  std::uint64_t changes_ = 0;
};

inline bool operator==(const Vehicle& a, const Vehicle& b) {
  return a.speed == b.speed && a.width == b.width && a.start == b.start;
}

}  // namespace rubicon::traffic
