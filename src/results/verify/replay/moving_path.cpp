#include "src/results/verify/replay/moving_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"

namespace rubicon::verify {

namespace {

/// Degrees that are no turn: what rounding leaves of two poses that are turned alike.
constexpr double kNoTurn = 1e-5;

/// From one pose to another at even speed.
MovingStretch stretch_between(const Pose& X_first, const Pose& X_second) {
  MovingStretch stretch;
  stretch.X_from = X_first;
  stretch.way = X_second.translation() - X_first.translation();
  const math::Mat3 R = X_second.linear() * X_first.linear().transpose();
  const double angle_deg = math::rotation_angle_deg(R);
  if (angle_deg > kNoTurn) {
    stretch.axis = Vec3(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)).normalized();
    stretch.angle_deg = angle_deg;
  }
  return stretch;
}

Pose pose_in(const MovingStretch& stretch, double s) {
  Pose X = stretch.X_from;
  X.linear() = math::rotation_about_deg(stretch.axis, s * stretch.angle_deg) * X.linear();
  X.translation() += s * stretch.way;
  return X;
}

}  // namespace

MovingStretch MovingStretch::part(double s0, double s1) const {
  MovingStretch part = *this;
  part.X_from = pose_in(*this, s0);
  part.way = (s1 - s0) * way;
  part.angle_deg = (s1 - s0) * angle_deg;
  const auto at = [&](double s) {
    return from + static_cast<Ticks>(s * static_cast<double>(to - from));
  };
  part.from = at(s0);
  part.to = at(s1);
  return part;
}

MovingPath::MovingPath(const SceneMoving& moving, const std::vector<MovingRecord>& records,
                       const std::vector<MeshData>& meshes, Ticks until, Faults& faults)
    : moving_(moving),
      solid_(make_solid(moving.shapes, meshes)),
      overhead_(make_solid(moving.overhead, meshes)) {
  Run run;
  Ticks delay = 0;
  for (const MovingRecord& record : records) {
    const auto fault = [&](std::string text) {
      faults.push_back({FaultKind::clock, ResultFile::trace, record.line, "", record.time,
                        moving.name + ": " + std::move(text)});
    };
    if (record.time < run.from) {
      fault("its times run backwards here");
      continue;
    }
    const bool stops = !record.by.empty();
    if (!stops && !run.stands) fault("it goes on, and did not stand");
    run.to = record.time;
    // Up to the record it stood, whether it goes on or is told a new cause.
    const Ticks late = delay + (run.stands ? run.to - run.from : 0);
    if (!stops) delay = late;
    if (std::abs(late - record.delay) > kTimeSlack) {
      fault(fmt::format("it is {:g} s late, the trace says {:g} s", static_cast<double>(late) / 1e9,
                        static_cast<double>(record.delay) / 1e9));
    }
    // Who stands and is told a new cause goes on standing.
    if (stops && run.stands) continue;
    const Ticks own = run.own + (run.stands ? 0 : run.to - run.from);
    runs_.push_back(run);
    run = {record.time, record.time, own, stops};
  }
  run.to = std::max(run.from, until);
  runs_.push_back(run);
}

void MovingPath::stretches(Ticks from, Ticks to, bool once,
                           const std::function<void(const MovingStretch&)>& visit) const {
  for (const Run& run : runs_) {
    const Ticks first = std::max(from, run.from);
    Ticks last = std::min(to, run.to);
    if (once && moving_.repeat) last = std::min(last, first + (end() - begin()));
    if (first <= last && (first < last || from == to)) visit_run(run, first, last, visit);
  }
}

void MovingPath::visit_run(const Run& run, Ticks from, Ticks to,
                           const std::function<void(const MovingStretch&)>& visit) const {
  const Ticks period = end() - begin();
  const auto& path = moving_.path;
  Ticks time = from;
  do {
    const Ticks own = run.own + (run.stands ? 0 : time - run.from);
    Ticks until = to;
    const bool comes = own < begin();
    const bool is_away =
        comes || (run.stands && own == begin() && own > 0) || (!moving_.repeat && own >= end());
    if (is_away) {
      if (!comes || run.stands) return;
      time += begin() - own;
      continue;
    }
    const Ticks passed = moving_.repeat ? (own - begin()) / period * period : 0;
    std::size_t second = 1;
    while (second + 1 < path.size() && path[second].time <= own - passed) ++second;
    const SceneMoving::Place& a = path[second - 1];
    const SceneMoving::Place& b = path[second];
    const auto share = [&](Ticks at) {
      return static_cast<double>(at - passed - a.time) / static_cast<double>(b.time - a.time);
    };
    const MovingStretch whole = stretch_between(a.X_WO, b.X_WO);
    MovingStretch stretch;
    if (run.stands) {
      stretch = whole.part(share(own), share(own));
    } else {
      until = std::min(to, time + (b.time - (own - passed)));
      stretch = whole.part(share(own), share(own + (until - time)));
    }
    stretch.from = time;
    stretch.to = until;
    visit(stretch);
    if (until == time) return;
    time = until;
  } while (time < to);
}

MovingPart::MovingPart(const Solid& solid, const MovingStretch& stretch) : stretch_(stretch) {
  const Vec3 axis_O = stretch.X_from.linear().transpose() * stretch.axis;
  for (int corner = 0; corner < 8; ++corner) {
    const Bounds& box = solid.bounds;
    const Vec3 p_O(corner & 1 ? box.upper.x() : box.lower.x(),
                   corner & 2 ? box.upper.y() : box.lower.y(),
                   corner & 4 ? box.upper.z() : box.lower.z());
    radius_ = std::max(radius_, axis_O.cross(p_O).norm());
  }
}

PartState MovingPart::state(double u0, double u1) const {
  PartState part;
  part.X_WS = pose_in(stretch_, u0 + (u1 - u0) / 2);
  part.reach.spread = stretch_.way.cwiseAbs() * ((u1 - u0) / 2);
  part.reach.rest = radius_ * math::radians(stretch_.angle_deg) * ((u1 - u0) / 2);
  return part;
}

}  // namespace rubicon::verify
