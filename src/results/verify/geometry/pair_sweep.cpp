#include "src/results/verify/geometry/pair_sweep.hpp"

#include <algorithm>
#include <cmath>

namespace rubicon::verify {

namespace {

/// Contact of thin things is judged more strictly, as docs/collision.md says: by a quarter of the
/// width, but for no less than this (m).
constexpr double kThinShare = 0.25;
constexpr double kThinFloor = 1e-5;

/// Pairs of pieces that are kept for the halves of an interval. If there are more, the halves look
/// for their own.
constexpr std::size_t kMostKept = 4096;

/// Times an interval is halved. Every motion of a finite speed is told apart long before; what is
/// not has a motion without bound, and counts as contact.
constexpr int kDeepestHalving = 40;

/// Tests of pieces for one pair of solids, about a minute; more are only needed by hostile motions,
/// and count as contact.
constexpr long kMostTests = 1L << 27;

}  // namespace

DepthQuery thin_levels(double width_a, double width_b, double contact_tolerance) {
  const double width = std::min(width_a, width_b);
  const double tolerance = std::min(contact_tolerance, std::max(kThinShare * width, kThinFloor));
  const double band = std::min(kBand, std::max(kThinShare * width, kThinFloor));
  DepthQuery levels;
  levels.alarm = tolerance + band / 2;
  levels.limit = tolerance + band;
  return levels;
}

PairSweep::PairSweep(const Solid& a, const PartMotion& motion_a, const Solid& b,
                     const PartMotion& motion_b, double contact_tolerance)
    : a_(a), motion_a_(motion_a), b_(b), motion_b_(motion_b), tolerance_(contact_tolerance) {}

std::optional<Contact> PairSweep::run() {
  if (one_holds_other(0) || one_holds_other(1)) return contact_;
  descend(0, 1, nullptr, 0);
  return contact_;
}

PairSweep::Interval PairSweep::interval(double u0, double u1) const {
  const PartState a = motion_a_.state(u0, u1);
  const PartState b = motion_b_.state(u0, u1);
  const Pose X_BW = b.X_WS.inverse(Eigen::Isometry);
  Interval interval{u0, u1, X_BW * a.X_WS, a.reach + b.reach};
  interval.changed_a = a.solid;
  interval.changed_b = b.solid;
  interval.a = a.solid ? a.solid.get() : &a_;
  interval.b = b.solid ? b.solid.get() : &b_;
  interval.reach_b.spread = X_BW.linear().cwiseAbs() * interval.reach_b.spread;
  return interval;
}

/// Looks at an interval and, where that does not tell, at its halves; true if there is contact.
bool PairSweep::descend(double u0, double u1, const std::vector<PiecePair>* open, int depth) {
  const double middle = u0 + (u1 - u0) / 2;
  if (++tests_ > kMostTests || depth > kDeepestHalving) {
    contact_ = Contact{0, middle};
    return true;
  }
  const Interval here = interval(u0, u1);
  std::vector<PiecePair> unsure;
  bool complete = true;
  if (open == nullptr) {
    complete = list_pairs(here, 0, 0, unsure);
  } else {
    for (const PiecePair& pair : *open) {
      if (!keep_unsure(here, pair, unsure)) break;
    }
  }
  if (contact_) return true;
  if (complete && unsure.empty()) return false;
  const std::vector<PiecePair>* kept = complete ? &unsure : nullptr;
  return descend(u0, middle, kept, depth + 1) || descend(middle, u1, kept, depth + 1);
}

/// Walks both trees; false if there are too many pairs to keep, or contact was found.
bool PairSweep::list_pairs(const Interval& interval, int node_a, int node_b,
                           std::vector<PiecePair>& open) {
  const BoxTree::Node& a = interval.a->tree.nodes()[static_cast<std::size_t>(node_a)];
  const BoxTree::Node& b = interval.b->tree.nodes()[static_cast<std::size_t>(node_b)];
  const double reach = interval.reach_b.most();
  const Bounds box_a = a.bounds.placed(interval.X_BA);
  // Not `meets`: a reach that is no number must not pass for apart.
  if (!std::isfinite(reach)) return false;
  if (!box_a.grown(reach).meets(b.bounds)) return true;
  if (a.left < 0 && b.left < 0) {
    return keep_unsure(interval, {a.item, b.item}, open) && open.size() <= kMostKept;
  }
  const bool split_a = b.left < 0 || (a.left >= 0 && (box_a.upper - box_a.lower).norm() >
                                                         (b.bounds.upper - b.bounds.lower).norm());
  if (split_a) {
    return list_pairs(interval, a.left, node_b, open) &&
           list_pairs(interval, a.right, node_b, open);
  }
  return list_pairs(interval, node_a, b.left, open) && list_pairs(interval, node_a, b.right, open);
}

/// Tests two pieces; false if they are in contact.
bool PairSweep::keep_unsure(const Interval& interval, PiecePair pair,
                            std::vector<PiecePair>& open) {
  const Convex& a = interval.a->pieces[static_cast<std::size_t>(pair.first)];
  const Convex& b = interval.b->pieces[static_cast<std::size_t>(pair.second)];
  ++tests_;
  DepthQuery query = thin_levels(a.width, b.width, tolerance_);
  query.reach = interval.reach_b;
  const DepthResult result = depth_test(a, interval.X_BA, b, query);
  if (result.nearness == Nearness::deep) {
    contact_ = Contact{result.depth, interval.u0 + (interval.u1 - interval.u0) / 2};
    return false;
  }
  if (result.nearness == Nearness::unsure) open.push_back(pair);
  return true;
}

/// Whether a point well inside one of them is inside a closed mesh of the other. The surfaces that
/// descend() looks at say nothing about what is wholly inside.
bool PairSweep::one_holds_other(double u) {
  if (a_.surfaces.empty() && b_.surfaces.empty()) return false;
  const Pose X_BA = interval(u, u).X_BA;
  const Pose X_AB = X_BA.inverse(Eigen::Isometry);
  const auto holds = [&](const Solid& outer, const Solid& inner, const Pose& X) {
    for (const ClosedSurface& surface : outer.surfaces) {
      for (const InnerPoint& point : inner.inner_points) {
        const double depth = thin_levels(point.width, point.width, tolerance_).alarm;
        if (!surface.holds(X * point.p, depth)) continue;
        contact_ = Contact{depth, u};
        return true;
      }
    }
    return false;
  };
  return holds(b_, a_, X_BA) || holds(a_, b_, X_AB);
}

}  // namespace rubicon::verify
