#include "src/simulation/site/rope_volume.hpp"

#include <utility>

#include "src/motion/math/index.hpp"
#include "src/motion/robot/body_motion.hpp"
#include "src/motion/robot/frame_chain.hpp"

namespace rubicon::site {

namespace {

/// Capsules that are kept. A step of the ropes of a crane has one to four.
constexpr std::size_t kKept = 32;

bool same(const geometry::Capsule& a, const geometry::Capsule& b) {
  return a.radius == b.radius && (a.a.array() == b.a.array()).all() &&
         (a.b.array() == b.b.array()).all();
}

geometry::Solid solid_of(const geometry::Capsule& capsule) {
  if ((capsule.a.array() == capsule.b.array()).all()) {
    return geometry::Sphere{capsule.a, capsule.radius};
  }
  return capsule;
}

using math::at;

}  // namespace

collision::BodyPtr RopeBodies::body_of(const geometry::Capsule& capsule) {
  for (const Entry& entry : entries_) {
    if (same(entry.capsule, capsule)) return entry.body;
  }
  Entry made{capsule, collision::prepare({geometry::Shape{solid_of(capsule)}})};
  collision::BodyPtr body = made.body;
  if (entries_.size() < kKept) {
    entries_.push_back(std::move(made));
  } else {
    entries_[oldest_] = std::move(made);
    oldest_ = (oldest_ + 1) % kKept;
  }
  return body;
}

void RopeBodies::add(int rope, robot::RopePath path, std::vector<int> parameters) {
  ropes_.emplace(rope, Known{std::move(path), std::move(parameters), {}});
}

const robot::RopePath& RopeBodies::path(int rope) const { return ropes_.at(rope).path; }

const RopeBodies::Hanging* RopeBodies::unchanged(int rope, std::span<const double> q0,
                                                 std::span<const double> q1) const {
  const auto found = ropes_.find(rope);
  if (found == ropes_.end() || !found->second.last.body) return nullptr;
  const Known& known = found->second;
  for (std::size_t i = 0; i < known.parameters.size(); ++i) {
    const std::size_t p = at(known.parameters[i]);
    if (q0[p] != q1[p] || q0[p] != known.last.values[i]) return nullptr;
  }
  return &known.last;
}

void RopeBodies::remember(int rope, std::span<const double> q0, std::span<const double> q1,
                          const robot::RopePiece& piece, collision::BodyPtr body) {
  const auto found = ropes_.find(rope);
  if (found == ropes_.end()) return;
  Known& known = found->second;
  std::vector<double> values;
  for (const int parameter : known.parameters) {
    if (q0[at(parameter)] != q1[at(parameter)]) return;
    values.push_back(q0[at(parameter)]);
  }
  known.last = {std::move(values), piece, std::move(body)};
}

std::vector<RopeVolume> rope_volumes(const SiteRobot& robot, int rope, std::span<const double> q0,
                                     std::span<const double> q1,
                                     const std::vector<geometry::Motion>& motions,
                                     int most_pieces) {
  if (const RopeBodies::Hanging* last = robot.rope_bodies->unchanged(rope, q0, q1)) {
    return {{last->body, motions[at(last->piece.body)], 0, 1}};
  }
  std::vector<RopeVolume> volumes;
  for (const robot::RopePiece& piece : robot.rope_bodies->path(rope).pieces(q0, q1, most_pieces)) {
    RopeVolume volume;
    volume.body = robot.rope_bodies->body_of({piece.a, piece.b, piece.radius});
    volume.s0 = piece.s0;
    volume.s1 = piece.s1;
    if (piece.s0 == 0 && piece.s1 == 1) {
      volume.motion = motions[at(piece.body)];
      robot.rope_bodies->remember(rope, q0, q1, piece, volume.body);
    } else {
      volume.motion = robot::step_motions(
          *robot.model, robot.mounting, robot::configuration_at(q0, q1, piece.s0),
          robot::configuration_at(q0, q1, piece.s1))[at(piece.body)];
    }
    volumes.push_back(std::move(volume));
  }
  return volumes;
}

RopeVolume standing_rope(const SiteRobot& robot, int rope, std::span<const double> q) {
  const robot::RopePiece piece = robot.rope_bodies->path(rope).pieces(q, q, 1).front();
  const math::Pose X_WB = robot::body_pose(*robot.model, robot.mounting, q, piece.body);
  return {robot.rope_bodies->body_of({piece.a, piece.b, piece.radius}), geometry::stationary(X_WB),
          0, 1};
}

}  // namespace rubicon::site
