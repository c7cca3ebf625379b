#include "src/motion/robot/rope_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/motion/robot/enclosed_point.hpp"
#include "src/motion/robot/frame_chain.hpp"

namespace rubicon::robot {

namespace {

/// m per m: what rounding may add to a point of a chain; a micrometre over a kilometre.
constexpr double kPointRounding = 1e-9;

/// The frames between two bodies: those of `up` lead from the common ancestor to the one whose
/// frame is meant, those of `down` from the ancestor to the other.
struct RelativeChain {
  std::vector<const FrameElement*> up, down;
};

std::vector<int> path_to(const RobotModel& model, int body) {
  std::vector<int> path;
  for (; body >= 0; body = model.bodies[static_cast<std::size_t>(body)].parent) {
    path.push_back(body);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

RelativeChain relative_chain(const RobotModel& model, int body, int other) {
  const std::vector<int> up = path_to(model, body);
  const std::vector<int> down = path_to(model, other);
  std::size_t common = 0;
  while (common < up.size() && common < down.size() && up[common] == down[common]) ++common;
  RelativeChain chain;
  const auto add = [&](const std::vector<int>& path, std::vector<const FrameElement*>& elements) {
    for (std::size_t i = common; i < path.size(); ++i) {
      for (const FrameElement& each : model.bodies[static_cast<std::size_t>(path[i])].frame) {
        elements.push_back(&each);
      }
    }
  };
  add(up, chain.up);
  add(down, chain.down);
  return chain;
}

/// A point of the other body as the first one sees it.
class SeenPoint {
 public:
  SeenPoint(const RobotModel& model, const Mounting& mounting, int body, int other,
            const Vec3& point)
      : chain_(relative_chain(model, body, other)), starts_(mounting.starts), point_(point) {}

  Vec3 at(std::span<const double> q) const {
    const FormulaInput input{q, {}, starts_};
    Pose X_up = Pose::Identity(), X_down = Pose::Identity();
    for (const FrameElement* each : chain_.up) append(X_up, *each, input);
    for (const FrameElement* each : chain_.down) append(X_down, *each, input);
    return X_up.inverse(Eigen::Isometry) * (X_down * point_);
  }

  /// Upper bound (m) of how far the point is from the straight line between where it is at s0 and
  /// at s1, while q runs from q0 to q1.
  double deviation(std::span<const double> q0, std::span<const double> q1, double s0,
                   double s1) const {
    EnclosedPoint p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = constant_enclosure(point_[static_cast<Eigen::Index>(i)]);
    }
    for (std::size_t n = chain_.down.size(); n-- > 0;) {
      const FrameElement& each = *chain_.down[n];
      transform(each, enclosed_arguments(each, q0, q1, starts_, s0, s1), p);
    }
    for (const FrameElement* each : chain_.up) {
      transform_back(*each, enclosed_arguments(*each, q0, q1, starts_, s0, s1), p);
    }
    // A curve whose second derivative is at most A deviates from its chord by at most
    // A (s1 - s0)^2 / 8.
    const double bound = acceleration_of(p) * (s1 - s0) * (s1 - s0) / 8;
    return bound >= 0 ? bound : std::numeric_limits<double>::infinity();
  }

 private:
  RelativeChain chain_;
  std::span<const double> starts_;
  Vec3 point_;
};

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double squared = ab.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
  return (p - (a + t * ab)).norm();
}

/// One piece and by how much it is larger (m) than what the rope sweeps.
struct MeasuredPiece {
  RopePiece piece;
  double excess = 0;
};

/// The capsule about `own` that holds all straight lines from there to points between p0 and p1,
/// and farther from these than `deviation` none.
MeasuredPiece capsule_about(int body, const Vec3& own, const Vec3& p0, const Vec3& p1,
                            double radius, double deviation) {
  MeasuredPiece measured;
  RopePiece& piece = measured.piece;
  piece.body = body;
  piece.a = own;
  const double reach = std::max((p0 - own).norm(), (p1 - own).norm());
  const Vec3 middle = (p0 + p1) / 2 - own;
  const bool same = (p0.array() == p1.array()).all();
  piece.b = same ? p0 : own;
  if (!same && middle.norm() > 0) piece.b = own + middle * (reach / middle.norm());
  // How far a point is from a convex set is convex along a line: the ends tell for all between.
  double growth =
      std::max(distance_to_segment(p0, own, piece.b), distance_to_segment(p1, own, piece.b)) +
      deviation;
  if (growth > 0) growth += kPointRounding * (1 + reach);
  piece.radius = radius + growth;
  measured.excess = growth;
  return measured;
}

std::vector<double> between(std::span<const double> q0, std::span<const double> q1, double s) {
  std::vector<double> q(q0.size());
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = q0[i] == q1[i] ? q0[i] : (1 - s) * q0[i] + s * q1[i];
  }
  return q;
}

/// A rope as seen from one of its ends.
class RopeView {
 public:
  RopeView(const RobotModel& model, const Mounting& mounting, const Body& rope, bool from_above)
      : body_(from_above ? rope.rope->from : rope.parent),
        own_(from_above ? rope.rope->p_from : rope.rope->p_to),
        radius_(rope.rope->radius),
        other_(model, mounting, body_, from_above ? rope.parent : rope.rope->from,
               from_above ? rope.rope->p_to : rope.rope->p_from),
        model_(model),
        mounting_(mounting) {}

