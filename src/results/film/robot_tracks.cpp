#include "src/results/film/robot_tracks.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "src/motion/math/turns.hpp"

namespace rubicon::film {

namespace {

/// The value that means the same angle and is at most half a turn away from the one before.
double unrolled(double value, double before) {
  const double off = before - value;
  if (std::abs(off) <= math::kHalfTurn_deg) return value;
  return value + std::copysign(math::whole_turns_deg(std::abs(off)), off);
}

}  // namespace

RobotTracks::RobotTracks(const std::vector<SceneRobot>& robots) {
  for (const SceneRobot& scene : robots) {
    std::vector<double> now;
    for (const SceneParameter& parameter : scene.parameters) now.push_back(parameter.start);
    const Key first = key(0, now);
    robots_.push_back({scene.parameters, now, first, KeyColumns(now.size())});
    robots_.back().main.add(first);
  }
}

Key RobotTracks::key(double t, const std::vector<double>& q) const {
  Key key;
  key.t = time_millionths(t);
  key.q.reserve(q.size());
  for (const double value : q) key.q.push_back(millionths(value, "a control parameter"));
  return key;
}

RobotTracks::Motion* RobotTracks::find(int run) {
  const auto found = open_.find(run);
  return found == open_.end() ? nullptr : &found->second;
}

void RobotTracks::begin(int run, int robot, double t) {
  if (robot < 0) return;
  const std::vector<double>& now = robots_[static_cast<std::size_t>(robot)].now;
  open_.emplace(run, Motion{robot, now, t, KeyFilter(key(t, now))});
}

void RobotTracks::stand(int run, double t) {
  Motion* motion = find(run);
  if (motion == nullptr || t <= motion->t) return;
  Key still = motion->keys.last();
  still.t = time_millionths(t);
  motion->keys.add(still);
  motion->t = t;
}

void RobotTracks::move(int run, double t, std::span<const double> q) {
  Motion* motion = find(run);
  if (motion == nullptr) return;
  if (t < motion->t) throw std::invalid_argument("the task's time runs backwards here");
  Robot& robot = robots_[static_cast<std::size_t>(motion->robot)];
  std::vector<double> there(q.begin(), q.end());
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (robot.parameters[i].cyclic) there[i] = unrolled(there[i], robot.now[i]);
  }
  motion->keys.add(key(t, there));
  motion->t = t;
  robot.now = std::move(there);
}

void RobotTracks::accept(int run) {
  Motion* motion = find(run);
  if (motion == nullptr) return;
  Robot& robot = robots_[static_cast<std::size_t>(motion->robot)];
  if (motion->keys.first().t < robot.last.t) {
    throw std::invalid_argument("the task's robot was in another task at its beginning");
  }
  motion->keys.finish();
  if (motion->keys.first() != robot.last) robot.main.add(motion->keys.first());
  robot.main.add(motion->keys.kept());
  robot.last = motion->keys.last();
  open_.erase(run);
}

void RobotTracks::reject(int run) {
  Motion* motion = find(run);
  if (motion == nullptr) return;
  motion->keys.finish();
  Track track{motion->robot, run, KeyColumns(motion->before.size())};
  track.keys.add(motion->keys.first());
  track.keys.add(motion->keys.kept());
  rejected_.push_back(std::move(track));
  robots_[static_cast<std::size_t>(motion->robot)].now = std::move(motion->before);
  open_.erase(run);
}

std::optional<double> RobotTracks::reached(int run) const {
  const auto found = open_.find(run);
  if (found == open_.end()) return std::nullopt;
  return found->second.t;
}

std::vector<Track> RobotTracks::take_tracks() {
  while (!open_.empty()) accept(open_.begin()->first);
  std::vector<Track> tracks;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    tracks.push_back({static_cast<int>(i), -1, std::move(robots_[i].main)});
  }
  for (Track& track : rejected_) tracks.push_back(std::move(track));
  return tracks;
}

}  // namespace rubicon::film
