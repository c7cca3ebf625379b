#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "src/results/verify/geometry/depth.hpp"
#include "src/results/verify/input/solid.hpp"

namespace rubicon::verify {

/// Where a solid is at the middle of an interval, and how far its points may be from there within
/// it. World frame.
struct PartState {
  Pose X_WS = Pose::Identity();
  Reach reach;
  /// Of what changes its shape: the one at the middle, always with as many pieces. Null: it does
  /// not.
  std::shared_ptr<const Solid> solid = {};
};

/// How a solid moves while u runs from 0 to 1.
class PartMotion {
 public:
  virtual ~PartMotion() = default;
  virtual PartState state(double u0, double u1) const = 0;
};

/// A solid that stands.
class StandingPart : public PartMotion {
 public:
  explicit StandingPart(const Pose& X_WS) : X_WS_(X_WS) {}
  PartState state(double, double) const override { return {X_WS_, {}}; }

 private:
  Pose X_WS_;
};

struct Contact {
  double depth = 0;  ///< m
  double u = 0;      ///< when
};

/// Tells whether two solids come deeper into each other than the contact tolerance while u runs
/// from 0 to 1. Intervals are halved until, with the pieces grown by all they move in it, each is
/// seen to be free, or one is found deep.
///
/// What is deeper than tolerance + kBand is always found; what is less deep than tolerance +
/// kBand / 2 is never reported. For thin pieces both are less (thin_levels).
class PairSweep {
 public:
  PairSweep(const Solid& a, const PartMotion& motion_a, const Solid& b, const PartMotion& motion_b,
            double contact_tolerance);

  std::optional<Contact> run();

 private:
  using PiecePair = std::pair<int, int>;
  struct Interval {
    double u0 = 0;
    double u1 = 1;
    Pose X_BA = Pose::Identity();
    Reach reach_b;  ///< in the frame of b
    const Solid* a = nullptr;
    const Solid* b = nullptr;
    std::shared_ptr<const Solid> changed_a = {}, changed_b = {};
  };

  Interval interval(double u0, double u1) const;
  bool descend(double u0, double u1, const std::vector<PiecePair>* open, int depth);
  bool list_pairs(const Interval& interval, int node_a, int node_b, std::vector<PiecePair>& open);
  bool keep_unsure(const Interval& interval, PiecePair pair, std::vector<PiecePair>& open);
  bool one_holds_other(double u);

  const Solid& a_;
  const PartMotion& motion_a_;
  const Solid& b_;
  const PartMotion& motion_b_;
  double tolerance_;
  std::optional<Contact> contact_;
  long tests_ = 0;
};

/// m: contact is a fault for sure when it is deeper than the tolerance by this, and for sure none
/// when it is deeper by half of it or less. Reason: the engine's own answers are exact to 0.1 mm.
inline constexpr double kBand = 5e-4;

/// What a pair of pieces of these widths may be deep without fault (limit, always less than half of
/// the thinner one's width) and when it is reported (alarm).
DepthQuery thin_levels(double width_a, double width_b, double contact_tolerance);

}  // namespace rubicon::verify
