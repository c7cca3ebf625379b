#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/results/film/key_filter.hpp"
#include "src/results/film/scene.hpp"

namespace rubicon::film {

/// One row of the head's `tracks` and its keys.
struct Track {
  int robot = 0;
  int run = -1;  ///< of a rejected run; -1: what happened
  KeyColumns keys;
};

/// How robots move: what each run (by number) does is kept apart until it is known whether it
/// happened. Values are in metres or degrees, times in seconds. A run moves one robot or none.
class RobotTracks {
 public:
  explicit RobotTracks(const std::vector<SceneRobot>& robots);

  /// The run stands where its robot is.
  void begin(int run, int robot, double t);
  /// It stands still until then.
  void stand(int run, double t);
  /// All parameters at the end of a step; turns go on the shorter way.
  void move(int run, double t, std::span<const double> q);
  /// It happened.
  void accept(int run);
  /// It did not happen: the robot is back where it began.
  void reject(int run);
  /// The time up to which the run's motion is known (s); nothing where it moves no robot.
  std::optional<double> reached(int run) const;

  /// The main tracks in the order of the robots, then those of rejected runs in the order in which
  /// they ended. Runs that never ended count as what happened. Nothing may follow.
  std::vector<Track> take_tracks();

 private:
  struct Motion {
    int robot = 0;
    std::vector<double> before;  ///< where the robot was at its beginning
    double t = 0;
    KeyFilter keys;
  };
  struct Robot {
    std::vector<SceneParameter> parameters;
    std::vector<double> now;  ///< turns unrolled
    Key last;                 ///< of its main track
    KeyColumns main;
  };

  Key key(double t, const std::vector<double>& q) const;
  Motion* find(int run);

  std::vector<Robot> robots_;
  std::map<int, Motion> open_;
  std::vector<Track> rejected_;
};

}  // namespace rubicon::film