  MeasuredPiece piece(std::span<const double> q0, std::span<const double> q1, double s0,
                      double s1) const {
    const bool whole = s0 == 0 && s1 == 1;
    const Vec3 p0 = other_.at(whole ? q0 : std::span<const double>(between(q0, q1, s0)));
    const Vec3 p1 = other_.at(whole ? q1 : std::span<const double>(between(q0, q1, s1)));
    MeasuredPiece measured =
        capsule_about(body_, own_, p0, p1, radius_, other_.deviation(q0, q1, s0, s1));
    measured.piece.s0 = s0;
    measured.piece.s1 = s1;
    // What the rope reaches at one moment counts for the whole piece, also where the body is at
    // another.
    const double length_change = (p1 - p0).norm();
    if (length_change > 0 && moves(q0, q1)) measured.excess += length_change;
    return measured;
  }

 private:
  bool moves(std::span<const double> q0, std::span<const double> q1) const {
    const Pose X0 = body_pose(model_, mounting_, q0, body_);
    const Pose X1 = body_pose(model_, mounting_, q1, body_);
    return (X0.matrix().array() != X1.matrix().array()).any();
  }

  int body_;
  Vec3 own_;
  double radius_;
  SeenPoint other_;
  const RobotModel& model_;
  const Mounting& mounting_;
};

}  // namespace

std::vector<RopePiece> rope_pieces(const RobotModel& model, const Mounting& mounting, int rope,
                                   std::span<const double> q0, std::span<const double> q1,
                                   int most_pieces) {
  const Body& body = model.bodies[static_cast<std::size_t>(rope)];
  const RopeView above(model, mounting, body, true);
  const MeasuredPiece from_above = above.piece(q0, q1, 0, 1);
  if (!(from_above.excess > 0)) return {from_above.piece};
  const RopeView below(model, mounting, body, false);
  const MeasuredPiece from_below = below.piece(q0, q1, 0, 1);
  const bool use_above = !(from_below.excess < from_above.excess);
  const MeasuredPiece& best = use_above ? from_above : from_below;
  if (best.excess <= kRopeExcess) return {best.piece};
  const RopeView& view = use_above ? above : below;
  const int count = static_cast<int>(
      std::clamp(std::ceil(best.excess / kRopeExcess), 1.0, static_cast<double>(most_pieces)));
  std::vector<RopePiece> pieces;
  for (int i = 0; i < count; ++i) {
    pieces.push_back(view.piece(q0, q1, i / static_cast<double>(count),
                                i + 1 == count ? 1.0 : (i + 1) / static_cast<double>(count))
                         .piece);
  }
  return pieces;
}

std::array<Vec3, 2> rope_ends(const RobotModel& model, const Mounting& mounting, int rope,
                              std::span<const double> q) {
  const Body& body = model.bodies[static_cast<std::size_t>(rope)];
  return {body_pose(model, mounting, q, body.rope->from) * body.rope->p_from,
          body_pose(model, mounting, q, body.parent) * body.rope->p_to};
}

}  // namespace rubicon::robot
